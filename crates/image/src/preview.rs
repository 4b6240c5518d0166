//! The first picture after a change: colours looked up where the picture itself would work them out.
//!
//! What depends on camera and light is kept while a film changes, what depends on the film is a table by angle.
//! Round pearls of the transport model whose layers are the same all over; whoever asks has another way for the rest.

pub(crate) mod backdrop;
pub(crate) mod canvas;
pub(crate) mod codes;
pub(crate) mod dyes;
pub(crate) mod glimpses;
pub(crate) mod grained;
pub(crate) mod lanes;
pub(crate) mod paint;
pub(crate) mod points;
pub(crate) mod veil;
