//! A pearl: its layers, its body, its surface and its grain, in one of two models of light.

use serde::Deserialize;

use super::{Colour, nacre::NacreSpec};
use crate::pearl::shape::is_round;

/// A pearl in one of the two models.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(tag = "model", rename_all = "lowercase")]
pub enum PearlSpec {
    /// Light through the film, into the pearl and out again.
    Transport(Box<TransportSpec>),
    /// The paper's model of 1996.
    Illuminant(Box<IlluminantSpec>),
}

/// A pearl of the transport model.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TransportSpec {
    /// What the pearl is called.
    pub name: String,
    /// Diameter of the whole pearl.
    pub diameter_mm: f64,
    /// Knob: strength of the interference colour.
    pub depth: f64,
    /// Knob: sharpness of what the surface mirrors.
    pub shininess: f64,
    /// Knob: strength of the surface texture.
    pub grain: f64,
    /// The layers.
    pub nacre: NacreSpec,
    /// The outer layers, which interfere.
    pub film: FilmSpec,
    /// The scattering nacre and the nucleus.
    pub body: BodySpec,
    /// The way of the light inside.
    pub inside: InsideSpec,
    /// The mirroring surface.
    pub surface: TransportSurfaceSpec,
    /// The grain of the surface.
    pub texture: TextureSpec,
    /// What differs from place to place.
    pub coat: CoatSpec,
    /// Pits, bumps and the like.
    pub blemishes: BlemishesSpec,
    /// What shape it has.
    pub shape: ShapeSpec,
    /// How the pearl is turned.
    pub pose: PoseSpec,
}

/// A pearl of the illuminant model.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct IlluminantSpec {
    /// What the pearl is called.
    pub name: String,
    /// Diameter of the whole pearl.
    pub diameter_mm: f64,
    /// The colour of the diffuse component.
    pub body_colour: Colour,
    /// Knob: strength of the interference colour.
    pub depth: f64,
    /// Knob: brightness and sharpness of what the surface mirrors.
    pub shininess: f64,
    /// Knob: strength of the surface texture.
    pub grain: f64,
    /// The layers.
    pub nacre: NacreSpec,
    /// The sum of the interfering light.
    pub interference: InterferenceSpec,
    /// The mirroring surface.
    pub surface: IlluminantSurfaceSpec,
    /// The grain of the surface.
    pub texture: TextureSpec,
}

/// The film: many columns of tablets.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FilmSpec {
    /// Depth of the outer nacre whose layers interfere; from the knob depth where left out.
    pub outer_um: Option<f64>,
    /// Columns whose reflectances are averaged.
    pub columns: usize,
    /// Spread of each layer's thickness from column to column, on top of growth.
    pub column_spread_nm: Option<f64>,
}

/// Pigmented nacre over a nucleus.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodySpec {
    /// The pigment by its name.
    pub pigment: String,
    /// Factor on its absorption.
    pub pigment_strength: f64,
    /// Thickness of the whole nacre; that of the layers where left out.
    pub nacre_mm: Option<f64>,
    /// Kubelka and Munk's scattering coefficient S.
    pub scattering_per_mm: f64,
    /// Reflectance of the nucleus, as a colour under D65.
    pub nucleus: Colour,
    /// How much darker the dark bands of the nucleus are than the light ones.
    pub nucleus_bands: f64,
    /// From one dark band to the next.
    pub nucleus_band_mm: f64,
}

/// How far light travels below the film.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InsideSpec {
    /// t of exp(-l (l + 1) t); from the knob depth where left out.
    pub spread: Option<f64>,
}

/// How the interfering light is added up (paper, section 3.2.4).
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InterferenceSpec {
    /// Optical path difference up to which waves interfere.
    pub coherence_nm: f64,
    /// Share of the light at which the sum over start layers ends.
    pub threshold: f64,
    /// D of equation (4); from the knob depth where left out.
    pub diffuse_loss: Option<f64>,
    /// Share of interference beside the body; from the knob depth where left out.
    pub mixing: Option<f64>,
}

/// The surface of the transport model.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TransportSurfaceSpec {
    /// Spread of the facets' slopes; from the knob shininess where left out.
    pub facet_spread_rad: Option<f64>,
    /// How the facets lean.
    pub facets: FacetsSpec,
    /// Spread of the tablets' lean against the surface.
    pub waviness_rad: f64,
}

/// How microscopic facets lean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FacetsSpec {
    /// Bell-shaped, with grooves (Torrance and Sparrow 1967).
    TorranceSparrow,
    /// With long tails (Walter and others 2007).
    Ggx,
}

/// The surface of the illuminant model (paper, section 4.2).
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct IlluminantSurfaceSpec {
    /// Spread of the facets' slopes; from the knob shininess where left out.
    pub facet_spread_rad: Option<f64>,
    /// Share of the mirrored surroundings that stays clear; from the knob shininess where left out.
    pub mirror_weight: Option<f64>,
    /// Share of the light that the layers mirror beside the surface.
    pub layer_reflectance: f64,
    /// Distance over which a mirrored thing fades.
    pub falloff_mm: f64,
}

/// The source of a grain that was measured on no photograph.
pub const PROCEDURAL: &str = "procedural";

