//! How the tablets lean against the surface, and what of their waves still meets the surface's in phase.
//!
//! A level mirror above one that leans across a tablet: the mean of exp(i phase) over their distance.
//! Left out: that tablets of one column lean alike and those of the next do not.

use crate::light::bands::{BANDS, Bands};

/// How the layers of tablets wave against the surface above them.
///
/// In mature nacre of Pinna interfaces curve by 5 degrees to either side, in its first layers by 7.5 (Hovden and others
/// 2015, Nat. Commun. 6, 10097, figure 5). Nobody has measured pearls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waviness {
    slope_rad: f64,
}

/// What of a film is worked out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilmParts {
    /// Surface and layers together, all waves in phase.
    Together,
    /// Each by itself.
    Apart,
    /// All of that.
    Both,
}

/// Width over which a tablet is plane **(ours)**: tablets are 2 to 10 um wide.
const TABLET_NM: f64 = 5000.0;

/// A share in phase below this is left out.
const LEAST_IN_PHASE: f64 = 0.01;

/// Least n cos of nacre, for n = 1.5 at the horizon.
const LEAST_PATH: f64 = 1.1;

impl Waviness {
    /// `slope_rad` from 0 (level) to 0.3 is the standard deviation of the tablets' lean.
    pub fn new(slope_rad: f64) -> Self {
        Self { slope_rad }
    }

    pub(crate) fn slope_rad(self) -> f64 {
        self.slope_rad
    }

    /// What a film must tell.
    pub fn parts(self) -> FilmParts {
        if self.slope_rad <= 0.0 {
            FilmParts::Together
        } else if self.in_phase(LEAST_PATH)[BANDS - 1] < LEAST_IN_PHASE {
            FilmParts::Apart
        } else {
            FilmParts::Both
        }
    }

    /// Share of the amplitude that the layers mirror which is in phase with what the surface mirrors, by band,
    /// where their distance counts `path` times (n cos).
    ///
    /// The mean of exp(i phase) over phases 4 pi n cos d / lambda that spread as a bell curve with the distance d,
    /// whose standard deviation over a plane that leans is slope times width over root 12.
    pub(crate) fn in_phase(self, path: f64) -> Bands {
        let spread_nm = self.slope_rad * TABLET_NM / 12.0_f64.sqrt();
        std::array::from_fn(|band| {
            let phase = 4.0 * std::f64::consts::PI * path * spread_nm / middle_nm(band);
            libm::exp(-0.5 * phase * phase)
        })
    }
}

/// The wavelength in the middle of a band.
fn middle_nm(band: usize) -> f64 {
    380.0 + 400.0 * (band as f64 + 0.5) / BANDS as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn level_layers_are_in_phase_and_steep_ones_are_not() {
        assert!(Waviness::new(0.0).in_phase(1.7).iter().all(|share| *share >= 1.0));
        assert!(Waviness::new(0.12).in_phase(1.2).iter().all(|share| *share < 0.01));
        let parts = [0.0, 1e-6, 0.05, 0.12].map(|slope| Waviness::new(slope).parts());
        assert_eq!(
            parts,
            [FilmParts::Together, FilmParts::Both, FilmParts::Both, FilmParts::Apart]
        );
    }

    #[test]
    fn blue_loses_its_phase_first() {
        let shares = Waviness::new(0.03).in_phase(1.68);
        assert!(shares.windows(2).all(|pair| pair[0] < pair[1]));
    }
}
