//! Blemishes: spots that differ from the pearl around them.

use libm::{fabs, sqrt};
use serde::Serialize;

use crate::border::Differences;
use crate::course::residuals;
use crate::disc::{Disc, Pixel};
use crate::lamp::Highlight;
use crate::nearby::nearby;
use crate::value::median;
use crate::{Circle, Value};

/// Out to here the pearl is looked at: nearer to the rim, spots are seen too obliquely.
const FARTHEST: f64 = 0.9;
/// What is left out around the lamp's image: half-widths, and degrees of the normal.
const CLEAR: (f64, f64) = (1.6, 8.0);
/// Difference from the pearl's own course of colour, in CIELAB, from which a pixel belongs to a spot: about
/// one that is just seen; and the same in what is usual nearby, for the pearl's texture and what it mirrors differ too
/// **(ours)**.
const LEAST_DIFFERENCE: f64 = 1.0;
const DEVIATIONS: f64 = 3.5;
/// What is usual: of what is nearby, this share differs less. Below, mirrored tables count as spots.
const QUIET: f64 = 0.5;
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
    /// The difference that counted, in CIELAB: the median over what was looked at.
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
    let radius = circle.radius_px / disc.factor as f64;
    let course = residuals(disc, &held, circle)?;
    let usual = nearby(&course, &held, disc, radius, 0.5);
    let less = |(one, usual): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|i| one[i] - usual[i]);
    let residual: Vec<[f64; 3]> = course.iter().zip(&usual).map(less).collect();
    let hides = |(pixel, held): (&Option<Pixel>, &bool)| {
        !held && pixel.is_some_and(|pixel| pixel.away < FARTHEST)
    };
    let hidden: Vec<bool> = disc.pixels.iter().zip(&held).map(hides).collect();
    let map = Differences {
        residual: &residual,
        held: &held,
        hidden: &hidden,
        width: disc.width,
        radius,
    };
    let size = |[l, a, b]: &[f64; 3]| [sqrt(l * l + a * a + b * b)];
    let difference: Vec<[f64; 1]> = residual.iter().map(size).collect();
    let usual = nearby(&difference, &held, disc, radius, QUIET);
    let difference = difference.as_flattened();
    let thresholds: Vec<f64> =
        usual.iter().map(|[usual]| (DEVIATIONS * usual).max(LEAST_DIFFERENCE)).collect();
    let mut looked: Vec<f64> =
        (0..held.len()).filter(|&at| held[at]).map(|at| thresholds[at]).collect();
    let threshold = median(&mut looked);
    let least = LEAST_SPOT * std::f64::consts::PI / (unit * unit);
    let at = |factor: f64| {
        let mut spots = spots(disc, difference, &held, |at| factor * thresholds[at]);
        spots.retain(|spot| spot.len() as f64 >= least.max(2.0));
        // Its border is where half of its difference is left, as seen through pixels that are averaged.
        for spot in &mut spots {
            let mut own: Vec<f64> = spot.iter().map(|&at| difference[at]).collect();
            let level = 0.5 * median(&mut own);
            spot.retain(|&at| difference[at] >= level);
        }
        spots.retain(|spot| map.has_border(spot));
        spots
    };
    let percent = |spots: &[Vec<usize>]| {
        // The sum of nothing is -0.
        100.0 * spots.iter().flatten().map(|&at| areas[at]).sum::<f64>() / whole + 0.0
    };
    let found = at(1.0);
    let doubt = 0.5 * (percent(&at(0.75)) - percent(&at(1.25)));
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

/// Pixels beyond a threshold that hang together.
fn spots(
    disc: &Disc,
    difference: &[f64],
    held: &[bool],
    threshold: impl Fn(usize) -> f64,
) -> Vec<Vec<usize>> {
    let mut free: Vec<bool> =
        (0..held.len()).map(|at| held[at] && difference[at] > threshold(at)).collect();
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
    let (mut x_px, mut y_px) = (0.0, 0.0);
    for pixel in spot.iter().filter_map(|&at| disc.pixels[at].as_ref()) {
        x_px += pixel.place.0 / count;
        y_px += pixel.place.1 / count;
    }
    let radius_px = disc.factor as f64 * sqrt(count / std::f64::consts::PI);
    Circle { x_px, y_px, radius_px }
}
