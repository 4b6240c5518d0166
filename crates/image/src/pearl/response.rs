//! What a pearl makes of light of any kind: by film, microfacets and body, as tables.
//!
//! Each a spectrum of the film between the palette's bands and RGB, by steps of the cosine.
//! Left out: the surroundings; so it is made once for all places of a pearl and shared.

use std::sync::Arc;

use crate::{
    light::{bands::Bands, palette::Palette},
    pearl::{
        body::Body,
        lobe_colours::LobeColours,
        passage::{Passage, cosines},
    },
    surface::coating::Surface,
};

/// What a pearl's film, facets and body make of light, in one scene's colours and under its lamps: made once
/// for all places where such pearls lie, and for all that their neighbours and the table send them.
#[derive(Debug)]
pub struct Response {
    lobes: Vec<LobeColours>,
    passage: Arc<Passage>,
    /// Power of each lamp, by band.
    powers: Vec<Bands>,
}

impl Response {
    /// `lamps` holds the power by band of each lamp, as light of a white matt surface that faces it.
    pub fn new(surface: &Surface, body: &Body, palette: &Palette, lamps: &[Bands]) -> Self {
        let entering: Vec<Bands> = cosines().map(|cosine| surface.entering(cosine)).collect();
        let colours = |number| LobeColours::new(surface, number, palette, lamps);
        Self {
            lobes: (0..surface.lobes().len()).map(colours).collect(),
            passage: Arc::new(Passage::new(surface, &entering, body, palette)),
            powers: lamps.to_vec(),
        }
    }

    /// What mirrors, each in its own direction, the sharpest first.
    pub(crate) fn lobes(&self) -> &[LobeColours] {
        &self.lobes
    }

    /// What becomes of light that enters.
    pub(crate) fn passage(&self) -> Arc<Passage> {
        Arc::clone(&self.passage)
    }

    /// Power of each lamp, by band.
    pub(crate) fn powers(&self) -> &[Bands] {
        &self.powers
    }
}
