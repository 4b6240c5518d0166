//! What a pearl is made of: layers of aragonite, each with a thin protein layer below it, grown
//! day by day around a nucleus.
//!
//! In scope: a validated stack of layers ([`LayerStack`]), refractive indices ([`Index`]), media ([`Medium`]) and
//! pigments ([`Pigment`]), and the growth of section 3.2.1 of the paper of 1996 ([`Growth`]). Out of scope: what light does in it
//! (`nacreous-optics`), calendars (days are counted from the day of seeding) and files.
//!
//! Same seed, same stack, on every platform: the noise is `ChaCha8` and the bell curve is computed by
//! `libm`, not by the platform's mathematics library.

mod dispersion;
mod error;
mod growth;
mod index;
mod medium;
mod pigment;
mod season;
mod stack;

pub use error::{NacreError, said};
pub use growth::{Deposit, Diary, Growth};
pub use index::Index;
pub use medium::{Medium, Principal};
pub use pigment::Pigment;
pub use season::Season;
pub use stack::{LayerStack, MAX_LAYERS, Thickness};
