//! The light of a scene: what counts for its white, its lamps, its windows and its sky.

use glam::DVec3;
use nacreous_colour::{ColourError, Illuminant, Observer, Spectrum};
use nacreous_image::{
    Bands, Lamp, Light, Microfacets, Palette, Place, Sky, Source, Window, direction,
};

use crate::{
    RenderError, Resources,
    arrangement::Arrangement,
    frame::Frame,
    spec::{
        lights::{LampSpec, WindowSpec},
        scene::{ObserverSpec, SceneSpec, SkyKind, SkySpec},
    },
};

/// What the light of a scene is made from.
#[derive(Debug, Clone, PartialEq)]
pub struct LightsKey {
    observer: ObserverSpec,
    white: String,
    lamps: Vec<LampSpec>,
    windows: Vec<WindowSpec>,
    frames: Vec<Frame>,
    sky: SkySpec,
}

impl LightsKey {
    /// Of a scene.
    pub(crate) fn new(scene: &SceneSpec, arrangement: &Arrangement) -> Self {
        Self {
            observer: scene.observer,
            white: scene.camera.white.clone(),
            lamps: scene.lamps.clone(),
            windows: scene.windows.clone(),
            frames: arrangement.frames().to_vec(),
            sky: scene.sky.clone(),
        }
    }
}

/// The light of a scene, before it falls on anything.
#[derive(Debug, Clone)]
pub struct Lights {
    /// Its colours as the camera sees them.
    pub light: Light,
    /// How RGB becomes light in bands and back.
    pub palette: Palette,
    /// The lamps that are on, each a point so far.
    pub lamps: Vec<Lamp>,
    /// Power of each lamp, by band.
    pub lamp_bands: Vec<Bands>,
    /// The windows that are lit.
    pub windows: Vec<Window>,
    /// What lies beyond.
    pub sky: Sky,
}

impl Lights {
    /// Of a scene. A lamp or window that is switched off has no say in what looks white either.
    ///
    /// # Errors
    /// [`RenderError`] for a light that is none, or whose file was not handed over.
    pub fn new(
        scene: &SceneSpec,
        arrangement: &Arrangement,
        resources: &Resources,
    ) -> Result<Self, RenderError> {
        let source = |key: String, name: &str, intensity| {
            let spectrum = resources.light(name)?;
            observer(scene).weights(&spectrum).map_err(|_| {
                let fault = format!("{key} is {name}, which has luminance 0; allowed: above 0");
                RenderError::scene(&scene.name, fault)
            })?;
            Ok::<_, RenderError>(Source { spectrum, intensity })
        };
        let lit: Vec<(usize, (&WindowSpec, &Frame))> = scene
            .windows
            .iter()
            .zip(arrangement.frames())
            .enumerate()
            .filter(|(_, (window, _))| is_lit(window))
            .collect();
        let lamps_on = || scene.lamps.iter().enumerate().filter(|(_, lamp)| is_on(lamp));
        let lamp_sources = lamps_on()
            .map(|(i, lamp)| source(format!("lamps.{i}.spectrum"), &lamp.spectrum, lamp.intensity))
            .collect::<Result<Vec<_>, _>>()?;
        let panes = lit
            .iter()
            .map(|(i, (pane, _))| {
                source(format!("windows.{i}.spectrum"), &pane.spectrum, pane.luminance)
            })
            .collect::<Result<Vec<_>, _>>()?;
        let shining = lit.iter().zip(&panes).map(|((_, (_, frame)), pane)| as_lamp(frame, pane));
        // A window that faces away lights no pearl, and has no say in what looks white.
        let shining = shining.filter(|source| source.intensity > 0.0);
        let all: Vec<Source> = lamp_sources.iter().cloned().chain(shining).collect();
        let sky = sky(&scene.sky, resources)?;
        let light = Light::new(&all, sky.mean_luminance(), white(scene)?, observer(scene))
            .map_err(|error| no_white(scene, error))?;
        let lamps = lamps_on()
            .zip(&lamp_sources)
            .map(|((_, lamp), source)| Ok(round(lamp, light.brightness(source)?)))
            .collect::<Result<_, RenderError>>()?;
        let windows = lit
            .iter()
            .zip(&panes)
            .map(|((_, (_, frame)), pane)| Ok(window(frame, light.brightness(pane)?)))
            .collect::<Result<_, RenderError>>()?;
        let lamp_bands =
            lamp_sources.iter().map(|source| light.bands(source)).collect::<Result<_, _>>()?;
        Ok(Self { palette: light.palette(), light, lamps, lamp_bands, windows, sky })
    }

