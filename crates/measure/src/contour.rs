//! The outline as a few waves of radius over direction, and the widths of what lies within.

use std::f64::consts::{PI, TAU};

use libm::{atan2, cos, fabs, sin, sqrt};

use crate::edge::Edge;
use crate::solve::{inverse, product, robust_weight, times};
use crate::value::median;
use crate::{Circle, Value};

/// Rounds of least absolute differences, and all, the rest by Tukey's biweight.
const ROUNDS: (usize, usize) = (8, 20);
/// The waves' prior standard deviation, in radii **(ours)**: it decides only where no edge is seen.
const PRIOR: f64 = 0.05;
/// Directions in which a shape is measured.
const DIRECTIONS: usize = 360;
/// Steps of the table of radii; between them they are taken as straight.
const TURNS: usize = 1024;
/// Residuals are never taken for smaller than this, in pixels.
const LEAST_SPREAD: f64 = 0.02;
/// What is systematic, as standard deviations: in pixels, and in those by which single edges scatter, for
/// what scatters them (cloth as light as the pearl, what it mirrors at its rim) also leans on all of a side
/// **(ours)**. Of a diameter, and of the difference of two. From rendered balls: docs/measure.md.
const SYSTEMATIC_OF_WIDTH: (f64, f64) = (0.2, 1.0);
const SYSTEMATIC_OF_DIFFERENCE: (f64, f64) = (0.5, 4.0);
/// Of both, by the standard deviation of the outline's blur.
const SYSTEMATIC_OF_BLUR: f64 = 0.3;

/// r(turn), in pixels from a middle: the mean, then cosine and sine of each wave.
#[derive(Clone, Debug)]
pub struct Contour {
    /// Where the rays start; its radius is the mean of r.
    pub middle: Circle,
    waves: Vec<f64>,
    covariance: Vec<Vec<f64>>,
    /// Standard deviation of single edges about it, in pixels.
    spread: f64,
}

/// The widths of a shape.
pub struct Widths {
    pub least: Value,
    pub greatest: Value,
    pub mean: Value,
    pub roundness: Value,
}

impl Contour {
    /// A circle.
    pub fn round(middle: Circle) -> Self {
        let waves = vec![middle.radius_px];
        Self { middle, waves, covariance: vec![vec![0.0]], spread: 0.0 }
    }

    /// The robust fit of waves up to `order` to edges seen from a middle; None where these are too few.
    pub fn fit(edges: &[Edge], middle: Circle, order: usize) -> Option<Self> {
        let seen: Vec<&Edge> = edges.iter().filter(|edge| edge.seen).collect();
        let size = 2 * order + 1;
        if seen.len() < 2 * size {
            return None;
        }
        let rows: Vec<Vec<f64>> = seen.iter().map(|edge| basis(edge.turn, order)).collect();
        let mut weights = vec![1.0; seen.len()];
        let mut waves = vec![0.0; size];
        let (mut spread, mut left) = (middle.radius_px, Vec::new());
        let mut covariance = Vec::new();
        for round in 0..ROUNDS.1 {
            let (matrix, side) = normal_equations(&rows, &weights, &seen, spread, middle);
            covariance = inverse(&matrix)?;
            waves = times(&covariance, &side);
            let off = |(edge, row): (&&Edge, &Vec<f64>)| edge.away - product(row, &waves);
            left = seen.iter().zip(&rows).map(off).collect::<Vec<f64>>();
            let mut sizes: Vec<f64> = left.iter().map(|one| fabs(*one)).collect();
            spread = (1.4826 * median(&mut sizes)).max(LEAST_SPREAD);
            let weight = |one: &f64| robust_weight(*one, spread, round < ROUNDS.0);
            weights = left.iter().map(weight).collect();
        }
        scale(&mut covariance, &weights, &left);
        let middle = Circle { radius_px: waves[0], ..middle };
        (waves[0] > 0.0).then_some(Self { middle, waves, covariance, spread })
    }

    /// Distance of the outline from the middle, in pixels.
    pub fn radius(&self, turn: f64) -> f64 {
        product(&basis(turn, self.waves.len() / 2), &self.waves)
    }

    /// The place in a direction, so many pixels beyond the outline.
    pub fn place(&self, turn: f64, more: f64) -> [f64; 2] {
        let away = self.radius(turn) + more;
        [self.middle.x_px + away * cos(turn), self.middle.y_px + away * sin(turn)]
    }

