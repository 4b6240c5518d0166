//! A spectral quantity on the working grid: 380 to 780 nm by 1 nm.

use std::ops::{Add, Mul};

use crate::ColourError;
use crate::table::{Row, rows};

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

/// Larger numbers than this are no light, and their powers might leave the range of `f64`.
const LARGEST: f64 = 1e12;

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

    /// The spectrum in a table of two columns, `wavelength_nm,value`, interpolated linearly.
    ///
    /// A header row is optional, `#` begins a comment. `place` is what messages call the table,
    /// such as its path.
    ///
    /// # Errors
    /// Fewer than two rows, wavelengths that do not increase or do not cover 380 to 780 nm, a value
    /// that is not within 0 to 1e12; the message names the line.
    ///
    /// ```
    /// use nacreous_colour::Spectrum;
    ///
    /// let ramp = Spectrum::from_csv("wavelength_nm,value\n380,0\n780,4", "ramp.csv")?;
    /// assert_eq!(ramp.values()[100], 1.0);
    /// # Ok::<(), nacreous_colour::ColourError>(())
    /// ```
    pub fn from_csv(text: &str, place: &str) -> Result<Self, ColourError> {
        let rows = rows::<2>(text, place)?;
        check(&rows, place)?;
        let mut upper = 1;
        Ok(Self(WAVELENGTH_NM.map(|wavelength_nm| {
            // Both grids increase, so the interval only ever moves up.
            while rows[upper].cells[0] < wavelength_nm {
                upper += 1;
            }
            let ([from_nm, from], [to_nm, to]) = (rows[upper - 1].cells, rows[upper].cells);
            from + (to - from) * (wavelength_nm - from_nm) / (to_nm - from_nm)
        })))
    }

    /// The value of each sample, in the order of [`WAVELENGTH_NM`].
    pub fn values(&self) -> &[f64; SAMPLES] {
        &self.0
    }
}

/// What [`Spectrum::from_csv`] promises about its rows.
fn check(rows: &[Row<2>], place: &str) -> Result<(), ColourError> {
    let table = |problem| ColourError::Table { place: place.to_owned(), problem };
    let line = |line, problem| ColourError::Line { place: place.to_owned(), line, problem };
    let [first, .., last] = rows else {
        return Err(table(format!("{} rows of numbers; allowed: at least 2", rows.len())));
    };
    for row in rows {
        if !(0.0..=LARGEST).contains(&row.cells[1]) {
            return Err(line(row.line, format!("value is {:?}; allowed: 0 to 1e12", row.cells[1])));
        }
    }
    for pair in rows.windows(2) {
        let ([before, _], [after, _]) = (pair[0].cells, pair[1].cells);
        if after <= before {
            let problem =
                format!("wavelength_nm is {after:?}; allowed: above {before:?}, the last");
            return Err(line(pair[1].line, problem));
        }
    }
    let ([from_nm, _], [to_nm, _]) = (first.cells, last.cells);
    let mut missing = Vec::new();
    if from_nm > FIRST_NM {
        missing.push(format!("{FIRST_NM:?} to {from_nm:?} nm"));
    }
    if to_nm < LAST_NM {
        missing.push(format!("{to_nm:?} to {LAST_NM:?} nm"));
    }
    if !missing.is_empty() {
        let missing = missing.join(" and ");
        return Err(table(format!(
            "wavelength_nm is {from_nm:?} to {to_nm:?}; missing: {missing}"
        )));
    }
    Ok(())
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

    fn problem(text: &str) -> String {
        Spectrum::from_csv(text, "lamp.csv").unwrap_err().to_string()
    }

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
    fn every_refusal_says_what_and_where() {
        assert_eq!(problem(""), "lamp.csv: 0 rows of numbers; allowed: at least 2");
        assert_eq!(problem("380,1"), "lamp.csv: 1 rows of numbers; allowed: at least 2");
        assert_eq!(
            problem("400,1\n700,1"),
            "lamp.csv: wavelength_nm is 400.0 to 700.0; missing: 380.0 to 400.0 nm and 700.0 to 780.0 nm"
        );
        assert_eq!(problem("380,1\n780,-2"), "lamp.csv, line 2: value is -2.0; allowed: 0 to 1e12");
        assert_eq!(
            problem("380,1\n500,1\n500,1\n780,1"),
            "lamp.csv, line 3: wavelength_nm is 500.0; allowed: above 500.0, the last"
        );
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
