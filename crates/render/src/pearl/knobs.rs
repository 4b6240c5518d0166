//! The keys that a pearl leaves open, by its knobs.

use nacreous_image::{Grain, Parameters};

use crate::{
    pearl::shape::lump_mm_of,
    spec::pearl::{PearlSpec, TransportSpec},
};

/// What each key of a pearl that may be left open comes to, by the key's path in a file.
///
/// ```
/// use nacreous_render::{resolved_of, spec::Recipe};
/// # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/recipes");
/// # let text = std::fs::read_to_string(format!("{folder}/akoya-rg-north-window-white.json")).unwrap();
/// let recipe = Recipe::from_json(&text)?;
/// assert!(resolved_of(&recipe.pearls[0]).iter().any(|(key, value)| *key == "film.outer_um" && *value > 36.0));
/// # Ok::<(), nacreous_render::RenderError>(())
/// ```
pub fn resolved_of(pearl: &PearlSpec) -> Vec<(&'static str, f64)> {
    let (knobs, grain) = (parameters_of(pearl), grain_of(pearl));
    let mut keys = vec![
        ("surface.facet_spread_rad", facet_spread_rad_of(pearl)),
        ("texture.hue_weight", grain.hue_rad),
        ("texture.chroma_weight", grain.chroma),
        ("texture.value_weight", grain.value),
    ];
    match pearl {
        PearlSpec::Transport(pearl) => {
            keys.push(("film.outer_um", outer_um_of(pearl)));
            keys.push(("coat.grain_relief_rad", grain.relief_rad));
            keys.push(("inside.spread", spread_of(pearl)));
            keys.push(("shape.lump_mm", lump_mm_of(pearl)));
        }
        PearlSpec::Illuminant(pearl) => {
            let (how, surface) = (&pearl.interference, &pearl.surface);
            let loss = how.diffuse_loss.unwrap_or(knobs.diffuse_loss);
            keys.push(("interference.diffuse_loss", loss));
            keys.push(("interference.mixing", how.mixing.unwrap_or(knobs.mixing)));
            let mirror_weight = surface.mirror_weight.unwrap_or(knobs.mirror_weight);
            keys.push(("surface.mirror_weight", mirror_weight));
        }
    }
    keys
}

/// The numbers behind a pearl's knobs depth, shininess and grain.
pub(crate) fn parameters_of(pearl: &PearlSpec) -> Parameters {
    let [depth, shininess, grain] = pearl.common().knobs;
    Parameters::new(depth, shininess, grain)
}

/// Spread of the facets' slopes: the file's, or what shininess makes of it.
pub(crate) fn facet_spread_rad_of(pearl: &PearlSpec) -> f64 {
    pearl.common().facet_spread_rad.unwrap_or_else(|| parameters_of(pearl).facet_spread_rad)
}

/// How strongly the grain acts: the file's weights, or what the knob grain makes of them.
pub(crate) fn grain_of(pearl: &PearlSpec) -> Grain {
    let (texture, knobs) = (pearl.common().texture, parameters_of(pearl));
    Grain {
        hue_rad: texture.hue_weight.unwrap_or(knobs.hue_weight),
        chroma: texture.chroma_weight.unwrap_or(knobs.chroma_weight),
        value: texture.value_weight.unwrap_or(knobs.value_weight),
        relief_rad: match pearl {
            PearlSpec::Transport(pearl) => pearl.coat.grain_relief_rad.unwrap_or(knobs.relief_rad),
            PearlSpec::Illuminant(_) => 0.0,
        },
    }
}

/// Seed of the grain's random phases: the file's, or the growth's.
///
/// A number of its own beside [`resolved_of`], for seeds are whole numbers up to 2^63.
pub fn texture_seed_of(pearl: &PearlSpec) -> u64 {
    pearl.common().texture.seed.unwrap_or_else(|| pearl.common().nacre.seed())
}

/// Depth of the film: the file's, or what depth makes of it.
pub fn outer_um_of(pearl: &TransportSpec) -> f64 {
    pearl.film.outer_um.unwrap_or_else(|| knobs(pearl).outer_um)
}

/// How far light wanders inside: the file's, or what depth makes of it.
pub(crate) fn spread_of(pearl: &TransportSpec) -> f64 {
    pearl.inside.spread.unwrap_or_else(|| knobs(pearl).spread)
}

fn knobs(pearl: &TransportSpec) -> Parameters {
    Parameters::new(pearl.depth, pearl.shininess, pearl.grain)
}
