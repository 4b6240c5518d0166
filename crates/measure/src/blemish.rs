//! Blemishes: spots that differ from the pearl around them.

use libm::{fabs, sqrt};
use serde::Serialize;

use crate::course::residuals;
use crate::disc::{Disc, Pixel};
use crate::highlight::Highlight;
use crate::regions::regions;
use crate::spot::{Map, Spot, needed, spot};
use crate::value::median;
use crate::{Circle, Value};

/// Out to here the pearl is looked at: nearer to the rim, spots are seen too obliquely.
const FARTHEST: f64 = 0.9;
/// Out to here surroundings are.
const SURROUNDINGS: f64 = 0.96;
/// What is left out around the lamp's image: half-widths, and degrees of the normal.
const CLEAR: (f64, f64) = (1.6, 8.0);
/// Difference from the surroundings' own course of colour, in CIELAB, from which a region is a spot: about one
/// that is just seen.
const LEAST_DIFFERENCE: f64 = 1.0;
/// The smallest spot, in shares of the disc and pixels, and the largest, a radius in radii: what is larger is shading or
/// mirrored **(ours)**.
const LEAST_SPOT: (f64, f64) = (2e-4, 4.0);
const LARGEST_SPOT: f64 = 0.17;
/// Radius of the spots, and how far apart they lie, in radii, by which it is tried what could be told.
const TRIED: (f64, f64) = (0.06, 0.15);
/// Regions that share more than this are one spot.
const SHARED: f64 = 0.3;
/// Where spots fill more than this of what lies within 2.5 radii of one, and 0.2 of the pearl's, it is a pattern,
/// mirrored **(ours)**.
const PATTERN: f64 = 0.3;

/// Spots found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Blemishes {
    /// Their area on the ball, in percent of what was looked at; its error: half of what thresholds a
    /// quarter lower or higher change.
    pub area: Value,
    /// How many there are.
    pub count: usize,
    /// Share of the visible half of the ball that was looked at.
    pub looked_at: f64,
    /// The least difference that is told, in CIELAB: 1, or what a spot of 0.06 radii needs to be told from texture and
    /// mirrored light here, the median of places tried.
    pub threshold: f64,
    /// Middles, and radii of discs as large as they look, in pixels, the largest first.
    pub spots: Vec<Circle>,
}

/// Looks for spots on a ball; None where too little of it is left.
pub fn blemishes(disc: &Disc, circle: &Circle, highlight: Option<Highlight>) -> Option<Blemishes> {
    let open: Vec<bool> =
        disc.pixels.iter().map(|pixel| is_open(pixel.as_ref(), circle, highlight)).collect();
    let within = |most: f64, hidden: bool| -> Vec<bool> {
        let inside = |pixel: &Option<Pixel>| pixel.is_some_and(|pixel| pixel.away < most);
        disc.pixels.iter().zip(&open).map(|(one, open)| inside(one) && *open != hidden).collect()
    };
    let (looked, held, hidden) =
        (within(FARTHEST, false), within(SURROUNDINGS, false), within(1.0, true));
    let areas = areas(disc, circle);
    let area = |at: usize| if looked[at] { areas[at] } else { 0.0 };
    let whole: f64 = (0..areas.len()).map(area).sum();
    let radius = circle.radius_px / disc.factor as f64;
    let looked_at = whole / (radius * radius) / std::f64::consts::TAU;
    if looked_at < 0.1 {
        return None;
    }
    let residual = residuals(disc, &held, circle)?;
    let map = Map { residual: &residual, held: &held, hidden: &hidden, width: disc.width, radius };
    let known = known(&map);
    let percent = |spots: &[&Spot]| {
        let covered = covered(spots, held.len());
        // The sum of nothing is -0.
        100.0 * (0..covered.len()).filter(|&at| covered[at]).map(area).sum::<f64>() / whole + 0.0
    };
    let mut found = chosen(&known, 1.0, &map);
    let value = percent(&found);
    let doubt = 0.5 * (percent(&chosen(&known, 0.75, &map)) - percent(&chosen(&known, 1.25, &map)));
    found.retain(|spot| spot.places.iter().any(|&at| looked[at]));
    let mut spots: Vec<Circle> = found.iter().map(|spot| around(disc, &spot.places)).collect();
    spots.sort_by(|one, other| other.radius_px.total_cmp(&one.radius_px));
    let area = Value::new(value, fabs(doubt));
    let (count, threshold) = (spots.len(), LEAST_DIFFERENCE.max(told_from(&map, &looked)));
    Some(Blemishes { area, count, looked_at, threshold, spots })
}

