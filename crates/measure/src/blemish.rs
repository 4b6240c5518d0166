//! Blemishes: spots that differ from the pearl around them.

use std::collections::HashSet;

use libm::{fabs, sqrt};
use serde::Serialize;

use crate::course::residuals;
use crate::disc::{Disc, Pixel};
use crate::lamp::Highlight;
use crate::value::median;
use crate::{Circle, Value};

/// Out to here the pearl is looked at: nearer to the rim, spots are seen too obliquely.
const FARTHEST: f64 = 0.9;
/// What is left out around the lamp's image: half-widths, and degrees of the normal.
const CLEAR: (f64, f64) = (1.6, 8.0);
/// Difference from the pearl's own course of colour, in CIELAB, from which a pixel belongs to a spot: about
/// one that is just seen; and the same in medians over the pearl, whose own texture differs too **(ours)**.
const LEAST_DIFFERENCE: f64 = 1.0;
const DEVIATIONS: f64 = 3.5;
/// A spot ends: so far off it, in radii, at most this share of its difference is left **(ours)**.
const OFF: f64 = 0.06;
const LEFT: f64 = 0.5;
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
    let residual = residuals(disc, &held, circle)?;
    let difference: Vec<f64> =
        residual.iter().map(|[l, a, b]| sqrt(l * l + a * a + b * b)).collect();
    let off = ((OFF * circle.radius_px / disc.factor as f64).round() as usize).max(2);
    let mut sizes: Vec<f64> =
        difference.iter().zip(&held).filter(|(_, held)| **held).map(|(one, _)| *one).collect();
    let threshold = (DEVIATIONS * median(&mut sizes)).max(LEAST_DIFFERENCE);
    let least = LEAST_SPOT * std::f64::consts::PI / (unit * unit);
    let at = |threshold: f64| {
        let mut spots = spots(disc, &difference, &held, threshold);
        spots.retain(|spot| {
            spot.len() as f64 >= least.max(2.0) && ends(spot, &residual, &held, disc.width, off)
        });
        // Its border is where half of its difference is left, as seen through pixels that are averaged.
        for spot in &mut spots {
            let mut own: Vec<f64> = spot.iter().map(|&at| difference[at]).collect();
            let level = 0.5 * median(&mut own);
            spot.retain(|&at| difference[at] >= level);
        }
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

/// Whether the difference of a spot is gone a little off it: that of a slow course of colour is not.
fn ends(spot: &[usize], residual: &[[f64; 3]], held: &[bool], width: usize, off: usize) -> bool {
    let mut own = [0.0; 3];
    for &at in spot {
        own = [0, 1, 2].map(|i| own[i] + residual[at][i] / spot.len() as f64);
    }
    let within: HashSet<usize> = spot.iter().copied().collect();
    let (mut left, mut count) = (0.0, 0.0);
    for &at in spot {
        for near in [at.wrapping_sub(off), at + off, at.wrapping_sub(off * width), at + off * width]
        {
            if held.get(near).copied().unwrap_or(false) && !within.contains(&near) {
                left += (0..3).map(|i| residual[near][i] * own[i]).sum::<f64>();
                count += 1.0;
            }
        }
    }
    count > 0.0 && left < LEFT * count * own.iter().map(|one| one * one).sum::<f64>()
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
