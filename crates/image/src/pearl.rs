//! What a pearl does with light, by either model, point by point.

pub(crate) mod beam;
pub(crate) mod body;
pub(crate) mod films;
pub(crate) mod gathered;
pub(crate) mod glint;
pub(crate) mod illuminant;
pub(crate) mod knob;
pub(crate) mod lobe_colours;
pub(crate) mod model;
pub(crate) mod net;
pub(crate) mod passage;
pub(crate) mod reflection;
pub(crate) mod reflection_cache;
pub(crate) mod response;
pub(crate) mod shade;
pub(crate) mod sight;
pub(crate) mod skin;
pub(crate) mod solid_light;
pub(crate) mod subsurface;
pub(crate) mod transport;
