//! Where a ball ends along a ray, by the light that its pixels hold.

use libm::{asin, fabs, sqrt};

use crate::{Circle, Picture};

/// Step along a ray, in pixels.
const STEP_PX: f64 = 0.5;
/// Steps to both sides of the edge that pixels of both sides may share.
const SHARED: usize = 5;
/// Steps beyond them that tell the light inside, at the least, and the same in radii; and outside.
const INSIDE: (usize, f64) = (8, 0.06);
const OUTSIDE: usize = 5;

/// The end of the ball near `about`, along a ray; None where inside and outside do not differ.
///
/// Light on a ball is smooth in the cosine of the view angle, so near the rim `a + c cos`: it falls, or
/// rises, ever more steeply, and the steepest place lies inside the outline. Both numbers are read a few
/// pixels inside, that of the surroundings a few outside. The edge is where `a + c cos` up to it, and the
/// surroundings from there on, hold as much light as the pixels between: a blur that is even moves none
/// of it.
pub fn end_of_ball(
    picture: &Picture<'_>,
    middle: Circle,
    (right, down): (f64, f64),
    about: f64,
) -> Option<f64> {
    let inside = INSIDE.0.max((INSIDE.1 * middle.radius_px / STEP_PX) as usize);
    let first = about - STEP_PX * (SHARED + inside) as f64;
    if first <= 0.0 {
        return None;
    }
    let place = |step: usize| first + STEP_PX * step as f64;
    let line: Vec<[f64; 3]> = (0..=inside + 2 * SHARED + OUTSIDE)
        .map(|step| picture.at(middle.x_px + right * place(step), middle.y_px + down * place(step)))
        .collect();
    let (near, rest) = line.split_at(inside);
    let (shared, far) = rest.split_at(2 * SHARED + 1);
    let beyond = mean(far);
    let difference = [0, 1, 2].map(|channel| near[inside - 1][channel] - beyond[channel]);
    // Light above that of the surroundings, as far as it differs in their direction of colour.
    let above = |rgb: &[f64; 3]| -> f64 {
        (0..3).map(|channel| difference[channel] * (rgb[channel] - beyond[channel])).sum()
    };
    let inner: Vec<f64> = near.iter().map(above).collect();
    let held = STEP_PX * shared.iter().map(above).sum::<f64>();
    let (start, stop) = (place(inside) - 0.5 * STEP_PX, place(inside + 2 * SHARED) + 0.5 * STEP_PX);
    let mut edge = about;
    for _ in 0..3 {
        let cosines = (0..inside).map(|step| cosine(place(step), edge));
        let (level, slope) = straight(cosines, &inner)?;
        let up_to = |edge: f64| level * (edge - start) + slope * below_cosine(start, edge);
        edge = crossing(|edge| up_to(edge) - held, (start, stop))?;
    }
    (fabs(edge - about) < STEP_PX * SHARED as f64).then_some(edge)
}

fn cosine(away: f64, edge: f64) -> f64 {
    let share = away / edge;
    sqrt((1.0 - share * share).max(0.0))
}

/// The integral of `cosine` from `start` to the edge.
fn below_cosine(start: f64, edge: f64) -> f64 {
    let share = (start / edge).min(1.0);
    0.5 * edge * (std::f64::consts::FRAC_PI_2 - asin(share) - share * sqrt(1.0 - share * share))
}

fn mean(line: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|channel| line.iter().map(|rgb| rgb[channel]).sum::<f64>() / line.len() as f64)
}

/// Level at 0 and slope of the line of least squares; None of places that are all the same.
fn straight(places: impl Iterator<Item = f64>, values: &[f64]) -> Option<(f64, f64)> {
    let (mut x, mut y, mut xx, mut xy) = (0.0, 0.0, 0.0, 0.0);
    for (place, value) in places.zip(values) {
        x += place;
        y += value;
        xx += place * place;
        xy += place * value;
    }
    let count = values.len() as f64;
    let spread = count * xx - x * x;
    let slope = (count * xy - x * y) / spread;
    (spread > 0.0 && slope.is_finite()).then(|| ((y - slope * x) / count, slope))
}

/// Where a function changes its sign between two places, by halving; None where it does not.
fn crossing(function: impl Fn(f64) -> f64, (mut low, mut high): (f64, f64)) -> Option<f64> {
    let sign = function(low) > 0.0;
    if (function(high) > 0.0) == sign {
        return None;
    }
    for _ in 0..24 {
        let between = f64::midpoint(low, high);
        if (function(between) > 0.0) == sign {
            low = between;
        } else {
            high = between;
        }
    }
    Some(f64::midpoint(low, high))
}
