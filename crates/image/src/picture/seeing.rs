//! A point of a pearl under the eye, filled in for its pearl: curvature, relief, what is known of its surroundings.
//!
//! Once a sample; curvature once a pixel.
//! Left out: how curvature changes within a pixel.

use glam::DVec3;

use crate::{
    coat::local::Local,
    pearl::sight::{Sight, Spread},
    picture::{sampler::Sampler, view::View},
    shape::ball::Hit,
    view::ray::Ray,
};

impl Sampler {
    /// What a point of a ball mirrors to so many pixels' width of the picture.
    pub(super) fn spread(&self, ball: usize, hit: &Hit, view: DVec3, width_px: f64) -> Spread {
        self.bent_spread(ball, hit, self.surroundings.bend(ball, hit, view), width_px)
    }

    /// The same where the surface's curvature is known.
    pub(super) fn bent_spread(
        &self,
        ball: usize,
        hit: &Hit,
        bend: [f64; 2],
        width_px: f64,
    ) -> Spread {
        let width = width_px * self.pixel_mm[ball] / self.surroundings.balls[ball].radius_mm;
        Spread::of_bent(width, hit.cos_view, bend)
    }

    /// The curvature of a ball where a sample sees it, worked out once a pixel; and how far off that is.
    pub(super) fn bend(&self, ball: usize, hit: &Hit, ray: &Ray, view: &mut View) -> [f64; 2] {
        if self.surroundings.solid(ball).is_none() {
            return [1.0; 2];
        }
        let far_mm = hit.point.distance(ray.from);
        let [near, far] = view.reach_mm.unwrap_or([far_mm; 2]);
        view.reach_mm = Some([near.min(far_mm), far.max(far_mm)]);
        let worked_out = || self.surroundings.bend(ball, hit, -ray.along);
        if view.balls.len() > 1 {
            return worked_out();
        }
        *view.bend.get_or_insert_with(worked_out)
    }

    /// A point of a ball under the eye, with the relief of its coat.
    pub(super) fn sight(
        &self,
        (ball, hit): (usize, Hit),
        view: DVec3,
        spread: Spread,
        part: (usize, usize),
    ) -> Sight {
        let (pearl, pixel_mm) = (&self.pearls[ball], self.pixel_mm[ball]);
        let outward = self.surroundings.outward(ball, &hit);
        if !pearl.skin.has_relief() {
            let (local, grain) = (Local::EVEN, None);
            let around = self.reflections.around(ball, hit.normal);
            return Sight {
                ball,
                hit,
                outward,
                local,
                grain,
                view,
                pixel_mm,
                spread,
                part,
                around,
            };
        }
        let place = &self.surroundings.balls[ball];
        let lengths_mm = [hit.point.distance(place.centre), pixel_mm];
        let (local, grain) = pearl.skin.local((outward, hit.cos_view), place.radius_mm, lengths_mm);
        let normal = local.normal(hit.normal, view);
        let hit = Hit { normal, cos_view: normal.dot(view), ..hit };
        let spread = spread.over_slopes(local.fine_slope2);
        let around = self.reflections.around(ball, normal);
        Sight { ball, hit, outward, local, grain, view, pixel_mm, spread, part, around }
    }
}
