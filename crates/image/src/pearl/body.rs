//! What a pearl's body does to light that has entered.
//!
//! Its reflectance comes from whoever makes the pearl, by Kubelka and Munk; the spread is **(ours)**.
//! Left out: the surface, which light passes before and after.

use nacreous_colour::SAMPLES;

use crate::light::bands::{Bands, means};

/// What a pearl does to light that has entered.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Share that nacre and nucleus send back, by band.
    pub reflectance: Bands,
    /// How far light wanders before it leaves: waves of degree l fade by exp(-l (l + 1) spread). 0 leaves a
    /// matt body, much a body that shines alike on all sides.
    pub spread: f64,
}

impl Body {
    /// Of a reflectance by wavelength.
    pub fn new(reflectance: &[f64; SAMPLES], spread: f64) -> Self {
        Self { reflectance: means(reflectance), spread }
    }
}
