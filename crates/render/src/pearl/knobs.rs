//! The keys that a pearl leaves open, by its knobs.

use nacreous_image::{Grain, Parameters};

use crate::spec::pearl::{PearlSpec, TransportSpec};

/// The numbers behind a pearl's knobs depth, shininess and grain.
pub fn parameters_of(pearl: &PearlSpec) -> Parameters {
    let [depth, shininess, grain] = pearl.common().knobs;
    Parameters::new(depth, shininess, grain)
}

/// Spread of the facets' slopes: the file's, or what shininess makes of it.
pub fn facet_spread_rad_of(pearl: &PearlSpec) -> f64 {
    pearl.common().facet_spread_rad.unwrap_or_else(|| parameters_of(pearl).facet_spread_rad)
}

/// How strongly the grain acts: the file's weights, or what the knob grain makes of them.
pub fn grain_of(pearl: &PearlSpec) -> Grain {
    let (texture, knobs) = (pearl.common().texture, parameters_of(pearl));
    Grain {
        hue_rad: texture.hue_weight.unwrap_or(knobs.hue_weight),
        chroma: texture.chroma_weight.unwrap_or(knobs.chroma_weight),
        value: texture.value_weight.unwrap_or(knobs.value_weight),
    }
}

/// Depth of the film: the file's, or what depth makes of it.
pub fn outer_um_of(pearl: &TransportSpec) -> f64 {
    pearl.film.outer_um.unwrap_or_else(|| knobs(pearl).outer_um)
}

/// How far light wanders inside: the file's, or what depth makes of it.
pub fn spread_of(pearl: &TransportSpec) -> f64 {
    pearl.inside.spread.unwrap_or_else(|| knobs(pearl).spread)
}

fn knobs(pearl: &TransportSpec) -> Parameters {
    Parameters::new(pearl.depth, pearl.shininess, pearl.grain)
}
