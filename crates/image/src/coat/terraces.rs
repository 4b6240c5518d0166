//! The terraces of the growth front: level lines where one tablet ends and the next begins.
//!
//! A staircase beside the smooth height of the growth front; Fourier series, of which a footprint leaves the low terms.
//! Left out: that real terraces spiral.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::coat::{local::Local, rulings::Rulings};

/// Steps of one height on a growth front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Terraces {
    /// Height of a step: a tablet's.
    step_mm: f64,
    /// Height of the growth front for a field of 1.
    amplitude_mm: f64,
}

/// Twice the Fourier coefficients I_k(6) / I_0(6) of a step's slope, exp(6 cos psi) / I_0(6), whose riser takes
/// a sixth of the way from step to step **(ours)**.
const SERIES: [f64; 5] = [1.824_719, 1.391_760, 0.896_878, 0.494_882, 0.237_035];

impl Terraces {
    /// Steps of `step_mm`, `spacing_mm` apart where a field on a pearl of `radius_mm` is as steep as its `steepness`.
    pub(crate) fn new(step_mm: f64, spacing_mm: f64, steepness: f64, radius_mm: f64) -> Self {
        Self { step_mm, amplitude_mm: step_mm / spacing_mm * radius_mm / steepness }
    }

    /// What they make of a place, as wide as `footprint_mm`, where the growth front is `field` high and goes up by
    /// `gradient` per mm.
    pub(crate) fn at(&self, field: f64, gradient: DVec3, footprint_mm: f64) -> Local {
        let (slope, fine_slope2) = self.slope(field, gradient, footprint_mm);
        let front = gradient.length() * self.amplitude_mm;
        let all: f64 = SERIES.iter().map(|amount| 0.5 * amount * amount).sum();
        let unseen = fine_slope2 / (all * front * front).max(f64::MIN_POSITIVE);
        let (up, per_mm) = (gradient.normalize_or_zero(), front / self.step_mm);
        let rulings = Rulings { up, per_mm, step_mm: self.step_mm, unseen, fine_slope2 };
        let rulings = (unseen > LEAST_UNSEEN).then_some(rulings);
        Local { slope, fine_slope2, rulings, ..Local::EVEN }
    }

    /// The surface's slope, and the mean square of the slopes that are finer than `footprint_mm`.
    fn slope(&self, field: f64, gradient: DVec3, footprint_mm: f64) -> (DVec3, f64) {
        let front = gradient * self.amplitude_mm;
        let psi = TAU * self.amplitude_mm * field / self.step_mm;
        let steps = front.length() / self.step_mm * footprint_mm;
        let (mut riser, mut fine) = (0.0, 0.0);
        let width = TAU * FOOTPRINT * steps;
        // What a footprint leaves of term k is what it leaves of the first, to the power of k squared; the cosine of k psi
        // follows from those of the two terms before.
        let (first, cosine) = (libm::exp(-0.5 * width * width), libm::cos(psi));
        let (mut left, mut ratio, mut before, mut now) = (1.0, first, 1.0, cosine);
        for amount in SERIES {
            left *= ratio;
            ratio *= first * first;
            riser += amount * left * now;
            fine += 0.5 * amount * amount * (1.0 - left * left);
            (before, now) = (now, 2.0 * cosine * now - before);
        }
        (front * riser, fine * front.length_squared())
    }
}

/// Terraces of which less than this is unseen are no rulings.
const LEAST_UNSEEN: f64 = 0.02;

/// Standard deviation of a footprint of width 1 that spreads as a pixel's tent does.
const FOOTPRINT: f64 = 0.41;

#[cfg(test)]
mod tests {
    use super::*;

    const TERRACES: Terraces = Terraces { step_mm: 4e-4, amplitude_mm: 0.02 };

    #[test]
    fn between_two_steps_the_surface_goes_neither_up_nor_down() {
        // Along a path over which the front rises by one step.
        let gradient = DVec3::X * 0.4;
        let count = 200;
        let rise: f64 = (0..count)
            .map(|i| TERRACES.step_mm / TERRACES.amplitude_mm * f64::from(i) / f64::from(count))
            .map(|field| TERRACES.slope(field, gradient, 0.0).0.x)
            .sum();
        assert!(rise.abs() < 1e-9);
        // The tread leans back by nearly all of the front's slope.
        let half = 0.5 * TERRACES.step_mm / TERRACES.amplitude_mm;
        let tread = TERRACES.slope(half, gradient, 0.0).0.x / (0.4 * TERRACES.amplitude_mm);
        assert!((-1.3..-0.7).contains(&tread), "{tread}");
    }

    #[test]
    fn what_a_footprint_hides_is_in_the_fine_slopes() {
        let gradient = DVec3::new(0.3, 0.2, 0.0);
        let square = |footprint_mm: f64| {
            let count = 500;
            let at = |i: i32| 0.02 * f64::from(i) / f64::from(count);
            let sum: f64 = (0..count)
                .map(|i| TERRACES.slope(at(i), gradient, footprint_mm))
                .map(|(slope, fine)| slope.length_squared() + fine)
                .sum();
            sum / f64::from(count)
        };
        assert!((square(0.0) / square(0.03) - 1.0).abs() < 1e-6);
        assert!((square(0.0) / square(1.0) - 1.0).abs() < 1e-6);
    }
}
