//! What takes up room: balls, pearls that are not round, where a ray meets them, and who lies near whom.

pub(crate) mod ball;
mod crossing;
pub(crate) mod dimensions;
pub(crate) mod form;
mod horizon;
pub(crate) mod hull;
pub(crate) mod neighbours;
mod passing;
pub(crate) mod rest;
pub(crate) mod solid;
