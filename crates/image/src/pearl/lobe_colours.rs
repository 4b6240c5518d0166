//! The colours of what a lobe mirrors, in one scene's light.
//!
//! Spectra of the film between the palette's bands and RGB, by steps of the cosine.
//! Left out: where the lobe points, which its facets know.

use nacreous_colour::Matrix;

use crate::{
    light::{
        bands::{self, BANDS, Bands},
        palette::Palette,
    },
    pearl::passage::{cosines, row},
    rgb::Rgb,
    surface::{coating::Surface, facets::Facets, lobe::Lobe},
};

/// One lobe of a pearl in one scene's colours and under its lamps.
#[derive(Debug)]
pub(crate) struct LobeColours {
    lobe: Lobe,
    /// What a facet mirrors of surroundings, from RGB to RGB, by the cosine of incidence.
    mirrored: Vec<Matrix>,
    /// What all facets together mirror of even surroundings, by the cosine of the view angle.
    mirrored_by_all: Vec<Matrix>,
    /// What a facet mirrors of each lamp, by the cosine of incidence.
    lamps_mirrored: Vec<Vec<Rgb>>,
}

impl LobeColours {
    /// Of a lobe of `surface` by its number.
    pub(crate) fn new(
        surface: &Surface,
        number: usize,
        palette: &Palette,
        lamps: &[Bands],
    ) -> Self {
        let lobe = &surface.lobes()[number];
        let film: Vec<Bands> = cosines().map(|cosine| lobe.mirrored(cosine)).collect();
        let by_all = |cosine| palette.filtered(&kept_out(surface, number, cosine));
        let colours = |power: &Bands| {
            film.iter().map(|share| palette.rgb(&bands::times(share, power))).collect()
        };
        Self {
            lobe: lobe.clone(),
            mirrored: film.iter().map(|share| palette.filtered(share)).collect(),
            mirrored_by_all: cosines().map(by_all).collect(),
            lamps_mirrored: lamps.iter().map(colours).collect(),
        }
    }

    /// The facets.
    pub(crate) fn facets(&self) -> Facets<'_> {
        self.lobe.facets()
    }

    /// What a facet mirrors of surroundings, from RGB to RGB, at a cosine of incidence.
    pub(crate) fn mirrored(&self, cosine: f64) -> &Matrix {
        &self.mirrored[row(cosine)]
    }

    /// What all facets together mirror of even surroundings, at a cosine of the view angle.
    pub(crate) fn mirrored_by_all(&self, cos_view: f64) -> &Matrix {
        &self.mirrored_by_all[row(cos_view)]
    }

    /// The colour that a facet mirrors of a lamp, at a cosine of incidence.
    pub(crate) fn lamp_mirrored(&self, lamp: usize, cosine: f64) -> Rgb {
        self.lamps_mirrored[lamp][row(cosine)]
    }
}

/// A lobe's part of what does not enter, so that all parts and what enters add up to one.
fn kept_out(surface: &Surface, number: usize, cosine: f64) -> Bands {
    let (entering, lobes) = (surface.entering(cosine), surface.lobes());
    let mut sum = [0.0; BANDS];
    for lobe in lobes {
        let albedo = lobe.albedo(cosine);
        sum = std::array::from_fn(|band| sum[band] + albedo[band]);
    }
    let own = lobes[number].albedo(cosine);
    std::array::from_fn(|band| {
        let part = if sum[band] > 0.0 { own[band] / sum[band] } else { 0.0 };
        (1.0 - entering[band]) * part
    })
}
