//! Pearls as look.py hands them over, into the rooms' types.

use nacreous_colour::SAMPLES;
use nacreous_image::{
    Bands, Body, Film, Grain, IlluminantPearl, Irradiance, Light, Microfacets, Model, Palette,
    Pearl, Progress, Rgb, Rings, Surface, Surroundings, TorranceSparrow, Transport, grain,
};
use nacreous_nacre::LayerStack;
use nacreous_optics::{IlluminantModel, OpticsError};
use pyo3::prelude::*;

use crate::{InputError, nacre::Stack, refused, texture::Texture};

/// A pearl's look and its grain.
pub type PearlGiven<'py> = (PearlSpec<'py>, Option<PyRef<'py, Texture>>);

/// How the pearl looks: numbers as in a pearl file, knobs resolved; one of the two models.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PearlSpec<'py> {
    diameter_mm: f64,
    facet_spread_rad: f64,
    hue_weight: f64,
    chroma_weight: f64,
    value_weight: f64,
    illuminant: Option<IlluminantSpec<'py>>,
    transport: Option<TransportSpec<'py>>,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct IlluminantSpec<'py> {
    stack: PyRef<'py, Stack>,
    body_colour: Rgb,
    coherence_nm: f64,
    threshold: f64,
    diffuse_loss: f64,
    mixing: f64,
    layer_reflectance: f64,
    mirror_weight: f64,
    falloff_mm: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct TransportSpec<'py> {
    facets: String,
    columns: Vec<PyRef<'py, Stack>>,
    /// By wavelength.
    body_reflectance: Vec<f64>,
    spread: f64,
}

/// A pearl before its light is known.
pub struct Subject<'a> {
    pub diameter_mm: f64,
    pub microfacets: Microfacets,
    model: Known,
    texture: Option<&'a grain::texture::Texture>,
    grain: Grain,
}

enum Known {
    Illuminant { model: IlluminantModel, stack: LayerStack, look: Look },
    Transport { columns: Vec<LayerStack>, body: Body },
}

/// What the model of 1996 asks of a pearl beside its layers.
#[derive(Clone, Copy)]
struct Look {
    facets: TorranceSparrow,
    mixing: f64,
    body_colour: Rgb,
    mirror_weight: f64,
    falloff_mm: f64,
}

/// A pearl's optics, the same in all its places.
pub enum Prepared {
    Illuminant(Rings),
    Transport(Box<Surface>),
}

/// What is around a pearl.
pub struct Around<'a> {
    pub surroundings: &'a Surroundings,
    pub palette: &'a Palette,
    pub lamps: &'a [Bands],
    pub samples_side: usize,
}

impl<'a> Subject<'a> {
    pub fn new((spec, texture): &'a PearlGiven<'_>) -> PyResult<Self> {
        let spread_rad = spec.facet_spread_rad;
        let (model, microfacets) = match (&spec.illuminant, &spec.transport) {
            (Some(illuminant), _) => {
                let known = illuminant.known(spread_rad)?;
                (known, Microfacets::grooves(spread_rad))
            }
            (None, Some(transport)) => (transport.known()?, transport.microfacets(spread_rad)),
            (None, None) => return Err(InputError::new_err("a pearl has no model")),
        };
        Ok(Self {
            diameter_mm: spec.diameter_mm,
            microfacets,
            model,
            texture: texture.as_ref().map(|texture| &texture.0),
            grain: Grain {
                hue_rad: spec.hue_weight,
                chroma: spec.chroma_weight,
                value: spec.value_weight,
            },
        })
    }

    /// The pearl's optics; `None` once `progress` says to stop.
    pub fn prepared(
        &self,
        light: &Light,
        progress: &Progress,
    ) -> Result<Option<Prepared>, OpticsError> {
        Ok(match &self.model {
            Known::Illuminant { model, stack, .. } => {
                Rings::new(stack, model, light, progress)?.map(Prepared::Illuminant)
            }
            Known::Transport { columns, .. } => Film::new(columns, progress.stop_flag())?
                .map(|film| Prepared::Transport(Box::new(Surface::new(film, self.microfacets)))),
        })
    }

    /// The pearl as it lies as the ball of number `ball`.
    pub fn pearl(&self, prepared: &Prepared, around: &Around<'_>, ball: usize) -> Pearl<'a> {
        let model = match (&self.model, prepared) {
            (Known::Illuminant { look, .. }, Prepared::Illuminant(rings)) => {
                Model::Illuminant(Box::new(IlluminantPearl {
                    rings: rings.clone(),
                    mixing: look.mixing,
                    body_colour: look.body_colour,
                    irradiance: Irradiance::new(around.surroundings, ball),
                    facets: look.facets,
                    mirror_weight: look.mirror_weight,
                    falloff_mm: look.falloff_mm,
                }))
            }
            (Known::Transport { body, .. }, Prepared::Transport(surface)) => {
                Model::Transport(Box::new(around.transport(surface, body, ball)))
            }
            _ => unreachable!("a pearl is prepared by its own model"),
        };
        Pearl { model, texture: self.texture, grain: self.grain }
    }
}

impl Around<'_> {
    fn transport(&self, surface: &Surface, body: &Body, ball: usize) -> Transport {
        let surface = surface.clone();
        Transport::new(
            surface,
            body,
            self.palette,
            self.surroundings,
            ball,
            self.lamps,
            self.samples_side,
        )
    }
}

impl IlluminantSpec<'_> {
    fn known(&self, spread_rad: f64) -> PyResult<Known> {
        let stack = &self.stack.0;
        let index = stack.aragonite().index("aragonite").map_err(refused)?.n();
        Ok(Known::Illuminant {
            model: IlluminantModel {
                coherence_nm: self.coherence_nm,
                threshold: self.threshold,
                diffuse_loss: self.diffuse_loss,
            },
            stack: stack.clone(),
            look: Look {
                facets: TorranceSparrow::new(spread_rad, index, self.layer_reflectance),
                mixing: self.mixing,
                body_colour: self.body_colour,
                mirror_weight: self.mirror_weight,
                falloff_mm: self.falloff_mm,
            },
        })
    }
}

impl TransportSpec<'_> {
    fn known(&self) -> PyResult<Known> {
        let spectrum: &[f64; SAMPLES] = self.body_reflectance[..].try_into().map_err(|_| {
            let found = self.body_reflectance.len();
            InputError::new_err(format!("body_reflectance has {found} values; allowed: {SAMPLES}"))
        })?;
        Ok(Known::Transport {
            columns: self.columns.iter().map(|column| column.0.clone()).collect(),
            body: Body::new(spectrum, self.spread),
        })
    }

    fn microfacets(&self, spread: f64) -> Microfacets {
        match self.facets.as_str() {
            "ggx" => Microfacets::ggx(spread),
            _ => Microfacets::grooves(spread),
        }
    }
}
