//! What differs from place to place on a pearl: relief, terraces, blemishes, thickness of the layers.

pub(crate) mod blemish;
pub(crate) mod drill;
pub(crate) mod fields;
pub(crate) mod layout;
pub(crate) mod local;
pub(crate) mod nucleus;
pub(crate) mod outer;
pub(crate) mod pose;
pub(crate) mod rulings;
pub(crate) mod spots;
pub(crate) mod terraces;
