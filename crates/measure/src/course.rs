//! The slow course of colour over a pearl, and what differs from it.

use libm::sqrt;

use crate::Circle;
use crate::disc::Disc;
use crate::solve::{inverse, robust_weight, times};
use crate::value::median;

/// The course is a polynomial of this degree in the place, per channel of CIELAB **(ours)**: shading, rings
/// of colour and glows are followed, spots are not.
const DEGREE: usize = 6;
const TERMS: usize = (DEGREE + 1) * (DEGREE + 2) / 2;
/// Rounds of least absolute differences, and all, the rest by Tukey's biweight.
const ROUNDS: (usize, usize) = (5, 12);
/// Differences are never taken for smaller than this.
const LEAST_SPREAD: f64 = 0.1;
/// About as many pixels are enough for the fit.
const ENOUGH: usize = 6000;
/// Ridge, in shares of the mean diagonal: it decides only where nothing is looked at.
const RIDGE: f64 = 1e-6;

/// A place's terms of the course, and its colour.
type Row = ([f64; TERMS], [f64; 3]);

/// CIELAB less the robust course of colour, averaged over 3 x 3 pixels; 0 where nothing is looked at.
///
/// None where too few pixels are left for a course.
pub fn residuals(disc: &Disc, held: &[bool], circle: &Circle) -> Option<Vec<[f64; 3]>> {
    let own = |at: usize| disc.pixels[at].as_ref().filter(|_| held[at]);
    let row = |at: usize| {
        let pixel = own(at)?;
        let (x, y) = pixel.place;
        let (right, down) =
            ((x - circle.x_px) / circle.radius_px, (y - circle.y_px) / circle.radius_px);
        Some((terms(right, down), pixel.lab))
    };
    let count = held.iter().filter(|held| **held).count();
    let rows: Vec<Row> =
        (0..held.len()).filter_map(row).step_by(count.div_ceil(ENOUGH).max(1)).collect();
    if rows.len() < 4 * TERMS {
        return None;
    }
    let course = fitted(&rows)?;
    let rest: Vec<[f64; 3]> = (0..held.len())
        .map(|at| row(at).map_or([0.0; 3], |(terms, lab)| less(lab, &terms, &course)))
        .collect();
    Some((0..held.len()).map(|at| averaged(&rest, held, at, disc.width)).collect())
}

/// Chebyshev's polynomials in both directions, up to the degree together.
fn terms(right: f64, down: f64) -> [f64; TERMS] {
    let line = |x: f64| {
        let mut line = [1.0, x, 0.0, 0.0, 0.0, 0.0, 0.0];
        for order in 2..=DEGREE {
            line[order] = 2.0 * x * line[order - 1] - line[order - 2];
        }
        line
    };
    let (across, along) = (line(right), line(down));
    let mut all = [0.0; TERMS];
    let orders = (0..=DEGREE).flat_map(|one| (0..=DEGREE - one).map(move |other| (one, other)));
    for (term, (one, other)) in all.iter_mut().zip(orders) {
        *term = across[one] * along[other];
    }
    all
}

fn less(lab: [f64; 3], terms: &[f64; TERMS], course: &[Vec<f64>; 3]) -> [f64; 3] {
    [0, 1, 2].map(|channel| {
        lab[channel] - terms.iter().zip(&course[channel]).map(|(term, of)| term * of).sum::<f64>()
    })
}

/// The robust fit of each channel, with the same weights.
fn fitted(rows: &[Row]) -> Option<[Vec<f64>; 3]> {
    let mut weights = vec![1.0; rows.len()];
    let mut course = [Vec::new(), Vec::new(), Vec::new()];
    for round in 0..ROUNDS.1 {
        let (matrix, sides) = normal_equations(rows, &weights);
        let inverse = inverse(&matrix)?;
        course = sides.map(|side| times(&inverse, &side));
        let sizes: Vec<f64> = rows
            .iter()
            .map(|(terms, lab)| less(*lab, terms, &course))
            .map(|[l, a, b]| sqrt(l * l + a * a + b * b))
            .collect();
        let spread = (1.4826 * median(&mut sizes.clone())).max(LEAST_SPREAD);
        weights = sizes.iter().map(|&size| robust_weight(size, spread, round < ROUNDS.0)).collect();
    }
    Some(course)
}

/// The matrix, with its ridge, and the side of each channel.
fn normal_equations(rows: &[Row], weights: &[f64]) -> (Vec<Vec<f64>>, [Vec<f64>; 3]) {
    let mut matrix = vec![vec![0.0; TERMS]; TERMS];
    let mut sides = [vec![0.0; TERMS], vec![0.0; TERMS], vec![0.0; TERMS]];
    for ((terms, lab), weight) in rows.iter().zip(weights) {
        for one in 0..TERMS {
            let weighted = weight * terms[one];
            for other in 0..TERMS {
                matrix[one][other] += weighted * terms[other];
            }
            for channel in 0..3 {
                sides[channel][one] += weighted * lab[channel];
            }
        }
    }
    let ridge = RIDGE * (0..TERMS).map(|at| matrix[at][at]).sum::<f64>() / TERMS as f64;
    for (at, line) in matrix.iter_mut().enumerate() {
        line[at] += ridge;
    }
    (matrix, sides)
}

/// The mean over a pixel and those around it.
fn averaged(rest: &[[f64; 3]], held: &[bool], at: usize, width: usize) -> [f64; 3] {
    if !held[at] {
        return [0.0; 3];
    }
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for row in 0..3 {
        for column in 0..3 {
            let Some(near) = (at + row * width + column).checked_sub(width + 1) else { continue };
            if held.get(near).copied().unwrap_or(false) {
                sum = [0, 1, 2].map(|channel| sum[channel] + rest[near][channel]);
                count += 1.0;
            }
        }
    }
    sum.map(|one| one / count)
}
