//! The picture of a pearl.

pub mod exr;
mod fourier;
pub mod grain;
pub mod harmonics;
mod legendre;
mod level;
pub mod photograph;
pub mod png;
pub mod texture;
