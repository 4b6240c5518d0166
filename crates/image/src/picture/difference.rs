//! How far apart two pictures look: CIEDE2000 of their codes, pixel by pixel, and what it comes to over a pearl.
//!
//! Left out: how the eye blurs what is fine, which models such as S-CIELAB and FLIP have.

use nacreous_colour::{RgbSpace, decode, delta_e_2000, lab_from_xyz};

/// CIEDE2000 over some pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DifferenceSummary {
    /// How many pixels.
    pub pixels: usize,
    /// Their mean.
    pub mean: f64,
    /// What 95 of 100 pixels do not exceed.
    pub percentile_95: f64,
    /// The largest.
    pub largest: f64,
}

/// CIEDE2000 between codes RGBA of one space, pixel by pixel, relative to its white; as many as both have.
pub fn differences(first: &[u8], second: &[u8], space: RgbSpace) -> Vec<f32> {
    let linear: Vec<f64> = (0..=u8::MAX).map(|code| decode(f64::from(code) / 255.0)).collect();
    let white = space.white_xyz();
    let lab = |code: &[u8; 4]| {
        let rgb = [0, 1, 2].map(|channel| linear[usize::from(code[channel])]);
        lab_from_xyz(space.xyz_from_rgb(rgb), white)
    };
    let (first, second) = (first.as_chunks::<4>().0, second.as_chunks::<4>().0);
    let one = |(a, b): (&[u8; 4], &[u8; 4])| {
        if a[..3] == b[..3] { 0.0 } else { delta_e_2000(lab(a), lab(b)) as f32 }
    };
    first.iter().zip(second).map(one).collect()
}

/// What the differences come to over the pixels that are covered; nothing of none.
pub fn summary(differences: &[f32], covered: &[u8]) -> Option<DifferenceSummary> {
    let counted = differences.iter().zip(covered).filter(|(_, covered)| **covered > 0);
    let mut counted: Vec<f64> = counted.map(|(difference, _)| f64::from(*difference)).collect();
    let largest = counted.iter().copied().reduce(f64::max)?;
    counted.sort_by(f64::total_cmp);
    let place = 0.95 * (counted.len() - 1) as f64;
    let (below, above) = (counted[place as usize], counted[place.ceil() as usize]);
    Some(DifferenceSummary {
        pixels: counted.len(),
        mean: counted.iter().sum::<f64>() / counted.len() as f64,
        percentile_95: below + (above - below) * place.fract(),
        largest,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_codes_differ_by_nothing_and_black_and_white_by_a_hundred() {
        let (black, white) = ([0, 0, 0, 255], [255, 255, 255, 255]);
        let first = [black, white, black].concat();
        let second = [black, white, white].concat();
        let found = differences(&first, &second, RgbSpace::Srgb);
        assert!(found[0] == 0.0 && found[1] == 0.0 && (found[2] - 100.0).abs() < 1e-3);
        assert_eq!(summary(&found, &[0, 0, 0]), None);
        let all = summary(&[0.0, 1.0, 2.0, 9.0], &[1, 1, 1, 0]).unwrap();
        assert!(all.pixels == 3 && (all.mean - 1.0).abs() < 1e-12);
        assert!((all.percentile_95 - 1.9).abs() < 1e-12 && (all.largest - 2.0).abs() < 1e-12);
    }
}