    /// The lamps, each with points enough for the pearl that mirrors it most sharply.
    pub fn lamps_for(&self, facets: impl Iterator<Item = Microfacets>) -> Vec<Lamp> {
        let sharpest = facets.min_by(|a, b| a.spread_rad().total_cmp(&b.spread_rad()));
        let resolved = |lamp: &Lamp| match &sharpest {
            Some(facets) => lamp.clone().resolved_for(&(*facets).into()),
            None => lamp.clone(),
        };
        self.lamps.iter().map(resolved).collect()
    }
}

/// Whether a lamp gives any light.
pub(crate) fn is_on(lamp: &LampSpec) -> bool {
    lamp.intensity > 0.0
}

/// Whether a window gives any light.
pub(crate) fn is_lit(window: &WindowSpec) -> bool {
    window.luminance > 0.0
}

/// What is wrong with the white, by the key that sets it.
fn no_white(scene: &SceneSpec, error: ColourError) -> RenderError {
    let ColourError::White { white: xyz } = error else { return error.into() };
    let xyz = xyz.map(|part| format!("{part:.3}")).join(", ");
    let given = format!("camera.white is {:?}, a light of XYZ {xyz}", scene.camera.white);
    let fault = format!("{given}; allowed: one that all three cones see, such as \"D65\"");
    RenderError::scene(&scene.name, fault)
}

/// A window as a lamp, by its light on a surface in the middle of the scene that faces it; what its own
/// intensity is, is its radiance.
fn as_lamp(frame: &Frame, pane: &Source) -> Source {
    let factor = window(frame, [1.0; 3]).facing_factor(DVec3::ZERO);
    Source { spectrum: pane.spectrum.clone(), intensity: pane.intensity * factor }
}

fn window(frame: &Frame, radiance: [f64; 3]) -> Window {
    Window::new(frame.centre_mm, frame.right_mm, frame.up_mm, radiance)
}

fn round(lamp: &LampSpec, brightness: [f64; 3]) -> Lamp {
    let place = match lamp.position_mm {
        Some(position_mm) => Place::Position(position_mm.into()),
        None => Place::Direction(direction(
            lamp.azimuth_deg.unwrap_or(0.0).to_radians(),
            lamp.elevation_deg.unwrap_or(0.0).to_radians(),
        )),
    };
    Lamp::new(place, lamp.angular_radius_deg.to_radians(), brightness)
}

/// What shall look white; `None` for the lamps' own mixture.
fn white(scene: &SceneSpec) -> Result<Option<Spectrum>, RenderError> {
    match scene.camera.white.as_str() {
        "auto" => Ok(None),
        name => Ok(Some(name.parse::<Illuminant>()?.spectrum())),
    }
}

fn observer(scene: &SceneSpec) -> Observer {
    match scene.observer {
        ObserverSpec::Cie1931 => Observer::Cie1931,
        ObserverSpec::Cie1964 => Observer::Cie1964,
    }
}

fn sky(spec: &SkySpec, resources: &Resources) -> Result<Sky, RenderError> {
    let scaled = |colour: [f64; 3]| colour.map(|channel| channel * spec.intensity);
    let horizon = scaled(spec.horizon.0);
    Ok(match spec.kind {
        SkyKind::Constant => Sky::Gradient { horizon, zenith: horizon },
        SkyKind::Gradient => Sky::Gradient { horizon, zenith: scaled(spec.zenith.0) },
        SkyKind::Panorama => {
            let path = spec.path.clone().unwrap_or_default();
            let picture = resources.panoramas.get(&path).cloned();
            Sky::Panorama {
                picture: picture.ok_or(RenderError::Missing(path))?,
                rotation_rad: spec.rotation_deg.to_radians(),
                intensity: spec.intensity,
            }
        }
    })
}
