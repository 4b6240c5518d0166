//! Spherical harmonics: fields on the whole sphere as sums of waves.
//!
//! A real field of band limit L is
//! `f(theta, phi) = sum over l of [a_l0 P_l0 + 2 Re sum over m > 0 of a_lm P_lm exp(i m phi)]`
//! with orthonormal associated Legendre functions `P_lm(cos theta)`, the Condon-Shortley sign
//! included. Colatitude counts from +z, longitude from +x to +y.

mod analysis;
mod coefficients;
pub(crate) mod fourier;
mod knots;
mod legendre;
mod place;
pub(crate) mod second_order;
mod synthesis;

pub use analysis::{analyse, directions_of_grid, point};
pub use coefficients::{CHANNELS, Coefficients};
pub(crate) use knots::knots;
pub(crate) use place::{Place, angle, from_grid, to_grid};
pub use synthesis::synthesise;