    /// Cosine and sine of the way straight out of the shape there.
    pub fn outwards(&self, turn: f64) -> (f64, f64) {
        let step = 1.0 / self.radius(turn);
        let (back, on) = (self.place(turn - step, 0.0), self.place(turn + step, 0.0));
        let [right, down] = [on[0] - back[0], on[1] - back[1]];
        let long = sqrt(right * right + down * down);
        (down / long, -right / long)
    }

    /// The middle of the shape, by its first wave.
    pub fn centre(&self) -> Circle {
        let (x, y) = if self.waves.len() > 2 { (self.waves[1], self.waves[2]) } else { (0.0, 0.0) };
        Circle {
            x_px: self.middle.x_px + x,
            y_px: self.middle.y_px + y,
            radius_px: self.middle.radius_px,
        }
    }

    /// The middle of the area within, and the circle of that area.
    pub fn centroid(&self) -> Circle {
        let places = self.places(DIRECTIONS);
        let (mut area, mut x_px, mut y_px) = (0.0, 0.0, 0.0);
        for (at, [x, y]) in places.iter().enumerate() {
            let [next_x, next_y] = places[(at + 1) % places.len()];
            let part = x * next_y - next_x * y;
            area += part;
            x_px += part * (x + next_x);
            y_px += part * (y + next_y);
        }
        Circle {
            x_px: x_px / (3.0 * area),
            y_px: y_px / (3.0 * area),
            radius_px: sqrt(fabs(area) / TAU),
        }
    }

    /// How far from the middle places lie, the outline being 1; from a table, for many of them.
    pub fn share(&self) -> impl Fn(f64, f64) -> f64 + use<> {
        let table: Vec<f64> =
            (0..=TURNS).map(|at| self.radius(TAU * at as f64 / TURNS as f64)).collect();
        let middle = self.middle;
        move |x, y| {
            let (right, down) = (x - middle.x_px, y - middle.y_px);
            let turn = (atan2(down, right) / TAU).rem_euclid(1.0) * TURNS as f64;
            let at = (turn as usize).min(TURNS - 1);
            let part = turn - at as f64;
            sqrt(right * right + down * down) / (table[at] + part * (table[at + 1] - table[at]))
        }
    }

    /// The shape as places, clockwise from the right.
    pub fn places(&self, count: usize) -> Vec<[f64; 2]> {
        (0..count).map(|at| self.place(TAU * at as f64 / count as f64, 0.0)).collect()
    }

    /// Feret's diameters: distances of parallel tangents, over all directions.
    ///
    /// Errors follow from the fit's covariance and from what is systematic; the difference of greatest and
    /// least has its own. `soft`: the outline's blur, a standard deviation in pixels.
    pub fn widths(&self, soft: f64) -> Widths {
        let shape = self.places(DIRECTIONS);
        let turn = |at: usize| PI * at as f64 / (DIRECTIONS / 2) as f64;
        let widths: Vec<Width> =
            (0..DIRECTIONS / 2).map(|at| self.width(&shape, turn(at))).collect();
        let by_size = |first: &&Width, second: &&Width| first.size.total_cmp(&second.size);
        let (Some(least), Some(greatest)) =
            (widths.iter().min_by(by_size), widths.iter().max_by(by_size))
        else {
            unreachable!("there are directions");
        };
        let mean = widths.iter().map(|width| width.size).sum::<f64>() / widths.len() as f64;
        let between: Vec<f64> =
            greatest.slopes.iter().zip(&least.slopes).map(|(one, other)| one - other).collect();
        let mut of_mean = vec![0.0; self.waves.len()];
        of_mean[0] = 2.0;
        let error = |slopes: &[f64], (pixels, spreads): (f64, f64)| {
            self.error(slopes, (pixels + SYSTEMATIC_OF_BLUR * soft, spreads))
        };
        let value = |size, slopes: &[f64]| Value::new(size, error(slopes, SYSTEMATIC_OF_WIDTH));
        Widths {
            least: value(least.size, &least.slopes),
            greatest: value(greatest.size, &greatest.slopes),
            mean: value(mean, &of_mean),
            roundness: Value::new(
                (greatest.size - least.size) / mean,
                error(&between, SYSTEMATIC_OF_DIFFERENCE) / mean,
            ),
        }
    }

