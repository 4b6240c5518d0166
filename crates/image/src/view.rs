//! Lines of sight: directions, rays, and the camera that they leave from.

pub(crate) mod camera;
pub(crate) mod cone;
pub(crate) mod direction;
pub(crate) mod ray;
