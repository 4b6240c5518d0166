//! From spectra to colour: spectrum x illuminant x observer, then XYZ, then Lab, RGB or Munsell HVC.
//!
//! A spectrum is 401 numbers from 380 to 780 nm. XYZ, Lab and linear RGB are `[f64; 3]`; conversions
//! are named output first ([`lab_from_xyz`]). RGB is linear until [`encode`]. XYZ is relative:
//! Y = 1 is the perfect reflecting diffuser under the illuminant.
//!
//! Transcendental functions come from `libm`, so that every platform computes the same bytes.
//!
//! Out of scope: where a spectrum comes from (the optics), pictures and files, colour profiles,
//! colour appearance beyond a change of white.
//!
//! ```
//! use nacreous_colour::{Illuminant, Observer, RgbSpace, Spectrum, encode, xyz_from_spectrum};
//!
//! let weights = Observer::Cie1931.weights(&Illuminant::D65.spectrum())?;
//! let reddish = Spectrum::from_fn(|wavelength_nm| if wavelength_nm < 600.0 { 0.1 } else { 0.6 });
//! let xyz = xyz_from_spectrum(&weights, reddish.values());
//! let [red, green, blue] = RgbSpace::Srgb.rgb_from_xyz(xyz).map(encode);
//! assert!(red > 0.7 && green < 0.4 && blue < 0.4);
//! # Ok::<(), nacreous_colour::ColourError>(())
//! ```

mod adaptation;
mod cells;
mod error;
mod gamut;
mod illuminant;
mod lab;
mod lamp;
pub mod matrix;
mod measured;
mod munsell;
mod observer;
mod reflectance;
mod rgb;
mod rows;
mod spectrum;
mod table;
mod xyz;

pub use adaptation::adaptation;
pub use error::ColourError;
pub use gamut::{Gamut, in_gamut, out_of_gamut_share};
pub use illuminant::{Illuminant, Kelvin};
pub use lab::{delta_e_2000, lab_from_xyz, xyz_from_lab};
pub use lamp::Lamp;
pub use matrix::Matrix;
pub use munsell::{Hvc, hvc_from_rgb, hvc_from_xyz, rgb_from_hvc, value_from_rgb, xyz_from_hvc};
pub use observer::Observer;
pub use reflectance::reflectance_from_rgb;
pub use rgb::{RgbSpace, decode, encode};
pub use spectrum::{FIRST_NM, LAST_NM, SAMPLES, Spectrum, WAVELENGTH_NM};
pub use xyz::{WHITE_C, xy_from_xyz, xyz, xyz_from_spectrum, xyz_from_xy};
