//! One level of a texture: the field up to some degree on a grid, and the look-up between its cells.
//!
//! Synthesis by `harmonics`; straight lines between cells.
//! Left out: cells that are alike in area; rows crowd at the poles.

use crate::harmonics::{CHANNELS, Coefficients, Place, synthesise};
use glam::{DVec3, Vec3A};
use std::f32;

/// Rows beyond each pole that let the look-up reach over it.
const MARGIN: usize = 2;
/// Columns beyond the date line, for the same reason.
const WRAP: usize = 3;

/// The field up to one degree, on a grid of at least four samples to its shortest wave.
#[derive(Debug)]
pub(crate) struct Level {
    top: usize,
    rows: usize,
    /// Rows of the grid, with `MARGIN` rows beyond either pole and `WRAP` columns beyond the last.
    texels: Vec<Vec3A>,
}

impl Level {
    pub fn synthesise(coefficients: &Coefficients, top: usize) -> Self {
        let power = (2 * top).next_power_of_two().max(16);
        let rows = if 3 * power / 4 >= 2 * top { 3 * power / 4 } else { power };
        let pitch = 2 * rows + WRAP;
        let mut texels = vec![Vec3A::ZERO; pitch * (rows + 2 * MARGIN)];
        let inner = pitch * MARGIN..pitch * (MARGIN + rows);
        let texel = |value: [f64; CHANNELS]| Vec3A::from_array(value.map(|v| v as f32));
        synthesise(coefficients, top, (rows, pitch), texel, &mut texels[inner]);
        // Beyond a pole lies the same ring, half way round.
        for beyond in 1..=MARGIN {
            let (north, south) = (MARGIN, MARGIN + rows);
            let mirrored =
                [(north - beyond, north + beyond - 1), (south + beyond - 1, south - beyond)];
            for (to, from) in mirrored.map(|(to, from)| (to * pitch, from * pitch)) {
                texels.copy_within(from + rows..from + 2 * rows, to);
                texels.copy_within(from..from + rows, to + rows);
            }
        }
        for row in texels.chunks_exact_mut(pitch) {
            row.copy_within(..WRAP, 2 * rows);
        }
        Self { top, rows, texels }
    }

    /// The highest degree it holds.
    pub fn top(&self) -> usize {
        self.top
    }

    /// Rows from pole to pole.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The grid without what lies beyond its ends, row-major.
    pub fn texels(&self) -> impl Iterator<Item = [f32; CHANNELS]> {
        let columns = 2 * self.rows;
        let inner = self.texels.chunks_exact(columns + WRAP).skip(MARGIN).take(self.rows);
        inner.flat_map(move |row| row[..columns].iter().map(Vec3A::to_array))
    }

    /// Cubic interpolation (Catmull and Rom 1974) of the sixteen texels around a place.
    #[inline]
    pub fn at(&self, place: Place) -> Vec3A {
        let (start, across, down) = self.around(place);
        let [along] = self.rings(start, [cubic_weights(across)]);
        stacked(along, cubic_weights(down))
    }

    /// The value in a direction, whose place is known too, and its gradient on the sphere in directions along the meridian,
    /// away from the pole, and along the parallel, per radian. Close to a pole, where parallels are short, by differences.
    #[inline]
    pub fn with_gradient(&self, direction: DVec3, place: Place) -> Steep {
        let (start, across, down) = self.around(place);
        let below = cubic_weights(down);
        let weights = [cubic_weights(across), cubic_slopes(across)];
        let [along, eastward] = self.rings(start, weights);
        let value = stacked(along, below);
        let sine = (direction.x * direction.x + direction.y * direction.y).sqrt();
        if sine < NEAR_POLE {
            return self.by_differences(direction, value);
        }
        let scale = self.rows as f32 / f32::consts::PI;
        let south = stacked(along, cubic_slopes(down)) * scale;
        let east = stacked(eastward, below) * (scale / sine as f32);
        let parallel = DVec3::new(-direction.y, direction.x, 0.0) / sine;
        Steep { value, south, east, meridian: parallel.cross(direction), parallel }
    }

