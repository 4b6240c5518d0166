//! A ball: where a ray meets it, what it hides.
//!
//! Spheres and discs in closed form; the form factor of a sphere above a plane. A pearl that is not round hides what the
//! ellipsoid around it does.
//! Left out: an edge is straight across a narrow cone.

use glam::DVec3;

use crate::{light::glow::Glow, shape::hull::Hull, view::ray::Ray};

/// What a hull is once space is stretched.
const UNIT: Ball = Ball { centre: DVec3::ZERO, radius_mm: 1.0, glow: Glow::BLACK, hull: None };

/// How far inside the silhouette a line of sight that grazes it is taken to hit.
const RIM: f64 = 1.0 - 1e-9;

/// A pearl among its surroundings: the place it takes and the light it sends out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Its middle.
    pub centre: DVec3,
    /// Radius in mm; half the width of a pearl that is not round.
    pub radius_mm: f64,
    /// The light that its neighbours and the table get from it.
    pub glow: Glow,
    /// What stands for a pearl that is not round where others see it.
    pub hull: Option<Hull>,
}

/// Where a line of sight meets a pearl.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Point on the surface, mm.
    pub point: DVec3,
    /// Outward normal there.
    pub normal: DVec3,
    /// Cosine of the view angle theta_0, between normal and line of sight.
    pub cos_view: f64,
}

impl Ball {
    /// A dark ball around the origin.
    pub fn alone(radius_mm: f64) -> Self {
        Self { centre: DVec3::ZERO, radius_mm, glow: Glow::BLACK, hull: None }
    }

    /// The farthest that it reaches from its middle.
    pub(crate) fn reach_mm(&self) -> f64 {
        self.hull.map_or(self.radius_mm, |hull| hull.reach_mm())
    }

    /// How far below its middle it reaches.
    pub(crate) fn below_mm(&self) -> f64 {
        self.hull.map_or(self.radius_mm, |hull| hull.below_mm())
    }

    /// The pearl along `ray`, or nothing.
    pub fn hit(&self, ray: &Ray) -> Option<Hit> {
        (self.is_ahead(ray) && self.cos_view_squared(ray) >= 0.0).then(|| self.nearest(ray))
    }

    /// Whether the ball's middle lies before where a line of sight starts.
    pub(crate) fn is_ahead(&self, ray: &Ray) -> bool {
        (ray.from - self.centre).dot(ray.along) < 0.0
    }

    /// The square of the cosine of the view angle along a line of sight; below 0 where it passes by.
    pub(crate) fn cos_view_squared(&self, ray: &Ray) -> f64 {
        1.0 - (self.passing_mm(ray) / self.radius_mm).powi(2)
    }

    /// Where a line of sight meets the ball, or the point of the rim that is next to it.
    pub(crate) fn nearest(&self, ray: &Ray) -> Hit {
        let from = ray.from - self.centre;
        let closest = from - ray.along * from.dot(ray.along);
        let passing_mm = closest.length();
        let sin_view = (passing_mm / self.radius_mm).min(RIM);
        let cos_view = (1.0 - sin_view * sin_view).sqrt();
        let aside = if passing_mm > 0.0 { closest * (sin_view / passing_mm) } else { DVec3::ZERO };
        let normal = aside - ray.along * cos_view;
        let point = self.centre + normal * self.radius_mm;
        Hit { point, normal, cos_view }
    }

    /// How far from the ball's middle a line of sight passes.
    pub(crate) fn passing_mm(&self, ray: &Ray) -> f64 {
        (ray.from - self.centre).reject_from_normalized(ray.along).length()
    }

    /// (distance, share) of a cone of light of full angle `spread_rad` around `ray` that the ball
    /// stops, if any: the area that two discs have in common, over the cone's.
    #[inline]
    pub(crate) fn stops(&self, ray: &Ray, spread_rad: f64) -> Option<(f64, f64)> {
        match &self.hull {
            None => self.stops_round(ray, spread_rad),
            Some(hull) => {
                let (from, along, [length, angle]) =
                    hull.stretched(ray.from - self.centre, ray.along);
                let stretched = Ray { from, along };
                let (far, share) = UNIT.stops_round(&stretched, spread_rad * angle)?;
                Some((far / length, share))
            }
        }
    }

