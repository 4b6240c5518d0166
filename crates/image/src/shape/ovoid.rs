//! The smooth part of a form: an ellipsoid whose one end may be narrower and whose other end may be flat.
//!
//! x^2/a^2 W^2 + y^2/b^2 W^2 + z^2/c^2 F^2 = 1, with W = 1 + taper ((1 + z)/2)^2 and F = 1 + flattening ((1 - z)/2)^2, all in
//! the direction from the middle; first and second derivatives in closed form.
//! Left out: lumps and grooves, which multiply it.

use glam::{DMat3, DVec3};

use crate::shape::bent::Bent;

/// An ovoid, over half of the pearl's width; its pole, z, is the axis of growth.
#[derive(Debug, Clone)]
pub(super) struct Ovoid {
    /// One over the squares of the half axes.
    squares: DVec3,
    taper: f64,
    flattening: f64,
    /// Makes it as wide as it shall be.
    scale: f64,
    is_ball: bool,
}

impl Ovoid {
    /// As wide as 1, on average around the axis, and `axes.z` as long: taper and flattening move both.
    pub(super) fn new(axes: DVec3, taper: f64, flattening: f64) -> Self {
        let squares = (axes * axes).recip();
        let is_ball = axes == DVec3::ONE && taper == 0.0 && flattening == 0.0;
        let mut ovoid = Self { squares, taper, flattening, scale: 1.0, is_ball };
        if !is_ball {
            ovoid.fit(axes.z);
        }
        ovoid
    }

    /// Distance of the surface in a direction, and its gradient.
    pub(super) fn at(&self, towards: DVec3) -> (f64, DVec3) {
        if self.is_ball {
            return (1.0, DVec3::ZERO);
        }
        let (above, below) = (0.5 * (1.0 + towards.z), 0.5 * (1.0 - towards.z));
        let narrow = 1.0 + self.taper * above * above;
        let flat = 1.0 + self.flattening * below * below;
        let across =
            self.squares.x * towards.x * towards.x + self.squares.y * towards.y * towards.y;
        let along = self.squares.z * towards.z * towards.z;
        let sum = across * narrow * narrow + along * flat * flat;
        let radius = self.scale / sum.sqrt();
        let half = DVec3::new(
            self.squares.x * towards.x * narrow * narrow,
            self.squares.y * towards.y * narrow * narrow,
            across * narrow * self.taper * above + self.squares.z * towards.z * flat * flat
                - along * flat * self.flattening * below,
        );
        (radius, half * (-radius / sum))
    }

    /// The same with second derivatives.
    pub(super) fn bent(&self, towards: DVec3) -> Bent {
        let (height, slope) = self.at(towards);
        if self.is_ball {
            return Bent { height, slope, change: DMat3::ZERO };
        }
        let DVec3 { x, y, z } = towards;
        let (above, below) = (0.5 * (1.0 + z), 0.5 * (1.0 - z));
        let (narrow, narrower) = (1.0 + self.taper * above * above, self.taper * above);
        let (flat, flatter) = (1.0 + self.flattening * below * below, -self.flattening * below);
        let squares = self.squares;
        let across = squares.x * x * x + squares.y * y * y;
        // Of the sum whose root is one over the height.
        let sum = (self.scale / height).powi(2);
        let aside = squares.truncate() * narrow * narrow;
        let skew = DVec3::new(squares.x * x, squares.y * y, 0.0) * (2.0 * narrow * narrower);
        let upright = across * (narrower * narrower + 0.5 * narrow * self.taper)
            + squares.z
                * (flat * flat
                    + 4.0 * z * flat * flatter
                    + z * z * (flatter * flatter + 0.5 * flat * self.flattening));
        let half = DMat3::from_cols(
            DVec3::new(aside.x, 0.0, skew.x),
            DVec3::new(0.0, aside.y, skew.y),
            DVec3::new(skew.x, skew.y, upright),
        );
        let change = Bent::outer(slope, slope) * (3.0 / height) - half * (height / sum);
        Bent { height, slope, change }
    }

    fn fit(&mut self, length: f64) {
        const TRIES: usize = 40;
        for _ in 0..TRIES {
            let [half_width, half_length] = self.extents();
            self.scale /= half_width;
            let short = length * half_width / half_length;
            if (short - 1.0).abs() < 1e-12 {
                return;
            }
            self.squares.z /= short * short;
        }
    }

    /// Half the width at the widest, on average around the axis, and half the length.
    fn extents(&self) -> [f64; 2] {
        const STEPS: usize = 512;
        let (mut width, mut top, mut bottom) = (0.0_f64, 0.0_f64, 0.0_f64);
        for step in 0..=STEPS {
            let (sin, cos) = libm::sincos(std::f64::consts::PI * step as f64 / STEPS as f64);
            let sides = [DVec3::new(sin, 0.0, cos), DVec3::new(0.0, sin, cos)];
            let [x, y] = sides.map(|towards| self.at(towards).0);
            width = width.max(0.5 * sin * (x + y));
            (top, bottom) = (top.max(x * cos), bottom.max(-x * cos));
        }
        [width, 0.5 * (top + bottom)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ellipsoid_is_bent_as_its_axes_say() {
        for length in [0.6, 1.0, 1.7] {
            let ovoid = Ovoid::new(DVec3::new(1.0, 1.0, length), 0.0, 0.0);
            let bend = |towards, along| ovoid.bent(towards).curvature(towards, along);
            let near = |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-9, "{found}");
            near(bend(DVec3::Z, DVec3::X), length);
            near(bend(DVec3::X, DVec3::Y), 1.0);
            near(bend(DVec3::X, DVec3::Z), 1.0 / (length * length));
            // Halfway, along the meridian: a b / (a^2 sin^2 + b^2 cos^2)^(3/2) of the angle that is even on a circle.
            let (sin, cos) = 0.7_f64.sin_cos();
            let place = DVec3::new(cos, 0.0, length * sin);
            let along = DVec3::new(-sin, 0.0, length * cos).normalize();
            let wide = sin * sin + length * length * cos * cos;
            near(bend(place.normalize(), along), length / wide.powf(1.5));
        }
    }
}
