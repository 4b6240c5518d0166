//! Spherical harmonics up to the second order, as far as matt surfaces see.
//!
//! Real harmonics in Cartesian form, as in Ramamoorthi and Hanrahan 2001.
//! Left out: every higher degree.

use glam::DVec3;

use crate::rgb::{self, Rgb};

/// Linear RGB by direction, as far as nine spherical harmonics tell it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SecondOrder([Rgb; 9]);

impl SecondOrder {
    pub(crate) const ZERO: Self = Self([[0.0; 3]; 9]);

    /// What is nearest, in the mean square, to directions given as (direction, share of the sphere,
    /// value); the shares add up to 1.
    pub(crate) fn nearest_to(values: impl Iterator<Item = (DVec3, f64, Rgb)>) -> Self {
        let mut coefficients = [[0.0; 3]; 9];
        for (direction, share, value) in values {
            for (sum, basis) in coefficients.iter_mut().zip(harmonics(direction)) {
                rgb::add(sum, rgb::scaled(value, 4.0 * basis * share));
            }
        }
        Self(coefficients)
    }

    /// Adds so much of another.
    pub(crate) fn add(&mut self, other: &Self, amount: f64) {
        for (sum, more) in self.0.iter_mut().zip(other.0) {
            rgb::add(sum, rgb::scaled(more, amount));
        }
    }

    /// The value in a direction, each harmonic times its weight.
    pub(crate) fn at(&self, direction: DVec3, weights: &[f64; 9]) -> Rgb {
        let mut value = [0.0; 3];
        for ((coefficient, basis), weight) in self.0.iter().zip(harmonics(direction)).zip(weights) {
            rgb::add(&mut value, rgb::scaled(*coefficient, basis * weight));
        }
        value
    }
}

/// Real spherical harmonics of degree 0 to 2, times sqrt(pi).
fn harmonics(d: DVec3) -> [f64; 9] {
    let (a, b) = (3.0_f64.sqrt() / 2.0, 15.0_f64.sqrt() / 2.0);
    [
        0.5,
        a * d.x,
        a * d.y,
        a * d.z,
        b * d.x * d.y,
        b * d.y * d.z,
        b * d.z * d.x,
        0.5 * b * (d.x * d.x - d.z * d.z),
        5.0_f64.sqrt() / 4.0 * (3.0 * d.y * d.y - 1.0),
    ]
}
