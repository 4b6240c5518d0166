//! The directions that a line of sight, or of reflection, stands for.
//!
//! An ellipse of directions, by two full angles and the way it is stretched.
//! Left out: how light falls off towards its edge, which is up to what is looked at.

use glam::DVec3;

/// The most round cones that stand for a long one.
const MOST_PARTS: f64 = 8.0;
/// Length of an even line that spreads as an even disc of width 1.
const LINE: f64 = 0.866;
const FINEST_RAD: f64 = 1e-9;

/// The directions that a line stands for: as spread as an even ellipse of these full angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    narrow_rad: f64,
    wide_rad: f64,
    /// The root of their product: the angle of a round cone of the same solid angle.
    mean_rad: f64,
    /// Unit vector across the line, along which the cone is wide.
    wide: DVec3,
}

impl Cone {
    /// Of the same angle all around.
    pub fn round(spread_rad: f64) -> Self {
        let (narrow_rad, wide_rad, mean_rad) = (spread_rad, spread_rad, spread_rad);
        Self { narrow_rad, wide_rad, mean_rad, wide: DVec3::ZERO }
    }

    /// Of `narrow_rad` all around, and along the unit vector `wide`, across the line, of `wide_rad` where that is more.
    pub fn stretched(narrow_rad: f64, wide_rad: f64, wide: DVec3) -> Self {
        let wide_rad = wide_rad.max(narrow_rad);
        Self { narrow_rad, wide_rad, mean_rad: (narrow_rad * wide_rad).sqrt(), wide }
    }

    /// Its angle along a unit vector.
    #[inline]
    pub fn along_rad(&self, direction: DVec3) -> f64 {
        if self.narrow_rad >= self.wide_rad {
            return self.wide_rad;
        }
        let (narrow2, wide2) = (self.narrow_rad * self.narrow_rad, self.wide_rad * self.wide_rad);
        let cosine = self.wide.dot(direction);
        (narrow2 + (wide2 - narrow2) * cosine * cosine).sqrt()
    }

    /// Round cones side by side that together are about as spread, each by its direction and angle, and the share of each.
    pub(crate) fn round_parts(self, along: DVec3) -> (impl Iterator<Item = (DVec3, f64)>, f64) {
        let count =
            (self.wide_rad / self.narrow_rad.max(FINEST_RAD)).round().clamp(1.0, MOST_PARTS);
        let step_rad = LINE * self.wide_rad / count;
        let spread_rad = if count > 1.0 { self.narrow_rad.max(step_rad) } else { self.mean_rad };
        let part = move |i: usize| {
            let aside = libm::tan(((i as f64 + 0.5) - 0.5 * count) * step_rad);
            let along = if count > 1.0 { (along + self.wide * aside).normalize() } else { along };
            (along, spread_rad)
        };
        ((0..count as usize).map(part), 1.0 / count)
    }

    /// Its greatest angle.
    pub fn wide_rad(&self) -> f64 {
        self.wide_rad
    }

    /// The angle of a round cone of the same solid angle.
    pub fn mean_rad(&self) -> f64 {
        self.mean_rad
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_parts_are_as_spread_as_the_cone() {
        let cone = Cone::stretched(0.01, 0.06, DVec3::X);
        let (parts, share) = cone.round_parts(DVec3::Z);
        // The mean square of an even disc along a line is a sixteenth of its angle's.
        let square = |(along, spread_rad): (DVec3, f64)| {
            share * (libm::asin(along.x).powi(2) + spread_rad * spread_rad / 16.0)
        };
        let wide_rad = (16.0 * parts.map(square).sum::<f64>()).sqrt();
        assert!((wide_rad / cone.along_rad(DVec3::X) - 1.0).abs() < 0.02, "{wide_rad}");
        assert!((cone.along_rad(DVec3::Y) - 0.01).abs() < 1e-15);
    }
}
