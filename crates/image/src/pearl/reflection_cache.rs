//! What a satin pearl's facets show of the surroundings, worked out at knots.
//!
//! Cubics between knots (Catmull and Rom 1974); a lobe leaves no finer detail.
//! Left out: the film's colour, which changes faster and is left to the pixel.

use std::f64::consts::FRAC_PI_4;

use glam::DVec3;

use crate::{
    parallel,
    rgb::{self, Rgb},
    surface::{facets::Facets, sampling::FacetSample},
};

/// What a satin pearl's facets show of the surroundings, cached at the knots of a grid over the side that the eye
/// sees, with cubics between them.
///
/// The facets blur whatever they mirror: a picture of it has no detail finer than their spread, and need not
/// be worked out at every pixel. What the film makes of it changes faster, and is left to the pixel.
#[derive(Debug)]
pub(crate) struct ReflectionCache {
    /// From the ball's centre to the eye, and two directions across.
    axis: DVec3,
    across: [DVec3; 2],
    /// Angle between the axis and the last points that the eye sees.
    reach_rad: f64,
    side: usize,
    knots: Vec<Around>,
}

/// The surroundings as all facets together show them to the eye.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Around {
    /// Their mean light, before the film.
    pub light: Rgb,
    /// What the film mirrors beyond what it would if they were even.
    pub rest: Rgb,
}

/// What each lobe shows, where that is known: the surface's, and the layers'.
pub type Arounds = [Option<Around>; 2];

/// Knots beyond the edge on each side, for the cubics.
const BORDER: usize = 2;

/// Steps of the grid for each standard deviation of the facets' lean **(ours)**: between knots the light is that
/// of a knot there to 0.01 of it (the test below).
const STEPS_PER_SPREAD: f64 = 1.4;

/// The cache's share of the facets that it spares, and how many a knot has; by eye **(ours)**.
const SHARE: f64 = 0.25;
const FEWEST: f64 = 96.0;
const MOST: usize = 1024;

impl ReflectionCache {
    /// `None` where the ball's pixels would look at fewer facets, `facets` in all, than a good cache's knots. The eye sees
    /// normals within `reach_rad` of `axis`. `gather` works out a knot for a normal and samples of facets.
    pub(crate) fn new(
        (axis, reach_rad): (DVec3, f64),
        lobe: &Facets<'_>,
        facets: f64,
        gather: impl Fn(DVec3, &[FacetSample]) -> Around + Sync,
    ) -> Option<Self> {
        let half = libm::ceil(reach_rad * STEPS_PER_SPREAD / lobe.spread_rad()) as usize;
        let side = 2 * (half + BORDER) + 1;
        // The knots lie in the disc; those beside it cost nothing.
        let each = SHARE * facets / (FRAC_PI_4 * (side * side) as f64);
        if each < FEWEST {
            return None;
        }
        let samples = lobe.lattice((each as usize).min(MOST));
        let (u, v) = axis.any_orthonormal_pair();
        let mut cache = Self { axis, across: [u, v], reach_rad, side, knots: Vec::new() };
        let knot = |i: usize| {
            let at = |i: usize| (i as f64 - (half + BORDER) as f64) / half as f64;
            let normal = cache.normal(at(i % side), at(i / side))?;
            Some(gather(normal, &samples))
        };
        cache.knots = parallel::map(side * side, |i| knot(i).unwrap_or_default());
        Some(cache)
    }

    /// The normal at a place of the grid; the edge of what the eye sees has radius 1. Beyond it, where cubics
    /// need knots, the edge's goes on; `None` where none is needed.
    fn normal(&self, x: f64, y: f64) -> Option<DVec3> {
        let radius = (x * x + y * y).sqrt();
        let needed = 1.0 + 3.0 * (2 * BORDER) as f64 / self.side as f64;
        if radius > needed {
            return None;
        }
        let (sin, cos) = libm::sincos(radius.min(1.0) * self.reach_rad);
        let outward = (self.across[0] * x + self.across[1] * y) / radius.max(1e-12);
        Some(self.axis * cos + outward * sin)
    }

    /// What the facets show at a point of the ball.
    pub(crate) fn at(&self, normal: DVec3) -> Around {
        let half = (self.side / 2 - BORDER) as f64;
        let [u, v] = self.across.map(|axis| normal.dot(axis));
        let radius = libm::acos(normal.dot(self.axis).clamp(-1.0, 1.0)) / self.reach_rad;
        let scale = radius.min(1.0) * half / (u * u + v * v).sqrt().max(1e-12);
        let middle = (self.side / 2) as f64;
        let (x, y) = (middle + u * scale, middle + v * scale);
        // Both positive, so `as` rounds down.
        let (left, top) = (x as usize, y as usize);
        let (across, down) = (cubic(x - left as f64), cubic(y - top as f64));
        let mut sum = Around::default();
        for (j, b) in down.iter().enumerate() {
            let row = (top + j - 1) * self.side + left - 1;
            for (knot, a) in self.knots[row..row + 4].iter().zip(across) {
                rgb::add(&mut sum.light, rgb::scaled(knot.light, a * b));
                rgb::add(&mut sum.rest, rgb::scaled(knot.rest, a * b));
            }
        }
        sum
    }
}

/// Weights of four neighbours at a place between the middle two (Catmull and Rom 1974).
fn cubic(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        0.5 * (2.0 * t2 - t3 - t),
        0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
        0.5 * (4.0 * t2 - 3.0 * t3 + t),
        0.5 * (t3 - t2),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        shape::ball::Ball,
        surface::microfacets::Microfacets,
        view::camera::{Camera, Projection},
    };

    fn wave(normal: DVec3) -> Rgb {
        [0, 1, 2].map(|i| 1.0 + libm::sin(8.0 * normal[i]))
    }

    fn cache(projection: Projection, spread_rad: f64) -> Option<ReflectionCache> {
        let camera = Camera::new(projection, 0.3, -0.5, 12.0);
        let gather =
            |normal: DVec3, _: &[FacetSample]| Around { light: wave(normal), rest: [normal.x; 3] };
        let (axis, far_mm) = camera.toward_eye(DVec3::ZERO);
        ReflectionCache::new(
            (axis, libm::acos(4.0 / far_mm)),
            &Facets::new(Microfacets::grooves(spread_rad), None),
            1e7,
            gather,
        )
    }

    #[test]
    fn between_knots_is_what_a_knot_there_would_be() {
        for projection in [Projection::Orthographic, Projection::Perspective { distance_mm: 60.0 }]
        {
            let cache = cache(projection, 0.1).unwrap();
            let camera = Camera::new(projection, 0.3, -0.5, 12.0);
            for i in 0..400 {
                let (x, y) = (f64::from(i % 20) / 14.0 - 0.68, f64::from(i / 20) / 14.0 - 0.68);
                let Some(hit) = Ball::alone(4.0).hit(&camera.ray(x, y)) else { continue };
                let found = cache.at(hit.normal).light;
                let expected = wave(hit.normal);
                assert!((0..3).all(|i| (found[i] - expected[i]).abs() < 0.01), "{hit:?} {found:?}");
            }
        }
    }

    #[test]
    fn a_mirror_has_no_cache() {
        assert!(cache(Projection::Orthographic, 0.01).is_none());
    }
}
