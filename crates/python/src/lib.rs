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
    use super::texture::{Texture, procedural_grain, synthesise_harmonics, synthesise_texture};
}
