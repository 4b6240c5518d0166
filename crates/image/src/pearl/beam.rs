//! A lamp as the inside of a pearl meets it.
//!
//! A disc of light from one direction.
//! Left out: that a near lamp shines on each side from another direction.

use glam::DVec3;

use crate::light::bands::Bands;

/// A lamp as the inside of a pearl meets it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Beam {
    /// Towards the lamp.
    pub(crate) direction: DVec3,
    /// Radius of its disc.
    pub(crate) angular_radius_rad: f64,
    /// Light in bands of a white matt surface that faces it.
    pub(crate) power: Bands,
}
