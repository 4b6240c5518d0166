//! The door to the picture.

use glam::DVec3;
use nacreous_colour::{Gamut, Observer, RgbSpace, Spectrum};
use nacreous_image::{
    Ball, Bands, CHANNELS, Camera, Glow, Lamp, Light, MAX_SIZE_PX, PARTS, Palette, Parameters,
    Pearl, Progress, Source, Surroundings, eight_bit, spread_glare,
};
use nacreous_optics::OpticsError;
use numpy::{IntoPyArray, PyArray3, PyArrayMethods, PyReadonlyArray3};
use pyo3::{prelude::*, types::PyDict};
use rayon::prelude::*;

use crate::{
    InputError, refused,
    spec::{LampSpec, PlaceSpec, SceneSpec, TableSpec, WallsSpec, WindowSpec},
    subject::{Around, PearlGiven, Prepared, Subject},
    watched::{broken_off, watched},
};

/// Everything that a render needs, in the types of the rooms.
struct Job<'a> {
    subjects: Vec<Subject<'a>>,
    /// Which of them lies in each place.
    places: Vec<usize>,
    light: Light,
    palette: Palette,
    /// Power of each lamp, by band.
    lamp_bands: Vec<Bands>,
    surroundings: Surroundings,
    camera: Camera,
    size_px: usize,
    samples_side: usize,
}

impl Job<'_> {
    fn run(mut self, progress: &Progress) -> Result<Option<Vec<f32>>, OpticsError> {
        let mut films = Vec::new();
        for subject in &self.subjects {
            match subject.prepared(&self.light, progress)? {
                Some(found) => films.push(found),
                None => return Ok(None),
            }
        }
        let alone = self.places.len() == 1;
        let mut softly_lit = !(alone && self.surroundings.windows.is_empty());
        if softly_lit {
            self.surroundings.settle();
        }
        let Some(pearls) = self.pearls(&films, progress) else { return Ok(None) };
        // One bounce: what the pearls send out lights the table and is mirrored by their neighbours.
        softly_lit |= pearls.iter().any(Pearl::gives_light);
        let glow = |(ball, pearl): (usize, &Pearl<'_>)| {
            let gives = (pearl.gives_light() || !alone) && !progress.is_stopped();
            if gives { pearl.glow(&self.surroundings, ball) } else { Glow::BLACK }
        };
        let glows: Vec<Glow> = pearls.par_iter().enumerate().map(glow).collect();
        drop(pearls);
        for (ball, glow) in glows.into_iter().enumerate() {
            self.surroundings.set_glow(ball, glow);
        }
        if softly_lit {
            self.surroundings.settle();
        }
        let Some(pearls) = self.pearls(&films, progress) else { return Ok(None) };
        let around = &self.surroundings;
        let (size, side) = (self.size_px, self.samples_side);
        Ok(nacreous_image::render(&pearls, around, &self.camera, size, side, progress))
    }

    /// The pearls in their places, in the light that there is; `None` once `progress` says to stop, which for
    /// hundreds of pearls need not wait for all of them.
    fn pearls(&self, prepared: &[Prepared], progress: &Progress) -> Option<Vec<Pearl<'_>>> {
        let scene = Around {
            surroundings: &self.surroundings,
            palette: &self.palette,
            lamps: &self.lamp_bands,
            samples_side: self.samples_side,
        };
        let places = self.places.par_iter().enumerate();
        places
            .map(|(ball, &subject)| {
                let pearl = || self.subjects[subject].pearl(&prepared[subject], &scene, ball);
                (!progress.is_stopped()).then(pearl)
            })
            .collect()
    }
}

