use glam::DVec3;

/// A line of sight or of reflection; `along` has length one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Where it starts, in mm.
    pub from: DVec3,
    /// Where it goes.
    pub along: DVec3,
}
