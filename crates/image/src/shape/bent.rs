//! A height over the sphere of directions with its first and second derivatives, and how its surface is bent.
//!
//! The height is a function of the direction's three coordinates, whatever it is off the sphere.
//! Left out: how the surface twists between two directions.

use glam::{DMat3, DVec3};

/// A height in a direction, and how it changes with the direction's coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bent {
    pub(super) height: f64,
    pub(super) slope: DVec3,
    /// How the slope changes; symmetric.
    pub(super) change: DMat3,
}

impl Bent {
    /// The product of two heights.
    pub(super) fn times(&self, other: &Self) -> Self {
        let mixed = Self::outer(self.slope, other.slope);
        Self {
            height: self.height * other.height,
            slope: self.slope * other.height + other.slope * self.height,
            change: self.change * other.height
                + other.change * self.height
                + mixed
                + mixed.transpose(),
        }
    }

    pub(super) fn outer(a: DVec3, b: DVec3) -> DMat3 {
        DMat3::from_cols(a * b.x, a * b.y, a * b.z)
    }

    /// Curvature of the surface that lies so high in the direction `towards`, along a direction on it: the second
    /// derivative of distance less height over the gradient's length.
    pub(super) fn curvature(&self, towards: DVec3, along: DVec3) -> f64 {
        let out = towards.dot(along);
        let aside = along - towards * out;
        let level = self.slope - towards * self.slope.dot(towards);
        let bulge = aside.length_squared() / self.height;
        let rise = aside.dot(self.change * aside)
            - self.slope.dot(towards) * aside.length_squared()
            - 2.0 * out * level.dot(along);
        let steep = (1.0 + level.length_squared() / (self.height * self.height)).sqrt();
        (bulge - rise / (self.height * self.height)) / steep
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::ovoid::Ovoid;

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
