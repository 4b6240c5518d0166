//! The hole along a pearl's axis, and its worn edge.
//!
//! A hole keeps nearly all light that falls in; at its edge the layers are worn down to a bevel.
//! Left out: light on the hole's walls, which a string hides.

use glam::DVec3;

use crate::coat::local::Local;

/// A hole drilled through along the axis of growth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drill {
    /// Radius of the hole; none where it is 0.
    pub radius_mm: f64,
    /// Width of its worn edge.
    pub wear_mm: f64,
}

/// What a hole sends back of what a matt place there would **(ours)**.
const LEFT: f64 = 0.03;
/// Slope of the bevel at the hole: 45 degrees **(ours)**.
const STEEPEST: f64 = 1.0;
/// Share of worn nacre at the hole that is matt **(ours)**.
const WORN: f64 = 0.6;

impl Drill {
    /// No hole.
    pub const NONE: Self = Self { radius_mm: 0.0, wear_mm: 0.0 };

    /// The place in a direction, the axis z, so far from the middle and as wide as `footprint_mm`; `None` beside hole and
    /// edge.
    pub(crate) fn at(&self, own: DVec3, away_mm: f64, footprint_mm: f64) -> Option<Local> {
        let aside = own.truncate();
        let from_axis_mm = aside.length() * away_mm;
        let from_edge_mm = from_axis_mm - self.radius_mm;
        let soft_mm = footprint_mm.max(1e-9);
        if from_edge_mm > self.wear_mm.max(0.5 * soft_mm) {
            return None;
        }
        let hole = (0.5 - from_edge_mm / soft_mm).clamp(0.0, 1.0);
        let worn = if self.wear_mm > 0.0 && from_edge_mm < self.wear_mm {
            (1.0 - from_edge_mm.max(0.0) / self.wear_mm) * (1.0 - hole)
        } else {
            0.0
        };
        let away = DVec3::new(aside.x, aside.y, 0.0).normalize_or_zero();
        let away = away - own * away.dot(own);
        Some(Local {
            slope: away * (STEEPEST * worn * worn),
            chalk: 1.0 - (1.0 - hole) * (1.0 - WORN * worn * worn),
            inside: 1.0 - hole * (1.0 - LEFT),
            ..Local::EVEN
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DRILL: Drill = Drill { radius_mm: 0.4, wear_mm: 0.1 };

    fn at(from_axis_mm: f64) -> Option<Local> {
        let sin = from_axis_mm / 4.0;
        DRILL.at(DVec3::new(sin, 0.0, (1.0 - sin * sin).sqrt()), 4.0, 0.01)
    }

    #[test]
    fn a_hole_is_dark_its_edge_leans_in_and_beside_it_all_is_as_it_was() {
        let hole = at(0.2).unwrap();
        assert!(hole.inside < 0.05 && hole.chalk > 0.999);
        let edge = at(0.42).unwrap();
        assert!(edge.slope.x > 0.3 && edge.inside > 0.999 && edge.chalk < 0.7);
        assert!(at(0.52).is_none());
    }

    #[test]
    fn an_edge_without_wear_neither_leans_nor_turns_matt() {
        let drill = Drill { wear_mm: 0.0, ..DRILL };
        for from_axis_mm in [0.0, 0.2, 0.396, 0.4, 0.404] {
            let sin = from_axis_mm / 4.0;
            let local =
                drill.at(DVec3::new(sin, 0.0, (1.0_f64 - sin * sin).sqrt()), 4.0, 0.01).unwrap();
            assert_eq!(local.slope, DVec3::ZERO, "{from_axis_mm}");
            let hole = (1.0 - local.inside) / (1.0 - LEFT);
            assert!((local.chalk - hole).abs() < 1e-12, "{from_axis_mm}");
        }
    }

    #[test]
    fn a_hole_covers_its_share_of_coarse_pixels() {
        // Along a line across it, whatever a pixel's width.
        for footprint_mm in [0.01, 0.05, 0.1] {
            let drill = Drill { wear_mm: 0.0, ..DRILL };
            let step = 1e-4;
            let dark: f64 = (0..6000)
                .map(|i| (f64::from(i) + 0.5) * step)
                .filter_map(|r| drill.at(DVec3::new(r / 4.0, 0.0, 1.0), 4.0, footprint_mm))
                .map(|local| (1.0 - local.inside) / (1.0 - LEFT) * step)
                .sum();
            assert!((dark - 0.4).abs() < 1e-3, "{footprint_mm}: {dark}");
        }
    }
}