    #[inline]
    fn stops_round(&self, ray: &Ray, spread_rad: f64) -> Option<(f64, f64)> {
        let from = ray.from - self.centre;
        let ahead_mm = -from.dot(ray.along);
        if ahead_mm <= 0.0 {
            return None;
        }
        let cone_mm = 0.5 * ahead_mm * spread_rad.max(FINEST_RAD);
        let passing2 = from.length_squared() - ahead_mm * ahead_mm;
        let reach_mm = self.radius_mm + cone_mm;
        if passing2 >= reach_mm * reach_mm {
            return None;
        }
        let share = overlap(passing2.max(0.0).sqrt(), self.radius_mm, cone_mm);
        let depth_mm = (self.radius_mm * self.radius_mm - passing2).max(0.0).sqrt();
        Some(((ahead_mm - depth_mm).max(0.0), share))
    }

    /// Whether no part of a disc of light towards `toward`, sine and cosine of its angular radius
    /// given, is hidden from `point`: the ball lies beside the cone. Far cheaper than `light_past`.
    pub(crate) fn is_clear_of(&self, point: DVec3, toward: DVec3, disc: (f64, f64)) -> bool {
        let rel = self.centre - point;
        let along_mm = rel.dot(toward);
        let passing2 = rel.length_squared() - along_mm * along_mm;
        let needed_mm = self.reach_mm() + along_mm * disc.0;
        needed_mm <= 0.0 || passing2 * disc.1 * disc.1 >= needed_mm * needed_mm
    }

    /// The share of a small disc of light, of angular radius `disc_rad` towards `toward`, that a point
    /// outside the pearl still sees past it.
    ///
    /// The pearl's edge is taken as straight across the disc, good while the disc is the smaller.
    pub fn light_past(&self, point: DVec3, toward: DVec3, disc_rad: f64) -> f64 {
        if let Some(hull) = &self.hull {
            let (from, along, [_, angle]) = hull.stretched(point - self.centre, toward);
            return UNIT.light_past(from, along, disc_rad * angle);
        }
        let from = point - self.centre;
        let distance_mm = from.length();
        let pearl_rad = libm::asin((self.radius_mm / distance_mm).min(1.0));
        let apart_rad = libm::acos((-from.dot(toward) / distance_mm).clamp(-1.0, 1.0));
        1.0 - straight_edge((pearl_rad - apart_rad) / disc_rad)
    }

    /// The share of an even sky that a point on the table still receives beside the pearl that lies on
    /// it. Exact for a ball: the form factor of a sphere wholly above a plane.
    pub fn sky_past(&self, point_on_table: DVec3) -> f64 {
        if let Some(hull) = &self.hull {
            return hull.sky_past(point_on_table - self.centre);
        }
        1.0 - (self.radius_mm / (point_on_table - self.centre).length()).min(1.0).powi(3)
    }
}

/// The share of a disc of radius `disc_mm` that another, of radius `radius_mm`, covers when their
/// middles are `apart_mm` apart.
fn overlap(apart_mm: f64, radius_mm: f64, disc_mm: f64) -> f64 {
    if disc_mm < STRAIGHT * radius_mm {
        return straight_edge((radius_mm - apart_mm) / disc_mm);
    }
    if apart_mm <= (radius_mm - disc_mm).abs() {
        return (radius_mm / disc_mm).min(1.0).powi(2);
    }
    let (r2, d2, a2) = (radius_mm * radius_mm, disc_mm * disc_mm, apart_mm * apart_mm);
    let sector = |own2: f64, own_mm: f64, other2: f64| {
        own2 * libm::acos(((a2 + own2 - other2) / (2.0 * apart_mm * own_mm)).clamp(-1.0, 1.0))
    };
    let kite = 4.0 * a2 * d2 - (a2 + d2 - r2).powi(2);
    let lens = sector(d2, disc_mm, r2) + sector(r2, radius_mm, d2) - 0.5 * kite.max(0.0).sqrt();
    (lens / (std::f64::consts::PI * d2)).clamp(0.0, 1.0)
}

/// The share of a disc of radius 1 on one side of a straight line, `x` beyond its middle.
fn straight_edge(x: f64) -> f64 {
    let x = (-x).clamp(-1.0, 1.0);
    (libm::acos(x) - x * (1.0 - x * x).sqrt()) / std::f64::consts::PI
}

