//! What a pixel may show: which pearls, and how much detail.
//!
//! By where pearls lie, what they mirror, and how fine pixels are against that.
//! Left out: a part of a pearl that stands before another by less than a step.

use crate::{
    coat::local::Local,
    pearl::{model::Model, reflection_cache::Arounds, sight::Sight},
    picture::{
        detail::{Detail, FEWEST_ALIKE, FINE, RIM, RIM_PX},
        sampler::Sampler,
        view::View,
    },
    surroundings::lit::Lit,
    view::ray::Ray,
};

/// So near to a silhouette, in pixels, a pixel has to know how far off it is.
const NEAR_PX: f64 = 4.0;

/// Places of one pixel that lie farther apart than this share of a pearl's radius are of different parts of it **(ours)**.
const STEP: f64 = 0.08;

/// Width of an even disc that spreads as a pixel's tent does.
const PIXEL_PX: f64 = 1.633;

impl Sampler {
    /// The balls that a pixel may show.
    pub(super) fn find(&self, row: usize, column: usize, balls: &[usize], view: &mut View) {
        let ray = self.ray((row, column), 0.0, 0.0);
        view.balls.clear();
        view.inside_mm.clear();
        view.known.clear();
        for &ball in balls {
            let aside_mm = 2.0 * self.pixel_mm[ball];
            if !self.surroundings.is_passed(ball, &ray, aside_mm) {
                let near_mm = NEAR_PX * self.pixel_mm[ball];
                let (inside_mm, known) = self.surroundings.inside_mm(ball, &ray, near_mm);
                if inside_mm > -aside_mm {
                    view.balls.push(ball);
                    view.inside_mm.push(inside_mm);
                    view.known.push(known);
                }
            }
        }
        view.clear();
    }

    /// What detail a pixel may have.
    pub(super) fn detail(&self, row: usize, column: usize, view: &View) -> Detail {
        let many = self.samples_side() >= FEWEST_ALIKE;
        let ray = self.ray((row, column), 0.0, 0.0);
        let crossed =
            |(&ball, inside_mm): (&usize, &f64)| inside_mm.abs() < RIM_PX * self.pixel_mm[ball];
        if view.balls.iter().zip(&view.inside_mm).any(crossed) {
            return Detail::Rim;
        }
        let ball = match view.balls[..] {
            [] if many => return Detail::Unknown,
            [ball] => ball,
            [] | [_, _, ..] => return Detail::Edges,
        };
        let (radius_mm, pixel_mm) = (self.surroundings.balls[ball].radius_mm, self.pixel_mm[ball]);
        let rim_mm = view.inside_mm[0];
        if rim_mm <= 3.0 * pixel_mm {
            return Detail::Rim;
        }
        let cached = self.reflections.are_cached(ball);
        if !self.pearls[ball].model.is_smooth() {
            return if many { Detail::Unknown } else { Detail::Edges };
        }
        if self.pearls[ball].skin.has_fine_relief() {
            return if cached { Detail::BelowPixel } else { Detail::Edges };
        }
        let hides = self.surroundings.hides_itself(ball);
        if cached && !hides && rim_mm > RIM * radius_mm && pixel_mm < FINE * radius_mm {
            Detail::None
        } else if !cached && self.shows(ball, &ray, Model::has_edges) {
            Detail::Edges
        } else {
            Detail::BelowPixel
        }
    }

    /// Whether a pixel around a line of sight shows something of what a ball mirrors.
    pub(super) fn shows(
        &self,
        ball: usize,
        ray: &Ray,
        something: impl Fn(&Model, &Lit, &Sight) -> bool,
    ) -> bool {
        let pixel_mm = self.pixel_mm[ball];
        let hit = self.surroundings.nearest(ball, ray);
        let spread = self.spread(ball, &hit, -ray.along, PIXEL_PX);
        let (view, part, around) = (-ray.along, (0, 1), Arounds::default());
        let outward = self.surroundings.outward(ball, &hit);
        let (local, grain) = (Local::EVEN, None);
        let sight =
            Sight { ball, hit, outward, local, grain, view, pixel_mm, spread, part, around };
        something(&self.pearls[ball].model, &self.surroundings, &sight)
    }

    /// Whether one part of a pearl stood before another in the samples.
    pub(super) fn shows_steps(&self, view: &View) -> bool {
        let (Some([near_mm, far_mm]), &[ball]) = (view.reach_mm, &view.balls[..]) else {
            return false;
        };
        far_mm - near_mm
            > (STEP * self.surroundings.balls[ball].radius_mm).max(2.0 * self.pixel_mm[ball])
    }
}
