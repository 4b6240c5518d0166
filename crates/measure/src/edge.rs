//! Where the pearl ends along a ray from its middle, finer than a pixel.

use libm::{cos, sin, sqrt};

use crate::rim::half_level;
use crate::{Circle, Picture};

/// Step along a ray, in pixels, and the half of the span over which light is compared, in steps.
const STEP_PX: f64 = 0.5;
const SPAN: usize = 2;
/// The least step of shade (1 is white) that counts as an edge.
const LEAST_RISE: f64 = 0.02;
/// How far to both sides of the steepest place the edge's middle is worked out, in steps, and steps more by softness.
const AROUND: usize = 5;
const AROUND_SOFT: f64 = 4.0;

/// The steepest place of one ray.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// Direction, clockwise from the right, as y runs down.
    pub turn: f64,
    /// Distance from the middle, in pixels.
    pub away: f64,
    /// Whether it is steep enough, and within the picture.
    pub seen: bool,
}

/// The edge near `expected`, within `reach` pixels to both sides of it, along a ray; `soft`: the outline's blur, a standard
/// deviation in pixels.
///
/// The steepest place is looked for in the root of light, of about equal visibility. Near it the edge is where
/// light is half-way between the pearl's own there and that beyond (`rim`); where that has no answer, the
/// mean place of the change in linear light.
pub fn edge(
    picture: &Picture<'_>,
    middle: Circle,
    turn: f64,
    expected: f64,
    reach: f64,
    soft: f64,
) -> Edge {
    let found = steepest(picture, middle, turn, expected, reach, soft);
    let (c, s) = (cos(turn), sin(turn));
    let away = half_level(picture, middle, (c, s), found.away, soft).unwrap_or(found.away);
    let (x, y) = (middle.x_px + c * away, middle.y_px + s * away);
    let (width, height) = (picture.width() as f64, picture.height() as f64);
    let within = x > 0.0 && y > 0.0 && x < width && y < height;
    Edge { turn, away, seen: within && found.seen }
}

/// The mean place of the steepest change near `expected`, along a ray.
pub fn steepest(
    picture: &Picture<'_>,
    middle: Circle,
    turn: f64,
    expected: f64,
    reach: f64,
    soft: f64,
) -> Edge {
    let span = SPAN + (soft / STEP_PX) as usize;
    // Beyond what is compared there is as much to look at as of a sharp outline.
    let reach = reach.max(STEP_PX * (SPAN + 1) as f64 + soft) + STEP_PX * (span - SPAN) as f64;
    let first = (expected - reach).max(STEP_PX);
    let steps = ((expected + reach - first) / STEP_PX) as usize + 1;
    let (c, s) = (cos(turn), sin(turn));
    let line: Vec<[f64; 3]> = (0..steps)
        .map(|step| first + STEP_PX * step as f64)
        .map(|away| picture.at(middle.x_px + c * away, middle.y_px + s * away))
        .collect();
    let shades: Vec<[f64; 3]> = line.iter().map(|rgb| shade(*rgb)).collect();
    let mut steepest = (0.0, span);
    for at in span..steps.saturating_sub(span) {
        let rise = distance(shades[at + span], shades[at - span]);
        if rise > steepest.0 {
            steepest = (rise, at);
        }
    }
    let around = AROUND + (AROUND_SOFT * soft) as usize;
    let away = first + STEP_PX * middle_of_change(&line, steepest.1, around);
    Edge { turn, away, seen: steepest.0 > LEAST_RISE }
}

/// The mean place of the change around a step of the line, in steps.
///
/// Changes count by their square: the slow ones of the pearl's own shading at its rim for little.
fn middle_of_change(line: &[[f64; 3]], at: usize, around: usize) -> f64 {
    let (first, last) = (at.saturating_sub(around), (at + around).min(line.len() - 1));
    let whole = difference(line[last], line[first]);
    let (mut sum, mut moment) = (0.0, 0.0);
    for step in first..last {
        let part = difference(line[step + 1], line[step]);
        let along = (part[0] * whole[0] + part[1] * whole[1] + part[2] * whole[2]).max(0.0);
        sum += along * along;
        moment += along * along * (step as f64 + 0.5);
    }
    if sum > 0.0 { moment / sum } else { at as f64 }
}

/// The root of light, of about equal visibility.
pub fn shade(rgb: [f64; 3]) -> [f64; 3] {
    rgb.map(|light| sqrt(light.max(0.0)))
}

pub fn difference(first: [f64; 3], second: [f64; 3]) -> [f64; 3] {
    [first[0] - second[0], first[1] - second[1], first[2] - second[2]]
}

pub fn distance(first: [f64; 3], second: [f64; 3]) -> f64 {
    let [r, g, b] = difference(first, second);
    sqrt(r * r + g * g + b * b)
}
