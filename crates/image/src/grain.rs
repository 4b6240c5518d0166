//! Grain over the whole sphere: a spectrum drawn as a random field by spherical harmonics.

pub(crate) mod level;
pub(crate) mod normal;
pub mod spectrum;
pub mod texture;