/// Below this ratio of discs the larger one's edge is straight to the smaller, to a thousandth.
const STRAIGHT: f64 = 1e-3;
/// Cones are at least this wide, so that a ball's edge has a width to fade over.
const FINEST_RAD: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        coat::pose::Pose,
        shape::form::{Form, FormParameters},
    };

    const BALL: Ball =
        Ball { centre: DVec3::new(0.0, 0.0, -50.0), radius_mm: 4.0, glow: Glow::BLACK, hull: None };

    fn share(aside_mm: f64, spread_rad: f64) -> f64 {
        let ray = Ray { from: DVec3::new(aside_mm, 0.0, 0.0), along: DVec3::NEG_Z };
        BALL.stops(&ray, spread_rad).map_or(0.0, |(_, share)| share)
    }

    #[test]
    fn a_narrow_cone_is_stopped_by_the_ball_and_by_nothing_beside_it() {
        assert!((share(3.9, 1e-3) - 1.0).abs() < 1e-12 && share(4.1, 1e-3) == 0.0);
        assert!((share(4.0, 1e-5) - 0.5).abs() < 1e-9);
        let ray = Ray { from: DVec3::ZERO, along: DVec3::Z };
        assert!(BALL.stops(&ray, 0.5).is_none(), "behind the ray");
        let ray = Ray { from: DVec3::ZERO, along: DVec3::NEG_Z };
        assert!((BALL.stops(&ray, 1e-3).unwrap().0 - 46.0).abs() < 1e-9);
    }

    #[test]
    fn cones_of_every_width_together_see_the_area_of_the_disc() {
        for spread_rad in [0.01, 0.1, 0.16, 0.3, 1.0] {
            let step_mm = 0.01;
            let area: f64 = (0..8000)
                .map(|i| (f64::from(i) + 0.5) * step_mm)
                .map(|aside_mm| {
                    2.0 * std::f64::consts::PI * aside_mm * step_mm * share(aside_mm, spread_rad)
                })
                .sum();
            let disc = std::f64::consts::PI * 16.0;
            assert!((area / disc - 1.0).abs() < 1e-3, "{spread_rad}: {}", area / disc);
        }
    }

    #[test]
    fn what_lies_clear_of_the_light_loses_none_of_it() {
        let toward = DVec3::new(0.3, 0.2, -0.9).normalize();
        let disc_rad = 0.1_f64;
        let mut clear = 0;
        for i in 0..2000 {
            let turn = f64::from(i) * 0.37;
            let point = BALL.centre
                + (4.0 + f64::from(i % 40))
                    * DVec3::new(turn.sin(), (turn * 0.7).cos(), (turn * 1.3).sin()).normalize();
            if BALL.is_clear_of(point, toward, disc_rad.sin_cos()) {
                clear += 1;
                assert!(BALL.light_past(point, toward, disc_rad) > 1.0 - 1e-12);
            }
        }
        assert!(clear > 500);
    }

    /// Of a form whose axis is upright, y.
    fn hull(form: &FormParameters) -> Hull {
        Hull::around(&Form::new(form), &Pose::new(0.0, 0.0, 0.0), 4.0)
    }

    #[test]
    fn the_hull_of_a_ball_hides_what_the_ball_does() {
        let ball = Ball::alone(4.0);
        let hull = Some(hull(&FormParameters::ROUND));
        let hulled = Ball { hull, ..ball };
        for i in 0..60 {
            let t = f64::from(i);
            let on_table = DVec3::new(0.3 * t, -4.0, 0.1 * t);
            assert!((ball.sky_past(on_table) - hulled.sky_past(on_table)).abs() < 2e-3, "{i}");
            let from = DVec3::new(20.0, 0.2 * t - 6.0, 0.07 * t);
            let ray = Ray { from, along: DVec3::NEG_X };
            let share = |ball: &Ball| ball.stops(&ray, 0.1).map_or(0.0, |(_, share)| share);
            assert!((share(&ball) - share(&hulled)).abs() < 5e-3, "{i}");
            let past = |ball: &Ball| ball.light_past(from, DVec3::NEG_X, 0.05);
            assert!((past(&ball) - past(&hulled)).abs() < 2e-2, "{i}");
        }
    }

    #[test]
    fn an_ellipsoids_shadow_is_as_wide_as_the_ellipsoid() {
        let form = FormParameters { length: 1.5, ..FormParameters::ROUND };
        let ball = Ball { hull: Some(hull(&form)), ..Ball::alone(4.0) };
        // 6 mm to the end of the axis, 4 mm aside.
        for (x, y, is_dark) in
            [(0.0, 5.9, true), (0.0, 6.1, false), (3.9, 0.0, true), (4.1, 0.0, false)]
        {
            let past = ball.light_past(DVec3::new(x, y, -30.0), DVec3::Z, 1e-4);
            assert!((past < 0.5) == is_dark, "{x} {y}: {past}");
        }
    }
}
