//! The light that a ball sends out, by direction.
//!
//! Spherical harmonics to the second order, by Gauss and Legendre's rule.
//! Left out: from which part of the ball it comes, and finer detail.

use std::f64::consts::PI;

use glam::DVec3;

use crate::{harmonics::second_order::SecondOrder, rgb::Rgb};

/// The light that a ball sends out as its neighbours see it: the mean radiance of its disc, by the
/// direction that it is seen from. Nine spherical harmonics **(ours)**: what lights a table or is
/// mirrored in the next pearl is spread too widely for finer detail to matter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glow(SecondOrder);

impl Glow {
    /// A ball that sends out nothing.
    pub const BLACK: Self = Self(SecondOrder::ZERO);

    /// The nearest to `radiance`, which is asked for directions towards the viewer, 72 of them. Exact
    /// for what nine harmonics can say.
    pub fn from_fn(radiance: impl Fn(DVec3) -> Rgb) -> Self {
        Self(SecondOrder::nearest_to(directions().map(|(to, share)| (to, share, radiance(to)))))
    }

    /// The mean of several, each by its weight; the weights add up to 1.
    pub(crate) fn mean(glows: impl Iterator<Item = (f64, Self)>) -> Self {
        let mut sum = SecondOrder::ZERO;
        for (weight, glow) in glows {
            sum.add(&glow.0, weight);
        }
        Self(sum)
    }

    /// Whether no direction shows another light than `other` does, by more than so much.
    pub fn is_near(&self, other: &Self, by: f64) -> bool {
        let apart = |(a, b): (f64, f64)| (a - b).abs();
        let near = |(towards, _): (DVec3, f64)| {
            self.at(towards).into_iter().zip(other.at(towards)).map(apart).all(|apart| apart <= by)
        };
        directions().all(near)
    }

    /// Mean radiance shown to a viewer in a direction (a unit vector from the ball).
    pub fn at(&self, towards_viewer: DVec3) -> Rgb {
        self.0.at(towards_viewer, &[1.0; 9]).map(|channel| channel.max(0.0))
    }
}

/// Gauss and Legendre's six nodes between -1 and 1, the positive half, and their weights.
const NODES: [(f64, f64); 3] = [
    (0.238_619_186_083_196_9, 0.467_913_934_572_691),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_35),
];
/// Even steps around the upright axis.
const STEPS: u32 = 12;

/// Directions with their shares of the sphere, by which polynomials up to degree 11 are summed exactly.
fn directions() -> impl Iterator<Item = (DVec3, f64)> {
    let both = NODES.into_iter().flat_map(|(y, weight)| [(y, weight), (-y, weight)]);
    both.flat_map(|(y, weight)| {
        let flat = (1.0 - y * y).sqrt();
        (0..STEPS).map(move |step| {
            let (sin, cos) = libm::sincos(2.0 * PI * (f64::from(step) + 0.5) / f64::from(STEPS));
            (DVec3::new(flat * sin, y, flat * cos), 0.5 * weight / f64::from(STEPS))
        })
    })
}

/// Rings of equal area, with so many points each, that stand for a ball's disc **(ours)**.
const RINGS: usize = 4;
const SPOKES: usize = 16;

/// So many points stand for a ball's disc as seen from one direction.
pub(crate) const DISC_POINTS: usize = RINGS * SPOKES;

/// One of them, on a disc of radius 1.
pub(crate) fn on_disc(point: usize) -> [f64; 2] {
    let (ring, spoke) = (point / SPOKES, point % SPOKES);
    let radius = ((ring as f64 + 0.5) / RINGS as f64).sqrt();
    let (sin, cos) = libm::sincos(2.0 * PI * (spoke as f64 + 0.5) / SPOKES as f64);
    [radius * cos, radius * sin]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_nine_harmonics_can_say_comes_back_exactly() {
        let light = |d: DVec3| [1.0 + 0.2 * d.x, 2.0 + d.x * d.y - 0.3 * d.z, 1.0 + d.y * d.y];
        let glow = Glow::from_fn(light);
        for direction in [DVec3::X, DVec3::NEG_Y, DVec3::new(0.48, 0.6, -0.64)] {
            let (got, put) = (glow.at(direction), light(direction));
            assert!(got.iter().zip(put).all(|(a, b)| (a - b).abs() < 1e-12), "{got:?} {put:?}");
        }
    }

    #[test]
    fn light_is_never_negative() {
        let lamp = Glow::from_fn(|d| [if d.y > 0.9 { 1.0 } else { 0.0 }; 3]);
        for (direction, _) in directions() {
            assert!(lamp.at(direction)[0] >= 0.0);
        }
        assert!(Glow::BLACK.at(DVec3::Y).iter().all(|channel| *channel == 0.0));
    }
}
