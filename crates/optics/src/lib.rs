//! transmittance of a whole stack ([`TransferModel`]), and the interference of light spread through the
//! whole nacre, after the paper of 1996 ([`IlluminantModel`]); and what scatters ([`kubelka_munk`]).
//!
//! In scope: a stack of layers in, numbers by angle and wavelength out. Out of scope: colour, pictures.
//!
//! Conventions: waves run as exp(i(kx - wt)), so n + ik with k > 0 absorbs; angles in radians from
//! the normal; wavelengths and thicknesses in nanometres; tables are `[angle, wavelength]`, angle first.
//! Both components of polarisation reflect with the same sign at normal incidence, as in the paper.
// Only what is inlined is compiled with the vector instructions of the function that calls it.
#![allow(clippy::inline_always)]
// In a loop over wavelengths `&&` and `||` are branches, which would keep them from running side by side.
#![allow(clippy::needless_bitwise_bool)]

mod absorbing;
mod depth;
mod ensemble;
mod error;
mod film;
mod fresnel;
mod grid;
mod illuminant;
mod incidence;
mod interference;
mod lanes;
mod lossless;
mod media;
mod packing;
mod parallel;
mod phase;
mod points;
mod real;
mod resonance;
mod sight;
mod tablets;
mod tabulated;
mod transfer;
mod turbid;
mod wave;
mod waves;
mod window;

pub use depth::Profile;
pub use ensemble::{Ensemble, reflectances};
pub use error::OpticsError;
pub use film::{Amplitudes, Film, Plate};
pub use fresnel::{Fresnel, fresnel};
pub use illuminant::IlluminantModel;
pub use resonance::{Resonance, resonances};
pub use transfer::{Energies, Origin, Precision, TransferModel};
pub use turbid::kubelka_munk;
pub use wave::Polarisation;
