//! The door to Python: converts types and errors, decides nothing.

use pyo3::prelude::*;

mod colour;
mod file;
mod image;
mod nacre;
mod optics;
mod texture;

pyo3::import_exception!(nacreous.problem, InputError);

/// The compiled rooms of nacreous.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::file::{read_panorama, read_photograph, read_png_text, write_exr, write_png};
}
