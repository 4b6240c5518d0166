//! A strand as it lies around a neck: pearls that touch, along an ellipse that is open at the back.
//!
//! Each pearl is found from the one before by its distance: that at which both, as they lie, reach a plane between them. The
//! ellipse is as large as the strand needs.
//! Left out: how a thread bends and turns pearls, and clasp and knots, for which there is the gap.

use glam::DVec3;
use nacreous_image::Solid;

/// The ellipse's width over its depth **(ours)**: a choker on a bust.
const WIDTH_OVER_DEPTH: f64 = 0.85;
/// Half of the angle that the pearls fill, from the front.
const HALF_ANGLE_RAD: f64 = 2.5;
/// Pearls on a thread do not quite touch: their distance over the sum of their radii.
const APART: f64 = 1.004;

/// Distances follow directions, and these the distances: so often, or until they change by no more than this share.
const ROUNDS: usize = 20;
const SETTLED: f64 = 1e-6;
/// Where pearls that are no neighbours would meet, the strand is opened by this factor, so often at most.
const OPENED: f64 = 0.9;
const OPENINGS: usize = 30;
/// Places of a surface by which it is told how far it reaches, and what lies between them.
const POINTS: usize = 3000;
const BETWEEN: f64 = 1.002;

/// A pearl on the thread, about its middle.
pub(super) struct Bead {
    radius_mm: f64,
    /// How high its middle lies above the table.
    height_mm: f64,
    /// Places of its surface; none of a ball's.
    surface: Vec<DVec3>,
}

impl Bead {
    /// As it lies on the table.
    pub(super) fn new(radius_mm: f64, height_mm: f64, solid: Option<&Solid>) -> Self {
        let surface = solid.map_or_else(Vec::new, |solid| solid.places_mm(POINTS));
        Self { radius_mm, height_mm, surface }
    }

    /// How far it reaches from its middle in a direction.
    fn extent_mm(&self, along: DVec3) -> f64 {
        if self.surface.is_empty() {
            return self.radius_mm;
        }
        let far = self.surface.iter().map(|place| place.dot(along)).fold(0.0, f64::max);
        BETWEEN * far
    }

    /// How far from its place on the table, in a direction (x, z), the next pearl's is that it touches.
    fn step_mm(&self, next: &Self, [x, z]: [f64; 2]) -> f64 {
        if self.surface.is_empty() && next.surface.is_empty() {
            // Middles of unlike pearls on one table lie at unlike heights.
            return APART * 2.0 * (self.radius_mm * next.radius_mm).sqrt();
        }
        let up_mm = next.height_mm - self.height_mm;
        let mut step_mm = self.radius_mm + next.radius_mm;
        for _ in 0..ROUNDS {
            let along = DVec3::new(x * step_mm, up_mm, z * step_mm).normalize();
            let apart_mm = APART * (self.extent_mm(along) + next.extent_mm(-along));
            let found_mm = (apart_mm * apart_mm - up_mm * up_mm).max(0.0).sqrt();
            let change_mm = (found_mm - step_mm).abs();
            step_mm = found_mm;
            if change_mm <= SETTLED * step_mm {
                break;
            }
        }
        step_mm
    }
}

/// Places (x, z) of pearls on a table, from the left end of the strand to the right one; the front of the neck is towards
/// +z, the middle of what they fill is the origin.
pub(super) fn neck(beads: &[Bead]) -> Vec<[f64; 2]> {
    if beads.len() < 2 {
        return vec![[0.0; 2]; beads.len()];
    }
    let mut half_angle_rad = HALF_ANGLE_RAD;
    let mut places = touching(beads, half_angle_rad);
    for _ in 0..OPENINGS {
        if !do_meet(beads, &places) {
            break;
        }
        half_angle_rad *= OPENED;
        places = touching(beads, half_angle_rad);
    }
    let ends = |axis: usize| {
        let reach = |sign: f64| {
            let out = if axis == 0 { DVec3::X } else { DVec3::Z } * sign;
            let reaches = places.iter().zip(beads);
            sign * reaches
                .map(|(at, bead)| sign * at[axis] + bead.extent_mm(out))
                .fold(f64::NEG_INFINITY, f64::max)
        };
        0.5 * (reach(1.0) + reach(-1.0))
    };
    let middle = [ends(0), ends(1)];
    places.iter().map(|at| [at[0] - middle[0], at[1] - middle[1]]).collect()
}

