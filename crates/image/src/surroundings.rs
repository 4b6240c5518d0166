//! Everything a pearl stands in and mirrors, and the light that falls there.

pub(crate) mod clusters;
pub(crate) mod environment;
pub(crate) mod ground;
pub(crate) mod incident;
pub(crate) mod irradiance;
pub(crate) mod lamp;
pub(crate) mod light_map;
pub(crate) mod lit;
pub(crate) mod outline;
pub(crate) mod pane;
pub(crate) mod panorama;
pub(crate) mod seen;
pub(crate) mod shadow;
pub(crate) mod sky;
pub(crate) mod table;
pub(crate) mod table_light;
pub(crate) mod viewpoint;
pub(crate) mod walls;
pub(crate) mod weave;
pub(crate) mod window;
