use crate::MAX_LAYERS;

/// A structure that cannot be: which quantity, its value, what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NacreError {
    /// A quantity lies outside its range.
    #[error("{quantity} is {}; allowed: {allowed}", said(*.value))]
    OutOfRange {
        /// The quantity, by its public name.
        quantity: String,
        /// What was given.
        value: f64,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// Too few or too many layers.
    #[error("the stack has {0} layers; allowed: 1 to {MAX_LAYERS}")]
    LayerCount(usize),
    /// The noise could make a layer vanish.
    #[error(
        "thickness_noise_nm is {noise_nm}; allowed: less than the thinnest layer of the season, \
         {thinnest_nm} nm"
    )]
    NoiseTooLarge {
        /// Half width of the uniform noise.
        noise_nm: f64,
        /// The smaller of the winter's and the summer's thickness.
        thinnest_nm: f64,
    },
    /// A table of indices whose columns do not fit together.
    #[error(
        "{quantity} has {indices} indices for {wavelengths} wavelengths; allowed: as many, at least 1"
    )]
    TableShape {
        /// Which medium.
        quantity: String,
        /// How many wavelengths were given.
        wavelengths: usize,
        /// How many indices.
        indices: usize,
    },
    /// A table of indices whose wavelengths do not rise.
    #[error(
        "{quantity}: wavelength_nm has {} after {}; allowed: rising values",
        said_nm(*.nm), said_nm(*.last_nm)
    )]
    TableOrder {
        /// Which medium.
        quantity: String,
        /// A wavelength.
        last_nm: f64,
        /// The one that follows it in the table.
        nm: f64,
    },
    /// A medium was asked about a wavelength at which nothing is known of it.
    #[error(
        "wavelength_nm is {}; allowed with this {quantity}: {} to {} nm",
        said_nm(*.wavelength_nm), said_nm(*.first_nm), said_nm(*.last_nm)
    )]
    NotMeasured {
        /// Which medium.
        quantity: String,
        /// What was asked.
        wavelength_nm: f64,
        /// Shortest known wavelength.
        first_nm: f64,
        /// Longest known wavelength.
        last_nm: f64,
    },
    /// A model that needs one index was given a medium with many.
    #[error(
        "the index of {quantity} changes with {fault}; allowed in this model: one constant index"
    )]
    NotConstant {
        /// Which medium.
        quantity: &'static str,
        /// With what its index changes.
        fault: &'static str,
    },
}

/// A number as messages give it: very large and very small ones by their power of ten.
///
/// ```
/// use nacreous_nacre::said;
/// assert_eq!([said(-2.0), said(0.25), said(1e-320)], ["-2", "0.25", "1e-320"]);
/// ```
#[must_use]
pub fn said(value: f64) -> String {
    let plain = value == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// A wavelength as messages give it: to the millionth of a nm, for a table in um may have any digits behind.
pub(crate) fn said_nm(nm: f64) -> String {
    ((nm * 1e6).round() / 1e6).to_string()
}

/// The one check of a number from outside: inside `range`, or an error that says what is `allowed`.
pub(crate) fn within(
    quantity: &str,
    value: f64,
    range: std::ops::RangeInclusive<f64>,
    allowed: &'static str,
) -> Result<f64, NacreError> {
    if range.contains(&value) {
        Ok(value)
    } else {
        Err(NacreError::OutOfRange { quantity: quantity.to_owned(), value, allowed })
    }
}
