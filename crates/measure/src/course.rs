//! The slow course of colour over a pearl, and what differs from it.

use libm::sqrt;

use crate::face::{Face, offset};
use crate::solve::{inverse, robust_weight, times};
use crate::value::median;

/// The course is a polynomial of this degree in the place, per channel of colour **(ours)**: shading, rings
/// of colour and glows are followed, spots are not.
const DEGREE: usize = 6;
const TERMS: usize = (DEGREE + 1) * (DEGREE + 2) / 2;
/// The map's places reach this far, in radians.
const REACH: f64 = 1.25;
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

/// Colour less its robust course; 0 where nothing is looked at. None where too few places are left for a course.
pub fn residuals(face: &Face) -> Option<Vec<[f64; 3]>> {
    let row = |at: usize| {
        let (right, down) = offset(at);
        face.held[at].then(|| (terms(right / REACH, down / REACH), face.lab[at]))
    };
    let count = face.held.iter().filter(|held| **held).count();
    let rows: Vec<Row> =
        (0..face.held.len()).filter_map(row).step_by(count.div_ceil(ENOUGH).max(1)).collect();
    if rows.len() < 4 * TERMS {
        return None;
    }
    let course = fitted(&rows)?;
    let rest = |at: usize| row(at).map_or([0.0; 3], |(terms, lab)| less(lab, &terms, &course));
    Some((0..face.held.len()).map(rest).collect())
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
