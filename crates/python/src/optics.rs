//! The bindings of optics.

use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_nacre::{Index, LayerStack};
use nacreous_optics::{Ensemble, Fresnel, IlluminantModel, Polarisation, Resonance, TransferModel};
use num_complex::Complex64;
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray3,
};
use pyo3::prelude::*;

use crate::{
    InputError,
    nacre::Stack,
    refused,
    watched::{broken_off, watched},
};

type Amplitudes<'py> = Bound<'py, PyArray1<Complex64>>;
type Energies<'py> = Bound<'py, PyArray1<f64>>;

/// (r_s, r_p, t_s, t_p, R_s, R_p, T_s, T_p) for each angle of incidence.
#[pyfunction]
#[allow(clippy::type_complexity)]
pub fn fresnel<'py>(
    py: Python<'py>,
    n_i: Complex64,
    n_t: Complex64,
    angle_rad: PyReadonlyArray1<'_, f64>,
) -> PyResult<([Amplitudes<'py>; 4], [Energies<'py>; 4])> {
    let n_i = Index::new("n_i", n_i.re, n_i.im).map_err(refused)?;
    let n_t = Index::new("n_t", n_t.re, n_t.im).map_err(refused)?;
    let boundaries = angle_rad
        .as_array()
        .iter()
        .map(|&angle| nacreous_optics::fresnel(n_i, n_t, angle))
        .collect::<Result<Vec<Fresnel>, _>>()
        .map_err(refused)?;
    let amplitudes: [fn(&Fresnel) -> Complex64; 4] = [|f| f.r_s, |f| f.r_p, |f| f.t_s, |f| f.t_p];
    let energies: [fn(&Fresnel) -> f64; 4] = [|f| f.R_s, |f| f.R_p, |f| f.T_s, |f| f.T_p];
    Ok((
        amplitudes.map(|part| boundaries.iter().map(part).collect::<Vec<_>>().into_pyarray(py)),
        energies.map(|part| boundaries.iter().map(part).collect::<Vec<_>>().into_pyarray(py)),
    ))
}

/// Relative spectral intensity [angle, wavelength] of the model of 1996.
#[pyfunction]
pub fn illuminant<'py>(
    py: Python<'py>,
    stack: &Stack,
    angle_rad: PyReadonlyArray1<'_, f64>,
    wavelength_nm: PyReadonlyArray1<'_, f64>,
    coherence_nm: f64,
    threshold: f64,
    diffuse_loss: f64,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let model = IlluminantModel { coherence_nm, threshold, diffuse_loss };
    let [rows, columns] = shape(&angle_rad, &wavelength_nm)?;
    let (angle, wavelength) = (angle_rad.as_array().to_vec(), wavelength_nm.as_array().to_vec());
    let stop = AtomicBool::new(false);
    let work = || model.spectra_unless(&stack.0, &angle, &wavelength, &stop);
    let found = if IlluminantModel::is_brief(&stack.0, rows, columns) {
        py.detach(work)
    } else {
        watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), work)?
    };
    found.map_err(refused)?.ok_or_else(broken_off)?.into_pyarray(py).reshape([rows, columns])
}

/// R, T and A [angle, wavelength] of the whole stack, exact.
#[pyfunction]
pub fn energies<'py>(
    py: Python<'py>,
    stack: &Stack,
    angle_rad: PyReadonlyArray1<'_, f64>,
    wavelength_nm: PyReadonlyArray1<'_, f64>,
    polarisation: &str,
    precision: &str,
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let model = transfer_model(polarisation, precision)?;
    let [rows, columns] = shape(&angle_rad, &wavelength_nm)?;
    let (angle, wavelength) = (angle_rad.as_array().to_vec(), wavelength_nm.as_array().to_vec());
    let stop = AtomicBool::new(false);
    let work = || model.energies(&stack.0, &angle, &wavelength, &stop);
    let found = if TransferModel::is_brief(&stack.0, rows, columns) {
        py.detach(work)
    } else {
        watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), work)?
    };
    let energies = found.map_err(refused)?.ok_or_else(broken_off)?;
    energies.into_flat().into_pyarray(py).reshape([3, rows, columns])
}

