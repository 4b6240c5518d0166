//! The bindings of films: any layers in any order.

use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_optics::{Amplitudes, Film as Layers, OpticsError, Plate};
use num_complex::Complex64;
use numpy::{IntoPyArray, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::{
    InputError,
    nacre::MediumSpec,
    refused,
    watched::{broken_off, watched},
};

type Table<'py> = Bound<'py, PyArray3<f64>>;

/// Layers of any media between an ambient and a substrate, surface first.
#[pyclass(frozen, name = "Film", module = "nacreous._core")]
pub struct Film(Layers);

#[pymethods]
impl Film {
    /// media: with their names, ambient first, substrate last. medium: the place of each layer's.
    #[new]
    fn new(
        media: Vec<(String, MediumSpec<'_>)>,
        medium: Vec<usize>,
        thickness_nm: Vec<f64>,
    ) -> PyResult<Self> {
        if media.len() < 2 || medium.iter().any(|&place| place >= media.len()) {
            return Err(InputError::new_err("a layer's medium is not among the media"));
        }
        let media = media.iter().map(|(name, spec)| spec.medium(name)).collect::<PyResult<_>>()?;
        let layers = medium.into_iter().zip(thickness_nm).collect();
        Layers::new(media, layers).map(Self).map_err(refused)
    }

    /// (r_s, r_p, t_s, t_p) and (R_s, R_p, T_s, T_p), each [4, angle, wavelength].
    fn amplitudes<'py>(
        &self,
        py: Python<'py>,
        angle_rad: PyReadonlyArray1<'_, f64>,
        wavelength_nm: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<(Bound<'py, PyArray3<Complex64>>, Table<'py>)> {
        let light = Light::of(&angle_rad, &wavelength_nm, 1)?;
        let found = Light::found(py, |stop| self.0.amplitudes(&light.angle, &light.nm, stop))?;
        let complex = |of: fn(&Amplitudes) -> Complex64| {
            [0, 1].map(|plane| found.iter().map(move |point| of(&point[plane])))
        };
        let amplitudes = [complex(|a| a.r), complex(|a| a.t)].into_iter().flatten().flatten();
        let real = |of: fn(&Amplitudes) -> f64| {
            [0, 1].map(|plane| found.iter().map(move |point| of(&point[plane])))
        };
        let energies = [real(|a| a.R), real(|a| a.T)].into_iter().flatten().flatten();
        let shape = [4, light.angle.len(), light.nm.len()];
        Ok((
            amplitudes.collect::<Vec<_>>().into_pyarray(py).reshape(shape)?,
            energies.collect::<Vec<_>>().into_pyarray(py).reshape(shape)?,
        ))
    }

    /// (R_s, R_p, T_s, T_p) [4, angle, wavelength] on a plate in place of the substrate.
    fn on_plate<'py>(
        &self,
        py: Python<'py>,
        thickness_nm: f64,
        behind: MediumSpec<'_>,
        angle_rad: PyReadonlyArray1<'_, f64>,
        wavelength_nm: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<Table<'py>> {
        let plate = Plate { thickness_nm, behind: behind.medium("behind")? };
        let light = Light::of(&angle_rad, &wavelength_nm, 1)?;
        let found =
            Light::found(py, |stop| self.0.on_plate(&plate, &light.angle, &light.nm, stop))?;
        let shares = [(0, 0), (1, 0), (0, 1), (1, 1)];
        let shares = shares
            .into_iter()
            .flat_map(|(plane, which)| found.iter().map(move |point| point[plane][which]));
        let shape = [4, light.angle.len(), light.nm.len()];
        shares.collect::<Vec<f64>>().into_pyarray(py).reshape(shape)
    }

    /// |E|^2 and absorption per nm [angle, wavelength, depth], absorption [angle, wavelength, layer].
    #[allow(clippy::type_complexity)]
    fn depth<'py>(
        &self,
        py: Python<'py>,
        polarisation: &str,
        depth_nm: PyReadonlyArray1<'_, f64>,
        angle_rad: PyReadonlyArray1<'_, f64>,
        wavelength_nm: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<(Table<'py>, Table<'py>, Table<'py>)> {
        let polarisation = polarisation.parse().map_err(refused)?;
        let depth = depth_nm.as_array().to_vec();
        let light = Light::of(&angle_rad, &wavelength_nm, depth.len().max(1))?;
        let found = Light::found(py, |stop| {
            self.0.depth(polarisation, &depth, &light.angle, &light.nm, stop)
        })?;
        let (angles, wavelengths) = (light.angle.len(), light.nm.len());
        let intensity: Vec<f64> = found.iter().flat_map(|at| at.intensity.clone()).collect();
        let per_nm: Vec<f64> = found.iter().flat_map(|at| at.absorbed_per_nm.clone()).collect();
        let absorbed: Vec<f64> = found.iter().flat_map(|at| at.absorbed.clone()).collect();
        let layers = absorbed.len() / (angles * wavelengths).max(1);
        Ok((
            intensity.into_pyarray(py).reshape([angles, wavelengths, depth.len()])?,
            per_nm.into_pyarray(py).reshape([angles, wavelengths, depth.len()])?,
            absorbed.into_pyarray(py).reshape([angles, wavelengths, layers])?,
        ))
    }
}

/// The light a film is asked about.
struct Light {
    angle: Vec<f64>,
    nm: Vec<f64>,
}

impl Light {
    fn of(
        angle_rad: &PyReadonlyArray1<'_, f64>,
        wavelength_nm: &PyReadonlyArray1<'_, f64>,
        each: usize,
    ) -> PyResult<Self> {
        let (angle, nm) = (angle_rad.as_array().to_vec(), wavelength_nm.as_array().to_vec());
        if angle.len().saturating_mul(nm.len()).saturating_mul(each) > MAX_VALUES {
            let message = format!(
                "the table has {} x {} values; allowed: up to {MAX_VALUES}",
                angle.len(),
                nm.len().saturating_mul(each)
            );
            return Err(InputError::new_err(message));
        }
        Ok(Self { angle, nm })
    }

    fn found<T: Send>(
        py: Python<'_>,
        work: impl Fn(&AtomicBool) -> Result<Option<T>, OpticsError> + Send + Sync,
    ) -> PyResult<T> {
        let stop = AtomicBool::new(false);
        let found = watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), || work(&stop))?;
        found.map_err(refused)?.ok_or_else(broken_off)
    }
}

/// Points hold more than a share each; a GB in all.
const MAX_VALUES: usize = 1 << 23;
