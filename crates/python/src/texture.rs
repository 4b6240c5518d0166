//! The binding of grain spectra and textures.

use std::sync::Arc;

use glam::DVec3;
use nacreous_image::grain::{
    self,
    photograph::{Measuring, Photograph, Samples, analysed, measured},
    spectrum::GrainSpectrum,
};
use nacreous_image::harmonics::{Coefficients, synthesise};
use nacreous_render::{
    GrainKey,
    spec::{from_json, pearl::PearlSpec},
};
use num_complex::Complex64;
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArray3, PyArray4, PyArrayMethods, PyReadonlyArray1,
    PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::{InputError, refused, threads::detached};

type Spectrum<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>);
/// Spectrum, texture images and corners.
type Analysed<'py> = (Spectrum<'py>, Bound<'py, PyArray4<f64>>, Vec<(usize, usize)>);

/// The stand-in spectrum: frequencies [k] per mm, density [channel, k], correlation [channel, channel].
#[pyfunction]
pub fn procedural_grain(py: Python<'_>) -> PyResult<Spectrum<'_>> {
    given(py, &GrainSpectrum::procedural())
}

/// A seamless texture over a sphere, ready for the renderer.
#[pyclass(frozen, module = "nacreous._core")]
pub struct Texture(Arc<grain::texture::Texture>);

#[pymethods]
impl Texture {
    /// The highest degree of its spherical harmonics.
    #[getter]
    fn band_limit(&self) -> usize {
        self.0.band_limit()
    }

    /// Variance of hue, value, chroma that the spectrum has and the texture has not.
    #[getter]
    fn lost_variance(&self) -> [f64; 3] {
        self.0.lost_variance()
    }

    /// Values [n, channel] towards directions [n, xyz], for samples `footprint_rad` apart.
    fn at<'py>(
        &self,
        py: Python<'py>,
        directions: PyReadonlyArray2<'_, f64>,
        footprint_rad: f64,
    ) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let directions = directions.as_array();
        if directions.ncols() != 3 {
            let columns = directions.ncols();
            let message = format!("texture: directions have {columns} numbers; allowed: 3");
            return Err(InputError::new_err(message));
        }
        if !(footprint_rad >= 0.0 && footprint_rad.is_finite()) {
            let message = format!("texture: footprint_rad is {footprint_rad}; allowed: 0 and more");
            return Err(InputError::new_err(message));
        }
        let mut values = Vec::with_capacity(3 * directions.nrows());
        for (index, row) in directions.rows().into_iter().enumerate() {
            let direction = DVec3::new(row[0], row[1], row[2]);
            let Some(direction) = direction.try_normalize() else {
                let message = format!(
                    "texture: directions[{index}] is {direction}; allowed: finite and not zero"
                );
                return Err(InputError::new_err(message));
            };
            values.extend(self.0.at(direction, footprint_rad));
        }
        values.into_pyarray(py).reshape([directions.nrows(), 3])
    }

    /// The finest grid [row, column, channel], from pole to pole and once round.
    fn grid<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        let values: Vec<f32> = self.0.texels().flatten().collect();
        values.into_pyarray(py).reshape([self.0.rows(), 2 * self.0.rows(), 3])
    }
}

/// A grain spectrum: frequencies [k] per mm, density [channel, k], correlation [channel, channel].
pub type GrainGiven<'py> =
    (PyReadonlyArray1<'py, f64>, PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, f64>);

/// The spectrum in the room's type.
pub fn grain_of((cycles_per_mm, density, correlation): &GrainGiven<'_>) -> PyResult<GrainSpectrum> {
    let (density, correlation) = (density.as_array(), correlation.as_array());
    let shapes = (density.nrows(), correlation.dim());
    if shapes != (3, (3, 3)) {
        let message = format!(
            "grain spectrum: density has {} rows and correlation {:?} numbers; allowed: 3 and (3, 3)",
            shapes.0, shapes.1
        );
        return Err(InputError::new_err(message));
    }
    GrainSpectrum::new(
        cycles_per_mm.as_array().to_vec(),
        [0, 1, 2].map(|channel| density.row(channel).to_vec()),
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| correlation[[i, j]])),
    )
    .map_err(refused)
}

fn given<'py>(py: Python<'py>, spectrum: &GrainSpectrum) -> PyResult<Spectrum<'py>> {
    let cycles_per_mm = spectrum.cycles_per_mm().to_vec();
    let count = cycles_per_mm.len();
    let density = spectrum.density().concat().into_pyarray(py).reshape([3, count])?;
    let correlation = spectrum.correlation().concat().into_pyarray(py).reshape([3, 3])?;
    Ok((cycles_per_mm.into_pyarray(py), density, correlation))
}

/// The part of a spectrum between two frequencies.
#[pyfunction]
pub fn limited_grain<'py>(
    py: Python<'py>,
    grain: GrainGiven<'_>,
    low_per_mm: f64,
    high_per_mm: f64,
) -> PyResult<Spectrum<'py>> {
    given(py, &grain_of(&grain)?.limited(low_per_mm, high_per_mm).map_err(refused)?)
}

