//! Patches of a pearl's photograph, such as the paper's crops of 64 x 64 pixels (figure 2).
//!
//! The pearl is what differs in colour from the photograph's border, taken as a disc **(ours)**. A close-up without
//! background needs corners given.

use thiserror::Error;

/// Linear light from which a pixel counts as clipped by a highlight.
const HIGHLIGHT: f64 = 0.99;
/// Share of the pearl's radius in which patches are taken: the outline itself foreshortens them.
const SAFE_RADIUS: f64 = 0.85;
/// Steps of the histogram that parts pearl and border.
const BINS: usize = 256;

/// No patch in the pearl that was found.
#[derive(Clone, Debug, Error, PartialEq)]
#[error(
    "texture: no patch of {side_px} px without highlight in the pearl seen (radius {radius_px:.0} px); allowed: a larger \
     pearl, a smaller side_px, or corners given"
)]
pub struct NoPatch {
    /// A patch's side.
    pub side_px: usize,
    /// The radius in which patches are taken.
    pub radius_px: f64,
}

/// A photograph in linear light, RGB row by row.
#[derive(Clone, Copy, Debug)]
pub struct Photograph<'a> {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Three numbers a pixel.
    pub rgb: Samples<'a>,
}

/// Numbers as they come: of files in single precision, of what was worked out in double.
#[derive(Clone, Copy, Debug)]
pub enum Samples<'a> {
    /// In single precision.
    Single(&'a [f32]),
    /// In double precision.
    Double(&'a [f64]),
}

impl Photograph<'_> {
    /// Light of a pixel.
    pub(super) fn at(&self, row: usize, column: usize) -> [f64; 3] {
        let first = 3 * (row * self.width + column);
        match self.rgb {
            Samples::Single(rgb) => [0, 1, 2].map(|channel| f64::from(rgb[first + channel])),
            Samples::Double(rgb) => [0, 1, 2].map(|channel| rgb[first + channel]),
        }
    }

    /// How many numbers it has.
    pub(super) fn numbers(&self) -> usize {
        match self.rgb {
            Samples::Single(rgb) => rgb.len(),
            Samples::Double(rgb) => rgb.len(),
        }
    }

    /// The first number that is none.
    pub(super) fn not_finite(&self) -> Option<usize> {
        match self.rgb {
            Samples::Single(rgb) => rgb.iter().position(|light| !light.is_finite()),
            Samples::Double(rgb) => rgb.iter().position(|light| !light.is_finite()),
        }
    }
}

/// First pixels (row, column) of all patches inside the pearl that no highlight touches, side by side. A
/// photograph less than two patches wide is a crop: its middle is the patch.
pub(super) fn corners(
    photograph: &Photograph<'_>,
    side: usize,
) -> Result<Vec<(usize, usize)>, NoPatch> {
    let (rows, columns) = (photograph.height, photograph.width);
    if rows.min(columns) < 2 * side {
        return Ok(vec![((rows - side) / 2, (columns - side) / 2)]);
    }
    let disc = pearl(photograph);
    let most = (disc.radius / side as f64) as usize + 1;
    let places = |middle: f64, count: usize| -> Vec<usize> {
        let place = |i: usize| (middle as usize + i * side).checked_sub(most * side);
        (0..2 * most).filter_map(place).filter(|first| first + side <= count).collect()
    };
    let mut found = Vec::new();
    for top in places(disc.row, rows) {
        for &left in &places(disc.column, columns) {
            let corner = (top, left);
            if disc.holds(corner, side) && !is_clipped(photograph, corner, side) {
                found.push(corner);
            }
        }
    }
    if found.is_empty() {
        return Err(NoPatch { side_px: side, radius_px: disc.radius });
    }
    Ok(found)
}

/// The pearl in a photograph, its radius the one that is safe, in pixels.
struct Disc {
    row: f64,
    column: f64,
    radius: f64,
}

impl Disc {
    fn holds(&self, (top, left): (usize, usize), side: usize) -> bool {
        let far = |row: usize, column: usize| {
            libm::hypot(row as f64 - self.row, column as f64 - self.column) <= self.radius
        };
        [top, top + side].iter().all(|&row| [left, left + side].iter().all(|&at| far(row, at)))
    }
}

fn is_clipped(photograph: &Photograph<'_>, (top, left): (usize, usize), side: usize) -> bool {
    let mut pixels = (top..top + side).flat_map(|row| (left..left + side).map(move |at| (row, at)));
    pixels.any(|(row, at)| photograph.at(row, at).iter().any(|&light| light >= HIGHLIGHT))
}

/// What differs in colour from the photograph's border (Otsu's threshold), taken as a disc.
fn pearl(photograph: &Photograph<'_>) -> Disc {
    let (rows, columns) = (photograph.height, photograph.width);
    // Steps of about equal visibility.
    let shade = |row, column| photograph.at(row, column).map(|light: f64| light.max(0.0).sqrt());
    let across = (0..columns).flat_map(|column| [(0, column), (rows - 1, column)]);
    let down = (0..rows).flat_map(|row| [(row, 0), (row, columns - 1)]);
    let border: Vec<[f64; 3]> =
        across.chain(down).map(|(row, column)| shade(row, column)).collect();
    let ground = [0, 1, 2].map(|channel| median(border.iter().map(|one| one[channel]).collect()));
    let distance: Vec<f64> = (0..rows * columns)
        .map(|i| {
            let seen = shade(i / columns, i % columns);
            let [r, g, b] = [0, 1, 2].map(|channel| (seen[channel] - ground[channel]).powi(2));
            (r + g + b).sqrt()
        })
        .collect();
    let threshold = otsu(&distance);
    let mut inside = (0_usize, 0.0, 0.0);
    for (i, _) in distance.iter().enumerate().filter(|(_, far)| **far > threshold) {
        inside = (inside.0 + 1, inside.1 + (i / columns) as f64, inside.2 + (i % columns) as f64);
    }
    let (count, row, column) = (inside.0 as f64, inside.1, inside.2);
    if inside.0 == 0 {
        return Disc { row: rows as f64 / 2.0, column: columns as f64 / 2.0, radius: 0.0 };
    }
    let radius = SAFE_RADIUS * (count / std::f64::consts::PI).sqrt();
    Disc { row: row / count, column: column / count, radius }
}

/// Otsu (1979): the threshold with the greatest variance between the two sides.
fn otsu(distance: &[f64]) -> f64 {
    let largest = distance.iter().copied().fold(0.0, f64::max);
    let step = if largest > 0.0 { largest } else { 1.0 } / BINS as f64;
    let edge = |bin: usize| bin as f64 * step;
    let mut counts = [0_usize; BINS];
    for &far in distance {
        let mut bin = ((far / step) as usize).min(BINS - 1);
        if far < edge(bin) {
            bin -= 1;
        } else if bin < BINS - 1 && far >= edge(bin + 1) {
            bin += 1;
        }
        counts[bin] += 1;
    }
    let all = distance.len() as f64;
    let total: f64 = counts.iter().enumerate().map(|(bin, &count)| count as f64 * edge(bin)).sum();
    let (mut below, mut sum, mut best, mut at) = (0.0, 0.0, -1.0, 0);
    for (bin, &count) in counts.iter().enumerate() {
        below += count as f64;
        sum += count as f64 * edge(bin);
        let spread = (total * below - sum * all).powi(2) / (below * (all - below)).max(1.0);
        if spread > best {
            (best, at) = (spread, bin);
        }
    }
    edge(at + 1)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    if values.len() % 2 == 1 {
        values[middle]
    } else {
        f64::midpoint(values[middle - 1], values[middle])
    }
}
