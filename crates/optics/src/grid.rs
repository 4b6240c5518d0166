//! Tables `[angle, wavelength]`, filled on all processors.

use std::f64::consts::FRAC_PI_2;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::{OpticsError, error::within, lanes::LANES, parallel};

/// The range of every question.
pub(crate) fn check(angle_rad: &[f64], wavelength_nm: &[f64]) -> Result<(), OpticsError> {
    for &angle in angle_rad {
        within("angle_rad", angle, 0.0..=FRAC_PI_2, "0 to pi/2")?;
    }
    for &wavelength in wavelength_nm {
        within("wavelength_nm", wavelength, 1.0..=1e6, "1 to 1000000 nm")?;
    }
    Ok(())
}

/// What is to be computed at each angle and block of wavelengths.
pub(crate) trait Work<const K: usize>: Sync {
    /// What is the same for all blocks of one angle.
    type Angle: Sync;

    /// Meets an angle, once for its row.
    fn meet(&self, angle_rad: f64) -> Self::Angle;

    /// Fills one block's part of each of the `K` tables; where wavelengths end within the block it is
    /// shorter than the lanes.
    fn fill(&self, angle: &Self::Angle, block: usize, tables: [&mut [f64]; K]);
}

/// Fills `K` tables with `work`, in an order of no consequence, or leaves off where `stop` is set.
pub(crate) fn fill<const K: usize>(
    work: &impl Work<K>,
    angle_rad: &[f64],
    tables: [&mut [f64]; K],
    stop: &AtomicBool,
) {
    if !tables[0].is_empty() {
        angles(work, angle_rad, tables, stop);
    }
}

fn angles<const K: usize>(
    work: &impl Work<K>,
    angle_rad: &[f64],
    tables: [&mut [f64]; K],
    stop: &AtomicBool,
) {
    match angle_rad {
        [] => {}
        &[angle] => row(work, &work.meet(angle), 0, tables, stop),
        angles => {
            let (first, second) = angles.split_at(angles.len() / 2);
            let row = tables[0].len() / angles.len();
            let [before, after] = split(tables, row * first.len());
            parallel::join(
                || self::angles(work, first, before, stop),
                || self::angles(work, second, after, stop),
            );
        }
    }
}

/// Blocks that one thread takes in one go: with few layers, less is not worth a hand-over.
const BLOCKS_AT_ONCE: usize = 4;

/// One row from block `from` on.
fn row<W: Work<K>, const K: usize>(
    work: &W,
    angle: &W::Angle,
    from: usize,
    rows: [&mut [f64]; K],
    stop: &AtomicBool,
) {
    let blocks = rows[0].len().div_ceil(LANES);
    if blocks > BLOCKS_AT_ONCE {
        let half = blocks / 2;
        let [before, after] = split(rows, half * LANES);
        parallel::join(
            || row(work, angle, from, before, stop),
            || row(work, angle, from + half, after, stop),
        );
        return;
    }
    let mut rest = rows;
    for block in from..from + blocks {
        if stop.load(Ordering::Relaxed) {
            return;
        }
        let at = rest[0].len().min(LANES);
        let [part, after] = split(rest, at);
        work.fill(angle, block, part);
        rest = after;
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
