//! The bands of a bead's own layers, as they show through thin nacre.
//!
//! A bead is cut from shell whose layers are plane: light and dark slices across one axis.
//! Left out: their colour, and that a bead's layers mirror as its nacre does.

use std::f64::consts::TAU;

use glam::DVec3;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;

use crate::grain::normal::uniform;

/// What shows of a nucleus' bands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NucleusBands {
    /// Share by which light from inside is more or less, at most.
    pub contrast: f64,
    /// From one dark band to the next.
    pub band_mm: f64,
}

/// The bands of one bead.
#[derive(Debug)]
pub(crate) struct Slices {
    contrast: f64,
    /// Waves per mm, and where they begin.
    waves: [(f64, f64); FREQUENCIES.len()],
}

/// Frequencies that never meet again, so that no two bands are alike **(ours)**.
const FREQUENCIES: [f64; 4] = [0.62, 1.0, 1.41, 2.19];

impl Slices {
    pub(crate) fn new(bands: NucleusBands, seed: u64) -> Self {
        let mut random = ChaCha8Rng::from_seed(key(seed));
        let waves = FREQUENCIES.map(|f| (f / bands.band_mm, uniform(&mut random)));
        Self { contrast: bands.contrast, waves }
    }

    /// Factor on the light from inside at a direction from the middle of a pearl of `pearl_mm`, its radius.
    pub(crate) fn at(&self, own: DVec3, pearl_mm: f64, footprint_mm: f64) -> f64 {
        let along_mm = own.x * pearl_mm;
        let mut sum = 0.0;
        for (per_mm, begins) in self.waves {
            let width = TAU * per_mm * FOOTPRINT * footprint_mm;
            let left = libm::exp(-0.5 * width * width);
            sum += left * libm::cos(TAU * (per_mm * along_mm + begins));
        }
        1.0 + self.contrast * (0.5 * sum).clamp(-1.0, 1.0)
    }
}

/// Standard deviation of a footprint of width 1 that spreads as a pixel's tent does.
const FOOTPRINT: f64 = 0.41;

fn key(seed: u64) -> [u8; 32] {
    let mut key = *b"-------- nacreous nucleus' bands";
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slices_are_plane_and_never_more_than_their_contrast() {
        let slices = Slices::new(NucleusBands { contrast: 0.2, band_mm: 0.5 }, 4);
        let (mut least, mut most) = (1.0_f64, 1.0_f64);
        for i in 0..400 {
            let x = f64::from(i) / 200.0 - 1.0;
            let ring = (1.0 - x * x).max(0.0).sqrt();
            let here = slices.at(DVec3::new(x, ring, 0.0), 4.0, 0.0);
            let there = slices.at(DVec3::new(x, -0.6 * ring, 0.8 * ring), 4.0, 0.0);
            assert!((here - there).abs() < 1e-12);
            (least, most) = (least.min(here), most.max(here));
        }
        assert!((0.8..0.9).contains(&least) && (1.1..=1.2).contains(&most), "{least} {most}");
        assert!((slices.at(DVec3::X, 4.0, 50.0) - 1.0).abs() < 1e-9);
    }
}
