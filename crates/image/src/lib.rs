//! The picture of a pearl: camera, ball, lamps, surroundings, facets, grain, and the rings of
//! interference colour, put together into linear light in named parts.
//!
//! In scope: everything between a stack of layers and the pixels, and picture files. Out of scope:
//! spectra and colour themselves (`nacreous-optics`, `nacreous-colour`), pearl files and presets.
//!
//! Conventions: lengths in mm, angles in rad, y up, the pearl's centre the origin, z towards the viewer
//! at azimuth 0. RGB is linear, in the primaries of sRGB, relative to the scene's white. The radiance
//! of a lamp, sky or surface is stated as that of a white matt surface, so no factor pi appears.

mod bands;
mod by_angle;
mod camera;
mod develop;
mod dome;
mod facet;
pub mod file;
mod film;
pub mod grain;
pub mod harmonics;
mod inside;
mod iridescence;
mod irradiance;
mod knob;
mod lamp;
mod light;
mod pearl;
mod picture;
mod relief;
mod rgb;
mod rings;
mod sky;
mod sphere;
mod surface;
mod surroundings;
mod table;
mod transport;

pub use bands::{BANDS, Bands, Palette};
pub use by_angle::ByAngle;
pub use camera::{Camera, Projection, Ray, direction};
pub use develop::{Developed, develop, eight_bit};
pub use dome::Dome;
pub use facet::Facets;
pub use film::Film;
pub use inside::{Beam, Body, Inside};
pub use iridescence::{Iridescence, Weights, interference_colours};
pub use irradiance::Irradiance;
pub use knob::Parameters;
pub use lamp::{Lamp, Place};
pub use light::{Light, Source};
pub use pearl::{Grain, Pearl, Shade};
pub use picture::{CHANNELS, MAX_SIZE_PX, PARTS, Progress, render};
pub use relief::{Facet, Glint, Relief};
pub use rgb::Rgb;
pub use rings::Rings;
pub use sky::Sky;
pub use sphere::{Hit, Sphere};
pub use surface::Surface;
pub use surroundings::{Seen, Surroundings, Walls};
pub use table::Table;
pub use transport::{Parts, Transport};
