//! The closed line around a middle along which colour changes most: the outline of what is not round.

use std::f64::consts::TAU;

use libm::{cos, sin, sqrt};

use crate::edge::Edge;
use crate::{Circle, Picture};

const TURNS: usize = 128;
/// Distances tried, in radii of the circle to start from.
const NEAREST: f64 = 0.5;
const FARTHEST: f64 = 2.0;
const STEPS: usize = 121;
/// Most places by which the line steps from a direction to the next, and what each of them costs, in the root of
/// steepness **(ours)**: a drop's tip is reached, a detour by the table does not pay.
const MOST_STEP: usize = 3;
const COST: f64 = 0.02;

/// The line that never steps far from a direction to the next, as edges.
pub fn closed_line(picture: &Picture<'_>, about: Circle) -> Vec<Edge> {
    let steep = polar(picture, about);
    // A first way from anywhere to anywhere finds where the closed one passes, half a turn on.
    let anywhere = way(&steep, 0, None);
    let through = anywhere[TURNS / 2];
    let closed = way(&steep, TURNS / 2, Some(through));
    (0..TURNS)
        .map(|turn| {
            let step = closed[(turn + TURNS / 2) % TURNS];
            Edge {
                turn: TAU * turn as f64 / TURNS as f64,
                away: about.radius_px * distance(step),
                seen: true,
            }
        })
        .collect()
}

fn distance(step: usize) -> f64 {
    NEAREST + (FARTHEST - NEAREST) * step as f64 / (STEPS - 1) as f64
}

/// How much more steeply shade changes outwards than aside, [turn][step]; the root, as in the search for circles.
fn polar(picture: &Picture<'_>, about: Circle) -> Vec<Vec<f64>> {
    let mut steep = Vec::with_capacity(TURNS);
    let span = 0.5 * (FARTHEST - NEAREST) / (STEPS - 1) as f64;
    for at in 0..TURNS {
        let turn = TAU * at as f64 / TURNS as f64;
        let shade = |share: f64, aside: f64| {
            let away = about.radius_px * share;
            let (c, s) = (cos(turn + aside), sin(turn + aside));
            let rgb = picture.at(about.x_px + c * away, about.y_px + s * away);
            rgb.map(|light| sqrt(light.max(0.0)))
        };
        let one = |step: usize| {
            let away = distance(step);
            let across = difference(shade(away - span, 0.0), shade(away + span, 0.0));
            let along = difference(shade(away, -span / away), shade(away, span / away));
            sqrt((across - along).max(0.0))
        };
        steep.push((0..STEPS).map(one).collect());
    }
    steep
}

fn difference(one: [f64; 3], other: [f64; 3]) -> f64 {
    sqrt((0..3).map(|i| (one[i] - other[i]) * (one[i] - other[i])).sum())
}

/// The way of the greatest sum, from direction `start` once round; from and to one place if given.
fn way(steep: &[Vec<f64>], start: usize, fixed: Option<usize>) -> Vec<usize> {
    let allowed = |step: usize| fixed.is_none_or(|place| place == step);
    let mut sums: Vec<f64> = (0..STEPS)
        .map(|step| if allowed(step) { steep[start][step] } else { f64::NEG_INFINITY })
        .collect();
    let mut come_from = Vec::with_capacity(TURNS);
    for at in 1..=TURNS {
        let line = &steep[(start + at) % TURNS];
        let mut next = vec![0.0; STEPS];
        let mut from = vec![0; STEPS];
        for step in 0..STEPS {
            let near = step.saturating_sub(MOST_STEP)..=(step + MOST_STEP).min(STEPS - 1);
            let left = |other: usize| sums[other] - COST * step.abs_diff(other) as f64;
            let best =
                near.fold(step, |best, other| if left(other) > left(best) { other } else { best });
            from[step] = best;
            next[step] = left(best) + line[step];
        }
        come_from.push(from);
        sums = next;
    }
    let mut step = fixed.unwrap_or_else(|| {
        (0..STEPS).fold(0, |best, other| if sums[other] > sums[best] { other } else { best })
    });
    let mut places = vec![0; TURNS];
    for at in (0..TURNS).rev() {
        step = come_from[at][step];
        places[at] = step;
    }
    places
}
