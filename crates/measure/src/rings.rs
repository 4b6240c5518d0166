//! Colour: of the whole pearl, by ring, and how it is spread over hues.

use std::f64::consts::TAU;

use libm::{asin, atan2, sqrt};
use serde::Serialize;

use crate::disc::{Disc, Pixel};
use crate::highlight::Highlight;
use crate::value::jackknife;
use crate::white::lab;
use crate::{Circle, Value};

/// Rings of equal width, out to where the outline's pixels begin **(ours)**.
const RINGS: usize = 8;
const OUTERMOST: f64 = 0.96;
/// Parts of a ring: cells for the spread over hues, and groups of cells that the jackknife leaves out.
const SECTORS: usize = 36;
const GROUPS: usize = 12;
/// Hue angles in CIELAB of the six regions' middles, in degrees: red, yellow, green, blue-green, blue, purple.
pub const HUES: [f64; 6] = [30.0, 90.0, 150.0, 210.0, 270.0, 330.0];
/// A cell counts as saturated from the second chroma on, not at all up to the first **(ours)**.
const SATURATED: [f64; 2] = [5.0, 10.0];
/// Around the lamp's image, what is left out of colours: half-widths, and degrees of the normal.
const CLEAR: (f64, f64) = (1.5, 6.0);
/// Below this chroma there is no hue.
const GREY: f64 = 0.5;

/// A colour in CIELAB relative to the stated white.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Colour {
    /// L*.
    pub lightness: Value,
    /// C*ab.
    pub chroma: Value,
    /// The hue angle in degrees, 0 to 360; None of a grey.
    pub hue_deg: Option<Value>,
}

/// The pearl's colour between two distances from its middle.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ring {
    /// Inner and outer distance, in radii.
    pub from: f64,
    /// The outer one.
    pub to: f64,
    /// View angle half-way, in degrees.
    pub view_deg: f64,
    /// Share of the ring that the lamp's image and clipped light leave.
    pub share: f64,
    /// Its colour; None where nothing is left.
    pub colour: Option<Colour>,
}

/// Colour over the rings.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rings {
    /// From the middle outwards.
    pub rings: Vec<Ring>,
    /// Mean chroma over the pearl.
    pub chroma: Value,
    /// Root mean square distance in (a*, b*) of the pearl's parts from their mean colour.
    pub orient: Value,
    /// Area that is saturated, in percent, by the six hue regions `HUES`.
    pub interference: [f64; 6],
    /// Their sum.
    pub interference_total: Value,
}

/// Sums of XYZ over pixels.
#[derive(Clone, Copy, Default)]
struct Cell {
    xyz: [f64; 3],
    count: f64,
}

impl Cell {
    fn add(&mut self, xyz: [f64; 3], count: f64) {
        for channel in 0..3 {
            self.xyz[channel] += xyz[channel];
        }
        self.count += count;
    }

    fn lab(&self) -> [f64; 3] {
        lab(self.xyz.map(|sum| sum / self.count))
    }
}

/// The colour of the whole pearl: the mean light of its middle half by lightness, which leaves out lamps'
/// images and shadows, round or not.
///
/// # Errors
/// So much of the pearl is clipped that its middle half would be another one.
pub fn whole(disc: &Disc, middle: &Circle) -> Result<Colour, String> {
    let mut held: Vec<&Pixel> =
        disc.pixels.iter().flatten().filter(|pixel| pixel.away < 0.9).collect();
    let clipped = held.iter().filter(|pixel| pixel.clipped).count();
    if 4 * clipped > held.len() {
        let percent = 100.0 * clipped as f64 / held.len() as f64;
        return Err(format!(
            "the pearl is clipped in {percent:.0} % of its pixels; allowed: up to 25 %"
        ));
    }
    // What is clipped was lighter than it seems.
    let lightness = |pixel: &Pixel| if pixel.clipped { f64::INFINITY } else { pixel.xyz[1] };
    held.sort_by(|one, other| lightness(one).total_cmp(&lightness(other)));
    let mut groups = [Cell::default(); GROUPS];
    for pixel in &held[held.len() / 4..held.len() - held.len() / 4] {
        groups[sector(pixel, middle, GROUPS)].add(pixel.xyz, 1.0);
    }
    colour(&groups).ok_or_else(|| "the pearl is too small".to_owned())
}

/// Colours by ring.
pub fn rings(disc: &Disc, circle: &Circle, highlight: Option<Highlight>) -> Option<Rings> {
    let mut cells = vec![[Cell::default(); SECTORS]; RINGS];
    let mut counts = [0.0; RINGS];
    for pixel in disc.pixels.iter().flatten().filter(|pixel| pixel.away < OUTERMOST) {
        let ring = ((pixel.away / OUTERMOST * RINGS as f64) as usize).min(RINGS - 1);
        counts[ring] += 1.0;
        let lamp = highlight.is_some_and(|lamp| lamp.covers(circle, pixel.place, CLEAR.0, CLEAR.1));
        if !lamp && !pixel.clipped {
            cells[ring][sector(pixel, circle, SECTORS)].add(pixel.xyz, 1.0);
        }
    }
    let rings = (0..RINGS).map(|ring| one_ring(ring, &cells[ring], counts[ring])).collect();
    let spread = |left_out: usize| Spread::of(&cells, left_out);
    let all = spread(GROUPS)?;
    let left_out: Vec<Spread> = (0..GROUPS).filter_map(spread).collect();
    let error =
        |part: fn(&Spread) -> f64| jackknife(&left_out.iter().map(part).collect::<Vec<f64>>());
    Some(Rings {
        rings,
        chroma: Value::new(all.chroma, error(|spread| spread.chroma)),
        orient: Value::new(all.orient, error(|spread| spread.orient)),
        interference: all.by_hue,
        interference_total: Value::new(
            all.by_hue.iter().sum(),
            error(|spread| spread.by_hue.iter().sum()),
        ),
    })
}

