//! The picture of a pearl.

pub mod exr;
pub mod panorama;
pub mod photograph;
pub mod picture_file;
pub mod png;
pub mod profile;
pub mod texture;
