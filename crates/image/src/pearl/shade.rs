//! The light of one point of a pearl, in parts.
//!
//! Interference, body and mirror add up, as in the paper's section 4.
//! Left out: what lies behind the pearl.

use crate::rgb::{self, Rgb};

/// The light of one point of the pearl, in parts.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Shade {
    /// What interference does. In the model of 1996 the rings' light; in the transport model what the film's
    /// colours add to light from inside, and take from it: there it may be negative.
    pub interference: Rgb,
    /// From the body; in the transport model light from inside, were the film without colour.
    pub diffuse: Rgb,
    /// Lamps and surroundings mirrored.
    pub mirror: Rgb,
    /// Grain in hue, value, chroma.
    pub texture: Rgb,
}

impl Shade {
    /// All of its light, before the grain.
    pub(crate) fn light(&self) -> Rgb {
        let mut light = self.interference;
        rgb::add(&mut light, self.diffuse);
        rgb::add(&mut light, self.mirror);
        light
    }
}
