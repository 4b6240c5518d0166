//! How soft an outline is, and whether an edge is as sharp as it.

use std::f64::consts::TAU;

use libm::{atan2, cos, sin, sqrt};

use crate::Picture;
use crate::contour::Contour;
use crate::edge::{difference, distance, shade, steepest};

/// Directions in which the change across the outline is added up, how far to both sides, and in which steps, in pixels.
const RAYS: usize = 120;
const REACH_PX: f64 = 12.0;
const STEP_PX: f64 = 0.25;
/// Where light is compared for how much it changes, in pixels off the edge.
const BESIDE_PX: f64 = 3.0;
/// The half width of the change at half its height, in standard deviations of a Gaussian.
const HALF_WIDTH: f64 = 1.177;
/// The standard deviation of what pixels and the lines between them do to an edge by themselves.
const SHARP_PX: f64 = 0.85;
/// Half of the span over which an edge's change is compared with that beside it: pixels, and softnesses.
const SPAN: (f64, f64) = (1.25, 1.2);
/// An edge that goes on to both sides by this share of its own change is softer than the outline: a shadow's **(ours)**.
const GOES_ON: f64 = 0.3;

/// Standard deviation of the blur that an outline has, in pixels; 0 of a sharp one.
///
/// The change of light along rays is laid on one another by its steepest place, and the narrower side of it at half its
/// height tells: a pearl's shading widens the other.
pub fn softness(picture: &Picture<'_>, contour: &Contour, reach: f64) -> f64 {
    let count = (2.0 * REACH_PX / STEP_PX) as usize;
    let mut change = vec![0.0; count];
    for at in 0..RAYS {
        let turn = TAU * at as f64 / RAYS as f64;
        let found = steepest(picture, contour.middle, turn, contour.radius(turn), reach, 0.0);
        if !found.seen {
            continue;
        }
        let light = |off: f64| {
            let [x, y] = contour.place(turn, found.away - contour.radius(turn) + off);
            picture.at(x, y)
        };
        let whole = difference(light(BESIDE_PX), light(-BESIDE_PX));
        let size = sqrt(whole.iter().map(|one| one * one).sum::<f64>()).max(1e-9);
        let along = |rgb: [f64; 3]| (0..3).map(|i| whole[i] * rgb[i]).sum::<f64>() / size;
        let mut last = along(light(-REACH_PX));
        for (step, sum) in change.iter_mut().enumerate() {
            let next = along(light(STEP_PX * (step + 1) as f64 - REACH_PX));
            *sum += next - last;
            last = next;
        }
    }
    let own = half_width(&change) / HALF_WIDTH;
    sqrt((own * own - SHARP_PX * SHARP_PX).max(0.0))
}

/// From the highest step near the middle to half its height, on the side where that is nearer, in pixels.
fn half_width(change: &[f64]) -> f64 {
    let middle = change.len() / 2;
    let near = (BESIDE_PX / STEP_PX) as usize;
    let top = (middle - near..middle + near)
        .fold(middle, |best, at| if change[at] > change[best] { at } else { best });
    let half = 0.5 * change[top];
    let until = |line: &mut dyn Iterator<Item = f64>| {
        let (mut steps, mut last) = (0.0, change[top]);
        for next in line {
            if next < half {
                return STEP_PX * (steps + (last - half) / (last - next));
            }
            (steps, last) = (steps + 1.0, next);
        }
        STEP_PX * steps
    };
    let outwards = until(&mut change[top + 1..].iter().copied());
    let inwards = until(&mut change[..top].iter().rev().copied());
    outwards.min(inwards)
}

/// Whether shade changes at a place alone, straight across the edge there, and not as much on both sides of it too;
/// `soft`: the outline's own blur.
pub fn is_sharp(picture: &Picture<'_>, [x, y]: [f64; 2], soft: f64) -> bool {
    let span = SPAN.0 + SPAN.1 * soft;
    let at =
        |(c, s): (f64, f64), off: f64| shade(picture.at(x + off * span * c, y + off * span * s));
    let slope = |way: (f64, f64)| difference(at(way, 1.0), at(way, -1.0));
    let (right, down) = (slope((1.0, 0.0)), slope((0.0, 1.0)));
    let sum = |one: [f64; 3], other: [f64; 3]| (0..3).map(|i| one[i] * other[i]).sum::<f64>();
    // The way of the greatest change, as the tensor of both slopes has it.
    let turn = 0.5 * atan2(2.0 * sum(right, down), sum(right, right) - sum(down, down));
    let way = (cos(turn), sin(turn));
    let [far_in, inside, beyond, far_out] = [-3.0, -1.0, 1.0, 3.0].map(|off| at(way, off));
    let beside = distance(far_in, inside).min(distance(beyond, far_out));
    beside < GOES_ON * distance(inside, beyond)
}