/// The pearls on an ellipse of which they fill twice the angle, each touching the next.
fn touching(beads: &[Bead], half_angle_rad: f64) -> Vec<[f64; 2]> {
    let pairs = || beads.windows(2).map(|pair| (&pair[0], &pair[1]));
    let mut steps_mm: Vec<f64> =
        pairs().map(|(left, right)| left.step_mm(right, [1.0, 0.0])).collect();
    let mut places = spaced(&steps_mm, half_angle_rad);
    for _ in 0..ROUNDS {
        let step_mm = |((left, right), at): ((&Bead, &Bead), &[[f64; 2]])| {
            let [x, z] = [at[1][0] - at[0][0], at[1][1] - at[0][1]];
            let far_mm = libm::hypot(x, z);
            left.step_mm(right, [x / far_mm, z / far_mm])
        };
        let found_mm: Vec<f64> = pairs().zip(places.windows(2)).map(step_mm).collect();
        let changes = found_mm.iter().zip(&steps_mm).map(|(new, old)| (new / old - 1.0).abs());
        let change = changes.fold(0.0, f64::max);
        if change <= SETTLED {
            break;
        }
        steps_mm = found_mm;
        places = spaced(&steps_mm, half_angle_rad);
    }
    places
}

/// Places at these distances on the ellipse that they fill.
fn spaced(steps_mm: &[f64], half_angle_rad: f64) -> Vec<[f64; 2]> {
    let length_mm: f64 = steps_mm.iter().sum();
    // The strand's angle grows as the ellipse shrinks; chords are shorter than arcs, so begin below.
    let (mut small, mut large) =
        (0.1 * length_mm, 10.0 * length_mm / (half_angle_rad / HALF_ANGLE_RAD));
    for _ in 0..60 {
        let middle = 0.5 * (small + large);
        let angles = walked(middle, steps_mm, half_angle_rad);
        if angles.is_some_and(|angles| angles[steps_mm.len()] <= half_angle_rad) {
            large = middle;
        } else {
            small = middle;
        }
    }
    let angles = walked(large, steps_mm, half_angle_rad).unwrap_or_default();
    angles.iter().map(|angle| place(large, *angle)).collect()
}

/// Whether pearls that are no neighbours reach each other along the line between their middles.
fn do_meet(beads: &[Bead], places: &[[f64; 2]]) -> bool {
    let meet = |i: usize, j: usize| {
        let [x, z] = [places[j][0] - places[i][0], places[j][1] - places[i][1]];
        let between = DVec3::new(x, beads[j].height_mm - beads[i].height_mm, z);
        let apart_mm = between.length();
        let along = between / apart_mm;
        apart_mm < beads[i].extent_mm(along) + beads[j].extent_mm(-along)
    };
    (2..beads.len()).any(|j| (0..j - 1).any(|i| meet(i, j)))
}

/// A point of the ellipse by its angle from the front, to the right.
fn place(half_depth_mm: f64, angle_rad: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle_rad);
    [WIDTH_OVER_DEPTH * half_depth_mm * sin, half_depth_mm * cos]
}

/// The angles of pearls at these distances, the first at the left end; `None` where the ellipse is too small.
fn walked(half_depth_mm: f64, steps_mm: &[f64], half_angle_rad: f64) -> Option<Vec<f64>> {
    let mut angles = vec![-half_angle_rad];
    for step_mm in steps_mm {
        let from = *angles.last()?;
        let apart = |angle: f64| {
            let [a, b] = [place(half_depth_mm, from), place(half_depth_mm, angle)];
            libm::hypot(a[0] - b[0], a[1] - b[1])
        };
        let (mut near, mut far) = (from, from + std::f64::consts::FRAC_PI_2);
        if apart(far) < *step_mm {
            return None;
        }
        for _ in 0..50 {
            let middle = 0.5 * (near + far);
            if apart(middle) < *step_mm {
                near = middle;
            } else {
                far = middle;
            }
        }
        angles.push(far);
    }
    Some(angles)
}

