//! A patch of a photograph as deviations of Munsell hue, value and chroma, faded out towards its edges.

use std::f64::consts::{PI, TAU};

use nacreous_colour::{Hvc, hvc_from_rgb};

use crate::grain::crop::Photograph;

/// Below this mean chroma a patch counts as grey **(ours)**: relative deviations would be noise.
const GREY_CHROMA: f64 = 0.2;

/// Deviations from the patch's mean, row by row: hue in rad, value and chroma relative.
///
/// Hue is an angle: its mean is the direction of the mean chroma vector, deviations lie in -pi to pi and count by
/// their chroma, since a grey has none.
pub(super) fn deviations(
    photograph: &Photograph<'_>,
    (top, left): (usize, usize),
    side: usize,
) -> [Vec<f64>; 3] {
    let pixel = |i: usize| hvc_from_rgb(photograph.at(top + i / side, left + i % side));
    let seen: Vec<Hvc> = (0..side * side).map(pixel).collect();
    let mean = |of: &dyn Fn(&Hvc) -> f64| {
        // Row by row, which rounds less than one long sum.
        let rows = seen.chunks_exact(side).map(|row| row.iter().map(of).sum::<f64>());
        rows.sum::<f64>() / seen.len() as f64
    };
    let along = mean(&|hvc| hvc.chroma * libm::cos(hvc.hue_rad));
    let beside = mean(&|hvc| hvc.chroma * libm::sin(hvc.hue_rad));
    let middle = libm::atan2(beside, along);
    let value = mean(&|hvc| hvc.value).max(0.1);
    let chroma = mean(&|hvc| hvc.chroma).max(GREY_CHROMA);
    let turned = |hvc: &Hvc| {
        let turned = hvc.hue_rad - middle;
        turned - TAU * ((turned + PI) / TAU).floor()
    };
    [
        seen.iter().map(|hvc| turned(hvc) * hvc.chroma / chroma).collect(),
        seen.iter().map(|hvc| hvc.value / value - 1.0).collect(),
        seen.iter().map(|hvc| hvc.chroma / chroma - 1.0).collect(),
    ]
}

/// A Hanning window that keeps the variance, and takes mean and slope away.
pub(super) struct Window {
    hanning: Vec<f64>,
    /// From -1 to 1.
    across: Vec<f64>,
    /// Of a plane's fit, weighted by the window, so that what the window leaves has neither mean nor slope.
    normal: [[f64; 3]; 3],
    /// One over its root mean square.
    correction: f64,
}

impl Window {
    pub(super) fn new(side: usize) -> Self {
        let hanning = |k: usize| 0.5 - 0.5 * libm::cos(TAU * k as f64 / side as f64);
        let hanning: Vec<f64> = (0..side).map(hanning).collect();
        let across = |k: usize| -1.0 + 2.0 * k as f64 / (side as f64 - 1.0);
        let across: Vec<f64> = (0..side).map(across).collect();
        let power: [fn(f64) -> f64; 3] = [|_| 1.0, |at| at, |at| at * at];
        let [all, first, second] = power.map(|power| -> f64 {
            hanning.iter().zip(&across).map(|(weight, at)| weight * power(*at)).sum()
        });
        let normal = [
            [all * all, first * all, all * first],
            [first * all, second * all, first * first],
            [all * first, first * first, all * second],
        ];
        let squares: f64 = hanning.iter().map(|weight| weight * weight).sum();
        Self { hanning, across, normal, correction: side as f64 / squares }
    }

    /// Lays it over one channel.
    pub(super) fn apply(&self, channel: &mut [f64]) {
        let side = self.hanning.len();
        let weighed = || self.hanning.iter().zip(&self.across);
        let mut right = [0.0; 3];
        for (row, (weight, at)) in channel.chunks_exact(side).zip(weighed()) {
            let terms = || weighed().zip(row).map(|((weight, at), value)| (weight * value, at));
            let all: f64 = terms().map(|(value, _)| value).sum();
            let first: f64 = terms().map(|(value, at)| value * at).sum();
            let line = [weight * all, weight * at * all, weight * first];
            right = [0, 1, 2].map(|i| right[i] + line[i]);
        }
        let [mean, down, along] = solved(self.normal, right);
        for (row, (row_weight, row_at)) in channel.chunks_exact_mut(side).zip(weighed()) {
            for (value, (weight, at)) in row.iter_mut().zip(weighed()) {
                let plane = mean + down * row_at + along * at;
                *value = (*value - plane) * row_weight * weight * self.correction;
            }
        }
    }
}

/// Three equations; the matrix is positive definite, so no pivot is zero.
fn solved(mut matrix: [[f64; 3]; 3], mut right: [f64; 3]) -> [f64; 3] {
    for pivot in 0..3 {
        for row in (0..3).filter(|&row| row != pivot) {
            let factor = matrix[row][pivot] / matrix[pivot][pivot];
            for column in 0..3 {
                matrix[row][column] -= factor * matrix[pivot][column];
            }
            right[row] -= factor * right[pivot];
        }
    }
    [0, 1, 2].map(|row| right[row] / matrix[row][row])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_takes_a_slope_away_and_keeps_the_variance() {
        let side = 33;
        let window = Window::new(side);
        let slope = |i: usize| 3.0 - 0.5 * (i / side) as f64 + 0.25 * (i % side) as f64;
        let mut plane: Vec<f64> = (0..side * side).map(slope).collect();
        window.apply(&mut plane);
        assert!(plane.iter().all(|value| value.abs() < 1e-13));
        let weight = |i: usize| window.hanning[i / side] * window.hanning[i % side];
        let squares: f64 = (0..side * side).map(|i| (weight(i) * window.correction).powi(2)).sum();
        assert!((squares / (side * side) as f64 - 1.0).abs() < 1e-14);
    }
}
