//! What a preview looks at: a scene before the camera, and its light.

use std::{ops::Range, sync::Arc};

use nacreous_image::{Development, Fineness, Lit, Microfacets, Response, Skin};

use super::{kept::Same, optics::microfacets_of};
use crate::{
    arrangement::{Arrangement, Solids},
    lights::{Lights, LightsKey},
    spec::{Recipe, pearl::PearlSpec},
};

/// How a preview shall be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Asked {
    /// Pixels a side; small ones are looked at less finely.
    pub size_px: usize,
    /// How light becomes codes; its exposure comes on top of the camera's.
    pub development: Development,
}

/// How finely a preview looks at what pearls mirror **(ours)**: `python benchmarks/viewer.py` has its errors.
pub(super) fn fineness(size_px: usize) -> Fineness {
    Fineness { knots: if size_px > SMALL_PX { 40 } else { 24 }, facets: 16 }
}

/// Pixels a side of previews that are shown while something moves.
pub(super) const SMALL_PX: usize = 320;
/// A scene before the camera, as far as it is the same for a view and a preview.
pub(crate) struct Before<'a> {
    pub(crate) recipe: &'a Recipe,
    pub(crate) arrangement: &'a Arrangement,
    pub(crate) solids: &'a Solids,
    pub(crate) lights: (&'a LightsKey, &'a Lights),
    /// Of each pearl given.
    pub(crate) skins: &'a [Skin],
}

/// What a preview by tables looks at.
pub(super) struct Seen<'a> {
    pub(super) before: &'a Before<'a>,
    /// Of each pearl given.
    pub(super) responses: &'a [Arc<Response>],
    pub(super) lit: &'a Arc<Lit>,
    pub(super) asked: &'a Asked,
}

impl Seen<'_> {
    pub(super) fn response(&self, ball: usize) -> Same<Response> {
        Same(Arc::clone(&self.responses[self.before.arrangement.places()[ball].pearl]))
    }

    fn pearl(&self, ball: usize) -> &PearlSpec {
        &self.before.recipe.pearls[self.before.arrangement.places()[ball].pearl]
    }

    pub(super) fn facets(&self, ball: usize) -> FacetsKey {
        let pearl = self.pearl(ball);
        let waviness_rad = match pearl {
            PearlSpec::Transport(pearl) => pearl.surface.waviness_rad,
            PearlSpec::Illuminant(_) => 0.0,
        };
        (microfacets_of(pearl), waviness_rad)
    }

    pub(super) fn balls(&self) -> Range<usize> {
        0..self.before.arrangement.places().len()
    }
}

/// How the facets of a pearl lean, and how its layers wave.
pub(super) type FacetsKey = (Microfacets, f64);
