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
pub(crate) fn ends(
    depth_nm: &[f64],
    path_per_nm: f64,
    coherence_nm: f64,
) -> impl Iterator<Item = usize> {
    let mut end = 0;
    let coherent = move |from: f64, to: f64| path_per_nm * (to - from) < coherence_nm;
    (0..depth_nm.len()).map(move |l| {
        end = end.max(l + 1);
        while end < depth_nm.len() && coherent(depth_nm[l], depth_nm[end]) {
            end += 1;
        }
        end
    })
}

/// The same where the path differs from lane to lane.
pub(crate) fn lane_ends(
    depth_nm: &[f64],
    path_per_nm: &Lanes<f64>,
    coherence_nm: f64,
) -> Vec<Lanes<usize>> {
    let mut by_layer = vec![[0; LANES]; depth_nm.len()];
    for (lane, &path) in path_per_nm.iter().enumerate() {
        if lane > 0 && path.to_bits() == path_per_nm[lane - 1].to_bits() {
            for layer in &mut by_layer {
                layer[lane] = layer[lane - 1];
            }
            continue;
        }
        for (layer, end) in by_layer.iter_mut().zip(ends(depth_nm, path, coherence_nm)) {
            layer[lane] = end;
        }
    }
    by_layer
}

/// Layers in the widest window.
pub(crate) fn widest(ends: &[impl Ends]) -> usize {
    ends.iter().enumerate().fold(0, |widest, (l, end)| widest.max(end.last() - l))
}
