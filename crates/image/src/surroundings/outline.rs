//! Where lines of sight meet the pearls, round or not.
//!
//! A ball's answers in closed form; a solid's by following the line.
//! Left out: what the pearls do with light.

use glam::DVec3;

use crate::{
    shape::{ball::Hit, solid::Solid},
    surroundings::environment::Surroundings,
    view::ray::Ray,
};

impl Surroundings {
    /// The form of a pearl that is not round.
    pub(crate) fn solid(&self, ball: usize) -> Option<&Solid> {
        self.solids.get(ball)?.as_deref()
    }

    /// Where a line of sight meets a pearl.
    #[inline]
    pub(crate) fn hit(&self, ball: usize, ray: &Ray) -> Option<Hit> {
        let place = &self.balls[ball];
        match self.solid(ball) {
            None => place.hit(ray),
            Some(solid) => {
                let hit = solid.hit(ray.from - place.centre, ray.along)?;
                Some(Hit { point: hit.point + place.centre, ..hit })
            }
        }
    }

    /// Where it meets the pearl, or the place of the rim that is next to it.
    #[inline]
    pub(crate) fn nearest(&self, ball: usize, ray: &Ray) -> Hit {
        let place = &self.balls[ball];
        match self.solid(ball) {
            None => place.nearest(ray),
            Some(solid) => {
                let hit = solid.nearest(ray.from - place.centre, ray.along);
                Hit { point: hit.point + place.centre, ..hit }
            }
        }
    }

    /// The square of the cosine of the view angle along a line of sight where the pearl is a ball, and what changes across
    /// the rim as that does where it is none; below 0 where the line passes by.
    #[inline]
    pub(crate) fn view_square(&self, ball: usize, ray: &Ray) -> f64 {
        let place = &self.balls[ball];
        self.solid(ball).map_or_else(
            || place.cos_view_squared(ray),
            |solid| solid.square(ray.from - place.centre, ray.along),
        )
    }

    /// How far inside a pearl's silhouette a line of sight passes, about; negative beside it. Within `near_mm` of the
    /// silhouette it is right.
    pub(crate) fn inside_mm(&self, ball: usize, ray: &Ray, near_mm: f64) -> f64 {
        let (place, passing_mm) = (&self.balls[ball], self.balls[ball].passing_mm(ray));
        let Some(solid) = self.solid(ball) else { return place.radius_mm - passing_mm };
        let [least_mm, greatest_mm] = solid.reach_mm();
        if passing_mm < least_mm - near_mm || passing_mm > greatest_mm + near_mm {
            return if passing_mm < least_mm { least_mm } else { greatest_mm } - passing_mm;
        }
        place.radius_mm * (1.0 - (1.0 - self.view_square(ball, ray)).max(0.0).sqrt())
    }

    /// The direction from a pearl's middle to where it was met.
    #[inline]
    pub(crate) fn outward(&self, ball: usize, hit: &Hit) -> DVec3 {
        match self.solid(ball) {
            None => hit.normal,
            Some(_) => (hit.point - self.balls[ball].centre).normalize(),
        }
    }

    /// The least distance of a pearl's surface from its middle.
    pub(crate) fn least_mm(&self, ball: usize) -> f64 {
        self.solid(ball).map_or(self.balls[ball].radius_mm, |solid| solid.reach_mm()[0])
    }

    /// Curvature where a pearl is seen, over that of a ball: outward in the plane of view and normal, and across it.
    #[inline]
    pub(crate) fn bend(&self, ball: usize, hit: &Hit, view: DVec3) -> [f64; 2] {
        self.solid(ball)
            .map_or([1.0; 2], |solid| solid.bend(self.outward(ball, hit), hit.normal, view))
    }

    /// The place of a pearl that lies farthest out in a direction: that with this normal, where it bulges everywhere.
    pub(crate) fn farthest(&self, ball: usize, normal: DVec3) -> DVec3 {
        let place = &self.balls[ball];
        match self.solid(ball) {
            None => place.centre + normal * place.radius_mm,
            Some(solid) => place.centre + solid.surface(solid.farthest(normal)).0,
        }
    }

    /// The share of light towards a direction, `width_rad` wide, that a pearl hides from a place of its own.
    #[inline]
    pub(crate) fn hidden_by_itself(
        &self,
        ball: usize,
        outward: DVec3,
        along: DVec3,
        width_rad: f64,
    ) -> f64 {
        let Some(solid) = self.solid(ball) else { return 0.0 };
        solid
            .horizon()
            .map_or(0.0, |horizon| horizon.hidden(solid.own(outward), solid.own(along), width_rad))
    }
}
