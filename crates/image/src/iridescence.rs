//! Interference colours by angle.

pub(crate) mod by_angle;
pub(crate) mod colours;
pub(crate) mod rings;
