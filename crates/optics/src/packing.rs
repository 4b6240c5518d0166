//! Tables of few wavelengths: a block that they would leave mostly empty runs on into the next angles.

use crate::lanes::{HALF, LANES, Lanes};

/// Whether blocks run on from angle to angle.
pub(crate) fn is_packed(angles: usize, wavelengths: usize) -> bool {
    wavelengths <= HALF && angles > 1
}

/// Blocks of a table.
pub(crate) fn blocks(angles: usize, wavelengths: usize) -> usize {
    if is_packed(angles, wavelengths) {
        (angles * wavelengths).div_ceil(LANES)
    } else {
        angles.saturating_mul(wavelengths.div_ceil(LANES))
    }
}

/// (angle, wavelength) of each lane of a packed block, by their places, as the table has them. Behind the
/// last angle are lanes that nobody asked for; they have that angle too.
pub(crate) fn places(block: usize, angles: usize, wavelengths: usize) -> Lanes<(usize, usize)> {
    let first = block * LANES;
    let (mut angle, mut wavelength) = (first / wavelengths, first % wavelengths);
    let mut places = [(0, 0); LANES];
    for place in &mut places {
        *place = (angle.min(angles - 1), wavelength);
        wavelength += 1;
        if wavelength == wavelengths {
            (angle, wavelength) = (angle + 1, 0);
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packed_blocks_hold_every_point_once_in_the_order_of_the_table() {
        for (angles, wavelengths) in [(2, 1), (900, 1), (5, 7), (41, 16), (64, 2)] {
            assert!(is_packed(angles, wavelengths));
            let blocks = blocks(angles, wavelengths);
            let lanes = (0..blocks).flat_map(|block| places(block, angles, wavelengths));
            let asked: Vec<_> = lanes.take(angles * wavelengths).collect();
            let row = |angle| (0..wavelengths).map(move |wavelength| (angle, wavelength));
            assert_eq!(asked, (0..angles).flat_map(row).collect::<Vec<_>>());
            assert!((blocks - 1) * LANES < angles * wavelengths);
            for (angle, wavelength) in places(blocks - 1, angles, wavelengths) {
                assert!(angle < angles && wavelength < wavelengths);
            }
        }
    }
}
