//! Grain over the whole sphere: a spectrum drawn as a random field by spherical harmonics.

mod crop;
pub(crate) mod level;
pub(crate) mod normal;
pub mod photograph;
pub mod spectrum;
pub mod texture;
