//! What takes up room: balls, pearls that are not round, where a ray meets them, and who lies near whom.

pub(crate) mod ball;
mod bent;
pub(crate) mod crossing;
pub(crate) mod dimensions;
mod directions;
pub(crate) mod form;
mod horizon;
pub(crate) mod hull;
mod lumps;
pub(crate) mod neighbours;
mod ovoid;
mod passing;
pub(crate) mod rest;
pub(crate) mod solid;
