//! Everything that this room refuses, each as one line for the person who gave the value.
//!
//! Numbers are written with `{:?}`, which keeps 1e300 short.

/// A value from outside that has no meaning as colour.
///
/// ```
/// use nacreous_colour::{ColourError, Illuminant};
///
/// let error: ColourError = "D66".parse::<Illuminant>().unwrap_err();
/// assert!(error.to_string().starts_with("illuminant is \"D66\"; allowed: A, C, D50, D55, D65"));
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ColourError {
    /// A name that stands for nothing here.
    #[error("{quantity} is {value:?}; allowed: {allowed}")]
    Name {
        /// What was to be named, such as `illuminant`.
        quantity: &'static str,
        /// The name as given.
        value: String,
        /// The names that exist.
        allowed: &'static str,
    },
    /// A colour temperature outside the range of the daylight and Planckian loci.
    #[error("colour temperature is {kelvin:?} K; allowed: 1000 to 25000 K")]
    Temperature {
        /// The temperature as given.
        kelvin: f64,
    },
    /// A spectrum with the wrong number of samples.
    #[error("spectrum has {samples} samples; allowed: 401 (380 to 780 nm by 1 nm)")]
    Samples {
        /// The number as given.
        samples: usize,
    },
    /// A sample that is not a spectral quantity.
    #[error("spectrum at {wavelength_nm} nm is {value:?}; allowed: 0 to 1e12")]
    Sample {
        /// Where in the spectrum.
        wavelength_nm: f64,
        /// The value as given.
        value: f64,
    },
    /// A line of a table that cannot be used.
    #[error("{place}, line {line}: {problem}")]
    Line {
        /// The file.
        place: String,
        /// The line in it, from 1.
        line: usize,
        /// Quantity, value and what is allowed.
        problem: String,
    },
    /// A table that cannot be used as a whole.
    #[error("{place}: {problem}")]
    Table {
        /// The file.
        place: String,
        /// Quantity, value and what is allowed.
        problem: String,
    },
    /// A light that the observer does not see, so that nothing is relative to it.
    #[error("illuminant has luminance {luminance}; allowed: above 0")]
    Dark {
        /// The integral of the light, weighted by the eye.
        luminance: f64,
    },
    /// A white too far from any white for a change of white to mean something.
    #[error("white XYZ is {white:?}; allowed: a light that all three cones see")]
    White {
        /// The white as given.
        white: [f64; 3],
    },
}
