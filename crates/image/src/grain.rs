//! Grain over the whole sphere: a spectrum drawn as a random field by spherical harmonics.

mod level;
pub mod spectrum;
pub mod texture;
