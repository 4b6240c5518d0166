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
