//! The CIE standard observers: how much each wavelength adds to X, Y and Z.

use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

use crate::table::rows;
use crate::{ColourError, SAMPLES, Spectrum};

/// A CIE standard observer, by the size of the field it was measured with.
///
/// Read from and written as `1931-2` and `1964-10`.
///
/// ```
/// use nacreous_colour::Observer;
/// assert_eq!("1964-10".parse(), Ok(Observer::Cie1964));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Observer {
    /// CIE 1931, 2 degrees: the paper's, and that of RGB spaces.
    #[default]
    Cie1931,
    /// CIE 1964, 10 degrees: for large patches of colour.
    Cie1964,
}

/// Colour-matching functions in the order x, y, z.
type MatchingFunctions = [[f64; SAMPLES]; 3];

static CIE_1931: LazyLock<MatchingFunctions> =
    LazyLock::new(|| matching_functions(include_str!("../../../data/cie_1931_2_degree.csv")));
static CIE_1964: LazyLock<MatchingFunctions> =
    LazyLock::new(|| matching_functions(include_str!("../../../data/cie_1964_10_degree.csv")));

fn matching_functions(text: &str) -> MatchingFunctions {
    // The tables are part of the program; the tests of this file read both.
    let rows = rows::<4>(text, "observer").expect("the table in data/ is well formed");
    std::array::from_fn(|channel| std::array::from_fn(|index| rows[index].cells[channel + 1]))
}

impl Observer {
    /// The colour-matching functions x, y, z (ISO/CIE 11664-1) by wavelength.
    ///
    /// ```
    /// use nacreous_colour::Observer;
    /// let [_, y, _] = Observer::Cie1931.matching_functions();
    /// assert_eq!(y[555 - 380], 1.0); // the eye's best wavelength
    /// ```
    pub fn matching_functions(self) -> &'static [[f64; SAMPLES]; 3] {
        match self {
            Self::Cie1931 => &CIE_1931,
            Self::Cie1964 => &CIE_1964,
        }
    }

    /// What each wavelength adds to X, Y and Z under a light, scaled so that the perfect reflecting
    /// diffuser (1 at every wavelength) has Y = 1.
    ///
    /// Made once, then used for many spectra by [`crate::xyz_from_spectrum`].
    ///
    /// # Errors
    /// The light has nothing that the eye sees, so that nothing is relative to it.
    ///
    /// ```
    /// use nacreous_colour::{Illuminant, Observer};
    /// let weights = Observer::Cie1931.weights(&Illuminant::A.spectrum())?;
    /// assert!((weights[1].iter().sum::<f64>() - 1.0).abs() < 1e-12);
    /// # Ok::<(), nacreous_colour::ColourError>(())
    /// ```
    pub fn weights(self, illuminant: &Spectrum) -> Result<[[f64; SAMPLES]; 3], ColourError> {
        let functions = self.matching_functions();
        let light = illuminant.values();
        let luminance: f64 = functions[1].iter().zip(light).map(|(y, power)| y * power).sum();
        // Below the smallest normal number the quotient is not finite.
        if !(luminance.is_normal() && luminance > 0.0) {
            return Err(ColourError::Dark { luminance });
        }
        Ok(std::array::from_fn(|channel| {
            std::array::from_fn(|index| functions[channel][index] * (light[index] / luminance))
        }))
    }
}

impl FromStr for Observer {
    type Err = ColourError;

    fn from_str(name: &str) -> Result<Self, ColourError> {
        match name {
            "1931-2" => Ok(Self::Cie1931),
            "1964-10" => Ok(Self::Cie1964),
            _ => Err(ColourError::Name {
                quantity: "observer",
                value: name.to_owned(),
                allowed: "1931-2, 1964-10",
            }),
        }
    }
}

impl fmt::Display for Observer {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Cie1931 => "1931-2",
            Self::Cie1964 => "1964-10",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::WAVELENGTH_NM;

    #[test]
    fn tables_stand_on_the_working_grid() {
        for text in [
            include_str!("../../../data/cie_1931_2_degree.csv"),
            include_str!("../../../data/cie_1964_10_degree.csv"),
        ] {
            let rows = rows::<4>(text, "observer").unwrap();
            let wavelengths: Vec<f64> = rows.iter().map(|row| row.cells[0]).collect();
            assert_eq!(wavelengths, WAVELENGTH_NM);
        }
    }

    #[test]
    fn a_dark_light_is_refused() {
        let error = Observer::Cie1931.weights(&Spectrum::from_fn(|_| 0.0)).unwrap_err();
        assert_eq!(error.to_string(), "illuminant has luminance 0; allowed: above 0");
    }

    #[test]
    fn names_are_read_as_written() {
        for observer in [Observer::Cie1931, Observer::Cie1964] {
            assert_eq!(observer.to_string().parse(), Ok(observer));
        }
        let error = "1931".parse::<Observer>().unwrap_err();
        assert_eq!(error.to_string(), "observer is \"1931\"; allowed: 1931-2, 1964-10");
    }
}
