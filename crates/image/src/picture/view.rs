//! What a pixel shows, while it is being made.
//!
//! Light by ball, and of what lies behind them all.
//! Left out: how it is sampled.

use crate::{
    picture::pixel::Pixel,
    rgb::{self, Rgb},
    shape::crossing::Beside,
};

/// What a pixel shows, while it is being made.
#[derive(Default)]
pub(super) struct View {
    pub(super) balls: Vec<usize>,
    /// How far inside each one's silhouette the middle of the pixel lies.
    pub(super) inside_mm: Vec<f64>,
    /// What is known of how lines of sight through the pixel come to each one.
    pub(super) known: Vec<Beside>,
    /// Where the middle of the pixel comes nearest to each one, along a line of sight.
    pub(super) passes: Vec<f64>,
    /// Light of each of those balls.
    pub(super) parts: Vec<Pixel>,
    /// Light of what lies behind them all.
    pub(super) behind: Rgb,
    /// Light of the samples of a pixel that shows no pearl.
    pub(super) lights: Vec<Rgb>,
    /// How the surface of the only ball is bent, where that is known: it hardly changes within a pixel.
    pub(super) bend: Option<[f64; 2]>,
    /// The nearest and the farthest place of it that were seen.
    pub(super) reach_mm: Option<[f64; 2]>,
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
        self.bend = None;
        self.reach_mm = None;
    }
}