/// What spots would have to differ by, tried over the pearl: the median; NaN where none could be told.
fn told_from(map: &Map<'_>, looked: &[bool]) -> f64 {
    let radius = (TRIED.0 * map.radius).max(1.0);
    let step = (TRIED.1 * map.radius).round().max(2.0) as usize;
    let disc = |at: usize| -> Vec<usize> {
        let reach = radius as usize + 1;
        let near = |row: usize| (0..=2 * reach).map(move |column| (row, column));
        let own = |(row, column): (usize, usize)| {
            let (down, right) = (row as f64 - reach as f64, column as f64 - reach as f64);
            let place = (at + row * map.width + column).checked_sub(reach * (map.width + 1))?;
            (down * down + right * right <= radius * radius).then_some(place)
        };
        (0..=2 * reach).flat_map(near).filter_map(own).collect()
    };
    let on_grid =
        |at: &usize| (at % map.width).is_multiple_of(step) && (at / map.width).is_multiple_of(step);
    let tried = (0..looked.len()).filter(|&at| looked[at]).filter(on_grid);
    median(&mut tried.filter_map(|at| needed(map, &disc(at))).collect::<Vec<f64>>())
}

/// Whether a place is no lamp's image and not clipped.
fn is_open(pixel: Option<&Pixel>, circle: &Circle, highlight: Option<Highlight>) -> bool {
    pixel.is_some_and(|pixel| {
        let lamp = highlight.is_some_and(|lamp| lamp.covers(circle, pixel.place, CLEAR.0, CLEAR.1));
        !pixel.clipped && !lamp
    })
}

/// What may be spots, the sharpest first.
fn known(map: &Map<'_>) -> Vec<Spot> {
    let disc = std::f64::consts::PI * map.radius * map.radius;
    let least = (LEAST_SPOT.0 * disc).max(LEAST_SPOT.1) as usize;
    let most = (LARGEST_SPOT * LARGEST_SPOT * disc) as usize;
    let mut known: Vec<Spot> =
        regions(map, least, most).iter().filter_map(|region| spot(map, region)).collect();
    known.sort_by(|one, other| other.sharpness.total_cmp(&one.sharpness));
    known
}

/// Those that differ enough, by a factor; of those over each other the sharpest, and none of patterns.
fn chosen<'a>(known: &'a [Spot], factor: f64, map: &Map<'_>) -> Vec<&'a Spot> {
    let differs =
        |spot: &&Spot| spot.contrast >= factor * LEAST_DIFFERENCE && spot.clearness >= factor;
    let mut taken = vec![false; map.held.len()];
    let mut chosen = Vec::new();
    for spot in known.iter().filter(differs) {
        let shared = spot.places.iter().filter(|&&at| taken[at]).count();
        if shared as f64 <= SHARED * spot.places.len() as f64 {
            spot.places.iter().for_each(|&at| taken[at] = true);
            chosen.push(spot);
        }
    }
    chosen.retain(|spot| is_alone(spot, &taken, map));
    chosen
}

/// Whether there are few other spots around one.
fn is_alone(spot: &Spot, taken: &[bool], map: &Map<'_>) -> bool {
    let count = spot.places.len() as f64;
    let mean = |of: &dyn Fn(usize) -> usize| {
        spot.places.iter().map(|&at| of(at) as f64).sum::<f64>() / count
    };
    let (x, y) = (mean(&|at| at % map.width), mean(&|at| at / map.width));
    let reach = (2.5 * spot.radius).max(0.2 * map.radius);
    let near = |at: &usize| {
        let (right, down) = ((at % map.width) as f64 - x, (at / map.width) as f64 - y);
        map.held[*at] && right * right + down * down <= reach * reach
    };
    let (mut all, mut filled) = (-count, -count);
    for at in (0..taken.len()).filter(near) {
        all += 1.0;
        filled += f64::from(u8::from(taken[at]));
    }
    all > 0.0 && filled <= PATTERN * all
}

fn covered(spots: &[&Spot], count: usize) -> Vec<bool> {
    let mut covered = vec![false; count];
    spots.iter().flat_map(|spot| &spot.places).for_each(|&at| covered[at] = true);
    covered
}

/// What each pixel covers of the ball, in pixels seen from straight ahead.
fn areas(disc: &Disc, circle: &Circle) -> Vec<f64> {
    let area = |pixel: &Option<Pixel>| {
        let normal = pixel.as_ref().and_then(|pixel| circle.normal(pixel.place.0, pixel.place.1));
        normal.map_or(0.0, |normal| 1.0 / normal[2].max(0.2))
    };
    disc.pixels.iter().map(area).collect()
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