    /// The distance of the parallel tangents across one direction.
    fn width(&self, shape: &[[f64; 2]], turn: f64) -> Width {
        let (c, s) = (cos(turn), sin(turn));
        let reach = |[x, y]: &[f64; 2]| c * x + s * y;
        let far = extreme(shape, |place| reach(place));
        let near = extreme(shape, |place| -reach(place));
        let slope = |place: usize| {
            let towards = TAU * place as f64 / DIRECTIONS as f64;
            let along = fabs(cos(towards - turn));
            basis(towards, self.waves.len() / 2).into_iter().map(move |part| along * part)
        };
        let slopes = slope(far).zip(slope(near)).map(|(one, other)| one + other).collect();
        Width { size: reach(&shape[far]) - reach(&shape[near]), slopes }
    }

    /// The standard error of what has such slopes in the waves, with what is systematic, in pixels and spreads.
    fn error(&self, slopes: &[f64], (pixels, spreads): (f64, f64)) -> f64 {
        let of_fit = product(slopes, &times(&self.covariance, slopes)).max(0.0);
        let lean = spreads * self.spread;
        sqrt(of_fit + pixels * pixels + lean * lean)
    }
}

/// The distance of two parallel tangents, and its slope in each wave.
struct Width {
    size: f64,
    slopes: Vec<f64>,
}

/// Makes the covariance that of the fit, by what is left of the edges.
fn scale(covariance: &mut [Vec<f64>], weights: &[f64], left: &[f64]) {
    let total: f64 = weights.iter().sum();
    let squares: f64 = weights.iter().zip(left).map(|(w, one)| w * one * one).sum();
    let variance = squares / (total - covariance.len() as f64).max(1.0);
    for part in covariance.iter_mut().flatten() {
        *part *= variance;
    }
}

fn basis(turn: f64, order: usize) -> Vec<f64> {
    let mut row = vec![1.0];
    for wave in 1..=order {
        row.push(cos(wave as f64 * turn));
        row.push(sin(wave as f64 * turn));
    }
    row
}

fn normal_equations(
    rows: &[Vec<f64>],
    weights: &[f64],
    edges: &[&Edge],
    spread: f64,
    middle: Circle,
) -> (Vec<Vec<f64>>, Vec<f64>) {
    let size = rows[0].len();
    let (mut matrix, mut side) = (vec![vec![0.0; size]; size], vec![0.0; size]);
    for ((row, weight), edge) in rows.iter().zip(weights).zip(edges) {
        for one in 0..size {
            side[one] += weight * row[one] * edge.away;
            for other in 0..size {
                matrix[one][other] += weight * row[one] * row[other];
            }
        }
    }
    let share = spread / (PRIOR * middle.radius_px);
    for wave in 3..size {
        matrix[wave][wave] += share * share;
    }
    (matrix, side)
}

/// The place that reaches furthest.
fn extreme(shape: &[[f64; 2]], reach: impl Fn(&[f64; 2]) -> f64) -> usize {
    let mut best = 0;
    for place in 1..shape.len() {
        if reach(&shape[place]) > reach(&shape[best]) {
            best = place;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ellipse(long: f64, short: f64, noise: f64) -> Contour {
        let middle = Circle { x_px: 200.0, y_px: 200.0, radius_px: 0.5 * (long + short) };
        let edges: Vec<Edge> = (0..600)
            .map(|at| {
                let turn = TAU * f64::from(at) / 600.0;
                let (c, s) = (cos(turn - 0.3) / long, sin(turn - 0.3) / short);
                // A third of the edges lies anywhere.
                let off =
                    if at % 3 == 0 { f64::from(at % 17) } else { noise * sin(f64::from(at * at)) };
                Edge { turn, away: 1.0 / sqrt(c * c + s * s) + off, seen: true }
            })
            .collect();
        Contour::fit(&edges, middle, 6).unwrap()
    }

    #[test]
    fn feret_diameters_are_the_axes_of_an_ellipse_though_a_third_of_the_edges_is_wrong() {
        let widths = ellipse(105.0, 100.0, 0.2).widths(0.0);
        assert!((widths.greatest.value - 210.0).abs() < 0.15, "{:?}", widths.greatest);
        assert!((widths.least.value - 200.0).abs() < 0.15, "{:?}", widths.least);
        assert!((widths.roundness.value - 10.0 / 205.0).abs() < 0.001);
        let error = widths.roundness.error.unwrap();
        assert!(error > 0.5 / 205.0 && error < 2.0 / 205.0, "{error}");
    }
}
