//! Grain over the whole sphere: a spectrum drawn as a random field by spherical harmonics.

pub(crate) mod level;
pub(crate) mod normal;
mod crop;
pub mod photograph;
pub mod spectrum;
pub mod texture;
