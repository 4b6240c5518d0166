//! The bindings of nacre.

use nacreous_nacre::{Index, LayerStack, MAX_LAYERS, Medium, NacreError};
use num_complex::Complex64;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::{InputError, refused};

/// Aragonite layers from the surface inward, each followed by a protein layer, then the substrate.
#[pyclass(frozen, name = "Stack", module = "nacreous._core")]
pub struct Stack(pub LayerStack);

/// A medium as `nacreous/medium/` hands it over.
#[derive(FromPyObject)]
pub enum MediumSpec<'py> {
    /// One that `media()` names.
    Name(String),
    /// n + ik.
    Constant(Complex64),
    /// Ordinary, extraordinary.
    Uniaxial(Complex64, Complex64),
    /// wavelength_nm, ordinary, extraordinary.
    Table(
        PyReadonlyArray1<'py, f64>,
        PyReadonlyArray1<'py, Complex64>,
        PyReadonlyArray1<'py, Complex64>,
    ),
}

impl MediumSpec<'_> {
    pub fn medium(&self, quantity: &str) -> PyResult<Medium> {
        let index = |n: &Complex64| Index::new(quantity, n.re, n.im).map_err(refused);
        match self {
            Self::Name(name) => Medium::named(name).ok_or_else(|| {
                let (name, names) = (name.chars().take(40).collect::<String>(), Medium::NAMES);
                let allowed = names.join(", ");
                InputError::new_err(format!("{quantity} is '{name}'; allowed: {allowed}"))
            }),
            Self::Constant(n) => Ok(index(n)?.into()),
            Self::Uniaxial(ordinary, extraordinary) => {
                Ok(Medium::uniaxial(index(ordinary)?, index(extraordinary)?))
            }
            Self::Table(wavelength_nm, ordinary, extraordinary) => {
                let wavelength_nm = wavelength_nm.as_array().to_vec();
                let ordinary = ordinary.as_array().to_vec();
                let extraordinary = extraordinary.as_array().to_vec();
                Medium::table(quantity, wavelength_nm, &ordinary, &extraordinary).map_err(refused)
            }
        }
    }
}

/// The names of the media that are known by name.
#[pyfunction]
pub fn media() -> Vec<&'static str> {
    Medium::NAMES.to_vec()
}

#[pymethods]
impl Stack {
    #[new]
    fn new(
        thickness_nm: PyReadonlyArray1<'_, f64>,
        protein_nm: f64,
        aragonite: MediumSpec<'_>,
        protein: MediumSpec<'_>,
        ambient: MediumSpec<'_>,
        substrate: MediumSpec<'_>,
    ) -> PyResult<Self> {
        // Before the copy, which for a billion layers takes 8 GB.
        let layers = thickness_nm.len()?;
        if layers > MAX_LAYERS {
            return Err(refused(NacreError::LayerCount(layers)));
        }
        LayerStack::new(
            thickness_nm.as_array().to_vec(),
            protein_nm,
            aragonite.medium("aragonite")?,
            protein.medium("protein")?,
            ambient.medium("ambient")?,
            substrate.medium("substrate")?,
        )
        .map(Self)
        .map_err(refused)
    }

    /// Thickness [layer] of the aragonite layers, surface first.
    fn thickness_nm<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.0.thickness_nm())
    }

    /// How many aragonite layers.
    fn __len__(&self) -> usize {
        self.0.thickness_nm().len()
    }

    /// Thickness of the whole nacre, protein included.
    fn total_um(&self) -> f64 {
        self.0.total_um()
    }

    /// (layers, mean_nm, spread_nm) of the aragonite layers that begin within depth_um.
    fn outer(&self, depth_um: f64) -> (usize, f64, f64) {
        let counted = self.0.outer(depth_um);
        (counted.layers, counted.mean_nm, counted.spread_nm)
    }
}
