//! What differs from place to place of a pearl: grain, relief, the thickness of its layers.
//!
//! The grain's texture and the coat, turned as the pearl is.
//! Left out: what they do with light.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    coat::{local::Local, outer::Coat},
    grain::texture::{Relief, Texture},
    rgb::Rgb,
};

/// How strongly the grain's textures act, per unit of texture and of lightness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grain {
    /// Radians of hue.
    pub hue_rad: f64,
    /// Relative chroma.
    pub chroma: f64,
    /// Relative brightness of what is mirrored.
    pub value: f64,
    /// Standard deviation of its slopes, in any one direction.
    pub relief_rad: f64,
}

/// What differs from place to place of a pearl.
#[derive(Debug, Clone)]
pub struct Skin {
    /// The grain over the sphere, if any.
    pub texture: Option<Arc<Texture>>,
    /// How strongly it acts.
    pub grain: Grain,
    /// What differs else, if anything does.
    pub coat: Option<Arc<Coat>>,
}

impl Skin {
    /// Whether its outer layers differ from place to place.
    pub(crate) fn has_relief(&self) -> bool {
        self.grain.relief_rad > 0.0 || self.coat.as_ref().is_some_and(|coat| !coat.is_even())
    }

    /// Whether they may have edges as fine as a pixel.
    pub(crate) fn has_fine_relief(&self) -> bool {
        self.coat.as_ref().is_some_and(|coat| coat.has_edges())
    }

    /// What its outer layers are like in a direction from its middle, `away_mm` from there, seen at a cosine of the view
    /// angle, as wide as `footprint_mm`; and the grain there, where its relief tells it too.
    pub(crate) fn local(
        &self,
        (outward, cos_view): (DVec3, f64),
        radius_mm: f64,
        [away_mm, footprint_mm]: [f64; 2],
    ) -> (Local, Option<Rgb>) {
        let (coat, relief) = self.layers((outward, cos_view), radius_mm, [away_mm, footprint_mm]);
        match relief {
            Some(relief) => (self.tilted(coat, &relief), Some(relief.value.map(f64::from))),
            None => (coat, None),
        }
    }

    /// The same in parts that do not hang on how steep the grain is, so long as it is steep at all: the coat, and the
    /// grain with its relief.
    pub(crate) fn layers(
        &self,
        (outward, cos_view): (DVec3, f64),
        radius_mm: f64,
        [away_mm, footprint_mm]: [f64; 2],
    ) -> (Local, Option<Relief>) {
        let coat = self
            .coat
            .as_ref()
            .map_or(Local::EVEN, |coat| coat.at(outward, [away_mm, footprint_mm], cos_view));
        let texture = self.texture.as_ref().filter(|_| self.grain.relief_rad > 0.0);
        let relief = texture
            .map(|texture| texture.with_relief(self.unturned(outward), footprint_mm / radius_mm));
        (coat, relief)
    }

    /// A coat tilted by the grain's relief, as steep as its brightness changes.
    pub(crate) fn tilted(&self, coat: Local, relief: &Relief) -> Local {
        let slope = relief.gradient * self.grain.relief_rad;
        let slope = self.coat.as_ref().map_or(slope, |coat| coat.pose().turned(slope));
        let fine_slope2 = 2.0 * self.grain.relief_rad.powi(2) * (1.0 - relief.seen);
        coat.and(Local { slope, fine_slope2, ..Local::EVEN })
    }

    /// A direction of the scene as it was before the pearl was turned.
    fn unturned(&self, outward: DVec3) -> DVec3 {
        self.coat.as_ref().map_or(outward, |coat| coat.pose().unturned(outward))
    }

    /// The grain in hue, value and chroma in a direction from the middle.
    pub(crate) fn grain_at(&self, outward: DVec3, footprint_rad: f64) -> Rgb {
        let at = |texture: &Arc<Texture>| texture.at(self.unturned(outward), footprint_rad);
        self.texture.as_ref().map(at).unwrap_or_default().map(f64::from)
    }
}
