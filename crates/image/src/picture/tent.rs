//! Where the samples of a pixel lie.
//!
//! A tent filter two pixels wide by equal weights at uneven places.
//! Left out: random places.

/// Column of the one sample that is taken in row `i`, such that no column comes twice.
pub(crate) fn rook(i: usize, side: usize) -> usize {
    (2 * i + 1) % (side + usize::from(side.is_multiple_of(2)))
}

/// Positions of the samples along one side, in pixels from the pixel's middle, such that equal weights
/// make a tent filter two pixels wide. The same pattern on both axes and in every pixel: pixels that
/// mirror each other about a lone pearl's centre see the same view angles.
pub(crate) fn tent(samples_side: usize) -> Vec<f64> {
    (0..samples_side)
        .map(|i| {
            let u = (i as f64 + 0.5) / samples_side as f64;
            if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() }
        })
        .collect()
}
