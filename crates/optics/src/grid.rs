//! Tables `[angle, wavelength]`, filled on all processors.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::{
    incidence::{Block, Incidence},
    lanes::LANES,
    media::Table,
    transfer::TransferModel,
    wave::{Plane, Polarisation},
};

/// What is to be computed at each angle and block of wavelengths.
pub(crate) trait Work<const K: usize>: Sync {
    /// Fills the block's part of each of the `K` tables; where wavelengths end within the block it is
    /// shorter than the lanes.
    fn fill<const N: usize>(&self, block: &Block<'_, N>, tables: [&mut [f64]; K]);
}

/// Fills `K` tables with `work`, in an order of no consequence, or leaves off where `stop` is set.
pub(crate) fn fill<const K: usize>(
    model: TransferModel,
    media: &Table,
    angle_rad: &[f64],
    tables: [&mut [f64]; K],
    work: &impl Work<K>,
    stop: &AtomicBool,
) {
    let grid = Grid { model, media, work, stop };
    match model.polarisation {
        Polarisation::S => grid.angles([Plane::S], angle_rad, tables),
        Polarisation::P => grid.angles([Plane::P], angle_rad, tables),
        Polarisation::Unpolarised => grid.angles([Plane::S, Plane::P], angle_rad, tables),
    }
}

struct Grid<'a, W> {
    model: TransferModel,
    media: &'a Table,
    work: &'a W,
    stop: &'a AtomicBool,
}

/// Blocks that one thread takes in one go: with few layers, less is not worth a hand-over.
const BLOCKS_AT_ONCE: usize = 4;

impl<W> Grid<'_, W> {
    fn angles<const N: usize, const K: usize>(
        &self,
        planes: [Plane; N],
        angle_rad: &[f64],
        tables: [&mut [f64]; K],
    ) where
        W: Work<K>,
    {
        match angle_rad {
            [] => {}
            &[angle] => {
                let incidence = Incidence::new(self.media, planes, angle, self.model.precision);
                self.blocks(&incidence, 0, tables);
            }
            angles => {
                let (first, second) = angles.split_at(angles.len() / 2);
                let row = tables[0].len() / angles.len();
                let [before, after] = split(tables, row * first.len());
                rayon::join(
                    || self.angles(planes, first, before),
                    || self.angles(planes, second, after),
                );
            }
        }
    }

    /// One row from block `from` on.
    fn blocks<const N: usize, const K: usize>(
        &self,
        incidence: &Incidence<'_, N>,
        from: usize,
        rows: [&mut [f64]; K],
    ) where
        W: Work<K>,
    {
        let blocks = rows[0].len().div_ceil(LANES);
        if blocks > BLOCKS_AT_ONCE {
            let half = blocks / 2;
            let [before, after] = split(rows, half * LANES);
            rayon::join(
                || self.blocks(incidence, from, before),
                || self.blocks(incidence, from + half, after),
            );
            return;
        }
        let mut rest = rows;
        for block in from..from + blocks {
            if self.stop.load(Ordering::Relaxed) {
                return;
            }
            let at = rest[0].len().min(LANES);
            let [part, after] = split(rest, at);
            incidence.with_block(block, |block| self.work.fill(block, part));
            rest = after;
        }
    }
}

/// Each table cut in two.
fn split<const K: usize>(tables: [&mut [f64]; K], at: usize) -> [[&mut [f64]; K]; 2] {
    let mut after: [&mut [f64]; K] = std::array::from_fn(|_| <&mut [f64]>::default());
    let mut ends = after.iter_mut();
    let before = tables.map(|table| {
        let (start, end) = table.split_at_mut(at);
        if let Some(slot) = ends.next() {
            *slot = end;
        }
        start
    });
    [before, after]
}