    /// The same from four places around.
    fn by_differences(&self, direction: DVec3, value: Vec3A) -> Steep {
        let step = 0.5 * std::f64::consts::PI / self.rows as f64;
        let (meridian, parallel) = direction.any_orthonormal_pair();
        let along = |aside: DVec3| {
            let at = |place: DVec3| self.at(Place::towards(place));
            (at(direction + aside * step) - at(direction - aside * step)) / (2.0 * step as f32)
        };
        Steep { value, south: along(meridian), east: along(parallel), meridian, parallel }
    }

    /// Where the sixteen texels around a place begin, and how far it is across and down between the middle four.
    #[inline]
    fn around(&self, place: Place) -> (usize, f32, f32) {
        let columns = 2 * self.rows;
        let scale = self.rows as f32 / f32::consts::PI;
        // A turn more keeps both positive, so that `as` rounds down.
        let across = place.longitude * scale + columns as f32;
        let down = place.colatitude * scale + (MARGIN as f32 - 0.5);
        let (column, row) = (across as i32 as usize, down as i32 as usize);
        let first = if column > columns { column - columns - 1 } else { column - 1 };
        let start = (row - 1) * (columns + WRAP) + first;
        (start, across - column as f32, down - row as f32)
    }

    /// Four rings of four texels each from `start`, each summed once by all of some weights across.
    #[inline]
    fn rings<const N: usize>(&self, start: usize, weights: [[f32; 4]; N]) -> [[Vec3A; 4]; N] {
        let pitch = 2 * self.rows + WRAP;
        let mut sums = [[Vec3A::ZERO; 4]; N];
        for down in 0..4 {
            let first = start + down * pitch;
            let ring = &self.texels[first..first + 4];
            for (sums, [a, b, c, d]) in sums.iter_mut().zip(weights) {
                sums[down] = (a * ring[0] + b * ring[1]) + (c * ring[2] + d * ring[3]);
            }
        }
        sums
    }
}

/// Four rings by their weights down.
#[inline]
fn stacked(rings: [Vec3A; 4], weights: [f32; 4]) -> Vec3A {
    let mut sum = Vec3A::ZERO;
    for (ring, weight) in rings.into_iter().zip(weights) {
        sum += weight * ring;
    }
    sum
}

/// A field in a direction, and how it rises there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Steep {
    pub value: Vec3A,
    south: Vec3A,
    east: Vec3A,
    meridian: DVec3,
    parallel: DVec3,
}

impl Steep {
    /// The gradient of one of its channels.
    pub fn gradient(&self, channel: usize) -> DVec3 {
        self.meridian * f64::from(self.south[channel])
            + self.parallel * f64::from(self.east[channel])
    }

    /// So much of the way to another, of the same direction.
    pub fn towards(&self, other: &Self, share: f32) -> Self {
        Self {
            value: self.value + share * (other.value - self.value),
            south: self.south + share * (other.south - self.south),
            east: self.east + share * (other.east - self.east),
            ..*self
        }
    }
}

/// Sine of the colatitude below which a place is close to a pole.
const NEAR_POLE: f64 = 0.02;

/// Weights of the four neighbours at t in 0..1 between the middle two; they add up to 1.
#[inline]
fn cubic_weights(t: f32) -> [f32; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        0.5 * (-t3 + 2.0 * t2 - t),
        0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
        0.5 * (-3.0 * t3 + 4.0 * t2 + t),
        0.5 * (t3 - t2),
    ]
}

/// Their derivatives by t; they add up to 0.
#[inline]
fn cubic_slopes(t: f32) -> [f32; 4] {
    let t2 = t * t;
    [
        0.5 * (-3.0 * t2 + 4.0 * t - 1.0),
        0.5 * (9.0 * t2 - 10.0 * t),
        0.5 * (-9.0 * t2 + 8.0 * t + 1.0),
        0.5 * (3.0 * t2 - 2.0 * t),
    ]
}
