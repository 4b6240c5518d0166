//! What light does in nacre: Fresnel's equations at one boundary ([`fresnel`]) and the interference of
//! light spread through the whole nacre, after the paper of 1996 ([`IlluminantModel`]).
//!
//! In scope: a stack of layers in, numbers by angle and wavelength out. Out of scope: colour, pictures.
//! Exact transfer matrices belong here too, beside the model of 1996.
//!
//! Conventions: waves run as exp(i(kx - wt)), so n + ik with k > 0 absorbs; angles in radians from
//! the normal; wavelengths and thicknesses in nanometres; tables are `[angle, wavelength]`, angle first.
//! Both components of polarisation reflect with the same sign at normal incidence, as in the paper.

mod cycle;
mod error;
mod fresnel;
mod illuminant;

pub use error::OpticsError;
pub use fresnel::{Fresnel, fresnel};
pub use illuminant::IlluminantModel;
