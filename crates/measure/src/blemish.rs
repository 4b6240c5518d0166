//! Blemishes: spots that differ from the pearl around them.

use libm::{cos, fabs, sin, sqrt};
use serde::Serialize;

use crate::disc::{Disc, Pixel};
use crate::lamp::Highlight;
use crate::value::median;
use crate::{Circle, Value};

/// Out to here the pearl is looked at: nearer to the rim, spots are seen too obliquely.
const FARTHEST: f64 = 0.9;
/// What is left out around the lamp's image: half-widths, and degrees of the normal.
const CLEAR: (f64, f64) = (1.6, 8.0);
/// How far to both sides of a place the pearl around it is looked at, in radii: spots up to this across
/// are seen whole **(ours)**.
const REACH: f64 = 0.2;
/// Directions in which that is done, and how many of them must lie on what is looked at.
const DIRECTIONS: usize = 8;
const LEAST_DIRECTIONS: usize = 5;
/// Difference from there, in CIELAB, from which a pixel belongs to a spot, and the same in medians
/// over the pearl, whose own texture differs too **(ours)**.
const LEAST_DIFFERENCE: f64 = 3.0;
const DEVIATIONS: f64 = 5.0;
/// The smallest spot, in shares of the disc.
const LEAST_SPOT: f64 = 2e-4;

/// Spots found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Blemishes {
    /// Their area on the ball, in percent of what was looked at; its error: half of what a threshold a
    /// quarter lower or higher changes.
    pub area: Value,
    /// How many there are.
    pub count: usize,
    /// Share of the visible half of the ball that was looked at.
    pub looked_at: f64,
    /// The difference that counted, in CIELAB.
    pub threshold: f64,
    /// Middles, and radii of discs as large as they look, in pixels, the largest first.
    pub spots: Vec<Circle>,
}

/// Looks for spots on a ball; None where too little of it is left.
pub fn blemishes(disc: &Disc, circle: &Circle, highlight: Option<Highlight>) -> Option<Blemishes> {
    let looks = |pixel: &Pixel| {
        let lamp = highlight.is_some_and(|lamp| lamp.covers(circle, pixel.place, CLEAR.0, CLEAR.1));
        pixel.away < FARTHEST && !pixel.clipped && !lamp
    };
    let held: Vec<bool> =
        disc.pixels.iter().map(|pixel| pixel.as_ref().is_some_and(looks)).collect();
    let areas = areas(disc, circle);
    let whole: f64 =
        areas.iter().zip(&held).map(|(area, held)| f64::from(u8::from(*held)) * area).sum();
    let unit = disc.factor as f64 / circle.radius_px;
    let looked_at = whole * unit * unit / std::f64::consts::TAU;
    if looked_at < 0.1 {
        return None;
    }
    let difference = differences(disc, &held, circle.radius_px);
    let mut sizes: Vec<f64> =
        difference.iter().zip(&held).filter(|(_, held)| **held).map(|(one, _)| *one).collect();
    let threshold = (DEVIATIONS * median(&mut sizes)).max(LEAST_DIFFERENCE);
    let least = LEAST_SPOT * std::f64::consts::PI / (unit * unit);
    let at = |threshold: f64| {
        let mut spots = spots(disc, &difference, &held, threshold);
        spots.retain(|spot| spot.len() as f64 >= least.max(2.0));
        spots
    };
    let percent = |spots: &[Vec<usize>]| {
        // The sum of nothing is -0.
        100.0 * spots.iter().flatten().map(|&at| areas[at]).sum::<f64>() / whole + 0.0
    };
    let found = at(threshold);
    let doubt = 0.5 * (percent(&at(0.75 * threshold)) - percent(&at(1.25 * threshold)));
    let mut spots: Vec<Circle> = found.iter().map(|spot| around(disc, spot)).collect();
    spots.sort_by(|one, other| other.radius_px.total_cmp(&one.radius_px));
    let area = Value::new(percent(&found), fabs(doubt));
    Some(Blemishes { area, count: spots.len(), looked_at, threshold, spots })
}

