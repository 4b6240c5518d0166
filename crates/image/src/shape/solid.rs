//! A pearl that is not round, in its place: where a ray meets it, its normal and curvature there.
//!
//! Its form is a height over the sphere of directions; rays are followed by steps that cannot pass the surface, then by
//! Newton's.
//! Left out: how the surface twists between two directions of its curvature.

use glam::DVec3;

use crate::{
    coat::pose::Pose,
    shape::{
        ball::Hit,
        form::{Form, FormParameters, even_directions},
        horizon::Horizon,
        hull::Hull,
    },
};

/// A pearl that is not round, about its middle.
#[derive(Debug)]
pub struct Solid {
    form: Form,
    pose: Pose,
    /// Half of its width: what the form is a multiple of.
    radius_mm: f64,
    /// Least and greatest distance of its surface from its middle, over that.
    least: f64,
    greatest: f64,
    /// The greatest curvature, over that of the ball.
    sharpest: f64,
    /// How much faster than a ray goes on its distance from the surface may change.
    steepest: f64,
    /// Where the surface hides itself, if it does anywhere.
    horizon: Option<Horizon>,
    hull: Hull,
}

/// The nearest that a line of sight comes to a solid, as a ball's would.
#[derive(Debug, Clone, Copy)]
struct Passing {
    /// How far along.
    at: f64,
    /// One less the square of its distance from the middle over the surface's.
    square: f64,
    /// How that changes along the line.
    change: f64,
}

/// Directions by which a form's extremes are taken, and the room left for what lies between them.
const POINTS: usize = 4000;
const ROOM: f64 = 1.02;
/// Steps along a line of sight on the way to the nearest place; by eye **(ours)**.
const STEPS: usize = 14;
/// Nearer to the surface than this, over the pearl's half width, a line of sight has met it.
const MET: f64 = 1e-10;
/// From here on nothing lies between that a longer step could pass.
const NEAR: f64 = 1e-3;

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

    /// Where a ray from `from`, as seen from the middle, meets the surface.
    pub fn hit(&self, from: DVec3, along: DVec3) -> Option<Hit> {
        self.followed(from, along, [0.0; 2]).0
    }

    /// The same from `near_mm` on, where that is outside of the pearl; and how far the ray goes without coming nearer to the
    /// pearl than `clear_mm`, from where rays beside it may be followed.
    pub(crate) fn followed(
        &self,
        from: DVec3,
        along: DVec3,
        [near_mm, clear_mm]: [f64; 2],
    ) -> (Option<Hit>, f64) {
        let line = self.line(from, along);
        let Some([start, end]) = self.hull.within(from, along) else { return (None, near_mm) };
        let [start, end] = [start.max(0.0), end].map(|mm| mm / self.radius_mm);
        let [near, clear] = [near_mm, clear_mm * self.steepest].map(|mm| mm / self.radius_mm);
        let mut t = if near > start && self.height(&line, near).0 > 0.0 { near } else { start };
        let (mut outside, mut free, mut is_clear) = (t, t, true);
        for _ in 0..MOST_STEPS {
            if t > end {
                return (None, free * self.radius_mm);
            }
            let (height, change) = self.height(&line, t);
            is_clear &= height > clear;
            if is_clear {
                free = t;
            }
            if height < MET {
                // Past the surface, the place is between here and the last one outside.
                let met = if height > -MET { t } else { self.between(&line, outside, t) };
                return (Some(self.met(&line, met)), free * self.radius_mm);
            }
            outside = t;
            t += self.step(height, change);
        }
        (None, free * self.radius_mm)
    }

    /// How far a ray may go on at a height above the surface, and its change.
    fn step(&self, height: f64, change: f64) -> f64 {
        let sure = height / self.steepest;
        match -height / change {
            // It moves away, and nothing that it could meet again is thinner than this.
            _ if change >= 0.0 => sure.max(LEAST_FEATURE),
            newton if height < NEAR => newton.max(sure),
            newton => newton.clamp(sure, 2.0 * sure),
        }
    }

    /// Where it meets the surface, or the place at the silhouette that it passes nearest to.
    pub(crate) fn nearest(&self, from: DVec3, along: DVec3) -> Hit {
        self.hit(from, along).unwrap_or_else(|| {
            let line = self.line(from, along);
            let own = line.point(self.passing(&line).at).normalize();
            let mut hit = self.hit_in(own, line.along);
            // Grazed from outside.
            hit.cos_view = hit.cos_view.max(LEAST_COSINE);
            hit
        })
    }

    /// As the square of the cosine of the view angle is for a ball: 1 less the square of the distance at which a line of
    /// sight passes the middle, over the surface's there; below 0 where it passes by.
    pub fn square(&self, from: DVec3, along: DVec3) -> f64 {
        self.passing(&self.line(from, along)).square
    }

    /// How far along a line of sight comes nearest to the surface.
    pub(crate) fn nearest_pass(&self, from: DVec3, along: DVec3) -> f64 {
        self.passing(&self.line(from, along)).at
    }

    /// [`Self::square`] of a line beside one whose nearest pass is known.
    pub(crate) fn square_near(&self, from: DVec3, along: DVec3, pass: f64) -> f64 {
        let line = self.line(from, along);
        self.nearer(&line, self.passing_at(&line, pass)).square
    }

    /// Curvature at a place, over that of the ball: outward in the plane of view and normal, and across it.
    pub(crate) fn bend(&self, towards: DVec3, normal: DVec3, view: DVec3) -> [f64; 2] {
        let outward = (normal * normal.dot(view) - view).normalize_or_zero();
        let outward =
            if outward == DVec3::ZERO { normal.any_orthonormal_vector() } else { outward };
        let point = self.surface(towards).0;
        let along = |direction: DVec3| {
            let aside = point + direction * (BEND_STEP * self.radius_mm);
            let (place, turned) = self.surface(aside.normalize());
            let moved_mm = (place - point).dot(direction);
            ((turned - normal).dot(direction) * self.radius_mm / moved_mm).abs()
        };
        [along(outward), along(normal.cross(outward))].map(|bend| bend.max(LEAST_BEND))
    }

    fn line(&self, from: DVec3, along: DVec3) -> Line {
        Line { from: self.pose.own(from) / self.radius_mm, along: self.pose.own(along) }
    }

    /// How far a place of a line is from the surface, and how fast that changes.
    fn height(&self, line: &Line, t: f64) -> (f64, f64) {
        let point = line.point(t);
        let far = point.length();
        let towards = point / far;
        let (radius, gradient) = self.form.at(towards);
        (far - radius, line.along.dot(towards - gradient / far))
    }

    /// The crossing between a place outside and one inside.
    fn between(&self, line: &Line, mut low: f64, mut high: f64) -> f64 {
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if self.height(line, middle).0 > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        high
    }

    /// The nearest pass of a line.
    fn passing(&self, line: &Line) -> Passing {
        let [from, to] = line.within(self.greatest).unwrap_or_else(|| {
            let middle = -line.from.dot(line.along);
            [middle - self.greatest, middle + self.greatest]
        });
        let step = (to - from) / STEPS as f64;
        let coarse = (0..=STEPS).map(|i| self.passing_at(line, from + step * i as f64));
        let best = coarse.max_by(|a, b| a.square.total_cmp(&b.square));
        best.map_or(Passing { at: from, square: 0.0, change: 0.0 }, |best| self.nearer(line, best))
    }

    /// The nearest pass next to one that is known, by secants of the change.
    fn nearer(&self, line: &Line, known: Passing) -> Passing {
        let (mut best, mut last) = (known, known);
        // That of a ball.
        let mut bend = -2.0;
        for _ in 0..REFINEMENTS {
            let step = (-last.change / bend).clamp(-LONGEST_STEP, LONGEST_STEP);
            if step.abs() < 1e-7 {
                break;
            }
            let next = self.passing_at(line, last.at + step);
            bend = ((next.change - last.change) / step).min(LEAST_BEND_OF_PASS);
            last = next;
            if next.square > best.square {
                best = next;
            }
        }
        best
    }

    fn passing_at(&self, line: &Line, at: f64) -> Passing {
        let point = line.point(at);
        let far = point.length();
        let towards = point / far;
        let (radius, gradient) = self.form.at(towards);
        let share = far / radius;
        let change = line.along.dot(towards) - share * gradient.dot(line.along) / far;
        Passing { at, square: 1.0 - share * share, change: -2.0 * share / radius * change }
    }

    fn met(&self, line: &Line, t: f64) -> Hit {
        self.hit_in(line.point(t).normalize(), line.along)
    }

    /// The surface in a direction of the form, seen along another; the point is as from the middle.
    fn hit_in(&self, own: DVec3, along: DVec3) -> Hit {
        let (radius, gradient) = self.form.at(own);
        let normal = (own - gradient / radius).normalize();
        let cos_view = (-normal.dot(along)).max(LEAST_COSINE);
        Hit {
            point: self.pose.scene(own * radius) * self.radius_mm,
            normal: self.pose.scene(normal),
            cos_view,
        }
    }
}

