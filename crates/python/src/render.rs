//! The binding of the render room: JSON in, a picture out.

use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use nacreous_colour::{Gamut, RgbSpace, Spectrum};
use nacreous_file::{
    exr::{Channels, Plane},
    png::PngPixels,
};
use nacreous_image::{
    CHANNELS, PARTS, Progress, develop, eight_bit, grain::spectrum::GrainSpectrum,
};
use nacreous_render::{Arrangement, Job, Needs, RenderError, Resources, light_of, spec::Recipe};
use numpy::{IntoPyArray, PyArray3, PyArrayMethods, PyReadonlyArray3};
use pyo3::prelude::*;

use crate::{
    InputError,
    file::{Text, save_exr, save_png},
    refused,
    texture::{GrainGiven, grain_of},
    threads::{detached, pool},
    watched::{broken_off, watched},
};

/// A rendered picture. NumPy is loaded with the first array that is asked for, and not before.
#[pyclass(frozen, module = "nacreous._core")]
pub struct Picture {
    pixels: Mutex<Pixels>,
    size_px: usize,
}

/// Linear light [row, column, channel]: ours, or an array's that Python looks at.
enum Pixels {
    Ours(Vec<f32>),
    Array(Py<PyArray3<f32>>),
}

/// Renders a recipe in JSON (`nacreous_render::spec::Recipe`).
///
/// `spectra`, `panoramas` and `grains` are the contents of the files that it names: by name, grains by the
/// pearl's number. `report(rows_done)` is called now and then; what it raises, and Ctrl-C, stops the render.
#[pyfunction]
pub fn render<'py>(
    py: Python<'py>,
    recipe: &str,
    spectra: Vec<(String, Vec<f64>)>,
    panoramas: Vec<(String, PyReadonlyArray3<'py, f32>)>,
    grains: Vec<(usize, GrainGiven<'py>)>,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Picture> {
    let recipe = Recipe::from_json(recipe).map_err(refused)?;
    let size_px = recipe.size;
    let mut job = Job::new(recipe, resources(spectra, panoramas, grains)?).map_err(refused)?;
    let progress = Progress::default();
    let look_up = || report.map_or(Ok(()), |say| say.call1((progress.rows_done(),)).map(drop));
    let work = || -> Result<Option<Vec<f32>>, RenderError> {
        Ok(job.view(&progress)?.and_then(|view| view.picture(&progress)))
    };
    let rendered = watched(py, look_up, || progress.stop(), work)?;
    let pixels = rendered.map_err(refused)?.ok_or_else(broken_off)?;
    Ok(Picture { pixels: Mutex::new(Pixels::Ours(pixels)), size_px })
}

/// Width of the view of a recipe in JSON.
#[pyfunction]
pub fn field_mm(recipe: &str) -> PyResult<f64> {
    let recipe = Recipe::from_json(recipe).map_err(refused)?;
    Ok(Arrangement::new(&recipe).map_err(refused)?.field_mm())
}

/// The files whose contents a recipe in JSON needs: (spectra, panoramas, numbers of the pearls with a
/// photograph).
#[pyfunction]
pub fn files_needed(recipe: &str) -> PyResult<(Vec<String>, Vec<String>, Vec<usize>)> {
    let needs = Needs::of(&Recipe::from_json(recipe).map_err(refused)?);
    let photographs = needs.photographs.into_keys().collect();
    Ok((Vec::from_iter(needs.spectra), Vec::from_iter(needs.panoramas), photographs))
}

fn resources(
    spectra: Vec<(String, Vec<f64>)>,
    panoramas: Vec<(String, PyReadonlyArray3<'_, f32>)>,
    grains: Vec<(usize, GrainGiven<'_>)>,
) -> PyResult<Resources> {
    let spectrum = |(name, values): (String, Vec<f64>)| {
        Ok((name, Spectrum::from_values(&values).map_err(refused)?))
    };
    let grain = |(pearl, given): (usize, GrainGiven<'_>)| -> PyResult<(usize, GrainSpectrum)> {
        Ok((pearl, grain_of(&given)?))
    };
    let mut resources = Resources {
        spectra: spectra.into_iter().map(spectrum).collect::<PyResult<_>>()?,
        grains: grains.into_iter().map(grain).collect::<PyResult<_>>()?,
        ..Resources::default()
    };
    for (name, picture) in panoramas {
        let picture = picture.as_array();
        let (height, width, _) = picture.dim();
        let rgb: Vec<f32> = picture.iter().copied().collect();
        resources.add_panorama(&name, (width, height), &rgb).map_err(refused)?;
    }
    Ok(resources)
}

#[pymethods]
impl Picture {
    /// Pixels a side.
    #[getter]
    fn size_px(&self) -> usize {
        self.size_px
    }

    /// Linear light [row, column, channel] in all parts: (array, (name, first channel, end) of each part).
    /// The first four parts add up to the picture.
    #[allow(clippy::type_complexity)]
    fn parts<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyArray3<f32>>, Vec<(&'static str, usize, usize)>)> {
        let mut pixels = self.pixels.lock().unwrap_or_else(PoisonError::into_inner);
        let array = match &mut *pixels {
            Pixels::Array(array) => array.bind(py).clone(),
            Pixels::Ours(ours) => {
                let shape = [self.size_px, self.size_px, CHANNELS];
                let array = std::mem::take(ours).into_pyarray(py).reshape(shape)?;
                *pixels = Pixels::Array(array.clone().unbind());
                array
            }
        };
        let named = PARTS.iter().map(|(name, part)| (*name, part.start, part.end)).collect();
        Ok((array, named))
    }

    /// Writes a PNG of `bits` a channel; returns the share of pixels out of the space's gamut.
    #[allow(clippy::too_many_arguments)]
    fn save_png(
        &self,
        py: Python<'_>,
        path: PathBuf,
        space: &str,
        gamut: &str,
        bits: u8,
        text: Text,
    ) -> PyResult<f64> {
        let rgb_space: RgbSpace = space.parse().map_err(refused)?;
        let gamut: Gamut = gamut.parse().map_err(refused)?;
        let size = u32::try_from(self.size_px).unwrap_or(u32::MAX);
        self.read(py, |pixels| {
            let developed = develop(&light_of(pixels), rgb_space, gamut);
            let eight = (bits == 8).then(|| eight_bit(&developed.codes));
            let codes = match &eight {
                Some(codes) => PngPixels::Eight(codes),
                None => PngPixels::Sixteen(&developed.codes),
            };
            save_png(&path, (size, size), codes, rgb_space, &text)?;
            Ok(developed.out_of_gamut)
        })
    }

    /// Writes an EXR of the picture and all its parts.
    fn save_exr(&self, py: Python<'_>, path: PathBuf, text: Text) -> PyResult<()> {
        self.read(py, |pixels| {
            let plane = |name: &str, samples: Vec<f32>| {
                let channels =
                    Channels::of_count(samples.len() / self.size_px.pow(2)).ok_or_else(|| {
                        InputError::new_err(format!("layer {name:?} has no channels"))
                    })?;
                Ok(Plane { name: name.to_owned(), channels, samples: samples.into() })
            };
            let parts = PARTS.iter().map(|(name, part)| {
                let channels = pixels.chunks_exact(CHANNELS).flat_map(|pixel| &pixel[part.clone()]);
                plane(name, channels.copied().collect())
            });
            let opaque = light_of(pixels).chunks_exact(3).flat_map(opaque).collect();
            let planes = [plane("", opaque)].into_iter().chain(parts);
            let planes: Vec<Plane<'_>> = planes.collect::<PyResult<_>>()?;
            save_exr(&path, (self.size_px, self.size_px), &planes, &text)
        })
    }
}

/// A pixel of a picture without holes.
fn opaque(light: &[f32]) -> [f32; 4] {
    [light[0], light[1], light[2], 1.0]
}

impl Picture {
    /// Lets `work` read the pixels, without Python where they are ours.
    fn read<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&[f32]) -> PyResult<T> + Send,
    ) -> PyResult<T> {
        let pixels = self.pixels.lock().unwrap_or_else(PoisonError::into_inner);
        match &*pixels {
            Pixels::Ours(ours) => detached(py, || work(ours)),
            Pixels::Array(array) => {
                let pixels = array.bind(py).readonly();
                let pixels = pixels.as_slice()?;
                pool().install(|| work(pixels))
            }
        }
    }
}
