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

    /// Bilayers that each block goes through, those of all stacks together.
    fn bilayers(&self) -> usize;

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
            let at_once = is_brief(angles.len() * row.div_ceil(LANES), work.bilayers());
            let [before, after] = split(tables, row * first.len());
            both(
                at_once,
                || self::angles(work, first, before, stop),
                || self::angles(work, second, after, stop),
            );
        }
    }
}

/// Whether so many blocks are computed before another thread would have taken up half of them.
pub(crate) fn is_brief(blocks: usize, bilayers: usize) -> bool {
    blocks.saturating_mul(bilayers + BILAYERS_OF_MEDIA) <= BRIEF
}

/// What a block costs before its first bilayer, in bilayers: the media are met, a table is written.
const BILAYERS_OF_MEDIA: usize = 32;

/// Bilayers times blocks, some 30 to 80 ns each.
const BRIEF: usize = 2048;

/// Both pieces of work, on two threads unless they are brief.
fn both(brief: bool, first: impl FnOnce() + Send, second: impl FnOnce() + Send) {
    if brief {
        first();
        second();
    } else {
        parallel::join(first, second);
    }
}

/// One row from block `from` on.
fn row<W: Work<K>, const K: usize>(
    work: &W,
    angle: &W::Angle,
    from: usize,
    rows: [&mut [f64]; K],
    stop: &AtomicBool,
) {
    let blocks = rows[0].len().div_ceil(LANES);
    if blocks > 1 && !is_brief(blocks, work.bilayers()) {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts how often each value is written.
    struct Count {
        bilayers: usize,
    }

    impl Work<1> for Count {
        type Angle = ();

        fn bilayers(&self) -> usize {
            self.bilayers
        }

        fn meet(&self, _: f64) {}

        fn fill(&self, (): &(), _: usize, [out]: [&mut [f64]; 1]) {
            for times in out {
                *times += 1.0;
            }
        }
    }

    #[test]
    fn every_value_is_written_once_by_one_thread_or_more() {
        let brief: Vec<bool> = [1, 2000, 100_000].map(|bilayers| is_brief(20, bilayers)).to_vec();
        assert_eq!(brief, [true, false, false]);
        for bilayers in [1, 2000, 100_000] {
            for (angles, wavelengths) in [(1, 1), (1, 33), (5, 31), (7, 401), (900, 1)] {
                let mut table = vec![0.0; angles * wavelengths];
                let work = Count { bilayers };
                fill(&work, &vec![0.0; angles], [&mut table], &AtomicBool::new(false));
                assert_eq!(table, vec![1.0; angles * wavelengths]);
            }
        }
    }
}
