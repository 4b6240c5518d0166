//! What pearls mirror to a camera, where that is cached; how wide a pixel is at each.
//!
//! By `pearl/reflection_cache.rs`, for pearls that are satin.
//! Left out: pearls whose pixels are coarser than a cache.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    pearl::{
        model::Model,
        reflection_cache::{Around, Arounds, CachePlan, ReflectionCache},
    },
    surroundings::lit::Lit,
    view::camera::Camera,
};

/// What satin pearls show a camera of their surroundings, each in its place; they have no detail that would
/// have to be worked out at every pixel.
#[derive(Debug)]
pub struct Reflections(Vec<Vec<Option<ReflectionCache>>>);

impl Reflections {
    /// Of `models[i]` as the ball `surroundings.balls[i]`, for a picture of `size_px` pixels a side.
    pub fn new(models: &[Arc<Model>], surroundings: &Lit, camera: &Camera, size_px: usize) -> Self {
        let plans = plans(models, surroundings, camera, size_px);
        let made = |plan: Option<CachePlan<'_>>| plan.map(CachePlan::cache);
        Self(plans.into_iter().map(|plans| plans.into_iter().map(made).collect()).collect())
    }

    /// A share of the work on them, for the same reflections elsewhere: every `parts`-th knot from number `part` on.
    pub fn part(
        models: &[Arc<Model>],
        surroundings: &Lit,
        (camera, size_px): (&Camera, usize),
        (part, parts): (usize, usize),
    ) -> Vec<f64> {
        let plans = plans(models, surroundings, camera, size_px);
        let knots = plans.iter().flatten().flatten().flat_map(|plan| plan.part(part, parts));
        knots.flat_map(|Around { light, rest }| light.into_iter().chain(rest)).collect()
    }

    /// Of what [`Reflections::part`] gave of each part; `None` where these are not all of them.
    pub fn joined(
        models: &[Arc<Model>],
        surroundings: &Lit,
        (camera, size_px): (&Camera, usize),
        parts: &[&[f64]],
    ) -> Option<Self> {
        let mut rest: Vec<_> = parts.iter().map(|part| part.chunks_exact(6)).collect();
        let count = rest.len();
        let mut knot = |number: usize| {
            let part = rest.get_mut(number.checked_rem(count)?)?;
            let &[a, b, c, d, e, f] = part.next()? else { return None };
            Some(Around { light: [a, b, c], rest: [d, e, f] })
        };
        let mut made = Vec::with_capacity(models.len());
        for plans in plans(models, surroundings, camera, size_px) {
            let mut caches = Vec::with_capacity(plans.len());
            for plan in plans {
                let Some(plan) = plan else {
                    caches.push(None);
                    continue;
                };
                let knots = (0..plan.knots()).map(&mut knot).collect::<Option<Vec<_>>>()?;
                caches.push(Some(plan.with(knots)));
            }
            made.push(caches);
        }
        rest.iter().all(|rest| rest.len() == 0).then_some(Self(made))
    }

    /// Of so many pearls, each to be worked out pixel by pixel.
    pub fn none(pearls: usize) -> Self {
        Self((0..pearls).map(|_| Vec::new()).collect())
    }

    /// Whether all that a ball mirrors is cached.
    pub(super) fn are_cached(&self, ball: usize) -> bool {
        !self.0[ball].is_empty() && self.0[ball].iter().all(Option::is_some)
    }

    /// What is cached of the surroundings that a ball's facets show at a point.
    pub(super) fn around(&self, ball: usize, normal: DVec3) -> Arounds {
        let mut around = Arounds::default();
        for (known, cache) in around.iter_mut().zip(&self.0[ball]) {
            *known = cache.as_ref().map(|cache| cache.at(normal));
        }
        around
    }
}

/// The caches of each pearl's lobes.
fn plans<'a>(
    models: &'a [Arc<Model>],
    surroundings: &'a Lit,
    camera: &'a Camera,
    size_px: usize,
) -> Vec<Vec<Option<CachePlan<'a>>>> {
    let pixel_mm = pixels_mm(surroundings, camera, size_px);
    let of = |(i, model): (usize, &'a Arc<Model>)| {
        model.reflection_caches(surroundings, i, camera, pixel_mm[i])
    };
    models.iter().enumerate().map(of).collect()
}

/// Width of a pixel at each ball.
pub(crate) fn pixels_mm(surroundings: &Lit, camera: &Camera, size_px: usize) -> Vec<f64> {
    let width_mm = |centre| camera.cell_mm(size_px) * camera.scale_at(centre).max(0.0);
    surroundings.balls.iter().map(|ball| width_mm(ball.centre)).collect()
}
