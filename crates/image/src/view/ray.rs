//! A ray: where it starts and where it goes.
//!
//! Geometry alone.
//! Left out: how wide a cone it stands for, which each question states.

use glam::DVec3;

/// A line of sight or of reflection; `along` has length one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Where it starts, in mm.
    pub from: DVec3,
    /// Where it goes.
    pub along: DVec3,
}
