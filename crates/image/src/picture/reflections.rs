//! What pearls mirror to a camera, where that is cached; how wide a pixel is at each.
//!
//! By `pearl/reflection_cache.rs`, for pearls that are satin.
//! Left out: pearls whose pixels are coarser than a cache.

use glam::DVec3;

use crate::{
    pearl::{
        model::Pearl,
        reflection_cache::{Arounds, ReflectionCache},
    },
    surroundings::lit::Lit,
    view::camera::Camera,
};

/// What satin pearls show a camera of their surroundings, each in its place; they have no detail that would
/// have to be worked out at every pixel.
#[derive(Debug)]
pub struct Reflections(Vec<Vec<Option<ReflectionCache>>>);

impl Reflections {
    /// Of `pearls[i]` as the ball `surroundings.balls[i]`, for a picture of `size_px` pixels a side.
    pub fn new(pearls: &[Pearl], surroundings: &Lit, camera: &Camera, size_px: usize) -> Self {
        let pixel_mm = pixels_mm(surroundings, camera, size_px);
        let of = |(i, pearl): (usize, &Pearl)| {
            pearl.model.reflection_caches(surroundings, i, camera, pixel_mm[i])
        };
        Self(pearls.iter().enumerate().map(of).collect())
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

/// Width of a pixel at each ball.
pub(crate) fn pixels_mm(surroundings: &Lit, camera: &Camera, size_px: usize) -> Vec<f64> {
    let width_mm = |centre| camera.cell_mm(size_px) * camera.scale_at(centre).max(0.0);
    surroundings.balls.iter().map(|ball| width_mm(ball.centre)).collect()
}
