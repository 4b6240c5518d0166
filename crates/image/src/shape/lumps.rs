//! The lumps of a baroque pearl: rises and hollows about directions that lie evenly over the sphere.
//!
//! Amount times (1 - (1 - cos) / foot)^4 each, made even so that their mean is 0. A grid over the sphere holds at each of its
//! cells those that reach it, side by side.
//! Left out: lumps of different sizes on one pearl.

use glam::{DMat3, DQuat, DVec3};
use multiversion::multiversion;
use rand_chacha::ChaCha8Rng;

use crate::{
    grain::normal::{normal_pair, uniform},
    shape::{bent::Bent, directions::even_directions},
};

/// All lumps of a form.
#[derive(Debug, Clone)]
pub(super) struct Lumps {
    /// The lumps that reach each cell of the grid, cell after cell.
    blocks: Vec<Block>,
    /// Where each cell's begin; one more at the end.
    begins: Vec<u32>,
    /// What they add on average.
    mean: f64,
}

/// Lumps side by side.
#[derive(Debug, Clone, Copy)]
struct Block {
    middle: [[f64; LANES]; 3],
    amount: [f64; LANES],
    per_foot: f64,
}

/// A rise or a hollow.
#[derive(Debug, Clone, Copy)]
struct Lump {
    middle: DVec3,
    amount: f64,
}

/// So many lumps share registers.
const LANES: usize = 8;
/// Lumps overlap so often at each place that they add up to an even landscape **(ours)**.
const OVERLAP: f64 = 6.0;
/// More lumps than this are none that one would see apart.
const MOST_LUMPS: usize = 160;
/// Directions by which their mean and spread are taken.
const POINTS: usize = 2000;
/// Cells along a side of the cube around the sphere; by time **(ours)**.
const CELLS: usize = 8;

impl Lumps {
    /// Of standard deviation `spread`, each `size_rad` from top to foot.
    pub(super) fn new(spread: f64, size_rad: f64, random: &mut ChaCha8Rng) -> Self {
        let mut lumps = drawn(size_rad, random);
        let per_foot = 1.0 / (1.0 - libm::cos(size_rad));
        let mean = level(&mut lumps, spread, per_foot);
        let (mut blocks, mut begins) = (Vec::new(), vec![0]);
        for cell in 0..6 * CELLS * CELLS {
            let (middle, wide_rad) = cap(cell);
            let least = libm::cos((size_rad + wide_rad).min(std::f64::consts::PI));
            let reaching: Vec<Lump> =
                lumps.iter().filter(|lump| lump.middle.dot(middle) >= least).copied().collect();
            blocks.extend(reaching.chunks(LANES).map(|lumps| Block::of(lumps, per_foot)));
            begins.push(blocks.len() as u32);
        }
        Self { blocks, begins, mean }
    }

    /// What they add in a direction, that of a point, and the gradient of that.
    #[inline]
    pub(super) fn at(&self, towards: DVec3, point: DVec3) -> (f64, DVec3) {
        let [amount, x, y, z] = sum(self.near(point), towards.to_array());
        (amount - self.mean, DVec3::new(x, y, z))
    }

    /// The same with second derivatives.
    pub(super) fn bent(&self, towards: DVec3) -> Bent {
        let (height, slope) = self.at(towards, towards);
        let mut change = DMat3::ZERO;
        for block in self.near(towards) {
            for lane in 0..LANES {
                let middle = DVec3::from([0, 1, 2].map(|axis| block.middle[axis][lane]));
                let left = (1.0 - (1.0 - towards.dot(middle)) * block.per_foot).max(0.0);
                let twice = 12.0 * block.amount[lane] * (left * block.per_foot).powi(2);
                change += Bent::outer(middle, middle) * twice;
            }
        }
        Bent { height, slope, change }
    }

    #[inline]
    fn near(&self, point: DVec3) -> &[Block] {
        let cell = cell(point);
        &self.blocks[self.begins[cell] as usize..self.begins[cell + 1] as usize]
    }
}

impl Block {
    fn of(lumps: &[Lump], per_foot: f64) -> Self {
        let lane =
            |axis: usize| std::array::from_fn(|i| lumps.get(i).map_or(0.0, |l| l.middle[axis]));
        let amount = std::array::from_fn(|i| lumps.get(i).map_or(0.0, |lump| lump.amount));
        Self { middle: [lane(0), lane(1), lane(2)], amount, per_foot }
    }
}

/// Even directions, turned at random, and heights from a normal distribution.
fn drawn(size_rad: f64, random: &mut ChaCha8Rng) -> Vec<Lump> {
    let foot = 1.0 - libm::cos(size_rad);
    let count = (libm::ceil(2.0 * OVERLAP / foot) as usize).min(MOST_LUMPS);
    let turn = std::f64::consts::TAU * uniform(random);
    let axis = DVec3::new(
        2.0 * uniform(random) - 1.0,
        2.0 * uniform(random) - 1.0,
        2.0 * uniform(random) - 1.0,
    );
    let turn = DQuat::from_axis_angle(axis.normalize_or(DVec3::X), turn);
    // Beyond two standard deviations a lump would be a horn.
    let mut lump = |middle: DVec3| Lump {
        middle: turn * middle,
        amount: normal_pair(random)[0].clamp(-2.0, 2.0),
    };
    even_directions(count).map(&mut lump).collect()
}

