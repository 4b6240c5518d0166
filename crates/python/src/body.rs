//! The bindings of what gives a pearl its body colour.

use nacreous_colour::{SAMPLES, Spectrum, reflectance_from_rgb};
use nacreous_nacre::Pigment;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::{InputError, refused};

type Row<'py> = Bound<'py, PyArray1<f64>>;

/// The names of the pigments.
#[pyfunction]
pub fn pigments() -> Vec<&'static str> {
    Pigment::NAMES.to_vec()
}

/// Absorption [401] per mm of a pigment at strength 1.
#[pyfunction]
pub fn pigment_absorption<'py>(py: Python<'py>, name: &str) -> PyResult<Row<'py>> {
    let pigment = Pigment::named(name).ok_or_else(|| {
        let (name, allowed) =
            (name.chars().take(40).collect::<String>(), Pigment::NAMES.join(", "));
        InputError::new_err(format!("pigment is '{name}'; allowed: {allowed}"))
    })?;
    let absorption = Spectrum::from_fn(|nm| pigment.absorption_per_mm(nm));
    Ok(PyArray1::from_slice(py, absorption.values()))
}

/// Reflectance [401] of a layer with this absorption [401] on this background [401].
#[pyfunction]
pub fn kubelka_munk<'py>(
    py: Python<'py>,
    scattering_per_mm: f64,
    absorption_per_mm: PyReadonlyArray1<'py, f64>,
    thickness_mm: f64,
    background: PyReadonlyArray1<'py, f64>,
) -> PyResult<Row<'py>> {
    let absorption = Spectrum::from_values(absorption_per_mm.as_slice()?).map_err(refused)?;
    let background = Spectrum::from_values(background.as_slice()?).map_err(refused)?;
    let reflectance: [f64; SAMPLES] = std::array::from_fn(|i| {
        let (absorption, background) = (absorption.values()[i], background.values()[i]);
        nacreous_optics::kubelka_munk(scattering_per_mm, absorption, thickness_mm, background)
    });
    Ok(PyArray1::from_slice(py, &reflectance))
}

/// Smooth reflectance [401] of a linear sRGB colour within 0 to 1.
#[pyfunction]
pub fn smooth_reflectance(py: Python<'_>, rgb: [f64; 3]) -> Row<'_> {
    PyArray1::from_slice(py, reflectance_from_rgb(rgb).values())
}
