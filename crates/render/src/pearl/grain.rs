//! The grain of a pearl as a texture over the whole sphere.

use nacreous_image::{
    Grain,
    grain::{spectrum::GrainSpectrum, texture::Texture},
};

use super::knobs::texture_seed_of;
use crate::{
    RenderError,
    spec::pearl::{PROCEDURAL, PearlSpec},
};

/// What makes a texture; pearls of the same grain share it.
#[derive(Debug, Clone, PartialEq)]
pub struct GrainKey {
    spectrum: GrainSpectrum,
    radius_mm: f64,
    seed: u64,
    footprint_rad: f64,
}

impl GrainKey {
    /// Of a pearl that shows its grain. `measured` is the spectrum of its photograph; `pixel_mm` the least
    /// width on a pearl that a pixel has: what only finer pixels would show is left out.
    ///
    /// # Errors
    /// [`RenderError`] for a photograph that was not handed over, or a band outside the spectrum.
    pub fn new(
        pearl: &PearlSpec,
        measured: Option<&GrainSpectrum>,
        pixel_mm: f64,
    ) -> Result<Self, RenderError> {
        let common = pearl.common();
        let texture = common.texture;
        let spectrum = match measured {
            Some(spectrum) => spectrum.clone(),
            None if texture.source == PROCEDURAL => {
                let (low, high) = (texture.low_per_mm, texture.high_per_mm);
                GrainSpectrum::procedural()
                    .limited(low.unwrap_or(0.0), high.unwrap_or(f64::INFINITY))?
            }
            None => return Err(RenderError::Missing(texture.source.clone())),
        };
        let radius_mm = 0.5 * common.diameter_mm;
        let (seed, footprint_rad) = (texture_seed_of(pearl), pixel_mm / radius_mm);
        Ok(Self { spectrum, radius_mm, seed, footprint_rad })
    }

    /// Draws the texture.
    ///
    /// # Errors
    /// [`RenderError::Grain`] for a pearl without a sensible size.
    pub fn texture(&self) -> Result<Texture, RenderError> {
        let Self { spectrum, radius_mm, seed, footprint_rad } = self;
        Ok(Texture::synthesise(spectrum, *radius_mm, *seed, *footprint_rad)?)
    }
}

/// Whether a grain shows at all.
pub(crate) fn is_seen(grain: &Grain) -> bool {
    [grain.hue_rad, grain.chroma, grain.value, grain.relief_rad].iter().any(|part| *part != 0.0)
}
