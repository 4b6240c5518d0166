//! The surface of a pearl: facets that lean, and the film of nacre on them.

pub(crate) mod clear;
pub(crate) mod coating;
pub(crate) mod facets;
pub(crate) mod film;
pub(crate) mod film_draft;
pub(crate) mod film_sampling;
pub(crate) mod lobe;
pub(crate) mod microfacets;
pub(crate) mod sampling;
pub(crate) mod torrance_sparrow;
pub(crate) mod waviness;
