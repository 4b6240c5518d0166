//! A pearl that is not round, in its place: its surface, with normals and curvature.
//!
//! Its form is a height over the sphere of directions. Where rays meet it: `crossing.rs`, and how near they pass:
//! `passing.rs`.
//! Left out: how the surface twists between two directions of its curvature.

use glam::DVec3;

use crate::{
    coat::pose::Pose,
    shape::{
        directions::even_directions,
        form::{Form, FormParameters},
        horizon::Horizon,
        hull::Hull,
    },
};

/// A pearl that is not round, about its middle.
#[derive(Debug)]
pub struct Solid {
    pub(super) form: Form,
    pub(super) pose: Pose,
    /// Half of its width: what the form is a multiple of.
    pub(super) radius_mm: f64,
    /// Least and greatest distance of its surface from its middle, over that.
    least: f64,
    pub(super) greatest: f64,
    /// The greatest curvature, over that of the ball.
    sharpest: f64,
    /// How much faster than a ray goes on its distance from the surface may change.
    pub(super) steepest: f64,
    /// Where the surface hides itself, if it does anywhere.
    horizon: Option<Horizon>,
    pub(super) hull: Hull,
}

/// Directions by which a form's extremes are taken, and the room left for what lies between them.
const POINTS: usize = 4000;
const ROOM: f64 = 1.02;

impl Solid {
    /// The form of `from` in a pose, `radius_mm` half its width.
    pub fn new(from: &FormParameters, pose: Pose, radius_mm: f64) -> Self {
        let form = Form::new(from);
        let (mut least, mut greatest, mut slope) = (f64::INFINITY, 0.0_f64, 0.0_f64);
        for towards in even_directions(POINTS) {
            let (radius, gradient) = form.at(towards);
            least = least.min(radius);
            greatest = greatest.max(radius);
            slope = slope.max(gradient.length());
        }
        (least, greatest) = (least / ROOM, greatest * ROOM);
        let hull = Hull::around(&form, &pose, radius_mm);
        let sharpest = 1.0;
        let steepest = (1.0 + (ROOM * ROOM * slope / least).powi(2)).sqrt();
        let horizon = Horizon::of(&form);
        let mut solid =
            Self { form, pose, radius_mm, least, greatest, sharpest, steepest, horizon, hull };
        solid.sharpest = solid.greatest_bend();
        solid
    }

    /// The greatest curvature of all.
    fn greatest_bend(&self) -> f64 {
        let bend = |towards: DVec3| {
            let (_, normal) = self.surface(towards);
            let (a, b) = (self.bend(towards, normal, towards.any_orthonormal_vector()), 1.0);
            a[0].max(a[1]).max(b)
        };
        ROOM * even_directions(POINTS / 4).map(bend).fold(0.0, f64::max)
    }

    /// A place seen at a cosine of the view angle lies at least so far inside the silhouette of its part of the pearl: the
    /// surface turns away over half of the square, of a radius of curvature.
    pub(crate) fn least_inside_mm(&self, cos_view: f64) -> f64 {
        0.5 * cos_view * cos_view / self.sharpest * self.radius_mm
    }

    /// Least and greatest distance of the surface from the middle.
    pub fn reach_mm(&self) -> [f64; 2] {
        [self.least, self.greatest].map(|share| share * self.radius_mm)
    }

    /// The ellipsoid that stands for it from afar.
    pub fn hull(&self) -> Hull {
        self.hull
    }

    /// Where it hides itself.
    pub(crate) fn horizon(&self) -> Option<&Horizon> {
        self.horizon.as_ref()
    }

    /// A direction of the scene as the form has it.
    pub(crate) fn own(&self, direction: DVec3) -> DVec3 {
        self.pose.own(direction)
    }

    /// The surface in a direction of the scene from the middle: its place from there, and its normal.
    pub fn surface(&self, towards: DVec3) -> (DVec3, DVec3) {
        let own = self.pose.own(towards);
        let (radius, gradient) = self.form.at(own);
        let normal = (own - gradient / radius).normalize();
        (towards * (radius * self.radius_mm), self.pose.scene(normal))
    }

    /// So many places of the surface, in directions from the middle that share out the sphere; seen from there.
    pub fn places_mm(&self, count: usize) -> Vec<DVec3> {
        even_directions(count).map(|towards| self.surface(towards).0).collect()
    }

    /// The area of the surface over the solid angle that it fills from the middle, in units of the square of half its
    /// width.
    pub(crate) fn area_per_angle(&self, towards: DVec3) -> f64 {
        let (radius, gradient) = self.form.at(self.pose.own(towards));
        radius * (radius * radius + gradient.length_squared()).sqrt()
    }

    /// The direction from the middle of the place that lies farthest out in a direction.
    pub(crate) fn farthest(&self, outward: DVec3) -> DVec3 {
        let own = self.pose.own(outward);
        // The square of the radius, for steps that are right for a ball; then shorter where the form is longer.
        let height = |towards: DVec3| self.form.at(towards).0 * towards.dot(own);
        let mut towards = own;
        let mut step = 1.0;
        let mut best = height(towards);
        for _ in 0..CLIMBS {
            let (radius, gradient) = self.form.at(towards);
            let uphill = gradient * towards.dot(own) + own * radius;
            let uphill = uphill - towards * uphill.dot(towards);
            let next = (towards + uphill * (step / radius)).normalize();
            let found = height(next);
            if found > best {
                (towards, best) = (next, found);
            } else {
                step *= 0.5;
            }
        }
        self.pose.scene(towards)
    }

    /// Curvature at a place, over that of the ball: outward in the plane of view and normal, and across it.
    pub(crate) fn bend(&self, towards: DVec3, normal: DVec3, view: DVec3) -> [f64; 2] {
        let outward = (normal * normal.dot(view) - view).normalize_or_zero();
        let outward =
            if outward == DVec3::ZERO { normal.any_orthonormal_vector() } else { outward };
        let (own, across) = (self.pose.own(towards), normal.cross(outward));
        let bent = self.form.bent(own);
        [outward, across]
            .map(|along| bent.curvature(own, self.pose.own(along)).abs().max(LEAST_BEND))
    }
}

/// Steps to the farthest place; each finds it to about half of what was left.
const CLIMBS: usize = 40;
/// A flat place mirrors as if it were bent by this share of the ball's curvature, so that its pixels still average.
const LEAST_BEND: f64 = 0.02;
