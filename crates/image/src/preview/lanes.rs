//! Pixels that are worked on side by side.
//!
//! As many as a processor takes at once, and some more for it to choose from.
//! Left out: what is done with them.

/// Pixels of a run.
pub(super) const LANES: usize = 16;
/// One number for each.
pub(super) type Lanes = [f32; LANES];

/// The larger of two numbers. `f32::max`, which minds what is no number, is a call in WebAssembly.
#[inline]
pub(super) fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
