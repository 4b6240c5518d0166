//! Picture files: PNG and OpenEXR out, photographs and panoramas in, each behind a feature of its name.
//!
//! In scope: bytes of a file to plain pixels and back, what they claim checked before anything is decoded.
//! Out of scope: what the pixels show, and the light of displays (`nacreous-colour`).

// A build with some of the codecs has no use for the checks of the others.
#![cfg_attr(
    not(all(feature = "exr", feature = "panorama", feature = "photograph", feature = "png")),
    allow(dead_code, unused_imports)
)]

#[cfg(feature = "photograph")]
mod encoding;
#[cfg(feature = "exr")]
pub mod exr;
#[cfg(any(feature = "photograph", feature = "png"))]
pub mod icc;
#[cfg(feature = "photograph")]
mod jpeg;
#[cfg(feature = "panorama")]
pub mod panorama;
#[cfg(feature = "photograph")]
pub mod photograph;
pub mod picture;
#[cfg(feature = "png")]
pub mod png;
#[cfg(feature = "photograph")]
mod png_colour;
#[cfg(any(feature = "panorama", feature = "photograph", feature = "png"))]
pub mod profile;
#[cfg(feature = "panorama")]
mod radiance;
#[cfg(feature = "photograph")]
mod tiff;
