//! Coherence windows: which layers interfere with which.

use crate::lanes::{LANES, Lanes};

/// The first layer that no longer belongs to the interference of one start layer, in each lane.
pub(crate) trait Ends: Copy + Sync {
    /// Whether it is the same in all lanes.
    const ARE_ALIKE: bool;
    fn at(self, lane: usize) -> usize;
    /// The largest of them.
    fn last(self) -> usize;
}

impl Ends for usize {
    const ARE_ALIKE: bool = true;
    #[inline(always)]
    fn at(self, _lane: usize) -> usize {
        self
    }
    #[inline(always)]
    fn last(self) -> usize {
        self
    }
}

impl Ends for Lanes<usize> {
    const ARE_ALIKE: bool = false;
    #[inline(always)]
    fn at(self, lane: usize) -> usize {
        self[lane]
    }
    #[inline(always)]
    fn last(self) -> usize {
        self.into_iter().fold(0, usize::max)
    }
}

/// The end of each start layer's window: here the coherence length is applied. A window always holds
/// its start layer.
pub(crate) fn ends(depth_nm: &[f64], path_per_nm: f64, coherence_nm: f64) -> Vec<usize> {
    let mut end = 0;
    let coherent = |from: f64, to: f64| path_per_nm * (to - from) < coherence_nm;
    (0..depth_nm.len())
        .map(|l| {
            end = end.max(l + 1);
            while end < depth_nm.len() && coherent(depth_nm[l], depth_nm[end]) {
                end += 1;
            }
            end
        })
        .collect()
}

/// The same where the path differs from lane to lane.
pub(crate) fn lane_ends(
    depth_nm: &[f64],
    path_per_nm: &Lanes<f64>,
    coherence_nm: f64,
) -> Vec<Lanes<usize>> {
    let mut by_layer = vec![[0; LANES]; depth_nm.len()];
    for (lane, &path_per_nm) in path_per_nm.iter().enumerate() {
        for (layer, end) in by_layer.iter_mut().zip(ends(depth_nm, path_per_nm, coherence_nm)) {
            layer[lane] = end;
        }
    }
    by_layer
}

/// Layers in the widest window.
pub(crate) fn widest(ends: &[impl Ends]) -> usize {
    ends.iter().enumerate().fold(0, |widest, (l, end)| widest.max(end.last() - l))
}
