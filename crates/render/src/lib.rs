//! From a complete pearl and scene to pixels: the one place that decides on the way. Knobs, growth, the
//! film's columns, the body, which pearl lies where, which lights count for the white, how finely lamps are
//! resolved, in which order light is worked out and how often it bounces.
//!
//! In scope: everything between a [`Recipe`](spec::Recipe) and linear light in named parts. Out of scope:
//! files (whoever calls hands over their contents as [`Resources`]), pages, and the ranges of keys, which
//! are checked where a file or a form is read.
//!
//! Same recipe, same bytes, on every machine that multiplies and adds in one step.

mod arrangement;
mod error;
mod frame;
mod lights;
mod pearl;
mod resources;
pub mod spec;
mod stages;

pub use arrangement::{Arrangement, MOST_PEARLS, Place, Sighted};
pub use error::RenderError;
pub use frame::Frame;
pub use lights::Lights;
pub use pearl::{
    body::reflectance_of,
    calendar::Calendar,
    columns::columns_of,
    grain::GrainKey,
    knobs::{outer_um_of, resolved_of, texture_seed_of},
    nacre::{Core, core_under, diary_of, season_of, stack_of},
    shape::dimensions_of,
    spectra::film_spectra,
};
pub use resources::{Needs, Resources};
pub use stages::{
    around::BOUNCES,
    job::{Job, MAX_SAMPLES, Shared},
    seen::Asked,
    view::{View, light_of, light_of_pixel},
};
