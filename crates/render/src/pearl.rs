//! A pearl's numbers: keys left open resolved by the knobs, layers grown, the film cut into columns, the
//! body and the grain worked out.

pub mod body;
pub mod calendar;
pub(crate) mod coat;
pub mod columns;
pub mod grain;
pub mod knobs;
pub mod nacre;
pub(crate) mod shape;
pub mod spectra;
