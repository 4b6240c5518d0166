//! From choices to a scale: who was preferred to whom, and how far apart they must be.
//!
//! Two models: Thurstone's case V (probit) and Bradley and Terry's (logit), both with ties and an
//! effect of the side, fitted by maximum likelihood to counts. What is in: the likelihood, whether it
//! has a maximum, the maximum, information, scores by person, bootstraps. What is not: tables, units,
//! tests and intervals, which the Python room does.
//!
//! Same counts, same seed, same bytes, however many threads: no sum is shared, `libm` computes the
//! functions.

mod bootstrap;
mod cholesky;
mod conjugate;
mod counts;
mod dealing;
mod error;
mod existence;
mod information;
mod likelihood;
mod model;
mod newton;
mod normal;
mod outcome;
mod people;
mod recession;
mod spread;
mod terms;

pub use bootstrap::{Bootstrap, Resampled, Source};
pub use counts::Counts;
pub use dealing::{Dealing, Spread, Stratum};
pub use error::ScalingError;
pub use existence::{Existence, components, existence};
pub use information::{Kind, information};
pub use likelihood::log_likelihood;
pub use model::{Design, Link, Model};
pub use newton::{Fit, fit};
pub use normal::{cdf, log_cdf};
pub use outcome::Outcome;
pub use people::{Answers, Ledger, person_scores};
pub use terms::probabilities;
