//! The picture of a pearl.

pub mod exr;
pub mod photograph;
pub mod png;
pub mod texture;