/// An ensemble with more columns: means of R and T, and sums of squared differences from them,
/// [4, angle, wavelength] after `columns` of them.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn ensemble<'py>(
    py: Python<'py>,
    stacks: Vec<PyRef<'_, Stack>>,
    angle_rad: PyReadonlyArray1<'_, f64>,
    wavelength_nm: PyReadonlyArray1<'_, f64>,
    polarisation: &str,
    precision: &str,
    columns: usize,
    tables: PyReadonlyArray3<'_, f64>,
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let model = transfer_model(polarisation, precision)?;
    let [rows, wavelengths] = shape(&angle_rad, &wavelength_nm)?;
    let stacks: Vec<LayerStack> = stacks.iter().map(|stack| stack.0.clone()).collect();
    let (angle, wavelength) = (angle_rad.as_array().to_vec(), wavelength_nm.as_array().to_vec());
    let before = Ensemble::resumed(columns, tables.as_array().iter().copied().collect());
    let stop = AtomicBool::new(false);
    let work = || before.with(model, &stacks, &angle, &wavelength, &stop);
    let found = watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), work)?;
    let ensemble = found.map_err(refused)?.ok_or_else(broken_off)?;
    ensemble.into_flat().into_pyarray(py).reshape([4, rows, wavelengths])
}

/// (series, wavenumber, half width, height) of narrow lines between falling wavelengths; of each angle
/// series 2 i is s and 2 i + 1 is p.
#[pyfunction]
#[allow(clippy::type_complexity)]
pub fn resonances<'py>(
    py: Python<'py>,
    stack: &Stack,
    angle_rad: PyReadonlyArray1<'_, f64>,
    wavelength_nm: PyReadonlyArray1<'_, f64>,
    polarisation: &str,
) -> PyResult<(Bound<'py, PyArray1<u64>>, Energies<'py>, Energies<'py>, Energies<'py>)> {
    let polarisation: Polarisation = polarisation.parse().map_err(refused)?;
    let (angle, wavelength) = (angle_rad.as_array().to_vec(), wavelength_nm.as_array().to_vec());
    let stop = AtomicBool::new(false);
    let work = || nacreous_optics::resonances(&stack.0, polarisation, &angle, &wavelength, &stop);
    let found = watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), work)?;
    let lines = found.map_err(refused)?.ok_or_else(broken_off)?;
    let column = |of: fn(&Resonance) -> f64| -> Energies<'py> {
        lines.iter().map(of).collect::<Vec<_>>().into_pyarray(py)
    };
    let series: Vec<u64> = lines.iter().map(|line| line.series as u64).collect();
    let widths = column(|line| line.half_width);
    Ok((
        series.into_pyarray(py),
        column(|line| line.wavenumber),
        widths,
        column(|line| line.height),
    ))
}

fn transfer_model(polarisation: &str, precision: &str) -> PyResult<TransferModel> {
    Ok(TransferModel {
        polarisation: polarisation.parse().map_err(refused)?,
        precision: precision.parse().map_err(refused)?,
        ..TransferModel::default()
    })
}

/// Of a table that memory can hold: a GB, for more than there is would end the whole process.
fn shape(
    angle_rad: &PyReadonlyArray1<'_, f64>,
    wavelength_nm: &PyReadonlyArray1<'_, f64>,
) -> PyResult<[usize; 2]> {
    let (rows, columns) = (angle_rad.len()?, wavelength_nm.len()?);
    if rows.saturating_mul(columns) > MAX_VALUES {
        let message =
            format!("the table has {rows} x {columns} values; allowed: up to {MAX_VALUES}");
        return Err(InputError::new_err(message));
    }
    Ok([rows, columns])
}

const MAX_VALUES: usize = 1 << 27;
