//! Light as the scene knows it: its sources and its white, bands of wavelengths, what a ball sends out.

pub(crate) mod bands;
pub(crate) mod glow;
pub(crate) mod palette;
pub(crate) mod scene;
