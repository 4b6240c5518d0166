/// Counts from which no scale can be made, or a search that did not end well.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ScalingError {
    /// Tables of different lengths.
    #[error("{table} has {found} rows; allowed: {expected}")]
    Length {
        /// Which table.
        table: &'static str,
        /// How many rows it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// A stimulus, a row or a person that is not there.
    #[error("{table} names {found}; allowed: 0 to {most}")]
    Index {
        /// In which table.
        table: &'static str,
        /// What it says.
        found: usize,
        /// The last one there is.
        most: i64,
    },
    /// A count that cannot be.
    #[error("a count is {0}; allowed: 0 or more, and finite")]
    Count(f64),
    /// A number that cannot be.
    #[error("{quantity} is {value}; allowed: {allowed}")]
    OutOfRange {
        /// The quantity, by its public name.
        quantity: &'static str,
        /// What was given.
        value: f64,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// The likelihood has no single highest point.
    #[error("the likelihood has no maximum: {0}")]
    NoMaximum(&'static str),
    /// No such model.
    #[error("model is '{0}'; allowed: probit, logit")]
    Link(String),
    /// Newton's steps did not end.
    #[error("the scale did not converge in {0} steps; allowed: counts less extreme, or a prior")]
    NotConverged(usize),
    /// Somebody asked to stop.
    #[error("the computation was stopped")]
    Stopped,
}
