//! stub
use pyo3::prelude::*;
/// stub
#[pyclass(frozen)]
pub struct Texture(pub nacreous_image::texture::Texture);
