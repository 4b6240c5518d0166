//! A rectangle of even light: how it is seen and what it gives.
//!
//! Lambert's sum over the edges, 1760; solid angles of rectangles. How a cone sees it: `pane.rs`.
//! Left out: that light comes through glass, and how it changes over the pane.

use std::f64::consts::PI;

use glam::DVec3;

use crate::{rgb::Rgb, surroundings::pane::Pane, view::ray::Ray};

/// A rectangle of even light: a window, a softbox, a lit plate. It gives light, and is seen, on one
/// side only.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// Its middle, mm.
    centre: DVec3,
    /// From the middle to the middle of an edge, and to that of the next; at right angles.
    right: DVec3,
    up: DVec3,
    /// Where it shines, a unit vector.
    facing: DVec3,
    /// Linear RGB.
    pub radiance: Rgb,
}

/// Beyond so many angles of a cone it sees nothing of a window: twice what its Gaussian reaches (`pane.rs`).
const NEAR: f64 = 3.0;

impl Window {
    /// `right` and `up`, in mm, go from the middle to two edges at right angles to each other, neither
    /// of length 0; the window faces along `right` x `up`.
    pub fn new(centre: DVec3, right: DVec3, up: DVec3, radiance: Rgb) -> Self {
        Self { centre, right, up, facing: right.cross(up).normalize(), radiance }
    }

    /// How far `point` lies in front of the window's plane.
    fn in_front_mm(&self, point: DVec3) -> f64 {
        (point - self.centre).dot(self.facing)
    }

    /// The corners as seen from `point`, in a round.
    fn corners(&self, point: DVec3) -> [DVec3; 4] {
        let middle = self.centre - point;
        [
            middle - self.right - self.up,
            middle + self.right - self.up,
            middle + self.right + self.up,
            middle - self.right + self.up,
        ]
    }

    /// The window as it stands before a point; `None` from behind.
    pub(crate) fn before(&self, point: DVec3) -> Option<Pane> {
        let in_front_mm = self.in_front_mm(point);
        if in_front_mm <= 0.0 {
            return None;
        }
        let (corners, middle) = (self.corners(point), self.centre - point);
        let inward = [0, 1, 2, 3].map(|edge| {
            let across = corners[edge].cross(corners[(edge + 1) % 4]).normalize_or_zero();
            across * across.dot(middle).signum()
        });
        let farthest_mm = middle.length() + self.right.length() + self.up.length();
        Some(Pane {
            inward,
            facing: self.facing,
            in_front_mm,
            farthest_mm,
            radiance: self.radiance,
        })
    }

    /// Whether no part of it lies in a cone of light of full angle `spread_rad`, or near it. Far cheaper than
    /// [`Self::before`].
    pub(crate) fn is_clear_of(&self, ray: &Ray, spread_rad: f64) -> bool {
        let middle = self.centre - ray.from;
        let (square, ahead_mm) = (middle.length_squared(), middle.dot(ray.along));
        let reach_mm = (self.right.length_squared() + self.up.length_squared()).sqrt()
            + NEAR * spread_rad * square.sqrt();
        ahead_mm < -reach_mm || square - ahead_mm * ahead_mm > reach_mm * reach_mm
    }

    /// The window's light on a matt surface at `point`: radiance of a white one over that of the window.
    /// Exact: Lambert's sum over the edges (1760) of what is above the surface's horizon.
    pub fn form_factor(&self, point: DVec3, normal: DVec3) -> f64 {
        if self.in_front_mm(point) <= 0.0 {
            return 0.0;
        }
        let corners = self.corners(point);
        let mut sum = 0.0;
        let (mut last, mut first) = (None, None);
        for edge in 0..4 {
            let (a, b) = (corners[edge], corners[(edge + 1) % 4]);
            let (high_a, high_b) = (a.dot(normal), b.dot(normal));
            let horizon = a + (b - a) * (high_a / (high_a - high_b));
            let (a, b) = match (high_a > 0.0, high_b > 0.0) {
                (true, true) => (a, b),
                (true, false) => (a, horizon),
                (false, true) => (horizon, b),
                (false, false) => continue,
            };
            // Between leaving the horizon and coming back above it the figure is closed along it.
            sum += last.map_or(0.0, |last| edge_sum(last, a, normal)) + edge_sum(a, b, normal);
            first = first.or(Some(a));
            last = Some(b);
        }
        if let (Some(first), Some(last)) = (first, last) {
            sum += edge_sum(last, first, normal);
        }
        (sum.abs() / (2.0 * PI)).min(1.0)
    }

    /// The same on a surface that faces the window's middle.
    pub fn facing_factor(&self, point: DVec3) -> f64 {
        self.form_factor(point, (self.centre - point).normalize_or_zero())
    }

    /// Unit vector from `point` to the middle.
    pub(crate) fn toward(&self, point: DVec3) -> DVec3 {
        (self.centre - point).normalize_or_zero()
    }

