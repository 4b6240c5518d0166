//! Where a line of sight meets a pearl that is not round.
//!
//! Steps that cannot pass the surface (Hart 1996), as long as its steepness allows, then Newton's.
//! Left out: rises thinner than the least feature, which no form has.

use glam::DVec3;

use crate::shape::{ball::Hit, solid::Solid};

/// A line of sight as the form has it, over half of the pearl's width.
pub(super) struct Line {
    pub(super) from: DVec3,
    pub(super) along: DVec3,
}

impl Line {
    pub(super) fn point(&self, t: f64) -> DVec3 {
        self.from + self.along * t
    }

    /// From where to where it is nearer to the middle than `reach`.
    pub(super) fn within(&self, reach: f64) -> Option<[f64; 2]> {
        let middle = -self.from.dot(self.along);
        let passing2 = (self.from + self.along * middle).length_squared();
        let half2 = reach * reach - passing2;
        (half2 > 0.0 && middle + half2.sqrt() > 0.0)
            .then(|| [(middle - half2.sqrt()).max(0.0), middle + half2.sqrt()])
    }
}

/// A place of a line and the form's height in its direction.
struct Place {
    towards: DVec3,
    radius: f64,
    gradient: DVec3,
    /// How far the place is from the surface.
    height: f64,
    /// How fast that changes along the line.
    change: f64,
}

/// What is known of the way of lines of sight beside one that was followed, as seen from the pearl's middle.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Beside {
    /// So far the one that was followed came no nearer than they lie beside it.
    pub(crate) free_mm: f64,
    /// Where it met the surface, and the normal there, if from there on it came ever nearer.
    surface: Option<[DVec3; 2]>,
}

/// Nearer to the surface than this, over the pearl's half width, a line of sight has met it.
const MET: f64 = 1e-10;
/// Or, where it meets the surface steeply, nearer than this along the line.
const MET_ALONG: f64 = 1e-8;
/// From here on nothing lies between that a longer step could pass.
const NEAR: f64 = 1e-3;

/// The most steps of a ray; near a silhouette many are short.
const MOST_STEPS: usize = 200;
/// No form has a rise that is thinner than this share of half its width.
const LEAST_FEATURE: f64 = 0.02;
/// Where a surface is seen at a lower cosine, the next line of sight may meet another part of it.
const LEAST_BESIDE: f64 = 0.1;
/// At the silhouette the cosine of the view angle is taken to be at least this.
const LEAST_COSINE: f64 = 1e-5;

impl Solid {
    /// Where a ray from `from`, as seen from the middle, meets the surface.
    pub fn hit(&self, from: DVec3, along: DVec3) -> Option<Hit> {
        self.followed(from, along, [0.0; 2]).0
    }

    /// The same of a ray beside one that was followed.
    pub(crate) fn hit_beside(&self, from: DVec3, along: DVec3, known: &Beside) -> Option<Hit> {
        let met = known.surface.and_then(|surface| self.met_beside(from, along, surface));
        met.or_else(|| self.followed(from, along, [known.free_mm, 0.0]).0)
    }

    /// By Newton's steps from where it meets the plane that touches the surface.
    fn met_beside(&self, from: DVec3, along: DVec3, [point, normal]: [DVec3; 2]) -> Option<Hit> {
        const STEPS: usize = 4;
        let line = self.line(from, along);
        let mut t = (point - from).dot(normal) / (along.dot(normal) * self.radius_mm);
        for _ in 0..STEPS {
            let place = self.place(&line, t);
            if place.change > -LEAST_BESIDE || place.height.abs() > NEAR {
                return None;
            }
            if place.off().abs() < 1.0 {
                return Some(self.met(&place, &line));
            }
            t -= place.height / place.change;
        }
        None
    }

    /// The same from `near_mm` on, where that is outside of the pearl; and what is then known of rays no more than
    /// `clear_mm` beside it.
    pub(crate) fn followed(
        &self,
        from: DVec3,
        along: DVec3,
        [near_mm, clear_mm]: [f64; 2],
    ) -> (Option<Hit>, Beside) {
        let line = self.line(from, along);
        let Some([start, end]) = self.hull.within(from, along) else {
            return (None, Beside { free_mm: near_mm, surface: None });
        };
        let [start, end] = [start.max(0.0), end].map(|mm| mm / self.radius_mm);
        let [near, clear] = [near_mm, clear_mm * self.steepest].map(|mm| mm / self.radius_mm);
        let (mut t, mut place) = self.begin(&line, start, near);
        let (mut outside, mut free, mut is_clear, mut falls) = (t, t, true, true);
        for _ in 0..MOST_STEPS {
            if t > end {
                break;
            }
            is_clear &= place.height > clear;
            if is_clear {
                free = t + (place.height - clear) / self.steepest;
            }
            falls = (falls || is_clear) && place.change < 0.0;
            if place.off() < 1.0 {
                // Past the surface, the place is between here and the last one outside.
                let is_past = place.off() < -1.0;
                let met = if is_past { self.between(&line, [outside, t], place) } else { place };
                let hit = self.met(&met, &line);
                let surface =
                    (falls && hit.cos_view > LEAST_BESIDE).then_some([hit.point, hit.normal]);
                return (Some(hit), Beside { free_mm: free * self.radius_mm, surface });
            }
            outside = t;
            t += self.step(place.height, place.change);
            place = self.place(&line, t);
        }
        (None, Beside { free_mm: free * self.radius_mm, surface: None })
    }

