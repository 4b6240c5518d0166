//! Where the pearl ends along a ray from its middle, finer than a pixel.

use libm::{cos, sin, sqrt};

use crate::rim::half_level;
use crate::{Circle, Picture};

/// Step along a ray, and the half of the span over which light is compared, in pixels.
const STEP_PX: f64 = 0.5;
const SPAN: usize = 2;
/// The least step of shade (1 is white) that counts as an edge.
const LEAST_RISE: f64 = 0.02;
/// How far to both sides of the steepest place the edge's middle is worked out, in steps.
const AROUND: usize = 5;

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

/// The edge near `expected`, within `reach` pixels to both sides of it, along a ray.
///
/// The steepest place is looked for in the root of light, of about equal visibility. Near it the edge is where
/// light is half-way between the pearl's own there and that beyond (`rim`); where that has no answer, the
/// mean place of the change in linear light.
pub fn edge(picture: &Picture<'_>, middle: Circle, turn: f64, expected: f64, reach: f64) -> Edge {
    let reach = reach.max(STEP_PX * (SPAN + 1) as f64);
    let first = (expected - reach).max(STEP_PX);
    let steps = ((expected + reach - first) / STEP_PX) as usize + 1;
    let (c, s) = (cos(turn), sin(turn));
    let line: Vec<[f64; 3]> = (0..steps)
        .map(|step| first + STEP_PX * step as f64)
        .map(|away| picture.at(middle.x_px + c * away, middle.y_px + s * away))
        .collect();
    let shade: Vec<[f64; 3]> =
        line.iter().map(|rgb| rgb.map(|light| sqrt(light.max(0.0)))).collect();
    let mut steepest = (0.0, SPAN);
    for at in SPAN..steps.saturating_sub(SPAN) {
        let rise = distance(shade[at + SPAN], shade[at - SPAN]);
        if rise > steepest.0 {
            steepest = (rise, at);
        }
    }
    let about = first + STEP_PX * middle_of_change(&line, steepest.1);
    let away = half_level(picture, middle, (c, s), about).unwrap_or(about);
    let (x, y) = (middle.x_px + c * away, middle.y_px + s * away);
    let (width, height) = (picture.width() as f64, picture.height() as f64);
    let within = x > 0.0 && y > 0.0 && x < width && y < height;
    Edge { turn, away, seen: within && steepest.0 > LEAST_RISE }
}

/// The mean place of the change around a step of the line, in steps.
///
/// Changes count by their square: the slow ones of the pearl's own shading at its rim for little.
fn middle_of_change(line: &[[f64; 3]], at: usize) -> f64 {
    let (first, last) = (at.saturating_sub(AROUND), (at + AROUND).min(line.len() - 1));
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

fn difference(first: [f64; 3], second: [f64; 3]) -> [f64; 3] {
    [first[0] - second[0], first[1] - second[1], first[2] - second[2]]
}

fn distance(first: [f64; 3], second: [f64; 3]) -> f64 {
    let [r, g, b] = difference(first, second);
    sqrt(r * r + g * g + b * b)
}
