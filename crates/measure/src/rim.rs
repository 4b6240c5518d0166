//! Where a ball ends along a ray: half-way between its own light there and that of what is beyond.

use libm::fabs;

use crate::{Circle, Picture};

/// Step along a ray, in pixels.
const STEP_PX: f64 = 0.25;
/// Where light inside is read, and outside, in pixels off the edge: beyond what a pixel there has of both.
const INSIDE: (f64, f64) = (1.25, 2.5);
const OUTSIDE: (f64, f64) = (1.5, 3.5);
/// How far from the last place the half level is looked for, in pixels, and how far from the first it may lie.
const REACH_PX: f64 = 1.5;
const FARTHEST_PX: f64 = 2.5;
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
) -> Option<f64> {
    let at = |away: f64| picture.at(middle.x_px + right * away, middle.y_px + down * away);
    let mut edge = about;
    for _ in 0..ROUNDS {
        let inner: Vec<[f64; 3]> = steps(INSIDE).map(|off| at(edge - off)).collect();
        let beyond = mean(&steps(OUTSIDE).map(|off| at(edge + off)).collect::<Vec<_>>());
        let own = mean(&inner);
        // Light above that of the surroundings, along the way of colour from there to the pearl.
        let above = |rgb: [f64; 3]| -> f64 {
            (0..3).map(|i| (own[i] - beyond[i]) * (rgb[i] - beyond[i])).sum()
        };
        let level = 0.5 * carried_on(&inner.iter().map(|rgb| above(*rgb)).collect::<Vec<_>>());
        edge = last_above(|away| above(at(away)), edge, level)?;
    }
    (fabs(edge - about) < FARTHEST_PX).then_some(edge)
}

fn steps((first, last): (f64, f64)) -> impl Iterator<Item = f64> {
    let count = ((last - first) / STEP_PX) as usize;
    (0..=count).map(move |step| first + STEP_PX * step as f64)
}

fn mean(line: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|channel| line.iter().map(|rgb| rgb[channel]).sum::<f64>() / line.len() as f64)
}

/// Light at the edge, from that at `steps(INSIDE)`, by the line of least squares.
fn carried_on(inner: &[f64]) -> f64 {
    let middle = 0.5 * (INSIDE.0 + INSIDE.1);
    let mean = inner.iter().sum::<f64>() / inner.len() as f64;
    let (mut along, mut square) = (0.0, 0.0);
    for (off, light) in steps(INSIDE).zip(inner) {
        along += (off - middle) * light;
        square += (off - middle) * (off - middle);
    }
    (mean - along / square * middle).max(LEAST_LEFT * mean)
}

/// The outermost place near `edge` where light falls below a level; None where it does not.
fn last_above(light: impl Fn(f64) -> f64, edge: f64, level: f64) -> Option<f64> {
    let mut beyond = light(edge + REACH_PX);
    if beyond >= level {
        return None;
    }
    let count = (2.0 * REACH_PX / STEP_PX) as usize;
    for away in (1..=count).map(|step| edge + REACH_PX - STEP_PX * step as f64) {
        let here = light(away);
        if here >= level {
            return Some(away + STEP_PX * (here - level) / (here - beyond));
        }
        beyond = here;
    }
    None
}
