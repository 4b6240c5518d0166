//! A pearl's outer layers at one place.
//!
//! Filled in by whoever knows a part of it; parts add up.
//! Left out: what they do with light.

use glam::DVec3;

use crate::coat::rulings::Rulings;

/// A pearl's outer layers at one place, as wide as what is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Local {
    /// Slope of the surface against the pearl's own: the gradient of its height, outward, along the surface.
    pub slope: DVec3,
    /// Mean square of the slopes that are finer than what is looked at.
    pub fine_slope2: f64,
    /// Factor on the thickness of the layers.
    pub thickness: f64,
    /// Share of chalk: matt, without layers.
    pub chalk: f64,
    /// Factor on light from inside.
    pub inside: f64,
    /// Terraces, where there are some too fine to be seen apart.
    pub rulings: Option<Rulings>,
}

impl Local {
    /// As everywhere on an even pearl.
    pub const EVEN: Self = Self {
        slope: DVec3::ZERO,
        fine_slope2: 0.0,
        thickness: 1.0,
        chalk: 0.0,
        inside: 1.0,
        rulings: None,
    };

    /// Both at the same place.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            slope: self.slope + other.slope,
            fine_slope2: self.fine_slope2 + other.fine_slope2,
            thickness: self.thickness * other.thickness,
            chalk: 1.0 - (1.0 - self.chalk) * (1.0 - other.chalk),
            inside: self.inside * other.inside,
            rulings: self.rulings.or(other.rulings),
        }
    }

    /// The surface's normal, where the pearl's own is `outward`; turned as far towards the eye as it takes to be seen.
    pub(crate) fn normal(&self, outward: DVec3, view: DVec3) -> DVec3 {
        let normal = (outward - self.slope).normalize();
        let hidden = LEAST_COSINE - normal.dot(view);
        if hidden > 0.0 { (normal + view * hidden).normalize() } else { normal }
    }
}

/// Cosine of the view angle below which a slope hides behind others **(ours)**.
const LEAST_COSINE: f64 = 0.02;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_leans_the_normal_downhill() {
        let local = Local { slope: DVec3::new(0.1, 0.0, 0.0), ..Local::EVEN };
        let normal = local.normal(DVec3::Z, DVec3::Z);
        assert!((normal.x / normal.z + 0.1).abs() < 1e-12 && normal.y == 0.0);
        assert_eq!(Local::EVEN.normal(DVec3::Y, DVec3::Y), DVec3::Y);
    }

    #[test]
    fn what_leans_away_from_the_eye_is_seen_at_a_grazing_angle() {
        let local = Local { slope: DVec3::new(0.0, 0.0, 0.5), ..Local::EVEN };
        let normal = local.normal(DVec3::X, DVec3::Z);
        assert!(normal.dot(DVec3::Z) > 0.0 && normal.dot(DVec3::Z) < 0.05);
    }
}
