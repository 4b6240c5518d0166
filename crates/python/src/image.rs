//! The door to the picture.

use std::{sync::Arc, time::Duration};

use glam::DVec3;
use nacreous_colour::{Gamut, Observer, RgbSpace, Spectrum};
use nacreous_image::{
    CHANNELS, Camera, Dome, Facets, Grain, Irradiance, Lamp, Light, MAX_SIZE_PX, PARTS, Parameters,
    Pearl, Place, Progress, Projection, Rgb, Rings, Sky, Source, Sphere, Surroundings, Table,
    Walls, eight_bit,
};
use nacreous_optics::IlluminantModel;
use numpy::{IntoPyArray, PyArray3, PyArrayMethods, PyReadonlyArray3};
use pyo3::{exceptions::PyRuntimeError, prelude::*, types::PyDict};

use crate::{InputError, nacre::Stack, refused, texture::Texture};

/// How the pearl looks: numbers as in a pearl file, knobs resolved.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct PearlSpec {
    diameter_mm: f64,
    body_colour: Rgb,
    coherence_nm: f64,
    threshold: f64,
    diffuse_loss: f64,
    mixing: f64,
    facet_spread_rad: f64,
    layer_reflectance: f64,
    mirror_weight: f64,
    falloff_mm: f64,
    hue_weight: f64,
    chroma_weight: f64,
    value_weight: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct CameraSpec {
    /// None for parallel lines of sight.
    distance_mm: Option<f64>,
    elevation_rad: f64,
    azimuth_rad: f64,
    field_mm: f64,
    exposure: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct LampSpec {
    /// Unit vector towards the lamp, or None where it has a position.
    direction: Option<[f64; 3]>,
    position_mm: [f64; 3],
    angular_radius_rad: f64,
    spectrum: Vec<f64>,
    intensity: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct TableSpec {
    kind: String,
    colour: Rgb,
    second_colour: Rgb,
    check_mm: f64,
    weave_mm: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct WallsSpec {
    half_width_mm: f64,
    height_mm: f64,
    colour: Rgb,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct SkySpec<'py> {
    horizon: Rgb,
    zenith: Rgb,
    /// None where the sky is a gradient.
    panorama: Option<PyReadonlyArray3<'py, f32>>,
    rotation_rad: f64,
    intensity: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct SceneSpec<'py> {
    observer: String,
    /// What shall look white; None for the lamps' own mixture.
    white: Option<Vec<f64>>,
    camera: CameraSpec,
    lamps: Vec<LampSpec>,
    table: Option<TableSpec>,
    walls: Option<WallsSpec>,
    sky: SkySpec<'py>,
}

impl CameraSpec {
    fn camera(&self) -> Camera {
        let projection = match self.distance_mm {
            Some(distance_mm) => Projection::Perspective { distance_mm },
            None => Projection::Orthographic,
        };
        Camera::new(projection, self.elevation_rad, self.azimuth_rad, self.field_mm)
    }
}

impl LampSpec {
    fn source(&self) -> PyResult<Source> {
        let spectrum = Spectrum::from_values(&self.spectrum).map_err(refused)?;
        Ok(Source { spectrum, intensity: self.intensity })
    }

    fn place(&self) -> Place {
        match self.direction {
            Some(direction) => Place::Direction(DVec3::from(direction)),
            None => Place::Position(DVec3::from(self.position_mm)),
        }
    }
}

impl TableSpec {
    fn table(&self) -> Table {
        let (colour, second_colour) = (self.colour, self.second_colour);
        match self.kind.as_str() {
            "checker" => Table::Checker { colour, second_colour, check_mm: self.check_mm },
            "cloth" => Table::Cloth { colour, weave_mm: self.weave_mm },
            _ => Table::Plain(colour),
        }
    }
}

impl SkySpec<'_> {
    fn sky(&self) -> Sky {
        let scaled = |colour: Rgb| colour.map(|channel| channel * self.intensity);
        match &self.panorama {
            None => Sky::Gradient { horizon: scaled(self.horizon), zenith: scaled(self.zenith) },
            Some(picture) => {
                let picture = picture.as_array();
                let (height, width, _) = picture.dim();
                let pixels = picture.rows().into_iter().map(|p| [p[0], p[1], p[2]]).collect();
                Sky::Panorama {
                    picture: Arc::new(Dome::new(width, height, pixels)),
                    rotation_rad: self.rotation_rad,
                    intensity: self.intensity,
                }
            }
        }
    }
}

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
        let pearl = Pearl {
            rings: Rings::new(&self.stack, &self.model, &self.light)?,
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
    let index = stack.0.aragonite().n();
    let facets = Facets::new(look.facet_spread_rad, index, look.layer_reflectance);
    let lamp = |(spec, source): (&LampSpec, &Source)| {
        let brightness = light.brightness(source).map_err(refused)?;
        let lamp = Lamp::new(spec.place(), spec.angular_radius_rad, brightness);
        Ok(lamp.resolved_for(&facets))
    };
    let lamps = scene.lamps.iter().zip(&sources).map(lamp).collect::<PyResult<Vec<_>>>()?;
    let walls = scene.walls.as_ref().map(|walls| Walls {
        half_width_mm: walls.half_width_mm,
        height_mm: walls.height_mm,
        colour: walls.colour,
    });
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

/// How often a waiting Python looks for the end, for Ctrl-C, and reports progress.
const LOOK_UP: Duration = Duration::from_millis(5);

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
    let mut pixels = watched(py, report, |progress| job.run(progress))?;
    scale_light(&mut pixels, exposure);
    pixels.into_pyarray(py).reshape([size_px, size_px, CHANNELS])
}

/// 32 x 32 samples a pixel.
const MAX_SAMPLES_SIDE: usize = 32;

/// Runs `work` on another thread while this one lets Python live.
fn watched<'py>(
    py: Python<'py>,
    report: Option<&Bound<'py, PyAny>>,
    work: impl FnOnce(&Progress) -> Result<Option<Vec<f32>>, nacreous_optics::OpticsError> + Send,
) -> PyResult<Vec<f32>> {
    let progress = Progress::default();
    std::thread::scope(|scope| {
        let worker = scope.spawn(|| work(&progress));
        while !worker.is_finished() {
            py.detach(|| std::thread::sleep(LOOK_UP));
            let reported =
                report.map_or(Ok(()), |report| report.call1((progress.rows_done(),)).map(drop));
            if let Err(error) = py.check_signals().and(reported) {
                progress.stop();
                return Err(error);
            }
        }
        let broken = "the render ended without a picture; please report this";
        let result = worker.join().map_err(|_| PyRuntimeError::new_err(broken))?;
        result.map_err(refused)?.ok_or_else(|| PyRuntimeError::new_err(broken))
    })
}

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
