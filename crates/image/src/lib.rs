//! The picture of a pearl: camera, ball, lamps, surroundings, facets, grain, and the rings of
//! interference colour, put together into linear light in named parts.
//!
//! In scope: everything between a stack of layers and the pixels, and picture files. Out of scope:
//! spectra and colour themselves (`nacreous-optics`, `nacreous-colour`), pearl files and presets.
//!
//! Conventions: lengths in mm, angles in rad, y up, the origin in the middle (a lone pearl's centre),
//! z towards the viewer at azimuth 0. RGB is linear, in the primaries of sRGB, relative to the scene's
//! white. The radiance of a lamp, sky or surface is stated as that of a white matt surface, so no factor
//! pi appears.

mod ball;
mod bands;
mod by_angle;
mod camera;
mod chart;
mod coarser;
mod crowd;
mod develop;
mod dome;
mod draw;
mod eye;
mod facet;
pub mod file;
mod film;
mod floor;
mod glare;
mod glow;
pub mod grain;
pub mod harmonics;
mod illuminant;
mod incident;
mod inside;
mod iridescence;
mod irradiance;
mod knob;
mod lamp;
mod light;
mod net;
mod nine;
mod pane;
mod passage;
mod pearl;
mod picture;
mod pixel;
mod relief;
mod response;
mod rgb;
mod rings;
mod sky;
mod surface;
mod surroundings;
mod table;
mod transport;
mod viewpoint;
mod walls;
mod window;

pub use ball::{Ball, Hit};
pub use bands::{BANDS, Bands, Palette};
pub use by_angle::ByAngle;
pub use camera::{Camera, Projection, Ray, direction};
pub use develop::{Developed, develop, eight_bit};
pub use dome::Dome;
pub use draw::{Draw, Facet, FacetsSeen};
pub use facet::Facets;
pub use film::Film;
pub use glare::spread as spread_glare;
pub use glow::Glow;
pub use illuminant::IlluminantPearl;
pub use inside::Body;
pub use iridescence::{Iridescence, Weights, interference_colours};
pub use irradiance::Irradiance;
pub use knob::Parameters;
pub use lamp::{Lamp, Place};
pub use light::{Light, Source};
pub use net::Around;
pub use pearl::{Grain, Model, Pearl, Shade, Sight};
pub use picture::{CHANNELS, MAX_SIZE_PX, PARTS, Progress, render};
pub use relief::{Glint, Relief};
pub use response::Response;
pub use rgb::Rgb;
pub use rings::Rings;
pub use sky::Sky;
pub use surface::Surface;
pub use surroundings::{Seen, Surroundings};
pub use table::Table;
pub use transport::Transport;
pub use walls::Walls;
pub use window::Window;
