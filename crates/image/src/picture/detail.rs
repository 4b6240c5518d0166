//! How much detail a pixel may have, which says how many samples it takes.
//!
//! By what is seen and how fine pixels are against it; else samples are compared.
//! Left out: things so small that all samples miss them.

use crate::rgb::Rgb;

/// What detail there is within a pixel.
pub(crate) enum Detail {
    /// Light hardly changes over several pixels: one sample will do.
    None,
    /// Nothing finer than a pixel, on the inner disc of one pearl: one sample in each row and column will do.
    BelowPixel,
    /// Perhaps nothing: those samples tell.
    Unknown,
    /// More than one pearl, or few samples.
    Edges,
    /// A pearl's rim crosses it, or lies next to it.
    Rim,
}

/// Between which lights those of some samples lie.
pub(crate) struct Range {
    least: Rgb,
    most: Rgb,
}

impl Default for Range {
    fn default() -> Self {
        Self { least: [f64::INFINITY; 3], most: [f64::NEG_INFINITY; 3] }
    }
}

impl Range {
    pub(crate) fn add(&mut self, light: Rgb) {
        for channel in 0..3 {
            self.least[channel] = self.least[channel].min(light[channel]);
            self.most[channel] = self.most[channel].max(light[channel]);
        }
    }

    /// Whether the samples are alike in a picture of that exposure.
    pub(crate) fn is_narrow(&self, exposure: f64) -> bool {
        let dark = DARK / exposure;
        (0..3).all(|i| self.most[i] - self.least[i] <= ALIKE * (self.most[i] + dark))
    }
}

/// Samples are alike whose exposed light differs by this share of it, and of some more in the dark: their mean is then
/// that of all to less than half a step between 8-bit codes (8 pearls in all scenes).
const ALIKE: f64 = 0.02;
const DARK: f64 = 0.02;
/// So many samples along a side have no edge pass between them unseen.
pub(crate) const FEWEST_ALIKE: usize = 4;
/// Pixels of less than this share of a pearl's radius, this share of it from its rim, see no change of what its
/// facets blur, its film or its grain.
pub(crate) const FINE: f64 = 1.0 / 700.0;
pub(crate) const RIM: f64 = 0.02;
/// So many pixels from its middle a pixel's filter reaches, at its corners: the root of 2.
pub(crate) const RIM_PX: f64 = 1.4143;