/// Linear light [row, column, rgb] of a file, or of what was worked out.
#[derive(FromPyObject)]
pub enum Light<'py> {
    /// Of a file.
    Single(PyReadonlyArray3<'py, f32>),
    /// Worked out.
    Double(PyReadonlyArray3<'py, f64>),
}

impl Light<'_> {
    /// The photograph in the room's type; rows lie one after the other, or `InputError`.
    fn photograph(&self) -> PyResult<Photograph<'_>> {
        let (shape, rgb) = match self {
            Self::Single(light) => (light.shape(), light.as_slice().map(Samples::Single)),
            Self::Double(light) => (light.shape(), light.as_slice().map(Samples::Double)),
        };
        Ok(Photograph { width: shape[1], height: shape[0], rgb: rgb.map_err(refused)? })
    }
}

/// Side of a patch, mm per pixel, and the band's limits per mm.
type How = (usize, Option<f64>, Option<f64>, Option<f64>);

fn measuring((side_px, mm_per_pixel, low_per_mm, high_per_mm): How) -> Measuring {
    Measuring { side_px, mm_per_pixel, low_per_mm, high_per_mm }
}

/// The grain on a photograph, in patches of the pearl that is found there.
#[pyfunction]
pub fn measured_grain<'py>(py: Python<'py>, light: Light<'_>, how: How) -> PyResult<Spectrum<'py>> {
    let (photograph, how) = (light.photograph()?, measuring(how));
    given(py, &detached(py, || measured(&photograph, &how)).map_err(refused)?)
}

/// The same with the texture images [patch, row, column, channel] and each patch's first (row, column), which may be
/// given.
#[pyfunction]
pub fn analysed_grain<'py>(
    py: Python<'py>,
    light: Light<'_>,
    how: How,
    corners: Option<Vec<(i64, i64)>>,
) -> PyResult<Analysed<'py>> {
    let (photograph, how) = (light.photograph()?, measuring(how));
    let found =
        detached(py, || analysed(&photograph, &how, corners.as_deref())).map_err(refused)?;
    let shape = [found.corners.len(), how.side_px, how.side_px, 3];
    let textures = found.textures.into_pyarray(py).reshape(shape)?;
    Ok((given(py, &found.spectrum)?, textures, found.corners))
}

/// Draws a texture of a spectrum.
#[pyfunction]
pub fn synthesise_texture(
    py: Python<'_>,
    grain: GrainGiven<'_>,
    radius_mm: f64,
    seed: u64,
    footprint_rad: f64,
) -> PyResult<Texture> {
    let spectrum = grain_of(&grain)?;
    let drawn = || grain::texture::Texture::synthesise(&spectrum, radius_mm, seed, footprint_rad);
    detached(py, drawn).map(|texture| Texture(Arc::new(texture))).map_err(refused)
}

/// The texture of a pearl in JSON, with the spectrum of its photograph where it has one.
#[pyfunction]
pub fn texture_of(
    py: Python<'_>,
    pearl: &str,
    measured: Option<GrainGiven<'_>>,
    footprint_rad: f64,
) -> PyResult<Texture> {
    let pearl: PearlSpec = from_json(pearl).map_err(refused)?;
    let measured = measured.as_ref().map(grain_of).transpose()?;
    let pixel_mm = footprint_rad * 0.5 * pearl.common().diameter_mm;
    let key = GrainKey::new(&pearl, measured.as_ref(), pixel_mm).map_err(refused)?;
    detached(py, || key.texture()).map(|texture| Texture(Arc::new(texture))).map_err(refused)
}

/// Fields [row, column, channel] of coefficients [channel, l, m], on twice as many columns as rows.
#[pyfunction]
pub fn synthesise_harmonics<'py>(
    py: Python<'py>,
    coefficients: PyReadonlyArray3<'_, Complex64>,
    rows: usize,
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let given = coefficients.as_array();
    let (channels, degrees, orders) = given.dim();
    let smooth = rows.is_power_of_two() || (rows.is_multiple_of(3) && (rows / 3).is_power_of_two());
    if channels != 3 || degrees != orders || !(1..=513).contains(&degrees) {
        let message = format!(
            "harmonics: coefficients have shape {:?}; allowed: (3, l, l) with l from 1 to 513",
            given.dim()
        );
        return Err(InputError::new_err(message));
    }
    if !(smooth && rows.is_multiple_of(2) && rows >= degrees && rows <= 2048) {
        let message = format!(
            "harmonics: rows is {rows}; allowed: 1 or 3 times a power of two, even, {degrees} to 2048"
        );
        return Err(InputError::new_err(message));
    }
    if !given.iter().all(|value| value.is_finite()) {
        return Err(InputError::new_err("harmonics: a coefficient is not finite"));
    }
    let mut ours = Coefficients::zero(degrees - 1);
    for ((channel, l, m), value) in given.indexed_iter().filter(|((_, l, m), _)| m <= l) {
        ours.at_mut(l, m)[channel] = [value.re, value.im];
    }
    let mut grid = vec![[0.0; 3]; 2 * rows * rows];
    detached(py, || synthesise(&ours, degrees - 1, (rows, 2 * rows), |texel| texel, &mut grid));
    grid.into_flattened().into_pyarray(py).reshape([rows, 2 * rows, 3])
}
