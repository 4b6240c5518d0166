//! Picture files: PNG and OpenEXR out, photographs and panoramas in.

pub mod exr;
pub mod panorama;
pub mod photograph;
pub mod picture;
pub mod png;
pub mod profile;