/// Makes the lumps' standard deviation `spread`, and gives their mean.
fn level(lumps: &mut [Lump], spread: f64, per_foot: f64) -> f64 {
    let all: Vec<Block> = lumps.chunks(LANES).map(|lumps| Block::of(lumps, per_foot)).collect();
    let amounts: Vec<f64> =
        even_directions(POINTS).map(|towards| sum(&all, towards.to_array())[0]).collect();
    let mean = amounts.iter().sum::<f64>() / POINTS as f64;
    let square = amounts.iter().map(|amount| (amount - mean).powi(2)).sum::<f64>();
    let factor = spread / (square / POINTS as f64).sqrt().max(f64::MIN_POSITIVE);
    for lump in lumps {
        lump.amount *= factor;
    }
    mean * factor
}

/// What lumps add up to in a direction, and the gradient of that.
#[multiversion(targets("x86_64+avx2"))]
fn sum(blocks: &[Block], [x, y, z]: [f64; 3]) -> [f64; 4] {
    let mut sums = [[0.0; LANES]; 4];
    for block in blocks {
        for lane in 0..LANES {
            let [mx, my, mz] = [0, 1, 2].map(|axis| block.middle[axis][lane]);
            let cosine = x * mx + y * my + z * mz;
            let left = (1.0 - (1.0 - cosine) * block.per_foot).max(0.0);
            let cube = block.amount[lane] * left * left * left;
            let slope = 4.0 * cube * block.per_foot;
            sums[0][lane] += cube * left;
            sums[1][lane] += mx * slope;
            sums[2][lane] += my * slope;
            sums[3][lane] += mz * slope;
        }
    }
    sums.map(|lanes| {
        let [a, b, c, d, e, f, g, h] = lanes;
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    })
}

/// The cell of the direction of a point: the side of a cube around the sphere that it meets, and where there.
#[inline]
fn cell(point: DVec3) -> usize {
    let DVec3 { x, y, z } = point;
    let (far, aside, side) = if x.abs() >= y.abs() && x.abs() >= z.abs() {
        (x, [y, z], 0)
    } else if y.abs() >= z.abs() {
        (y, [z, x], 2)
    } else {
        (z, [x, y], 4)
    };
    let half = 0.5 * CELLS as f64;
    let scale = half / far.abs();
    let [column, row] = aside.map(|place| ((place * scale + half) as usize).min(CELLS - 1));
    ((side + usize::from(far < 0.0)) * CELLS + row) * CELLS + column
}

/// The middle of a cell, and how far from there its corners are.
fn cap(cell: usize) -> (DVec3, f64) {
    let (side, row, column) = (cell / (CELLS * CELLS), cell / CELLS % CELLS, cell % CELLS);
    let far = if side % 2 == 0 { 1.0 } else { -1.0 };
    let place = |column: f64, row: f64| {
        let [a, b] = [column, row].map(|place| 2.0 * place / CELLS as f64 - 1.0);
        let turned = match side / 2 {
            0 => DVec3::new(far, a, b),
            1 => DVec3::new(b, far, a),
            _ => DVec3::new(a, b, far),
        };
        turned.normalize()
    };
    let (column, row) = (column as f64, row as f64);
    let middle = place(column + 0.5, row + 0.5);
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
    let cosine = corners.map(|(right, down)| place(column + right, row + down).dot(middle));
    // A little more, for what rounding does at an edge.
    (middle, libm::acos(cosine.into_iter().fold(1.0, f64::min)) + 1e-9)
}

#[cfg(test)]
mod tests {
    use rand_core::SeedableRng;

    use super::*;

    #[test]
    fn a_cell_holds_all_lumps_that_reach_it_and_few_others() {
        for size_rad in [0.15, 0.4, 0.9, 1.6] {
            let random = || ChaCha8Rng::from_seed([7; 32]);
            let lumps = Lumps::new(0.1, size_rad, &mut random());
            let per_foot = 1.0 / (1.0 - libm::cos(size_rad));
            let mut all = drawn(size_rad, &mut random());
            let mean = level(&mut all, 0.1, per_foot);
            let all: Vec<Block> =
                all.chunks(LANES).map(|lumps| Block::of(lumps, per_foot)).collect();
            let mut held = 0;
            for towards in even_directions(3000).chain([DVec3::X, DVec3::NEG_Y, DVec3::Z]) {
                let (amount, slope) = lumps.at(towards, towards);
                let [whole, x, y, z] = sum(&all, towards.to_array());
                assert!((amount + mean - whole).abs() < 1e-12, "{size_rad} {towards}");
                assert!(slope.distance(DVec3::new(x, y, z)) < 1e-12, "{size_rad} {towards}");
                held += lumps.near(towards).len();
            }
            assert!(held < 3003 * all.len().min(3), "{size_rad}: {held}");
        }
    }
}