/// What each pixel covers of the ball, in pixels seen from straight ahead.
fn areas(disc: &Disc, circle: &Circle) -> Vec<f64> {
    let area = |pixel: &Option<Pixel>| {
        let normal = pixel.as_ref().and_then(|pixel| circle.normal(pixel.place.0, pixel.place.1));
        normal.map_or(0.0, |normal| 1.0 / normal[2].max(0.2))
    };
    disc.pixels.iter().map(area).collect()
}

/// How far each pixel's colour is from that of the pearl around it, in CIELAB.
///
/// A spot differs in the same way from the mean of its two neighbours in every direction: of all the least
/// difference counts. Slopes have none, edges that pass through, such as a mirrored horizon, none along them,
/// and a glow other signs along and across.
fn differences(disc: &Disc, held: &[bool], radius_px: f64) -> Vec<f64> {
    let own = |at: usize| disc.pixels[at].as_ref().filter(|_| held[at]).map(|pixel| pixel.lab);
    let colours: Vec<Option<[f64; 3]>> = (0..held.len()).map(own).collect();
    let reach = REACH * radius_px / disc.factor as f64;
    let steps: Vec<isize> = (0..DIRECTIONS)
        .map(|at| std::f64::consts::PI * at as f64 / DIRECTIONS as f64)
        .map(|turn| ((reach * cos(turn)).round() as isize, (reach * sin(turn)).round() as isize))
        .map(|(right, down)| down * disc.width.cast_signed() + right)
        .collect();
    (0..held.len()).map(|at| least_difference(&colours, at, &steps)).collect()
}

fn least_difference(colours: &[Option<[f64; 3]>], at: usize, steps: &[isize]) -> f64 {
    let Some(own) = colours[at] else { return 0.0 };
    let there = |step: isize| at.checked_add_signed(step).and_then(|near| *colours.get(near)?);
    let difference = |step: &isize| {
        let (one, other) = (there(*step)?, there(-*step)?);
        Some([0, 1, 2].map(|channel| own[channel] - 0.5 * (one[channel] + other[channel])))
    };
    let found: Vec<[f64; 3]> = steps.iter().filter_map(difference).collect();
    if found.len() < LEAST_DIRECTIONS {
        return 0.0;
    }
    let sum = [0, 1, 2].map(|channel| found.iter().map(|one| one[channel]).sum::<f64>());
    let length = sqrt(sum.iter().map(|part| part * part).sum());
    let along = |one: &[f64; 3]| one.iter().zip(&sum).map(|(part, of)| part * of).sum::<f64>();
    found.iter().map(along).fold(f64::INFINITY, f64::min).max(0.0) / length.max(1e-12)
}

/// Pixels beyond a threshold that hang together.
fn spots(disc: &Disc, difference: &[f64], held: &[bool], threshold: f64) -> Vec<Vec<usize>> {
    let mut free: Vec<bool> =
        difference.iter().zip(held).map(|(one, held)| *held && *one > threshold).collect();
    let mut spots = Vec::new();
    for first in 0..free.len() {
        if !free[first] {
            continue;
        }
        free[first] = false;
        let (mut spot, mut next) = (Vec::new(), vec![first]);
        while let Some(at) = next.pop() {
            spot.push(at);
            for near in [at.wrapping_sub(1), at + 1, at.wrapping_sub(disc.width), at + disc.width] {
                if free.get(near).copied().unwrap_or(false) {
                    free[near] = false;
                    next.push(near);
                }
            }
        }
        spots.push(spot);
    }
    spots
}

/// The disc as large as a spot, around its middle, in original pixels.
fn around(disc: &Disc, spot: &[usize]) -> Circle {
    let count = spot.len() as f64;
    let side = disc.factor as f64;
    let mean = |place: fn(&usize, usize) -> usize| {
        spot.iter().map(|at| place(at, disc.width) as f64 + 0.5).sum::<f64>() / count * side
    };
    Circle {
        x_px: mean(|at, width| at % width),
        y_px: mean(|at, width| at / width),
        radius_px: side * sqrt(count / std::f64::consts::PI),
    }
}
