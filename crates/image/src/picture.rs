//! From pearls in their surroundings to pixels, and from linear light to codes for a screen.

pub(crate) mod channels;
pub(crate) mod chord;
pub(crate) mod detail;
pub(crate) mod develop;
pub(crate) mod difference;
pub(crate) mod finding;
pub(crate) mod glare;
pub(crate) mod open;
pub(crate) mod pixel;
pub(crate) mod reflections;
pub(crate) mod resampling;
pub(crate) mod rim;
pub(crate) mod sampler;
pub(crate) mod screen;
pub(crate) mod seeing;
pub(crate) mod tent;
pub(crate) mod view;
