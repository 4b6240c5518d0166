//! Grain over the whole sphere: a spectrum drawn as a random field by spherical harmonics.

mod fourier;
pub mod harmonics;
mod legendre;
mod level;
pub mod spectrum;
pub mod texture;