    /// Where to begin: near to the pearl, unless that is within it.
    fn begin(&self, line: &Line, start: f64, near: f64) -> (f64, Place) {
        if near > start {
            let place = self.place(line, near);
            if place.height > 0.0 {
                return (near, place);
            }
        }
        (start, self.place(line, start))
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
            let place = self.place(&line, self.passing(&line).at);
            self.met(&place, &line)
        })
    }

    pub(super) fn line(&self, from: DVec3, along: DVec3) -> Line {
        Line { from: self.pose.own(from) / self.radius_mm, along: self.pose.own(along) }
    }

    fn place(&self, line: &Line, t: f64) -> Place {
        let point = line.point(t);
        let far = point.length();
        let towards = point / far;
        let (radius, gradient) = self.form.below(towards, point);
        let change = line.along.dot(towards - gradient / far);
        Place { towards, radius, gradient, height: far - radius, change }
    }

    /// The crossing between a place outside and one inside, by Newton's steps that stay between.
    fn between(&self, line: &Line, [mut low, mut high]: [f64; 2], inside: Place) -> Place {
        let (mut t, mut place) = (high, inside);
        for _ in 0..50 {
            let newton = t - place.height / place.change;
            t = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            place = self.place(line, t);
            if place.off().abs() < 1.0 {
                break;
            }
            if place.height > 0.0 {
                low = t;
            } else {
                high = t;
            }
        }
        place
    }

    /// The surface below or above a place; the point is as from the middle.
    fn met(&self, place: &Place, line: &Line) -> Hit {
        let normal = (place.towards - place.gradient / place.radius).normalize();
        let cos_view = (-normal.dot(line.along)).max(LEAST_COSINE);
        Hit {
            point: self.pose.scene(place.towards * place.radius) * self.radius_mm,
            normal: self.pose.scene(normal),
            cos_view,
        }
    }
}

impl Place {
    /// Distance from the surface over that at which it is met.
    fn off(&self) -> f64 {
        self.height / MET.max(-self.change * MET_ALONG)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        coat::pose::Pose,
        shape::form::{FormParameters, tests::kinds},
    };

    fn solid(form: &FormParameters) -> Solid {
        Solid::new(form, Pose::new(0.4, 1.1, 0.2), 4.0)
    }

    #[test]
    fn beside_a_ray_that_is_free_so_far_others_meet_the_same() {
        let clear_mm = 0.1;
        for form in kinds() {
            let (solid, mut later) = (solid(&form), 0);
            for i in 0..600 {
                let t = f64::from(i);
                let aim = 4.2 * DVec3::new((1.1 * t).cos(), (1.7 * t).sin(), (2.3 * t).cos());
                let from = 40.0 * DVec3::new((0.7 * t).sin(), 0.4, (0.3 * t).cos()).normalize();
                let along = (aim - from).normalize();
                let (_, known) = solid.followed(from, along, [0.0, clear_mm]);
                let aside = along.any_orthonormal_vector() * (0.9 * clear_mm);
                let whole = solid.hit(from + aside, along);
                let short = solid.hit_beside(from + aside, along, &known);
                match (whole, short) {
                    (None, None) => {}
                    (Some(whole), Some(short)) => {
                        let apart_mm = whole.point.distance(short.point);
                        assert!(apart_mm < 1e-6, "{form:?} {i}: {apart_mm}");
                        later += i32::from(known.free_mm > 30.0);
                    }
                    (whole, short) => panic!("{form:?} {i}: {whole:?} {short:?}"),
                }
            }
            assert!(later > 100, "{form:?}: {later} began anywhere near the pearl");
        }
    }

    #[test]
    fn no_ray_that_meets_a_pearl_is_taken_to_pass_it() {
        for form in kinds() {
            let (solid, mut passed) = (solid(&form), 0);
            for i in 0..2000 {
                let t = f64::from(i);
                let aim = 5.5 * DVec3::new((1.1 * t).cos(), (1.7 * t).sin(), (2.3 * t).cos());
                let from = 40.0 * DVec3::new((0.7 * t).sin(), 0.4, (0.3 * t).cos()).normalize();
                let along = (aim - from).normalize();
                if solid.hull().is_passed(from, along, 0.0) {
                    passed += 1;
                    assert!(solid.hit(from, along).is_none(), "{form:?} {i}");
                }
            }
            assert!(passed > 100, "{form:?}: {passed}");
        }
    }
}
