use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::{camera::Camera, eye::Eye, pearl::Pearl, surroundings::Surroundings};

/// Numbers per pixel: four parts of three channels, the texture's three, and the pearls' coverage.
pub const CHANNELS: usize = 16;

/// The parts of a picture and the channels they take in each pixel. The first four add up to the
/// picture.
pub const PARTS: [(&str, std::ops::Range<usize>); 6] = [
    ("interference", 0..3),
    ("diffuse", 3..6),
    ("mirror", 6..9),
    ("surroundings", 9..12),
    ("texture", 12..15),
    ("coverage", 15..16),
];

/// The largest picture: 8192 pixels a side take 4 GB.
pub const MAX_SIZE_PX: usize = 8192;

/// How far a render is, seen from another thread, and the wish that it stop.
#[derive(Debug, Default)]
pub struct Progress {
    rows_done: AtomicUsize,
    stop: AtomicBool,
}

impl Progress {
    /// Rows finished so far.
    pub fn rows_done(&self) -> usize {
        self.rows_done.load(Ordering::Relaxed)
    }

    /// What turns true with the wish to stop.
    pub fn stop_flag(&self) -> &AtomicBool {
        &self.stop
    }

    /// Whether there is that wish.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Asks the render to stop at the end of the row.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// Renders a square picture, `size_px` a side, `samples_side` squared samples a pixel: linear light,
/// [`CHANNELS`] numbers a pixel, row by row from the top. `None` if it was stopped.
///
/// `pearls[i]` is the ball `surroundings.balls[i]`.
///
/// No random numbers: every sample stands for its cell, and lamps, table and silhouette are averaged
/// over the cell in closed form. Memory: 64 bytes a pixel.
pub fn render(
    pearls: &[Pearl<'_>],
    surroundings: &Surroundings,
    camera: &Camera,
    size_px: usize,
    samples_side: usize,
    progress: &Progress,
) -> Option<Vec<f32>> {
    let mut pixels = vec![0.0_f32; size_px * size_px * CHANNELS];
    let eye = Eye::new(pearls, surroundings, camera, size_px, samples_side);
    pixels.par_chunks_mut(size_px * CHANNELS).enumerate().for_each(|(row, out)| {
        if !progress.is_stopped() {
            eye.row(row, out.chunks_mut(CHANNELS));
            progress.rows_done.fetch_add(1, Ordering::Relaxed);
        }
    });
    (!progress.is_stopped()).then_some(pixels)
}
