/// A question that optics cannot answer: which quantity, its value, what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OpticsError {
    /// A medium has no index, or not one, where it was asked.
    #[error(transparent)]
    Medium(#[from] nacreous_nacre::NacreError),
    /// A quantity lies outside its range.
    #[error("{quantity} is {}; allowed: {allowed}", nacreous_nacre::said(*.value))]
    OutOfRange {
        /// The quantity, by its public name.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// No such polarisation.
    #[error("polarisation is '{0}'; allowed: s, p, unpolarised")]
    Polarisation(String),
    /// No such precision.
    #[error("precision is '{0}'; allowed: double, single")]
    Precision(String),
    /// Light of two speeds would run where the model knows one.
    #[error("the index of {medium} changes with direction; allowed: an isotropic medium")]
    Anisotropic {
        /// Which medium.
        medium: &'static str,
    },
    /// An ensemble of stacks that are not alike.
    #[error("the stacks of an ensemble differ in their media; allowed: the same media in all")]
    DifferentMedia,
    /// Columns were added to an ensemble of another table.
    #[error(
        "the table has {values} values, that of the columns before {before}; allowed: the same"
    )]
    DifferentTable {
        /// Angles times wavelengths now.
        values: usize,
        /// And before.
        before: usize,
    },
    /// The illuminant model was asked about absorbing media.
    #[error(
        "{medium} has k = {k}; allowed: 0, for the model of 1996 knows no absorption inside a layer \
         (its loss is diffuse_loss)"
    )]
    Absorbing {
        /// Which medium.
        medium: &'static str,
        /// Its extinction coefficient.
        k: f64,
    },
    /// The illuminant model was asked about a stack whose light cannot leave at every angle.
    #[error(
        "{medium} has n = {n}; allowed: at least the ambient's {ambient}, so that light seen from \
         outside exists inside at every angle"
    )]
    TotalReflection {
        /// Which medium.
        medium: &'static str,
        /// Its index.
        n: f64,
        /// The index outside.
        ambient: f64,
    },
}

/// The one check of a number at this door.
pub(crate) fn within(
    quantity: &'static str,
    value: f64,
    range: std::ops::RangeInclusive<f64>,
    allowed: &'static str,
) -> Result<f64, OpticsError> {
    if range.contains(&value) {
        Ok(value)
    } else {
        Err(OpticsError::OutOfRange { quantity, value, allowed })
    }
}
