//! The door to the picture.

use nacreous_colour::{Gamut, Observer, RgbSpace, Spectrum};
use nacreous_image::{
    CHANNELS, Camera, Facets, Grain, Irradiance, Lamp, Light, MAX_SIZE_PX, PARTS, Parameters,
    Pearl, Progress, Rings, Source, Sphere, Surroundings, eight_bit,
};
use nacreous_optics::IlluminantModel;
use numpy::{IntoPyArray, PyArray3, PyArrayMethods, PyReadonlyArray3};
use pyo3::{prelude::*, types::PyDict};

use crate::{
    InputError,
    nacre::Stack,
    refused,
    spec::{LampSpec, PearlSpec, SceneSpec, TableSpec, WallsSpec},
    texture::Texture,
    watched::{broken_off, watched},
};

/// Everything that a render needs, in the types of the rooms.
struct Job<'a> {
    model: IlluminantModel,
    stack: nacreous_nacre::LayerStack,
    light: Light,
    surroundings: Surroundings,
    camera: Camera,
    facets: Facets,
    look: PearlSpec,
    texture: Option<&'a nacreous_image::grain::texture::Texture>,
    size_px: usize,
    samples_side: usize,
}

impl Job<'_> {
    fn run(self, progress: &Progress) -> Result<Option<Vec<f32>>, nacreous_optics::OpticsError> {
        let look = &self.look;
        let Some(rings) = Rings::new(&self.stack, &self.model, &self.light, progress)? else {
            return Ok(None);
        };
        let pearl = Pearl {
            rings,
            mixing: look.mixing,
            body_colour: look.body_colour,
            irradiance: Irradiance::new(&self.surroundings),
            facets: self.facets,
            mirror_weight: look.mirror_weight,
            falloff_mm: look.falloff_mm,
            texture: self.texture,
            grain: Grain {
                hue_rad: look.hue_weight,
                chroma: look.chroma_weight,
                value: look.value_weight,
            },
        };
        let (size, side) = (self.size_px, self.samples_side);
        Ok(nacreous_image::render(&pearl, &self.surroundings, &self.camera, size, side, progress))
    }
}

fn job<'a>(
    look: PearlSpec,
    scene: &SceneSpec<'_>,
    stack: &Stack,
    texture: Option<&'a Texture>,
    size_px: usize,
    samples_side: usize,
) -> PyResult<Job<'a>> {
    let sources = scene.lamps.iter().map(LampSpec::source).collect::<PyResult<Vec<_>>>()?;
    let white = scene.white.as_deref().map(Spectrum::from_values).transpose().map_err(refused)?;
    let observer: Observer = scene.observer.parse().map_err(refused)?;
    let sky = scene.sky.sky();
    let light = Light::new(&sources, sky.mean_luminance(), white, observer).map_err(refused)?;
    let index = stack.0.aragonite().index("aragonite").map_err(refused)?.n();
    let facets = Facets::new(look.facet_spread_rad, index, look.layer_reflectance);
    let lamp = |(spec, source): (&LampSpec, &Source)| {
        let brightness = light.brightness(source).map_err(refused)?;
        let lamp = Lamp::new(spec.place(), spec.angular_radius_rad, brightness);
        Ok(lamp.resolved_for(&facets))
    };
    let lamps = scene.lamps.iter().zip(&sources).map(lamp).collect::<PyResult<Vec<_>>>()?;
    let walls = scene.walls.as_ref().map(WallsSpec::walls);
    let ball = Sphere { radius_mm: 0.5 * look.diameter_mm };
    let table = scene.table.as_ref().map(TableSpec::table);
    Ok(Job {
        model: IlluminantModel {
            coherence_nm: look.coherence_nm,
            threshold: look.threshold,
            diffuse_loss: look.diffuse_loss,
        },
        stack: stack.0.clone(),
        light,
        surroundings: Surroundings::new(table, walls, sky, lamps, ball),
        camera: scene.camera.camera(),
        facets,
        look,
        texture: texture.map(|texture| &texture.0),
        size_px,
        samples_side,
    })
}

