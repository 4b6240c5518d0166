//! What a pearl mirrors in one direction and about it: the surface's lobe, and that of the layers below.
//!
//! The surface's is sharp and nearly without colour, the layers' broad and coloured (docs/transport.md, Two lobes).
//! Left out: polarisation of light that the layers turn out of its plane, which is weighed as if it stayed there.

use crate::{
    light::bands::{BANDS, Bands},
    surface::{
        clear::Clear,
        facets::Facets,
        film::{self, Film, LayersMirrored, STEPS, cosines},
        microfacets::Microfacets,
        sampling::FacetSample,
        waviness::Waviness,
    },
};

/// Facets, in air or below a clear surface, and what they mirror.
#[derive(Debug, Clone)]
pub struct Lobe {
    microfacets: Microfacets,
    below: Option<Clear>,
    /// What a facet mirrors, by the cosine of incidence in air.
    mirrored: Vec<Bands>,
    /// What all of them mirror, by the cosine of the view angle.
    albedo: Vec<Bands>,
}

/// Facets to average over, at every angle **(ours)**; 4096 agree with the integral to 0.01 (test in `sampling.rs`).
pub(crate) const FACETS: usize = 512;
/// For a preview **(ours)**.
pub(crate) const FEW_FACETS: usize = 96;

impl Lobe {
    fn new(
        microfacets: Microfacets,
        below: Option<Clear>,
        mirrored: Vec<Bands>,
        count: usize,
    ) -> Self {
        let mut lobe = Self { microfacets, below, mirrored, albedo: Vec::new() };
        let samples = microfacets.samples(count);
        lobe.albedo = cosines().map(|cosine| lobe.mirrored_by_all(&samples, cosine)).collect();
        lobe
    }

    /// The facets as light meets them.
    pub fn facets(&self) -> Facets<'_> {
        Facets::new(self.microfacets, self.below.as_ref())
    }

    /// What a facet mirrors at a cosine of incidence in air.
    pub fn mirrored(&self, cosine: f64) -> Bands {
        film::at(&self.mirrored, cosine)
    }

    /// What all facets mirror, by the cosine of the view angle, evenly from 0 (grazing) to 1.
    pub(crate) fn albedo_rows(&self) -> &[Bands] {
        &self.albedo
    }

    /// The same at any cosine.
    pub(crate) fn albedo(&self, cosine: f64) -> Bands {
        film::at(&self.albedo, cosine)
    }

    /// What facets that stand for all of them mirror to an eye at a cosine.
    fn mirrored_by_all(&self, samples: &[FacetSample], cosine: f64) -> Bands {
        let seen = self.facets().seen_at(cosine.max(0.25 / STEPS as f64));
        let mut mirrored = [0.0; BANDS];
        for facet in samples.iter().filter_map(|sample| seen.facet(*sample)) {
            for (sum, share) in mirrored.iter_mut().zip(self.mirrored(facet.cos_half)) {
                *sum += facet.weight * share;
            }
        }
        mirrored.map(|sum| sum / samples.len() as f64)
    }
}

/// The lobes of a film on microfacets whose layers wave, by so many facets at an angle: one where they do not.
pub(crate) fn lobes(
    film: &Film,
    microfacets: Microfacets,
    waviness: Waviness,
    count: usize,
) -> Vec<Lobe> {
    let mirrored = film.mirrored(waviness);
    let sharp = Lobe::new(microfacets, None, mirrored.sharp, count);
    let Some(LayersMirrored { passing, through }) = mirrored.layers else { return vec![sharp] };
    // Layers follow the surface and wave against it; seen from outside, their lean counts n times.
    let followed_rad = microfacets.spread_rad() / film.index();
    let slope_rad = (waviness.slope_rad().powi(2) + followed_rad.powi(2)).sqrt();
    let clear = Clear::new(film.index(), passing);
    vec![sharp, Lobe::new(Microfacets::grooves(slope_rad), Some(clear), through, count)]
}
