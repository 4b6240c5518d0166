//! What takes up room: the balls, where a ray meets them, and who lies near whom.

pub(crate) mod ball;
pub(crate) mod neighbours;
