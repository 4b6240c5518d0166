//! A spectral quantity on the working grid: 380 to 780 nm by 1 nm.

use std::ops::{Add, Mul};

use crate::{
    ColourError,
    measured::{self, LARGEST},
};

/// Number of samples of a [`Spectrum`].
pub const SAMPLES: usize = 401;
/// Wavelength of the first sample.
pub const FIRST_NM: f64 = 380.0;
/// Wavelength of the last sample.
pub const LAST_NM: f64 = 780.0;

/// The wavelength of each sample of a [`Spectrum`].
///
/// ```
/// use nacreous_colour::{SAMPLES, WAVELENGTH_NM};
/// assert_eq!((WAVELENGTH_NM[0], WAVELENGTH_NM[SAMPLES - 1]), (380.0, 780.0));
/// ```
pub static WAVELENGTH_NM: [f64; SAMPLES] = wavelengths();

const fn wavelengths() -> [f64; SAMPLES] {
    let mut grid = [FIRST_NM; SAMPLES];
    let mut index = 1;
    while index < SAMPLES {
        grid[index] = grid[index - 1] + 1.0;
        index += 1;
    }
    grid
}

/// A reflectance, a transmittance or a relative power by wavelength; see [`WAVELENGTH_NM`].
///
/// Spectra add (lamps together) and multiply (a light through a filter, a change of strength).
///
/// ```
/// use nacreous_colour::{Illuminant, Spectrum};
///
/// let filter = Spectrum::from_fn(|wavelength_nm| if wavelength_nm < 500.0 { 0.0 } else { 1.0 });
/// let light = &(&Illuminant::D65.spectrum() * &filter) * 2.0;
/// assert_eq!(light.values()[560 - 380], 2.0);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum(pub(crate) [f64; SAMPLES]);

impl Spectrum {
    /// The spectrum with value `value_at(wavelength_nm)` at every sample.
    ///
    /// The function must give finite numbers, not negative; what comes from outside goes through
    /// [`Spectrum::from_values`] or [`Spectrum::from_csv`], which check.
    pub fn from_fn(value_at: impl Fn(f64) -> f64) -> Self {
        Self(WAVELENGTH_NM.map(value_at))
    }

    /// The spectrum of 401 values.
    ///
    /// # Errors
    /// Another number of values, or one that is not within 0 to 1e12.
    pub fn from_values(values: &[f64]) -> Result<Self, ColourError> {
        let samples = <[f64; SAMPLES]>::try_from(values)
            .map_err(|_| ColourError::Samples { samples: values.len() })?;
        for (&wavelength_nm, &value) in WAVELENGTH_NM.iter().zip(&samples) {
            if !(0.0..=LARGEST).contains(&value) {
                return Err(ColourError::Sample { wavelength_nm, value });
            }
        }
        Ok(Self(samples))
    }

    /// The spectrum in a table of two columns, wavelength in nm and value, as instruments write it.
    ///
    /// Columns are parted by semicolons, tabs, commas or blanks; decimals have a point or a comma,
    /// exponents an E or Fortran's D; wavelengths rise or fall. Lines before and after the numbers are passed over, `#` begins a
    /// comment. Values between samples lie on straight lines; of samples finer than 1 nm each value
    /// is the mean over the nm around it. Where 400 to 700 nm are covered, the nearest value stands
    /// beyond the ends. Values down to -5 % of the largest are noise and count as 0. `place` is what
    /// messages call the table, such as its path.
    ///
    /// # Errors
    /// Fewer than two rows, more than two columns, wavelengths that turn or do not cover 400 to 700
    /// nm, a value that is not within 0 to 1e12; the message names the line.
    ///
    /// ```
    /// use nacreous_colour::Spectrum;
    ///
    /// let ramp = Spectrum::from_csv("Wavelength [nm];Counts\n780,0;4,0\n380,0;0,0", "ramp.csv")?;
    /// assert_eq!(ramp.values()[100], 1.0);
    /// # Ok::<(), nacreous_colour::ColourError>(())
    /// ```
    pub fn from_csv(text: &str, place: &str) -> Result<Self, ColourError> {
        measured::values(text, place).map(Self)
    }

    /// The value of each sample, in the order of [`WAVELENGTH_NM`].
    pub fn values(&self) -> &[f64; SAMPLES] {
        &self.0
    }
}

impl Add for &Spectrum {
    type Output = Spectrum;

    fn add(self, other: &Spectrum) -> Spectrum {
        Spectrum(std::array::from_fn(|index| self.0[index] + other.0[index]))
    }
}

impl Mul for &Spectrum {
    type Output = Spectrum;

    fn mul(self, other: &Spectrum) -> Spectrum {
        Spectrum(std::array::from_fn(|index| self.0[index] * other.0[index]))
    }
}

impl Mul<f64> for &Spectrum {
    type Output = Spectrum;

    fn mul(self, factor: f64) -> Spectrum {
        Spectrum(self.0.map(|value| value * factor))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn csv(wavelength_nm: &[f64], value_at: impl Fn(f64) -> f64) -> String {
        let line = |&nm: &f64| format!("{nm},{}", value_at(nm));
        wavelength_nm.iter().map(line).collect::<Vec<_>>().join("\n")
    }

    proptest! {
        #[test]
        fn linear_interpolation_returns_a_straight_line(
            offset in 0.0..5.0_f64,
            slope in 0.0..0.1_f64,
            mut inner_nm in proptest::collection::vec(381.0..779.0_f64, 0..30),
        ) {
            inner_nm.extend([350.0, 800.0]);
            inner_nm.sort_by(f64::total_cmp);
            inner_nm.dedup();
            let line = |nm: f64| offset + slope * (nm - 350.0);
            let spectrum = Spectrum::from_csv(&csv(&inner_nm, line), "line.csv").unwrap();
            for (&nm, &value) in WAVELENGTH_NM.iter().zip(spectrum.values()) {
                prop_assert!((value - line(nm)).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn a_grid_of_one_nm_is_returned_exactly() {
        let value_at = |nm: f64| 1.0 / nm;
        let text = csv(&WAVELENGTH_NM, value_at);
        assert_eq!(Spectrum::from_csv(&text, "same.csv"), Ok(Spectrum::from_fn(value_at)));
    }

    #[test]
    fn values_from_outside_are_checked() {
        let error = |values: &[f64]| Spectrum::from_values(values).unwrap_err().to_string();
        let mut values = [1.0; SAMPLES];
        values[20] = f64::NAN;
        assert_eq!(error(&values), "spectrum at 400 nm is NaN; allowed: 0 to 1e12");
        assert_eq!(
            error(&values[1..]),
            "spectrum has 400 samples; allowed: 401 (380 to 780 nm by 1 nm)"
        );
    }
}
