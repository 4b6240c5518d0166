//! Facets that mirror as the eye sees them: in air, or below a pearl's clear surface.
//!
//! Whichever they are; [`Microfacets`] lean and mask alike in both.
//! Left out: facets of the clear surface above those below, whose lean they bring with them.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use crate::surface::{
    clear::Clear,
    microfacets::{Glint, Microfacets},
    sampling::{Facet, FacetSample, FacetsSeen},
};

/// Facets of one lobe.
#[derive(Debug, Clone, Copy)]
pub struct Facets<'a> {
    microfacets: Microfacets,
    below: Option<&'a Clear>,
}

/// Facets from one angle, in the frame where z is the normal and the eye stands over the x axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LobeSeen<'a> {
    seen: FacetsSeen,
    /// The surface above, and the share of light to the eye that it lets through.
    below: Option<(&'a Clear, f64)>,
}

impl<'a> Facets<'a> {
    /// In air, or below a clear surface.
    pub(crate) fn new(microfacets: Microfacets, below: Option<&'a Clear>) -> Self {
        Self { microfacets, below }
    }

    /// Whether they lie below a clear surface.
    pub(crate) fn are_below(&self) -> bool {
        self.below.is_some()
    }

    /// How much farther light turns that goes out through the surface.
    fn index(&self) -> f64 {
        self.below.map_or(1.0, Clear::index)
    }

    /// The lean that stands for the width of the lobe outside.
    pub(crate) fn spread_rad(&self) -> f64 {
        self.index() * self.microfacets.spread_rad()
    }

    /// Whether no facet that leans little enough mirrors any part of a disc of light around `middle` to `view`.
    pub(crate) fn miss(
        &self,
        normal: DVec3,
        view: DVec3,
        middle: DVec3,
        angular_radius_rad: f64,
    ) -> bool {
        let below = |outside| self.below.map_or(outside, |clear| clear.inside(normal, outside));
        let half = below(view) + below(middle);
        let length = half.length();
        // Near the far side of the pearl the half vector turns faster than half the lamp's angle; below a surface
        // the disc is smaller.
        let disc_rad = angular_radius_rad / length.max(1e-3);
        let reach_rad = self.microfacets.reach_rad() + disc_rad;
        reach_rad < FRAC_PI_2 && normal.dot(half) < length * libm::cos(reach_rad)
    }

    /// Facets that lean by so much more, a standard deviation of some normals that are looked at together.
    #[must_use]
    pub(crate) fn over(self, normals_rad: f64) -> Self {
        let microfacets = self.microfacets.over(normals_rad / self.index());
        Self { microfacets, ..self }
    }

    /// As [`Microfacets::mirrored`]; the cosine of incidence is that in air.
    pub fn mirrored(&self, normal: DVec3, view: DVec3, light: DVec3) -> Option<Glint> {
        let Some(clear) = self.below else { return self.microfacets.mirrored(normal, view, light) };
        let (cos_view, cos_light) = (normal.dot(view), normal.dot(light));
        if cos_view <= 0.0 || cos_light <= 0.0 {
            return None;
        }
        let [view, light] = [view, light].map(|outside| clear.inside(normal, outside));
        let below = self.microfacets.mirrored(normal, view, light)?;
        Some(clear.glint(below, cos_view, cos_light))
    }

    /// As [`Microfacets::samples`].
    pub(crate) fn samples(&self, count: usize) -> Vec<FacetSample> {
        self.microfacets.samples(count)
    }

    /// As [`Microfacets::lattice`].
    pub(crate) fn lattice(&self, count: usize) -> Vec<FacetSample> {
        self.microfacets.lattice(count)
    }

    /// The facets as an eye at `cos_view` above 0 sees them.
    pub(crate) fn seen_at(&self, cos_view: f64) -> LobeSeen<'a> {
        match self.below {
            None => LobeSeen { seen: self.microfacets.seen_at(cos_view), below: None },
            Some(clear) => LobeSeen {
                seen: self.microfacets.seen_at(clear.cos_inside(cos_view)),
                below: Some((clear, clear.passing(cos_view))),
            },
        }
    }
}

impl From<Microfacets> for Facets<'_> {
    /// In air.
    fn from(microfacets: Microfacets) -> Self {
        Self::new(microfacets, None)
    }
}

impl LobeSeen<'_> {
    /// As [`FacetsSeen::facet`].
    #[inline]
    pub(crate) fn facet(&self, sample: FacetSample) -> Option<Facet> {
        let facet = self.seen.facet(sample)?;
        match self.below {
            None => Some(facet),
            Some((clear, passing)) => clear.facet(facet, passing),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::film::cosines;

    fn towards(cosine: f64, turn: f64) -> DVec3 {
        let sin = (1.0 - cosine * cosine).sqrt();
        DVec3::new(sin * turn.cos(), sin * turn.sin(), cosine)
    }

    /// A surface that mirrors more the more grazing, as nacre does.
    fn clear() -> Clear {
        Clear::new(1.683, cosines().map(|c| 0.93 * (1.0 - (1.0 - c).powi(5))).collect())
    }

    #[test]
    fn light_and_eye_may_change_places_below_a_clear_surface_too() {
        let clear = clear();
        for below in [None, Some(&clear)] {
            let facets = Facets::new(Microfacets::grooves(0.1), below);
            for (a, b) in [(0.9, 0.7), (0.3, 0.5), (0.15, 0.95)] {
                let (view, light) = (towards(a, 0.3), towards(b, 2.9));
                let there = facets.mirrored(DVec3::Z, view, light).unwrap();
                let back = facets.mirrored(DVec3::Z, light, view).unwrap();
                assert!((there.share / b - back.share / a).abs() < 1e-12 * there.share);
                assert!((there.cos_half - back.cos_half).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn facets_sampled_below_are_those_that_mirror() {
        // Weight times density, of a sample, is what `mirrored` states of its light.
        let clear = clear();
        let facets = Facets::new(Microfacets::grooves(0.1), Some(&clear));
        let mut met = 0;
        for sample in facets.samples(64) {
            let Some(facet) = facets.seen_at(0.6).facet(sample) else { continue };
            let stated = facets.mirrored(DVec3::Z, towards(0.6, 0.0), facet.light).unwrap();
            let sampled = facet.weight * facet.density;
            assert!((sampled - stated.share).abs() < 1e-9 * stated.share, "{facet:?} {stated:?}");
            assert!((facet.cos_half - stated.cos_half).abs() < 1e-9);
            met += 1;
        }
        assert!(met > 30);
    }

    #[test]
    fn level_facets_below_are_a_mirror_that_the_surface_covers_twice() {
        let clear = clear();
        let facets = Facets::new(Microfacets::grooves(0.002), Some(&clear));
        for cosine in [1.0, 0.6, 0.2] {
            let seen = facets.seen_at(cosine);
            let samples = facets.samples(256);
            let sum: f64 = samples.iter().filter_map(|s| seen.facet(*s)).map(|f| f.weight).sum();
            let law = clear.passing(cosine).powi(2);
            assert!((sum / 256.0 - law).abs() < 0.02 * law, "{cosine}: {} {law}", sum / 256.0);
        }
    }
}
