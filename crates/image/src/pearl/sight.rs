use glam::DVec3;

use crate::{pearl::reflection_cache::Around, shape::ball::Hit};

/// A point of a pearl under the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// The pearl's number among the balls.
    pub ball: usize,
    /// The point.
    pub hit: Hit,
    /// Towards the eye.
    pub view: DVec3,
    /// The width on the pearl that a pixel stands for.
    pub pixel_mm: f64,
    /// Which part of the light around this sample looks at: a pixel's samples, as many as stand along its
    /// side, share it out. Any number.
    pub part: usize,
    /// What all facets show of the surroundings, where that is known.
    pub around: Option<Around>,
}
