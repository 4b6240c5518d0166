//! What a satin pearl's facets show of the surroundings, worked out at knots.
//!
//! Cubics between knots (Catmull and Rom 1974); a lobe leaves no finer detail.
//! Left out: the film's colour, which changes faster and is left to the pixel.

use std::f64::consts::FRAC_PI_4;

use glam::DVec3;

use crate::{
    parallel,
    pearl::net::{Net, cubic},
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
    net: Net,
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

/// Steps of the grid for each standard deviation of the facets' lean **(ours)**: between knots the light is that
/// of a knot there to 0.01 of it (the test below).
const STEPS_PER_SPREAD: f64 = 1.4;

/// The cache's share of the facets that it spares, and how many a knot has; by eye **(ours)**.
const SHARE: f64 = 0.25;
const FEWEST: f64 = 96.0;
const MOST: usize = 1024;

/// A cache to be made: its net, and what works a knot out.
pub(crate) struct CachePlan<'a> {
    net: Net,
    knot: Box<dyn Fn(DVec3) -> Around + Sync + 'a>,
}

impl<'a> CachePlan<'a> {
    /// `None` where the ball's pixels would look at fewer facets, `facets` in all, than a good cache's knots. What is `seen` are
    /// the normals within an angle of an axis. `gather` works out a knot for a normal and samples of facets.
    pub(crate) fn new(
        seen: (DVec3, f64),
        lobe: &Facets<'_>,
        facets: f64,
        gather: impl Fn(DVec3, &[FacetSample]) -> Around + Sync + 'a,
    ) -> Option<Self> {
        let half = libm::ceil(seen.1 * STEPS_PER_SPREAD / lobe.spread_rad()) as usize;
        let net = Net::new(seen, half);
        let knots = net.side() * net.side();
        // The knots lie in the disc; those beside it cost nothing.
        let each = SHARE * facets / (FRAC_PI_4 * knots as f64);
        if each < FEWEST {
            return None;
        }
        let samples = lobe.lattice((each as usize).min(MOST));
        Some(Self { net, knot: Box::new(move |normal| gather(normal, &samples)) })
    }

    /// All of it.
    pub(crate) fn cache(self) -> ReflectionCache {
        let knots = self.part(0, 1);
        ReflectionCache { net: self.net, knots }
    }

    /// Every `parts`-th knot from number `part` on.
    pub(crate) fn part(&self, part: usize, parts: usize) -> Vec<Around> {
        let knot = |i: usize| self.net.normal(part + i * parts).map(&self.knot).unwrap_or_default();
        let count = (self.net.side() * self.net.side()).saturating_sub(part).div_ceil(parts);
        parallel::map(count, knot)
    }

    /// Knots in all.
    pub(crate) fn knots(&self) -> usize {
        self.net.side() * self.net.side()
    }

    /// Of knots worked out elsewhere, all of them in their order.
    pub(crate) fn with(self, knots: Vec<Around>) -> ReflectionCache {
        ReflectionCache { net: self.net, knots }
    }
}

impl ReflectionCache {
    /// What the facets show at a point of the ball.
    pub(crate) fn at(&self, normal: DVec3) -> Around {
        let [x, y] = self.net.place(normal);
        // Both positive, so `as` rounds down.
        let (left, top) = (x as usize, y as usize);
        let (across, down) = (cubic(x - left as f64), cubic(y - top as f64));
        let mut sum = Around::default();
        for (j, b) in down.iter().enumerate() {
            let row = (top + j - 1) * self.net.side() + left - 1;
            for (knot, a) in self.knots[row..row + 4].iter().zip(across) {
                rgb::add(&mut sum.light, rgb::scaled(knot.light, a * b));
                rgb::add(&mut sum.rest, rgb::scaled(knot.rest, a * b));
            }
        }
        sum
    }
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
        let plan = CachePlan::new(
            (axis, libm::acos(4.0 / far_mm)),
            &Facets::new(Microfacets::grooves(spread_rad), None),
            1e7,
            gather,
        );
        plan.map(CachePlan::cache)
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