    /// The same, and the angular radius of a cone around the whole window.
    pub(crate) fn cone(&self, point: DVec3) -> (DVec3, f64) {
        let toward = self.toward(point);
        let cosine = |corner: DVec3| corner.normalize_or_zero().dot(toward);
        let least = self.corners(point).into_iter().map(cosine).fold(1.0, f64::min);
        (toward, libm::acos(least.clamp(-1.0, 1.0)))
    }

    /// Patches of the window: direction from `point`, angular radius of a disc as large, and light on a
    /// surface with this normal, in a unit of its own. None from behind.
    pub(crate) fn patches(&self, point: DVec3, normal: DVec3) -> impl Iterator<Item = Patch> {
        let (across, along) = (self.range(point, self.right), self.range(point, self.up));
        let columns = across.steps(PATCH_RAD, MOST_PATCHES as u32);
        let rows = along.steps(PATCH_RAD, MOST_PATCHES as u32);
        // Tangents of a row's or column's angle, and how fast they grow with it.
        let tangents = |range: &Range, count| {
            let mut found = [(0.0, 0.0); MOST_PATCHES];
            for (i, found) in (0..count).zip(&mut found) {
                let tangent = libm::tan(range.at(f64::from(i) + 0.5, count));
                *found = (tangent, (1.0 + tangent * tangent) * range.step_rad(count));
            }
            found
        };
        let (x, y) = (tangents(&across, columns), tangents(&along, rows));
        let facing = self.facing;
        (0..rows as usize).flat_map(move |row| {
            (0..columns as usize).filter_map(move |column| {
                let ((x, wide), (y, high)) = (x[column], y[row]);
                let length2 = 1.0 + x * x + y * y;
                let length = length2.sqrt();
                let toward = (across.unit * x + along.unit * y - facing) / length;
                let (cosine, solid) = (toward.dot(normal), wide * high / (length * length2));
                (cosine > 0.0).then(|| Patch {
                    toward,
                    disc_rad: (solid / PI).sqrt(),
                    light: cosine * solid,
                })
            })
        })
    }

    /// Directions from `point` that share the window out evenly in angle, about `step_rad` apart, each
    /// with its solid angle. None from behind.
    pub(crate) fn directions(
        &self,
        point: DVec3,
        step_rad: f64,
    ) -> impl Iterator<Item = (DVec3, f64)> {
        let (across, along) = (self.range(point, self.right), self.range(point, self.up));
        let facing = self.facing;
        let rows = along.steps(step_rad, MOST_STEPS);
        along.tangents(rows).flat_map(move |(y, low, high)| {
            let columns = across.steps(step_rad, MOST_STEPS);
            across.tangents(columns).map(move |(x, left, right)| {
                let solid = corner(right, high) - corner(left, high) - corner(right, low)
                    + corner(left, low);
                ((across.unit * x + along.unit * y - facing).normalize(), solid)
            })
        })
    }

    /// In what angles the edges stand along `half`, left and right or below and above, from `point`.
    fn range(&self, point: DVec3, half: DVec3) -> Range {
        let in_front_mm = self.in_front_mm(point);
        let half_mm = half.length();
        let unit = half / half_mm;
        let along_mm = (self.centre - point).dot(unit);
        let angle = |mm: f64| libm::atan(mm / in_front_mm);
        let (low_rad, high_rad) = (angle(along_mm - half_mm), angle(along_mm + half_mm));
        Range { unit, low_rad, high_rad, behind: in_front_mm <= 0.0 }
    }
}

/// Part of a window.
pub(crate) struct Patch {
    pub(crate) toward: DVec3,
    pub(crate) disc_rad: f64,
    pub(crate) light: f64,
}

/// The angles in which a window stands along one of its sides.
#[derive(Debug, Clone, Copy)]
struct Range {
    /// Along that side.
    unit: DVec3,
    low_rad: f64,
    high_rad: f64,
    behind: bool,
}

impl Range {
    fn steps(&self, step_rad: f64, most: u32) -> u32 {
        let steps = ((self.high_rad - self.low_rad) / step_rad).ceil();
        if self.behind { 0 } else { steps.clamp(2.0, f64::from(most)) as u32 }
    }

    fn step_rad(&self, count: u32) -> f64 {
        (self.high_rad - self.low_rad) / f64::from(count.max(1))
    }

    fn at(&self, step: f64, count: u32) -> f64 {
        self.low_rad + step * self.step_rad(count)
    }

    /// (tangent in the middle, at both ends) of equal steps of angle.
    fn tangents(self, count: u32) -> impl Iterator<Item = (f64, f64, f64)> {
        let at = move |step| libm::tan(self.at(step, count));
        (0..count).map(f64::from).map(move |i| (at(i + 0.5), at(i), at(i + 1.0)))
    }
}

/// Solid angle of a rectangle at distance 1 with one corner straight ahead, the other at (x, y).
fn corner(x: f64, y: f64) -> f64 {
    libm::atan(x * y / (1.0 + x * x + y * y).sqrt())
}