/// The grain of the surface (paper, section 4.3).
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TextureSpec {
    /// [`PROCEDURAL`], or the path of a photograph.
    pub source: String,
    /// Size of the photograph's pixels on the pearl.
    pub mm_per_pixel: Option<f64>,
    /// Side of the patches whose spectrum was taken.
    pub side_px: usize,
    /// Lower limit of the band-pass filter.
    pub low_per_mm: Option<f64>,
    /// Upper limit of the band-pass filter.
    pub high_per_mm: Option<f64>,
    /// Seed of the random phases; the growth's where left out.
    pub seed: Option<u64>,
    /// Weight on hue; from the knob grain where left out.
    pub hue_weight: Option<f64>,
    /// Weight on chroma; from the knob grain where left out.
    pub chroma_weight: Option<f64>,
    /// Weight on the brightness of what is mirrored; from the knob grain where left out.
    pub value_weight: Option<f64>,
}

/// What differs from place to place on a pearl.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoatSpec {
    /// Seed of its fields; the growth's where left out.
    pub seed: Option<u64>,
    /// Standard deviation of the layers' thickness, as a share of it.
    pub thickness_spread: f64,
    /// Within this length the thickness is alike.
    pub patch_mm: f64,
    /// Share of all that in bands about the axis of growth.
    pub banding: f64,
    /// Share of the rest that changes with the angle it is seen at.
    pub liveliness: f64,
    /// Standard deviation of the lean of a hammered surface.
    pub hammering_rad: f64,
    /// Size of its dents.
    pub dent_mm: f64,
    /// Standard deviation of the grain's slopes; from the knob grain where left out.
    pub grain_relief_rad: Option<f64>,
    /// Spacing of growth terraces; none where it is 0.
    pub terrace_um: f64,
    /// Height of a terrace.
    pub terrace_step_nm: f64,
}

/// Pits, bumps and the like on a pearl.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlemishesSpec {
    /// Seed of their places; the growth's where left out.
    pub seed: Option<u64>,
    /// Round hollows.
    pub pits: usize,
    /// Round rises.
    pub bumps: usize,
    /// Narrow grooves.
    pub scratches: usize,
    /// Long rises.
    pub wrinkles: usize,
    /// Matt white spots.
    pub chalky_spots: usize,
    /// Mean diameter.
    pub size_mm: f64,
    /// Mean depth or height.
    pub depth_um: f64,
    /// Share of the pearl that they cover, by which sizes and depths are multiplied, where given.
    pub area: Option<f64>,
}

/// What shape a pearl has; lengths without a unit are shares of half its width.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShapeSpec {
    /// Seed of lumps and circles; the growth's where left out.
    pub seed: Option<u64>,
    /// Length along the axis of growth over the width across it.
    pub length: f64,
    /// How much narrower a drop's end is.
    pub taper: f64,
    /// How much nearer to the middle a button's flat side is.
    pub flattening: f64,
    /// Difference of the widths across the axis, as a share of them.
    pub out_of_round: f64,
    /// Standard deviation of a baroque pearl's lumps.
    pub lumps: f64,
    /// Size of a lump, from its top to its foot; by the pearl's size where left out.
    pub lump_mm: Option<f64>,
    /// Number of grooves about the axis.
    pub circles: usize,
    /// Depth of a groove.
    pub circle_depth: f64,
    /// Diameter of the drill hole along the axis; none where it is 0.
    pub drill_mm: f64,
    /// Width of the hole's worn edge.
    pub drill_wear_mm: f64,
}

/// How a pearl is turned in its place.
#[derive(Debug, Clone, Copy, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PoseSpec {
    /// About the upright.
    pub turn_deg: f64,
    /// Of the axis of growth from the upright towards the viewer; left out, upright for a round pearl and at rest, across
    /// the view, for another.
    pub tilt_deg: Option<f64>,
    /// About the axis of growth.
    pub spin_deg: f64,
}

/// What both models have of a pearl.
#[derive(Debug, Clone, Copy)]
pub struct Common<'a> {
    /// Diameter of the whole pearl.
    pub diameter_mm: f64,
    /// The knobs depth, shininess and grain.
    pub knobs: [f64; 3],
    /// The layers.
    pub nacre: &'a NacreSpec,
    /// Spread of the facets' slopes, where given.
    pub facet_spread_rad: Option<f64>,
    /// The grain.
    pub texture: &'a TextureSpec,
}

impl PearlSpec {
    /// What both models have.
    pub fn common(&self) -> Common<'_> {
        match self {
            Self::Transport(pearl) => Common {
                diameter_mm: pearl.diameter_mm,
                knobs: [pearl.depth, pearl.shininess, pearl.grain],
                nacre: &pearl.nacre,
                facet_spread_rad: pearl.surface.facet_spread_rad,
                texture: &pearl.texture,
            },
            Self::Illuminant(pearl) => Common {
                diameter_mm: pearl.diameter_mm,
                knobs: [pearl.depth, pearl.shininess, pearl.grain],
                nacre: &pearl.nacre,
                facet_spread_rad: pearl.surface.facet_spread_rad,
                texture: &pearl.texture,
            },
        }
    }

    /// The same pearl without its name, its grain and its pose, which change nothing about the light around it.
    pub(crate) fn without_grain(&self) -> Self {
        let mut same = self.clone();
        let (name, grain, texture) = match &mut same {
            Self::Transport(pearl) => {
                if is_round(pearl) {
                    pearl.pose = PoseSpec::default();
                }
                (&mut pearl.name, &mut pearl.grain, &mut pearl.texture)
            }
            Self::Illuminant(pearl) => (&mut pearl.name, &mut pearl.grain, &mut pearl.texture),
        };
        name.clear();
        *grain = 0.0;
        *texture = TextureSpec::default();
        same
    }
}
