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

mod ball;
mod bands;
mod by_angle;
mod camera;
mod channels;
mod chart;
mod coarser;
mod crowd;
mod develop;
mod direction;
mod dome;
mod draw;
mod eye;
mod facet;
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
mod palette;
mod pearl;
mod picture;
mod pixel;
mod progress;
mod ray;
mod relief;
mod rgb;
mod rings;
mod seen;
mod shade;
mod sight;
mod sky;
mod surface;
mod surroundings;
mod table;
mod transport;
mod walls;
mod window;

pub use ball::{Ball, Hit};
pub use bands::{BANDS, Bands};
pub use by_angle::ByAngle;
pub use camera::{Camera, Projection};
pub use channels::{CHANNELS, MAX_SIZE_PX, PARTS};
pub use develop::{Developed, develop, eight_bit};
pub use direction::direction;
pub use dome::Dome;
pub use draw::{Draw, Facet, FacetsSeen};
pub use facet::Facets;
pub use film::Film;
pub use glare::spread as spread_glare;
pub use glow::Glow;
pub use illuminant::IlluminantPearl;
pub use inside::{Beam, Body, Inside};
pub use iridescence::{Iridescence, Weights, interference_colours};
pub use irradiance::Irradiance;
pub use knob::Parameters;
pub use lamp::{Lamp, Place};
pub use light::{Light, Source};
pub use net::Around;
pub use palette::Palette;
pub use pearl::{Grain, Model, Pearl};
pub use picture::render;
pub use progress::Progress;
pub use ray::Ray;
pub use relief::{Glint, Relief};
pub use rgb::Rgb;
pub use rings::Rings;
pub use seen::Seen;
pub use shade::Shade;
pub use sight::Sight;
pub use sky::Sky;
pub use surface::Surface;
pub use surroundings::Surroundings;
pub use table::Table;
pub use transport::Transport;
pub use walls::Walls;
pub use window::Window;
