//! The picture of a pearl: camera, ball, lamps, surroundings, facets, grain, and the rings of
//! interference colour, put together into linear light in named parts.
//!
//! In scope: everything between a stack of layers and the pixels. Out of scope: picture files (`nacreous-file`),
//! spectra and colour themselves (`nacreous-optics`, `nacreous-colour`), pearl files and presets.
//!
//! Conventions: lengths in mm, angles in rad, y up, the origin in the middle (a lone pearl's centre),
//! z towards the viewer at azimuth 0. RGB is linear, in the primaries of sRGB, relative to the scene's
//! white. The radiance of a lamp, sky or surface is stated as that of a white matt surface, so no factor
//! pi appears.

mod coat;
pub mod grain;
pub mod harmonics;
mod iridescence;
mod light;
pub mod parallel;
mod pearl;
mod picture;
mod preview;
mod progress;
mod rgb;
mod shape;
mod surface;
mod surroundings;
mod view;

pub use coat::blemish::{Blemishes, Kind as BlemishKind};
pub use coat::drill::Drill;
pub use coat::local::Local;
pub use coat::nucleus::NucleusBands;
pub use coat::outer::{Coat, CoatParameters};
pub use coat::pose::Pose;
pub use coat::rulings::Rulings;
pub use iridescence::by_angle::ByAngle;
pub use iridescence::colours::{Iridescence, Weights, interference_colours};
pub use iridescence::rings::Rings;
pub use light::bands::{BANDS, Bands};
pub use light::glow::Glow;
pub use light::palette::Palette;
pub use light::scene::{Light, Source};
pub use pearl::body::Body;
pub use pearl::illuminant::IlluminantPearl;
pub use pearl::knob::Parameters;
pub use pearl::model::{Model, Pearl};
pub use pearl::reflection_cache::{Around, Arounds};
pub use pearl::response::Response;
pub use pearl::shade::Shade;
pub use pearl::sight::{Sight, Spread};
pub use pearl::skin::{Grain, Skin};
pub use pearl::subsurface::Subsurface;
pub use pearl::transport::Transport;
pub use picture::channels::{CHANNELS, MAX_SIZE_PX, PARTS};
pub use picture::develop::{Developed, develop, eight_bit};
pub use picture::difference::{DifferenceSummary, differences, summary};
pub use picture::glare::spread as spread_glare;
pub use picture::reflections::Reflections;
pub use picture::sampler::Sampler;
pub use picture::screen::{Screened, screen};
pub use preview::backdrop::Backdrop;
pub use preview::canvas::{Canvas, Sitter};
pub use preview::dyes::Dyes;
pub use preview::glimpses::{Fineness, Glimpses};
pub use preview::paint::{Development, Painted, paint};
pub use preview::points::Points;
pub use preview::veil::Veil;
pub use progress::Progress;
pub use rgb::Rgb;
pub use shape::ball::{Ball, Hit};
pub use shape::dimensions::Dimensions;
pub use shape::form::FormParameters;
pub use shape::hull::Hull;
pub use shape::rest::Rest;
pub use shape::solid::Solid;
pub use surface::coating::Surface;
pub use surface::facets::Facets;
pub use surface::film::Film;
pub use surface::film_draft::FilmDraft;
pub use surface::film_sampling::FilmSampling;
pub use surface::lobe::Lobe;
pub use surface::microfacets::{Glint, Microfacets};
pub use surface::sampling::{Facet, FacetSample, FacetsSeen};
pub use surface::torrance_sparrow::TorranceSparrow;
pub use surface::waviness::{FilmParts, Waviness};
pub use surroundings::environment::Surroundings;
pub use surroundings::ground::Seen;
pub use surroundings::irradiance::Irradiance;
pub use surroundings::lamp::{Lamp, Place};
pub use surroundings::lit::Lit;
pub use surroundings::panorama::Panorama;
pub use surroundings::sky::Sky;
pub use surroundings::table::Table;
pub use surroundings::walls::Walls;
pub use surroundings::window::Window;
pub use view::camera::{Camera, Projection};
pub use view::cone::Cone;
pub use view::direction::direction;
pub use view::ray::Ray;
