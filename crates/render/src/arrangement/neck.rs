//! A strand as it lies around a neck: pearls that touch, along an ellipse that is open at the back.
//!
//! Each pearl is found from the one before by its distance; the ellipse is as large as the strand needs.
//! Left out: how a thread bends, and clasp and knots, for which there is the gap.

/// The ellipse's width over its depth **(ours)**: a choker on a bust.
const WIDTH_OVER_DEPTH: f64 = 0.85;
/// Half of the angle that the pearls fill, from the front.
const HALF_ANGLE_RAD: f64 = 2.5;
/// Pearls on a thread do not quite touch: their distance over the sum of their radii.
const APART: f64 = 1.004;

/// Places (x, z) of balls of these radii on a table, from the left end of the strand to the right one; the front of the neck
/// is towards +z, the middle of what they fill is the origin.
pub(super) fn neck(radii_mm: &[f64]) -> Vec<[f64; 2]> {
    if radii_mm.len() < 2 {
        return vec![[0.0; 2]; radii_mm.len()];
    }
    let steps_mm: Vec<f64> = radii_mm
        .windows(2)
        // Middles of unlike pearls on one table lie at unlike heights.
        .map(|pair| APART * 2.0 * (pair[0] * pair[1]).sqrt())
        .collect();
    let length_mm: f64 = steps_mm.iter().sum();
    // The strand's angle grows as the ellipse shrinks; chords are shorter than arcs, so begin below.
    let (mut small, mut large) = (0.1 * length_mm, 10.0 * length_mm);
    for _ in 0..60 {
        let middle = 0.5 * (small + large);
        if walked(middle, &steps_mm).is_some_and(|angles| angles[steps_mm.len()] <= HALF_ANGLE_RAD)
        {
            large = middle;
        } else {
            small = middle;
        }
    }
    let angles = walked(large, &steps_mm).unwrap_or_default();
    let places: Vec<[f64; 2]> = angles.iter().map(|angle| place(large, *angle)).collect();
    let ends = |axis: usize| {
        let reach = |sign: f64| {
            let reaches = places.iter().zip(radii_mm);
            sign * reaches.map(|(at, r)| sign * at[axis] + r).fold(f64::NEG_INFINITY, f64::max)
        };
        0.5 * (reach(1.0) + reach(-1.0))
    };
    let middle = [ends(0), ends(1)];
    places.iter().map(|at| [at[0] - middle[0], at[1] - middle[1]]).collect()
}

/// A point of the ellipse by its angle from the front, to the right.
fn place(half_depth_mm: f64, angle_rad: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle_rad);
    [WIDTH_OVER_DEPTH * half_depth_mm * sin, half_depth_mm * cos]
}

/// The angles of pearls at these distances, the first at the left end; `None` where the ellipse is too small.
fn walked(half_depth_mm: f64, steps_mm: &[f64]) -> Option<Vec<f64>> {
    let mut angles = vec![-HALF_ANGLE_RAD];
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
    use super::*;

    #[test]
    fn neighbours_touch_and_nobody_else_does() {
        for count in [2, 3, 9, 56] {
            let radius = |i: usize| 4.0 - 1.5 * (2.0 * i as f64 / count as f64 - 1.0).abs();
            let radii: Vec<f64> = (0..count).map(radius).collect();
            let places = neck(&radii);
            for i in 0..count {
                for j in 0..i {
                    let flat =
                        libm::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1]);
                    let apart = flat.hypot(radii[i] - radii[j]) / (radii[i] + radii[j]);
                    assert!(apart > 1.0, "{count}: {i} {j} {apart}");
                    assert!(i - j > 1 || apart < 1.01, "{count}: {i} {j} {apart}");
                }
            }
        }
    }

    #[test]
    fn an_even_strand_lies_alike_on_both_sides() {
        let places = neck(&[4.0; 21]);
        for (left, right) in places.iter().zip(places.iter().rev()) {
            assert!((left[0] + right[0]).abs() < 1e-6 && (left[1] - right[1]).abs() < 1e-6);
        }
        assert!(places[10][1] > places[0][1], "the front is towards the viewer");
    }
}