fn one_ring(ring: usize, cells: &[Cell; SECTORS], count: f64) -> Ring {
    let at = |place: f64| OUTERMOST * place / RINGS as f64;
    let mut groups = [Cell::default(); GROUPS];
    for (sector, cell) in cells.iter().enumerate() {
        groups[sector * GROUPS / SECTORS].add(cell.xyz, cell.count);
    }
    let held: f64 = groups.iter().map(|cell| cell.count).sum();
    Ring {
        from: at(ring as f64),
        to: at(ring as f64 + 1.0),
        view_deg: asin(at(ring as f64 + 0.5)).to_degrees(),
        share: if count > 0.0 { held / count } else { 0.0 },
        colour: colour(&groups),
    }
}

/// The sector of a pixel, of so many around the middle.
fn sector(pixel: &Pixel, middle: &Circle, count: usize) -> usize {
    let turn = atan2(pixel.place.1 - middle.y_px, pixel.place.0 - middle.x_px) / TAU;
    ((turn.rem_euclid(1.0) * count as f64) as usize).min(count - 1)
}

/// The colour of all groups, with its jackknife; None of nothing.
fn colour(groups: &[Cell; GROUPS]) -> Option<Colour> {
    let sum = |left_out: usize| {
        let mut all = Cell::default();
        for (_, cell) in groups.iter().enumerate().filter(|(at, _)| *at != left_out) {
            all.add(cell.xyz, cell.count);
        }
        all
    };
    let all = sum(GROUPS);
    if all.count == 0.0 {
        return None;
    }
    let found = polar(all.lab());
    let held = (0..GROUPS).filter(|&at| groups[at].count > 0.0).map(sum);
    let left_out: Vec<[f64; 3]> =
        held.filter(|cell| cell.count > 0.0).map(|cell| polar(cell.lab())).collect();
    let error =
        |part: usize| jackknife(&left_out.iter().map(|one| one[part]).collect::<Vec<f64>>());
    let turned: Vec<f64> =
        left_out.iter().map(|one| (one[2] - found[2] + 180.0).rem_euclid(360.0) - 180.0).collect();
    Some(Colour {
        lightness: Value::new(found[0], error(0)),
        chroma: Value::new(found[1], error(1)),
        hue_deg: (found[1] >= GREY).then(|| Value::new(found[2], jackknife(&turned))),
    })
}

/// L*, C*ab and hue in degrees.
fn polar([lightness, a, b]: [f64; 3]) -> [f64; 3] {
    [lightness, sqrt(a * a + b * b), atan2(b, a).to_degrees().rem_euclid(360.0)]
}

/// How colour is spread over the pearl's parts.
struct Spread {
    chroma: f64,
    orient: f64,
    by_hue: [f64; 6],
}

impl Spread {
    /// Without one group of sectors; None where nothing is left.
    fn of(cells: &[[Cell; SECTORS]], left_out: usize) -> Option<Self> {
        let held = cells.iter().flat_map(|ring| ring.iter().enumerate());
        let held = held.filter(|(at, cell)| at * GROUPS / SECTORS != left_out && cell.count > 0.0);
        let parts: Vec<([f64; 3], f64)> = held.map(|(_, cell)| (cell.lab(), cell.count)).collect();
        let whole: f64 = parts.iter().map(|(_, count)| count).sum();
        if parts.len() < SECTORS {
            return None;
        }
        let mean = [1, 2]
            .map(|axis| parts.iter().map(|(lab, count)| lab[axis] * count).sum::<f64>() / whole);
        let (mut chroma, mut square, mut by_hue) = (0.0, 0.0, [0.0; 6]);
        for (lab, count) in &parts {
            let share = count / whole;
            let [_, c, hue] = polar(*lab);
            chroma += share * c;
            let (a, b) = (lab[1] - mean[0], lab[2] - mean[1]);
            square += share * (a * a + b * b);
            let [least, full] = SATURATED;
            let saturated = ((c - least) / (full - least)).clamp(0.0, 1.0);
            for (region, part) in hue_parts(hue) {
                by_hue[region] += 100.0 * share * saturated * part;
            }
        }
        Some(Self { chroma, orient: sqrt(square), by_hue })
    }
}

/// The two regions nearest to a hue, and what each has of it: no hue lies on a border.
fn hue_parts(hue_deg: f64) -> [(usize, f64); 2] {
    let place = ((hue_deg - HUES[0]) / 60.0).rem_euclid(6.0);
    let first = (place as usize).min(5);
    let part = place - first as f64;
    [(first, 1.0 - part), ((first + 1) % 6, part)]
}