/// Lambert's sum for one edge: the angle it is seen in times the cosine of its plane's tilt.
fn edge_sum(a: DVec3, b: DVec3, normal: DVec3) -> f64 {
    let across = a.cross(b);
    let length = across.length();
    if length <= 0.0 { 0.0 } else { libm::atan2(length, a.dot(b)) * across.dot(normal) / length }
}

/// Size of the patches by which a window's shadow is found **(ours)**: a ball's shadow is within 0.006 of the light
/// (the test in `incident.rs`).
const PATCH_RAD: f64 = 0.35;
const MOST_PATCHES: usize = 9;
/// Most steps along a side of a window, which bounds the work **(ours)**.
const MOST_STEPS: u32 = 64;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{cone::Cone, direction::directions};

    /// The six walls of a box around the origin, all of radiance 1.
    fn room() -> Vec<Window> {
        let half = DVec3::new(7.0, 4.0, 11.0);
        [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z]
            .into_iter()
            .map(|outward| {
                let (right, up) = (-outward).any_orthonormal_pair();
                let (right, up) = (right * half.dot(right.abs()), up * half.dot(up.abs()));
                Window::new(outward * half, right, up, [1.0; 3])
            })
            .collect()
    }

    const CEILING: Window = Window {
        centre: DVec3::new(3.0, 20.0, -2.0),
        right: DVec3::new(0.0, 0.0, 9.0),
        up: DVec3::new(5.0, 0.0, 0.0),
        facing: DVec3::NEG_Y,
        radiance: [1.0; 3],
    };

    #[test]
    fn a_room_of_light_lights_every_surface_in_it_fully() {
        let point = DVec3::new(1.0, -2.0, 3.0);
        for normal in [DVec3::Y, DVec3::NEG_X, DVec3::new(0.6, 0.48, 0.64)] {
            let sum: f64 = room().iter().map(|w| w.form_factor(point, normal)).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{normal}: {sum}");
        }
        let whole: f64 =
            room().iter().flat_map(|w| w.directions(point, 0.05)).map(|(_, solid)| solid).sum();
        assert!((whole / (4.0 * PI) - 1.0).abs() < 1e-12, "{whole}");
    }

    #[test]
    fn a_ray_in_a_room_of_light_meets_one_wall_and_a_cone_all_that_it_holds() {
        let from = DVec3::new(1.0, -2.0, 3.0);
        for (along, _) in directions(7) {
            let sum = |spread_rad| -> f64 {
                let panes = room().into_iter().filter_map(|window| window.before(from));
                panes
                    .filter_map(|pane| pane.seen(along, &Cone::round(spread_rad)))
                    .map(|seen| seen.1)
                    .sum()
            };
            assert!((sum(1e-7) - 1.0).abs() < 1e-9, "{along}: {}", sum(1e-7));
            assert!((sum(0.2) - 1.0).abs() < 0.06, "{along}: {}", sum(0.2));
        }
    }

    #[test]
    fn light_blurred_is_light_kept() {
        let pane = CEILING.before(DVec3::ZERO).unwrap();
        let solid: f64 = CEILING.directions(DVec3::ZERO, 0.02).map(|(_, solid)| solid).sum();
        for spread_rad in [0.05, 0.2, 0.6, 1.0] {
            let seen: f64 = directions(200)
                .map(|(along, share)| {
                    4.0 * PI
                        * share
                        * pane.seen(along, &Cone::round(spread_rad)).map_or(0.0, |seen| seen.1)
                })
                .sum();
            assert!((seen / solid - 1.0).abs() < 0.08, "{spread_rad}: {}", seen / solid);
        }
    }

    #[test]
    fn a_rectangle_above_its_corner_has_the_textbooks_factor() {
        // Siegel and Howell, C-4: element below a corner, sides a and b, distance c.
        let (a, b, c) = (3.0_f64, 5.0_f64, 2.0_f64);
        let (x, y) = (a / c, b / c);
        let (rx, ry) = ((1.0 + x * x).sqrt(), (1.0 + y * y).sqrt());
        let expected = (x / rx * (y / rx).atan() + y / ry * (x / ry).atan()) / (2.0 * PI);
        let half = (DVec3::new(0.0, 0.0, 0.5 * b), DVec3::new(0.5 * a, 0.0, 0.0));
        let window = Window::new(DVec3::new(0.5 * a, c, 0.5 * b), half.1, half.0, [1.0; 3]);
        assert!((window.form_factor(DVec3::ZERO, DVec3::Y) - expected).abs() < 1e-12);
        let weights: f64 = window.patches(DVec3::ZERO, DVec3::Y).map(|patch| patch.light).sum();
        assert!((weights / PI / expected - 1.0).abs() < 0.03, "{weights} {expected}");
    }

    #[test]
    fn nothing_comes_from_behind() {
        let above = DVec3::new(3.0, 21.0, -2.0);
        assert!(CEILING.before(above).is_none());
        assert!(CEILING.form_factor(above, DVec3::NEG_Y) <= 0.0);
        assert_eq!(CEILING.directions(above, 0.1).count(), 0);
        assert!(CEILING.form_factor(DVec3::ZERO, DVec3::NEG_Y) <= 0.0);
    }
}