/// Linear light [row, column, channel] in the parts that `parts()` names, times the exposure.
///
/// `pearl` and `scene` are mappings as image.py makes them. `report(rows_done)` is called now and then;
/// what it raises, and Ctrl-C, stops the render.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn render<'py>(
    py: Python<'py>,
    pearl: &Bound<'py, PyDict>,
    scene: &Bound<'py, PyDict>,
    stack: &Stack,
    texture: Option<&Texture>,
    size_px: usize,
    samples_side: usize,
    report: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArray3<f32>>> {
    if !(1..=MAX_SIZE_PX).contains(&size_px) {
        let message = format!("size is {size_px}; allowed: 1 to {MAX_SIZE_PX} pixels");
        return Err(InputError::new_err(message));
    }
    if !(1..=MAX_SAMPLES_SIDE).contains(&samples_side) {
        let message = format!("samples_side is {samples_side}; allowed: 1 to {MAX_SAMPLES_SIDE}");
        return Err(InputError::new_err(message));
    }
    let scene: SceneSpec<'py> = scene.extract()?;
    let exposure = scene.camera.exposure as f32;
    let job = job(pearl.extract()?, &scene, stack, texture, size_px, samples_side)?;
    let progress = Progress::default();
    let look_up = || report.map_or(Ok(()), |say| say.call1((progress.rows_done(),)).map(drop));
    let rendered = watched(py, look_up, || progress.stop(), || job.run(&progress))?;
    let mut pixels = rendered.map_err(refused)?.ok_or_else(broken_off)?;
    scale_light(&mut pixels, exposure);
    pixels.into_pyarray(py).reshape([size_px, size_px, CHANNELS])
}

/// 32 x 32 samples a pixel.
const MAX_SAMPLES_SIDE: usize = 32;

/// Light is multiplied by the exposure; texture and coverage are no light.
fn scale_light(pixels: &mut [f32], exposure: f32) {
    for pixel in pixels.chunks_exact_mut(CHANNELS) {
        for channel in &mut pixel[..PARTS[3].1.end] {
            *channel *= exposure;
        }
    }
}

/// (name, first channel, end) of each part of a rendered pixel; the first four add up to the picture.
#[pyfunction]
pub fn parts() -> Vec<(&'static str, usize, usize)> {
    PARTS.iter().map(|(name, channels)| (*name, channels.start, channels.end)).collect()
}

/// The physical parameters behind the three knobs.
#[pyfunction]
pub fn parameters(
    py: Python<'_>,
    depth: f64,
    shininess: f64,
    grain: f64,
) -> PyResult<Bound<'_, PyDict>> {
    let p = Parameters::new(depth, shininess, grain);
    let named = PyDict::new(py);
    named.set_item("diffuse_loss", p.diffuse_loss)?;
    named.set_item("mixing", p.mixing)?;
    named.set_item("outer_um", p.outer_um)?;
    named.set_item("spread", p.spread)?;
    named.set_item("facet_spread_rad", p.facet_spread_rad)?;
    named.set_item("mirror_weight", p.mirror_weight)?;
    named.set_item("hue_weight", p.hue_weight)?;
    named.set_item("chroma_weight", p.chroma_weight)?;
    named.set_item("value_weight", p.value_weight)?;
    Ok(named)
}

/// (codes [row, column, rgb] as uint8 or uint16, share of pixels out of gamut) of linear light.
#[pyfunction]
pub fn develop<'py>(
    py: Python<'py>,
    linear: PyReadonlyArray3<'py, f32>,
    space: &str,
    gamut: &str,
    bits: u8,
) -> PyResult<(Bound<'py, PyAny>, f64)> {
    let shape = linear.as_array().dim();
    if shape.2 != 3 {
        return Err(InputError::new_err(format!("linear has {} channels; allowed: 3", shape.2)));
    }
    let light = linear.as_array().iter().copied().collect::<Vec<_>>();
    if light.iter().any(|channel| !channel.is_finite()) {
        return Err(InputError::new_err("linear has a value that is not finite"));
    }
    let space: RgbSpace = space.parse().map_err(refused)?;
    let gamut: Gamut = gamut.parse().map_err(refused)?;
    let developed = py.detach(|| nacreous_image::develop(&light, space, gamut));
    let shape = [shape.0, shape.1, 3];
    let codes = match bits {
        8 => eight_bit(&developed.codes).into_pyarray(py).reshape(shape)?.into_any(),
        16 => developed.codes.into_pyarray(py).reshape(shape)?.into_any(),
        _ => return Err(InputError::new_err(format!("bits is {bits}; allowed: 8, 16"))),
    };
    Ok((codes, developed.out_of_gamut))
}
