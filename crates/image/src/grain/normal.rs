//! Normal deviates, the same on every machine.
//!
//! Box and Muller 1958, with libm's sines.
//! Left out: speed; fields are drawn once.

use rand_chacha::ChaCha8Rng;
use rand_core::Rng;
use std::f64::consts::TAU;

/// Two independent normal deviates (Box and Muller 1958), with sines that are the same everywhere.
pub(crate) fn normal_pair(random: &mut ChaCha8Rng) -> [f64; 2] {
    let radius = (-2.0 * libm::log(1.0 - uniform(random))).sqrt();
    let (sin, cos) = libm::sincos(TAU * uniform(random));
    [radius * cos, radius * sin]
}

/// An even deviate from 0 to below 1.
pub(crate) fn uniform(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}