/// A line of sight as the form has it, over half of the pearl's width.
struct Line {
    from: DVec3,
    along: DVec3,
}

impl Line {
    fn point(&self, t: f64) -> DVec3 {
        self.from + self.along * t
    }

    /// From where to where it is nearer to the middle than `reach`.
    fn within(&self, reach: f64) -> Option<[f64; 2]> {
        let middle = -self.from.dot(self.along);
        let passing2 = (self.from + self.along * middle).length_squared();
        let half2 = reach * reach - passing2;
        (half2 > 0.0 && middle + half2.sqrt() > 0.0)
            .then(|| [(middle - half2.sqrt()).max(0.0), middle + half2.sqrt()])
    }
}

/// The most steps of a ray; near a silhouette many are short.
const MOST_STEPS: usize = 200;
/// No form has a rise that is thinner than this share of half its width.
const LEAST_FEATURE: f64 = 0.02;
/// Steps to the farthest place; each finds it to about half of what was left.
const CLIMBS: usize = 40;
/// Steps to the nearest pass once it is known roughly: its square is then right to 1e-9.
const REFINEMENTS: usize = 5;
/// None of them is longer than this, over half of the pearl's width.
const LONGEST_STEP: f64 = 0.2;
/// Nor is the pass taken for flatter than this.
const LEAST_BEND_OF_PASS: f64 = -0.2;
/// At the silhouette the cosine of the view angle is taken to be at least this.
const LEAST_COSINE: f64 = 1e-5;
/// Distance between two normals for a curvature, over half of the pearl's width.
const BEND_STEP: f64 = 1e-3;
/// A flat place mirrors as if it were bent by this share of the ball's curvature, so that its pixels still average.
const LEAST_BEND: f64 = 0.02;
