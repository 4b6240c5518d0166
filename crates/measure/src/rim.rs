//! Where a ball ends along a ray: half-way between its own light there and that of what is beyond.

use libm::fabs;

use crate::{Circle, Picture};

/// Step along a ray, in pixels.
const STEP_PX: f64 = 0.25;
/// Where light inside is read, and outside, in pixels off the edge: beyond what a pixel there has of both; each further by
/// so many standard deviations of the outline's blur, up to a share of the radius **(ours)**.
const INSIDE: (f64, f64) = (1.25, 2.5);
const OUTSIDE: (f64, f64) = (1.5, 3.5);
const SOFTER: (f64, f64) = (2.0, 3.0);
const MOST_SOFTER: f64 = 0.3;
/// How far from the last place the half level is looked for, in pixels, and how far from the first it may lie.
const REACH_PX: f64 = 1.5;
const FARTHEST_PX: f64 = 2.5;
/// More of both by the outline's blur.
const REACH_SOFTER: f64 = 1.0;
const ROUNDS: usize = 3;
/// Light inside that falls towards the edge is not followed below this share of what it is on average.
const LEAST_LEFT: f64 = 0.3;

/// The end of the ball near `about`, along a ray; None where inside and outside do not differ.
///
/// A ball darkens, or lightens, towards its rim, the more the nearer: the steepest place lies inside. So its
/// light is read a little inside and carried on straight to the edge **(ours)**; there half of it, and half of
/// what is beyond, make up a pixel.
pub fn half_level(
    picture: &Picture<'_>,
    middle: Circle,
    (right, down): (f64, f64),
    about: f64,
    soft: f64,
) -> Option<f64> {
    let wide = soft.min(MOST_SOFTER / SOFTER.1 * middle.radius_px);
    let further = |(first, last): (f64, f64)| (first + SOFTER.0 * wide, last + SOFTER.1 * wide);
    let (inside, outside) = (further(INSIDE), further(OUTSIDE));
    let (reach, farthest) = (REACH_PX + REACH_SOFTER * soft, FARTHEST_PX + REACH_SOFTER * soft);
    let at = |away: f64| picture.at(middle.x_px + right * away, middle.y_px + down * away);
    let mut edge = about;
    for _ in 0..ROUNDS {
        let inner: Vec<[f64; 3]> = steps(inside).map(|off| at(edge - off)).collect();
        let beyond = mean(&steps(outside).map(|off| at(edge + off)).collect::<Vec<_>>());
        let own = mean(&inner);
        // Light above that of the surroundings, along the way of colour from there to the pearl.
        let above = |rgb: [f64; 3]| -> f64 {
            (0..3).map(|i| (own[i] - beyond[i]) * (rgb[i] - beyond[i])).sum()
        };
        let level =
            0.5 * carried_on(inside, &inner.iter().map(|rgb| above(*rgb)).collect::<Vec<_>>());
        edge = last_above(|away| above(at(away)), edge, level, reach)?;
    }
    (fabs(edge - about) < farthest).then_some(edge)
}

/// Distances from the first to the last, about a step apart.
fn steps((first, last): (f64, f64)) -> impl Iterator<Item = f64> {
    let count = ((last - first) / STEP_PX) as usize;
    let step = (last - first) / count as f64;
    (0..=count).map(move |at| first + step * at as f64)
}

fn mean(line: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|channel| line.iter().map(|rgb| rgb[channel]).sum::<f64>() / line.len() as f64)
}

/// Light at the edge, from that at `steps(inside)`, by the line of least squares.
fn carried_on(inside: (f64, f64), inner: &[f64]) -> f64 {
    let middle = 0.5 * (inside.0 + inside.1);
    let mean = inner.iter().sum::<f64>() / inner.len() as f64;
    let (mut along, mut square) = (0.0, 0.0);
    for (off, light) in steps(inside).zip(inner) {
        along += (off - middle) * light;
        square += (off - middle) * (off - middle);
    }
    (mean - along / square * middle).max(LEAST_LEFT * mean)
}

/// The outermost place near `edge` where light falls below a level; None where it does not.
fn last_above(light: impl Fn(f64) -> f64, edge: f64, level: f64, reach: f64) -> Option<f64> {
    let mut beyond = light(edge + reach);
    if beyond >= level {
        return None;
    }
    let count = (2.0 * reach / STEP_PX) as usize;
    for away in (1..=count).map(|step| edge + reach - STEP_PX * step as f64) {
        let here = light(away);
        if here >= level {
            return Some(away + STEP_PX * (here - level) / (here - beyond));
        }
        beyond = here;
    }
    None
}
