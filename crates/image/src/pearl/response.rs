//! What a pearl makes of light of any kind: by film, microfacets and body, as tables.
//!
//! Each a spectrum of the film between the palette's bands and RGB, by steps of the cosine.
//! Left out: the surroundings; so it is made once for all places of a pearl and shared.

use std::sync::Arc;

use nacreous_colour::Matrix;

use crate::{
    light::{
        bands::{self, Bands},
        palette::Palette,
    },
    pearl::{
        body::Body,
        passage::{COSINES, Passage},
    },
    rgb::Rgb,
    surface::{coating::Surface, microfacets::Microfacets},
};

/// What a pearl's film, facets and body make of light, in one scene's colours and under its lamps: made once
/// for all places where such pearls lie, and for all that their neighbours and the table send them.
#[derive(Debug)]
pub struct Response {
    microfacets: Microfacets,
    passage: Arc<Passage>,
    /// What the film mirrors of surroundings, from RGB to RGB, by the cosine of incidence.
    mirrored: Vec<Matrix>,
    /// What all facets together mirror of even surroundings, by the cosine of the view angle.
    mirrored_by_all: Vec<Matrix>,
    /// Power of each lamp, and what the film mirrors of it by the cosine of incidence.
    powers: Vec<Bands>,
    lamps_mirrored: Vec<Vec<Rgb>>,
}

impl Response {
    /// `lamps` holds the power by band of each lamp, as light of a white matt surface that faces it.
    pub fn new(surface: &Surface, body: &Body, palette: &Palette, lamps: &[Bands]) -> Self {
        let cosines = || (0..=COSINES).map(|step| step as f64 / COSINES as f64);
        let film: Vec<Bands> = cosines().map(|cosine| surface.film.reflectance(cosine)).collect();
        let entering: Vec<Bands> = cosines().map(|cosine| surface.entering(cosine)).collect();
        let kept_out = |entering: &Bands| palette.filtered(&entering.map(|share| 1.0 - share));
        let colours = |power: &Bands| {
            film.iter().map(|share| palette.rgb(&bands::times(share, power))).collect()
        };
        Self {
            microfacets: surface.microfacets,
            passage: Arc::new(Passage::new(surface, &entering, body, palette)),
            mirrored: film.iter().map(|share| palette.filtered(share)).collect(),
            mirrored_by_all: entering.iter().map(kept_out).collect(),
            powers: lamps.to_vec(),
            lamps_mirrored: lamps.iter().map(colours).collect(),
        }
    }

    /// The facets.
    pub(crate) fn microfacets(&self) -> &Microfacets {
        &self.microfacets
    }

    /// What becomes of light that enters.
    pub(crate) fn passage(&self) -> Arc<Passage> {
        Arc::clone(&self.passage)
    }

    /// What the film mirrors of surroundings, from RGB to RGB, at a cosine of incidence.
    pub(crate) fn mirrored(&self, cosine: f64) -> &Matrix {
        &self.mirrored[row(cosine)]
    }

    /// What all facets together mirror of even surroundings, at a cosine of the view angle.
    pub(crate) fn mirrored_by_all(&self, cos_view: f64) -> &Matrix {
        &self.mirrored_by_all[row(cos_view)]
    }

    /// Power of each lamp, by band.
    pub(crate) fn powers(&self) -> &[Bands] {
        &self.powers
    }

    /// The colour that the film mirrors of a lamp, at a cosine of incidence.
    pub(crate) fn lamp_mirrored(&self, lamp: usize, cosine: f64) -> Rgb {
        self.lamps_mirrored[lamp][row(cosine)]
    }
}

fn row(cosine: f64) -> usize {
    (cosine.clamp(0.0, 1.0) * COSINES as f64 + 0.5) as usize
}
