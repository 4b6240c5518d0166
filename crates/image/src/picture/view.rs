//! What a pixel shows, while it is being made.
//!
//! Light by ball, and of what lies behind them all.
//! Left out: how it is sampled.

use crate::{
    picture::pixel::Pixel,
    rgb::{self, Rgb},
};

/// What a pixel shows, while it is being made.
#[derive(Default)]
pub(super) struct View {
    pub(super) balls: Vec<usize>,
    /// Light of each of those balls.
    pub(super) parts: Vec<Pixel>,
    /// Light of what lies behind them all.
    pub(super) behind: Rgb,
}

impl View {
    /// Counts all light that was gathered so many times.
    pub(super) fn brighten(&mut self, times: f64) {
        for part in &mut self.parts {
            part.brighten(times);
        }
        self.behind = rgb::scaled(self.behind, times);
    }

    /// Forgets the light that was gathered.
    pub(super) fn clear(&mut self) {
        self.parts.clear();
        self.parts.resize(self.balls.len(), Pixel::default());
        self.behind = [0.0; 3];
    }
}
