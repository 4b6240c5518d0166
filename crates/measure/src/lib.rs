//! From a linear picture of a pearl to numbers: outline, size, roundness, colour by ring, the lamp's
//! image, blemishes, each with its standard error where one can be had.
//!
//! It takes linear light and what is known of it (white, scale, where codes end), and no pearl file:
//! a render and a photograph are measured alike. What cannot be measured is refused by name, with a
//! reason; grades are no part of it. Definitions and their sources: `docs/measure.md`.
//!
//! Lengths are in pixels from the outer corner of the first one, y down, or in radii of the pearl;
//! angles are those of the surface's normal: one degree turns mirrored light by two. The eye is taken
//! as far away **(ours)**: at 12 diameters the normal is off by up to 2.4 degrees at the rim.
//!
//! ```
//! use nacreous_measure::{Given, Picture, measure};
//!
//! let side = 64_usize;
//! let light: Vec<f32> = (0..side * side)
//!     .flat_map(|at| {
//!         let away = ((at % side) as f32 - 31.5).hypot((at / side) as f32 - 31.5);
//!         [0.05 + 0.6 * (20.5 - away).clamp(0.0, 1.0); 3]
//!     })
//!     .collect();
//! let found = measure(&Picture::new(&light, side, side)?, &Given::default())?;
//! assert!((found.size.mean.value - 40.0).abs() < 0.1 && found.sphere);
//! assert_eq!(found.refused[0].quantity, "lamp");
//! # Ok::<(), nacreous_measure::MeasureError>(())
//! ```

mod blemish;
mod candidate;
mod circle;
mod contour;
mod course;
mod disc;
mod edge;
mod error;
mod face;
mod highlight;
mod hollow;
mod lamp;
mod measures;
mod outline;
mod path;
mod picture;
mod profile;
mod rim;
mod rings;
mod search;
mod soft;
mod solve;
mod spot;
mod value;
mod white;

pub use blemish::Blemishes;
pub use circle::Circle;
pub use error::MeasureError;
pub use lamp::LampImage;
pub use measures::{Given, Measures, Place, Refused, Size, measure, measure_cut_out};
pub use picture::Picture;
pub use rings::{Colour, HUES, Ring, Rings};
pub use value::Value;
