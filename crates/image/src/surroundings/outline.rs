//! Where lines of sight meet the pearls, round or not.
//!
//! A ball's answers in closed form; a solid's by following the line.
//! Left out: what the pearls do with light.

use glam::DVec3;

use crate::{
    shape::{ball::Hit, crossing::Beside, solid::Solid},
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
        self.hit_beside(ball, ray, &Beside::default())
    }

    /// The same beside a line of sight that was followed.
    #[inline]
    pub(crate) fn hit_beside(&self, ball: usize, ray: &Ray, known: &Beside) -> Option<Hit> {
        let place = &self.balls[ball];
        match self.solid(ball) {
            None => place.hit(ray),
            Some(solid) => {
                let hit = solid.hit_beside(ray.from - place.centre, ray.along, known)?;
                Some(Hit { point: hit.point + place.centre, ..hit })
            }
        }
    }

    /// Whether one part of a pearl may stand before another.
    pub(crate) fn hides_itself(&self, ball: usize) -> bool {
        self.solid(ball).is_some_and(|solid| solid.horizon().is_some())
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
    /// the rim as that does where it is none, `pass` being the nearest pass of a line beside it; below 0 where the line passes by.
    #[inline]
    pub(crate) fn view_square(&self, ball: usize, ray: &Ray, pass: f64) -> f64 {
        let place = &self.balls[ball];
        self.solid(ball).map_or_else(
            || place.cos_view_squared(ray),
            |solid| solid.square_near(ray.from - place.centre, ray.along, pass),
        )
    }

    /// Where a line of sight comes nearest to a pearl that is not round, for lines beside it.
    pub(crate) fn nearest_pass(&self, ball: usize, ray: &Ray) -> f64 {
        let centre = self.balls[ball].centre;
        self.solid(ball).map_or(0.0, |solid| solid.nearest_pass(ray.from - centre, ray.along))
    }

    /// How far inside a pearl's silhouette a line of sight passes, about; negative beside it, and within `near_mm` of the
    /// silhouette right. And what is then known of rays no farther than that from it.
    pub(crate) fn inside_mm(&self, ball: usize, ray: &Ray, near_mm: f64) -> (f64, Beside) {
        let place = &self.balls[ball];
        let Some(solid) = self.solid(ball) else {
            return (place.radius_mm - place.passing_mm(ray), Beside::default());
        };
        let from = ray.from - place.centre;
        let (hit, known) = solid.followed(from, ray.along, [0.0, near_mm]);
        let least_inside_mm = hit.map_or(0.0, |hit| solid.least_inside_mm(hit.cos_view));
        if least_inside_mm > near_mm {
            return (least_inside_mm, known);
        }
        let passing = (1.0 - solid.square(from, ray.along)).max(0.0).sqrt();
        (place.radius_mm * (1.0 - passing), known)
    }

    /// Whether a line of sight surely passes a pearl by more than `aside_mm`.
    #[inline]
    pub(crate) fn is_passed(&self, ball: usize, ray: &Ray, aside_mm: f64) -> bool {
        let place = &self.balls[ball];
        place.passing_mm(ray) >= place.reach_mm() + aside_mm
            || place
                .hull
                .is_some_and(|hull| hull.is_passed(ray.from - place.centre, ray.along, aside_mm))
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
