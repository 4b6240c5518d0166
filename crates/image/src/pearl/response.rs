//! What a pearl makes of light of any kind: by film, microfacets and body, as tables.
//!
//! Each a spectrum of the film between the palette's bands and RGB, by steps of the cosine.
//! Left out: the surroundings; so it is made once for all places of a pearl and shared.

use std::sync::Arc;

use crate::{
    light::{bands::Bands, palette::Palette},
    parallel,
    pearl::{body::Body, films::Films, lobe_colours::LobeColours, passage::Passage},
    surface::coating::Surface,
};

/// What a pearl's film, facets and body make of light, in one scene's colours and under its lamps: made once
/// for all places where such pearls lie, and for all that their neighbours and the table send them.
#[derive(Debug)]
pub struct Response {
    /// What mirrors, by the thickness of the layers: the surface, and the layers where they wave.
    films: Films<Vec<LobeColours>>,
    passage: Arc<Passage>,
    /// Power of each lamp, by band.
    powers: Vec<Bands>,
}

impl Response {
    /// `surfaces` are those of films whose layers' thickness is `step` apart, as a share of the middle one's: an odd
    /// number, thinnest first; `lamps` holds the power by band of each lamp, as light of a white matt surface that
    /// faces it. What enters and what is thrown back inside goes by the middle one.
    pub fn new(
        (surfaces, step): (&[Surface], f64),
        body: &Body,
        palette: &Palette,
        lamps: &[Bands],
    ) -> Self {
        let colours = |surface: &Surface| {
            let lobe = |number| LobeColours::new(surface, number, palette, lamps);
            (0..surface.lobes().len()).map(lobe).collect()
        };
        let all = parallel::map(surfaces.len(), |film| colours(&surfaces[film]));
        let passage = Passage::new((surfaces, step), body, palette);
        Self { films: Films::new(all, step), passage: Arc::new(passage), powers: lamps.to_vec() }
    }

    /// What mirrors, each in its own direction, the sharpest first, by the thickness of the layers.
    pub(crate) fn films(&self) -> &Films<Vec<LobeColours>> {
        &self.films
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
