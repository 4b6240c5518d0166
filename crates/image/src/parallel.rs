//! Work shared out among threads where there are any: by rayon with the feature `parallel`, one piece
//! after the other without it.
//!
//! Results stand in order and no piece knows of another, so both give the same bytes. No sums.

#[cfg(feature = "parallel")]
use rayon::prelude::*;

/// What `work` makes of each number below `count`.
#[cfg(feature = "parallel")]
pub(crate) fn map<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    (0..count).into_par_iter().map(&work).collect()
}

/// What `work` makes of each number below `count`.
#[cfg(not(feature = "parallel"))]
pub(crate) fn map<T>(count: usize, work: impl Fn(usize) -> T) -> Vec<T> {
    (0..count).map(work).collect()
}

/// Hands `work` each run of `length` items with the run's number; what it gives back stands in their order.
#[cfg(feature = "parallel")]
pub(crate) fn map_chunks<T: Send, R: Send>(
    items: &mut [T],
    length: usize,
    work: impl Fn(usize, &mut [T]) -> R + Sync,
) -> Vec<R> {
    let chunks = items.par_chunks_mut(length).enumerate();
    chunks.map(|(i, chunk)| work(i, chunk)).collect()
}

/// Hands `work` each run of `length` items with the run's number; what it gives back stands in their order.
#[cfg(not(feature = "parallel"))]
pub(crate) fn map_chunks<T, R>(
    items: &mut [T],
    length: usize,
    work: impl Fn(usize, &mut [T]) -> R,
) -> Vec<R> {
    let chunks = items.chunks_mut(length).enumerate();
    chunks.map(|(i, chunk)| work(i, chunk)).collect()
}

/// Hands `work` runs of `length` items of both halves, from the first half's beginning and from the second
/// half's end, with the pair's number.
#[cfg(feature = "parallel")]
pub(crate) fn for_mirrored_chunks<T: Send>(
    (north, south): (&mut [T], &mut [T]),
    length: usize,
    work: impl Fn(usize, &mut [T], &mut [T]) + Sync,
) {
    let pairs = north.par_chunks_mut(length).zip(south.par_rchunks_mut(length));
    pairs.enumerate().for_each(|(i, (first, second))| work(i, first, second));
}

/// Hands `work` runs of `length` items of both halves, from the first half's beginning and from the second
/// half's end, with the pair's number.
#[cfg(not(feature = "parallel"))]
pub(crate) fn for_mirrored_chunks<T>(
    (north, south): (&mut [T], &mut [T]),
    length: usize,
    work: impl Fn(usize, &mut [T], &mut [T]),
) {
    let pairs = north.chunks_mut(length).zip(south.rchunks_mut(length));
    for (i, (first, second)) in pairs.enumerate() {
        work(i, first, second);
    }
}
