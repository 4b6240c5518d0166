//! The stages of a picture, each made of the one before and kept until something above it changes: optics of
//! each pearl, the light around them, what the eye sees, and the look of it.

pub mod around;
pub mod job;
mod kept;
mod optics;
pub mod preview;
pub mod seen;
mod sized;
pub mod view;
mod work;
