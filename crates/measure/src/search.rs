//! The circle along which colour changes most, by trying all of them in a small copy of the picture.

use std::f64::consts::TAU;

use libm::{cos, rint, sin, sqrt};

use crate::{Circle, Picture};

/// Longest side of the small copy.
const COARSE_PX: usize = 96;
const DIRECTIONS: usize = 72;
/// Circles up to this ratio count as of one size.
const SIZE: (usize, usize) = (5, 4);

/// How steeply colour changes along each direction, from 0 to 1: [direction][row, column].
pub struct Steepness {
    by_direction: Vec<Vec<f32>>,
    width: usize,
    height: usize,
    factor: usize,
}

impl Steepness {
    /// Of a picture.
    pub fn of(picture: &Picture<'_>) -> Self {
        let factor = picture.width().max(picture.height()).div_ceil(COARSE_PX);
        let small = picture.reduced(factor);
        let (width, height) = (small.width, small.height);
        let shade: Vec<[f64; 3]> =
            small.light.iter().map(|rgb| rgb.map(|light| sqrt(light.max(0.0)))).collect();
        let at = |column: usize, row: usize| shade[row * width + column];
        let mut tensor = Vec::with_capacity(width * height);
        for row in 0..height {
            for column in 0..width {
                let left = at(column.saturating_sub(1), row);
                let right = at((column + 1).min(width - 1), row);
                let up = at(column, row.saturating_sub(1));
                let down = at(column, (row + 1).min(height - 1));
                let mut parts = [0.0; 3];
                for channel in 0..3 {
                    let (across, along) =
                        (right[channel] - left[channel], down[channel] - up[channel]);
                    parts[0] += across * across;
                    parts[1] += across * along;
                    parts[2] += along * along;
                }
                tensor.push(parts);
            }
        }
        let mut by_direction = Vec::with_capacity(DIRECTIONS);
        for (c, s) in directions() {
            let steep = |[a, b, d]: &[f64; 3]| {
                sqrt((c * c * a + 2.0 * c * s * b + s * s * d).max(0.0)) as f32
            };
            by_direction.push(tensor.iter().map(steep).collect::<Vec<f32>>());
        }
        let top = steepest(&by_direction).max(1e-6);
        for one in by_direction.iter_mut().flatten() {
            // The root, so that all of a faint outline counts for more than a part of a strong one.
            *one = (*one / top).min(1.0).sqrt();
        }
        Self { by_direction, width, height, factor }
    }

    /// The circles with the greatest mean steepness, one of each size, clear of another one if given.
    pub fn best(&self, clear_of: Option<Circle>) -> Vec<Circle> {
        let shorter = self.width.min(self.height);
        let mut best: Vec<(f32, Circle)> = Vec::new();
        let mut total = Vec::new();
        let (mut sum_of_size, mut last_of_size) = (0.0, 0);
        for radius in (shorter / 8).max(3)..shorter.div_ceil(2) {
            if radius > last_of_size {
                (sum_of_size, last_of_size) = (0.0, radius * SIZE.0 / SIZE.1);
            }
            let (across, down) = (self.width - 2 * radius, self.height - 2 * radius);
            self.add_up(radius, (across, down), &mut total);
            for (at, &sum) in total.iter().enumerate().filter(|(_, sum)| **sum > 0.0) {
                if sum <= sum_of_size {
                    continue;
                }
                let found = self.circle(at % across + radius, at / across + radius, radius);
                if clear_of.is_none_or(|other| apart(&found, &other)) {
                    if sum_of_size > 0.0 {
                        best.pop();
                    }
                    sum_of_size = sum;
                    best.push((sum, found));
                }
            }
        }
        best.into_iter().map(|(_, circle)| circle).collect()
    }

    /// Sums of steepness along circles of one radius around each centre.
    fn add_up(&self, radius: usize, (across, down): (usize, usize), total: &mut Vec<f32>) {
        total.clear();
        total.resize(across * down, 0.0);
        for (steep, (c, s)) in self.by_direction.iter().zip(directions()) {
            let left = (radius as f64 + rint(radius as f64 * c)) as usize;
            let top = (radius as f64 + rint(radius as f64 * s)) as usize;
            for row in 0..down {
                let first = (top + row) * self.width + left;
                let line = &steep[first..first + across];
                for (sum, one) in total[row * across..].iter_mut().zip(line) {
                    *sum += one;
                }
            }
        }
    }

    fn circle(&self, column: usize, row: usize, radius: usize) -> Circle {
        let factor = self.factor as f64;
        Circle {
            x_px: factor * (column as f64 + 0.5),
            y_px: factor * (row as f64 + 0.5),
            radius_px: factor * (radius as f64 + 0.5),
        }
    }
}

/// Two circles that share little: one lies beside the other.
fn apart(first: &Circle, second: &Circle) -> bool {
    let (x, y) = (first.x_px - second.x_px, first.y_px - second.y_px);
    sqrt(x * x + y * y) > 0.9 * (first.radius_px + second.radius_px)
}

fn directions() -> impl Iterator<Item = (f64, f64)> {
    (0..DIRECTIONS).map(|at| TAU * at as f64 / DIRECTIONS as f64).map(|turn| (cos(turn), sin(turn)))
}

/// What all but one in a hundred stay below.
fn steepest(by_direction: &[Vec<f32>]) -> f32 {
    let mut all: Vec<f32> = by_direction.iter().step_by(6).flatten().copied().collect();
    let place = all.len() * 99 / 100;
    *all.select_nth_unstable_by(place, f32::total_cmp).1
}
