//! The door to Python: converts types and errors, decides nothing.

use pyo3::prelude::*;

mod colour;
mod file;
mod image;
mod nacre;
mod optics;
mod texture;

pyo3::import_exception!(nacreous.problem, InputError);

/// What a room refuses, said to Python.
#[allow(clippy::needless_pass_by_value)] // the form that map_err wants
fn refused(error: impl std::fmt::Display) -> PyErr {
    InputError::new_err(error.to_string())
}

/// The compiled rooms of nacreous.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::file::{read_panorama, read_photograph, read_png_text, write_exr, write_png};
    #[pymodule_export]
    use super::image::{develop, parameters, parts, render};
    #[pymodule_export]
    use super::nacre::{Stack, grow};
    #[pymodule_export]
    use super::optics::{fresnel, illuminant};
}
