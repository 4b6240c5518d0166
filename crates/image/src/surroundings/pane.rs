//! A window as it stands before one point.
//!
//! A Gaussian cone against four straight edges.
//! Left out: that a cone wider than a corner sees it sharp.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use glam::DVec3;

use crate::{rgb::Rgb, view::cone::Cone};

/// A window as it stands before one point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pane {
    /// Normals of the planes through the point and each edge, in a round, towards the window's middle.
    pub(crate) inward: [DVec3; 4],
    pub(crate) facing: DVec3,
    pub(crate) in_front_mm: f64,
    pub(crate) farthest_mm: f64,
    pub(crate) radiance: Rgb,
}

impl Pane {
    /// (distance, share) of a cone of light around `along` that comes from the window, if any.
    ///
    /// The cone is a Gaussian as wide, in the mean square, as an even ellipse of its angles; the share is
    /// the product of what two pairs of opposite edges let in, each a great circle to the ray and straight
    /// to the cone. Exact for narrow cones; a cone too wide for the window's corners sees them a little
    /// round **(ours)**.
    pub(crate) fn seen(&self, along: DVec3, cone: &Cone) -> Option<(f64, f64)> {
        let reach_rad = CUT * 0.25 * cone.wide_rad().max(FINEST_RAD);
        let mut inside = [0.0; 4];
        for (inward, inside) in self.inward.iter().zip(&mut inside) {
            *inside = inward.dot(along);
            if *inside < -reach_rad {
                return None;
            }
        }
        let part = |edge: usize| {
            let sine = inside[edge];
            if sine > reach_rad {
                1.0
            } else {
                let sigma_rad = 0.25 * cone.along_rad(self.inward[edge]).max(FINEST_RAD);
                libm::erf(libm::asin(sine.clamp(-1.0, 1.0)) / sigma_rad * FRAC_1_SQRT_2)
            }
        };
        let between = |one: usize, other: usize| (0.5 * (part(one) + part(other))).max(0.0);
        let share = between(0, 2) * between(1, 3);
        let toward = -along.dot(self.facing);
        let distance_mm = if toward > 0.0 { self.in_front_mm / toward } else { f64::INFINITY };
        (share > 0.0).then_some((distance_mm.min(self.farthest_mm), share))
    }

    /// Whether one of its edges may lie within an angle of a direction.
    pub(crate) fn has_edge_within(&self, along: DVec3, within_rad: f64) -> bool {
        let sine = libm::sin(within_rad.min(FRAC_PI_2));
        self.is_within(along, within_rad) && self.inward.iter().any(|i| i.dot(along) < sine)
    }

    /// Whether any of it may lie within an angle of a direction.
    pub(crate) fn is_within(&self, along: DVec3, within_rad: f64) -> bool {
        let sine = libm::sin(within_rad.min(FRAC_PI_2));
        self.inward.iter().all(|inward| inward.dot(along) >= -sine)
    }
}

/// Cones are at least this wide, so that an edge has a width to fade over.
const FINEST_RAD: f64 = 1e-9;
/// Beyond this many standard deviations a Gaussian is nothing.
const CUT: f64 = 6.0;
