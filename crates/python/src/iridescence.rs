//! The bindings of colours by angle.

use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_colour::{Observer, Spectrum};
use nacreous_image::{ByAngle, Weights, interference_colours};
use nacreous_optics::{IlluminantModel, Polarisation};
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::{
    nacre::Stack,
    refused,
    watched::{broken_off, watched},
};

type Colours<'py> = Bound<'py, PyArray2<f64>>;

/// XYZ [cosine, 3] that a stack reflects and lets through, cosines evenly from 0 to 1.
#[pyfunction]
pub fn iridescence<'py>(
    py: Python<'py>,
    stack: &Stack,
    illuminant: PyReadonlyArray1<'_, f64>,
    observer: &str,
    polarisation: &str,
) -> PyResult<(Colours<'py>, Colours<'py>)> {
    let weights = weights(&illuminant, observer)?;
    let polarisation: Polarisation = polarisation.parse().map_err(refused)?;
    let stop = AtomicBool::new(false);
    let work = || nacreous_image::Iridescence::new(&stack.0, polarisation, &weights, &stop);
    let found = watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), work)?;
    let colours = found.map_err(refused)?.ok_or_else(broken_off)?;
    Ok((table(py, &colours.reflected)?, table(py, &colours.transmitted)?))
}

/// XYZ [cosine, 3] of the model of 1996, the brightest with Y = 1, cosines evenly from 0 to 1.
#[pyfunction]
pub fn interference_iridescence<'py>(
    py: Python<'py>,
    stack: &Stack,
    illuminant: PyReadonlyArray1<'_, f64>,
    observer: &str,
    coherence_nm: f64,
    threshold: f64,
    diffuse_loss: f64,
) -> PyResult<Colours<'py>> {
    let weights = weights(&illuminant, observer)?;
    let model = IlluminantModel { coherence_nm, threshold, diffuse_loss };
    let stop = AtomicBool::new(false);
    let work = || interference_colours(&stack.0, &model, &weights, &stop);
    let found = watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), work)?;
    table(py, &found.map_err(refused)?.ok_or_else(broken_off)?)
}

fn weights(illuminant: &PyReadonlyArray1<'_, f64>, observer: &str) -> PyResult<Weights> {
    let light = Spectrum::from_values(&illuminant.as_array().to_vec()).map_err(refused)?;
    let observer: Observer = observer.parse().map_err(refused)?;
    observer.weights(&light).map_err(refused)
}

fn table<'py>(py: Python<'py>, colours: &ByAngle) -> PyResult<Colours<'py>> {
    let nodes = colours.nodes();
    nodes.as_flattened().to_vec().into_pyarray(py).reshape([nodes.len(), 3])
}