fn job<'a>(
    pearls: &'a [PearlGiven<'_>],
    scene: &SceneSpec<'_>,
    size_px: usize,
    samples_side: usize,
) -> PyResult<Job<'a>> {
    let subjects = pearls.iter().map(Subject::new).collect::<PyResult<Vec<_>>>()?;
    let places = scene.places.iter().map(|place| place.pearl).collect::<Vec<_>>();
    if places.iter().any(|&place| place >= subjects.len()) {
        return Err(InputError::new_err("a place has no pearl"));
    }
    let sources = scene.lamps.iter().map(LampSpec::source).collect::<PyResult<Vec<_>>>()?;
    let shining = scene.windows.iter().map(WindowSpec::source);
    let all = sources.iter().cloned().map(Ok).chain(shining).collect::<PyResult<Vec<_>>>()?;
    let white = scene.white.as_deref().map(Spectrum::from_values).transpose().map_err(refused)?;
    let observer: Observer = scene.observer.parse().map_err(refused)?;
    let sky = scene.sky.sky();
    let light = Light::new(&all, sky.mean_luminance(), white, observer).map_err(refused)?;
    let balls = balls(&subjects, scene);
    let reach = |ball: &Ball| ball.centre.length() + ball.radius_mm;
    let camera = scene.camera.camera().in_front_of(balls.iter().map(reach).fold(0.0, f64::max));
    let lamps = lamps(scene, &sources, &light, &subjects)?;
    let window =
        |spec: &WindowSpec| Ok(spec.window(light.brightness(&spec.pane()?).map_err(refused)?));
    let windows = scene.windows.iter().map(window).collect::<PyResult<Vec<_>>>()?;
    let walls = scene.walls.as_ref().map(WallsSpec::walls);
    let table = scene.table.as_ref().map(TableSpec::table);
    Ok(Job {
        palette: light.palette(),
        lamp_bands: lamp_bands(&light, &sources)?,
        surroundings: Surroundings::new(table, walls, sky, lamps, balls).with_windows(windows),
        subjects,
        places,
        light,
        camera,
        size_px,
        samples_side,
    })
}

/// The lamps, each with points enough for the pearl that mirrors it most sharply.
fn lamps(
    scene: &SceneSpec<'_>,
    sources: &[Source],
    light: &Light,
    subjects: &[Subject<'_>],
) -> PyResult<Vec<Lamp>> {
    let surfaces = subjects.iter().map(|subject| subject.microfacets);
    let sharpest = surfaces.min_by(|a, b| a.spread_rad().total_cmp(&b.spread_rad()));
    let lamp = |(spec, source): (&LampSpec, &Source)| {
        let brightness = light.brightness(source).map_err(refused)?;
        let lamp = Lamp::new(spec.place(), spec.angular_radius_rad, brightness);
        Ok(match sharpest {
            Some(microfacets) => lamp.resolved_for(&microfacets),
            None => lamp,
        })
    };
    scene.lamps.iter().zip(sources).map(lamp).collect()
}

fn lamp_bands(light: &Light, sources: &[Source]) -> PyResult<Vec<Bands>> {
    sources.iter().map(|source| light.bands(source).map_err(refused)).collect()
}

/// The pearls' shapes in their places.
fn balls(subjects: &[Subject<'_>], scene: &SceneSpec<'_>) -> Vec<Ball> {
    let ball = |place: &PlaceSpec| Ball {
        centre: DVec3::from(place.centre_mm),
        ..Ball::alone(0.5 * subjects[place.pearl].diameter_mm)
    };
    scene.places.iter().map(ball).collect()
}

/// Linear light [row, column, channel] in the parts that `parts()` names, times the exposure.
///
/// `pearls`, each different one once, and `scene` are as image.py makes them; the scene's places say
/// which pearl lies where. `report(rows_done)` is called now and then; what it raises, and Ctrl-C,
/// stops the render.
#[pyfunction]
pub fn render<'py>(
    py: Python<'py>,
    pearls: Vec<PearlGiven<'py>>,
    scene: &Bound<'py, PyDict>,
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
    let glare_px = scene.camera.glare_mm / scene.camera.field_mm * size_px as f64;
    let job = job(&pearls, &scene, size_px, samples_side)?;
    let progress = Progress::default();
    let look_up = || report.map_or(Ok(()), |say| say.call1((progress.rows_done(),)).map(drop));
    let work = || {
        let mut pixels = job.run(&progress);
        if let Ok(Some(pixels)) = &mut pixels {
            spread_glare(pixels, size_px, scene.camera.glare, glare_px);
        }
        pixels
    };
    let rendered = watched(py, look_up, || progress.stop(), work)?;
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