#[cfg(test)]
mod tests {
    use nacreous_image::{FormParameters, Pose};

    use super::*;

    fn balls(radii_mm: &[f64]) -> Vec<Bead> {
        radii_mm.iter().map(|&radius_mm| Bead::new(radius_mm, radius_mm, None)).collect()
    }

    /// Middles in space.
    fn middles(beads: &[Bead]) -> Vec<DVec3> {
        let places = neck(beads);
        places
            .iter()
            .zip(beads)
            .map(|(at, bead)| DVec3::new(at[0], bead.height_mm, at[1]))
            .collect()
    }

    #[test]
    fn neighbours_touch_and_nobody_else_does() {
        for count in [2, 3, 9, 56] {
            let radius = |i: usize| 4.0 - 1.5 * (2.0 * i as f64 / count as f64 - 1.0).abs();
            let radii: Vec<f64> = (0..count).map(radius).collect();
            let places = middles(&balls(&radii));
            for i in 0..count {
                for j in 0..i {
                    let apart = places[i].distance(places[j]) / (radii[i] + radii[j]);
                    assert!(apart > 1.0, "{count}: {i} {j} {apart}");
                    assert!(i - j > 1 || apart < 1.01, "{count}: {i} {j} {apart}");
                }
            }
        }
    }

    #[test]
    fn pearls_of_any_shape_touch_as_they_reach_along_the_cord_and_overlap_nowhere() {
        let round = FormParameters::ROUND;
        let forms = [
            FormParameters { length: 1.4, ..round },
            FormParameters { length: 1.5, taper: 1.2, ..round },
            FormParameters { length: 0.7, flattening: 0.5, ..round },
            FormParameters { length: 1.2, lumps: 0.1, lump_rad: 0.9, ..round },
        ];
        for (form, count) in forms.iter().flat_map(|form| [3, 14].map(|count| (form, count))) {
            let solid = |i: usize| {
                let radius_mm = 3.0 + 0.5 * (i % 3) as f64;
                let form = FormParameters { seed: i as u64, ..*form };
                Solid::new(&form, Pose::new(0.3 * (i % 5) as f64, 1.2, 0.0), radius_mm)
            };
            let solids: Vec<Solid> = (0..count).map(solid).collect();
            let beads: Vec<Bead> = solids
                .iter()
                .map(|solid| Bead::new(3.0, solid.hull().below_mm(), Some(solid)))
                .collect();
            let places = middles(&beads);
            let surfaces: Vec<Vec<DVec3>> = solids.iter().map(|s| s.places_mm(5000)).collect();
            let reach = |i: usize, along: DVec3| {
                surfaces[i].iter().map(|place| place.dot(along)).fold(0.0, f64::max)
            };
            for i in 0..count {
                for j in 0..i {
                    let along = (places[i] - places[j]).normalize();
                    let apart_mm = places[i].distance(places[j]);
                    let apart = apart_mm / (reach(j, along) + reach(i, -along));
                    assert!(apart > 1.0, "{form:?} {count}: {i} {j} {apart}");
                    assert!(i - j > 1 || apart < 1.02, "{form:?} {count}: {i} {j} {apart}");
                }
            }
        }
    }

    #[test]
    fn an_even_strand_lies_alike_on_both_sides() {
        let places = neck(&balls(&[4.0; 21]));
        for (left, right) in places.iter().zip(places.iter().rev()) {
            assert!((left[0] + right[0]).abs() < 1e-6 && (left[1] - right[1]).abs() < 1e-6);
        }
        assert!(places[10][1] > places[0][1], "the front is towards the viewer");
    }
}
