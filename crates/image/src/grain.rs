//! Grain: measured on a photograph as a spectrum, and drawn over the whole sphere as a random field by spherical
//! harmonics.

mod crop;
pub(crate) mod level;
mod measuring;
pub(crate) mod normal;
mod patch;
pub mod photograph;
pub mod spectrum;
pub mod texture;
mod transform;
mod waves;
