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
    (0..samples_side).map(|i| place((i as f64 + 0.5) / samples_side as f64)).collect()
}

/// The same, a little apart, so that they have the tent's variance, a sixth, whatever their number from 2 up: an
/// edge that passes across all of them is then as soft as the tent makes it.
pub(crate) fn tent_of_full_width(samples_side: usize) -> Vec<f64> {
    let places = tent(samples_side);
    let wider = (TENT_VARIANCE / variance(&places)).sqrt();
    places.iter().map(|x| x * wider).collect()
}

/// Width of an even disc that makes a tent, in the mean square, of samples at some places, in pixels.
pub(crate) fn width_between(places: &[f64]) -> f64 {
    4.0 * (TENT_VARIANCE - variance(places)).max(0.0).sqrt()
}

fn variance(places: &[f64]) -> f64 {
    places.iter().map(|x| x * x).sum::<f64>() / places.len() as f64
}

const TENT_VARIANCE: f64 = 1.0 / 6.0;

/// The share of the tent left of a place.
pub(crate) fn share_left_of(x: f64) -> f64 {
    let x = x.clamp(-1.0, 1.0);
    0.5 + x - 0.5 * x * x.abs()
}

/// The place that has a share of the tent on its left.
pub(crate) fn place(share: f64) -> f64 {
    if share < 0.5 { (2.0 * share).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * share).sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_shares_of_the_tent_are_each_others_inverse() {
        for i in 0..=20 {
            let share = f64::from(i) / 20.0;
            assert!((share_left_of(place(share)) - share).abs() < 1e-15, "{share}");
        }
    }

    #[test]
    fn samples_of_full_width_have_the_variance_of_the_tent() {
        for side in 2..9 {
            let places = tent_of_full_width(side);
            assert!((variance(&places) - TENT_VARIANCE).abs() < 1e-12 && places[side - 1] < 1.0);
        }
    }
}
