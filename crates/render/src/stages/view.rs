//! Third stage and fourth: what the eye sees of the lit scene, row by row, and how it looks at it.

use std::{ops::Range, sync::Arc};

use nacreous_image::{CHANNELS, PARTS, Progress, Sampler, spread_glare};

use crate::spec::scene::SceneSpec;

/// A scene before the camera, ready for any row.
#[derive(Debug, Clone)]
pub struct View {
    sampler: Arc<Sampler>,
    look: Look,
    size_px: usize,
}

/// How lens, eye and exposure change the light of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Look {
    exposure: f32,
    /// Share of the light that is spread, and the radius that holds half of it.
    glare: f64,
    glare_px: f64,
}

impl Look {
    pub(crate) fn new(scene: &SceneSpec, field_mm: f64, size_px: usize) -> Self {
        let camera = &scene.camera;
        let glare_mm = camera.distance_mm * libm::tan(camera.glare_deg.to_radians());
        let glare_px = glare_mm / field_mm * size_px as f64;
        Self { exposure: camera.exposure as f32, glare: camera.glare, glare_px }
    }
}

impl View {
    pub(crate) fn new(sampler: Arc<Sampler>, look: Look, size_px: usize) -> Self {
        Self { sampler, look, size_px }
    }

    /// Pixels a side.
    pub fn size_px(&self) -> usize {
        self.size_px
    }

    /// Some rows from the top, [`CHANNELS`] numbers a pixel, before the look; rows beyond the last are left
    /// out. `None` once `progress` says to stop. Memory: 68 bytes a pixel.
    pub fn rows(&self, rows: Range<usize>, progress: &Progress) -> Option<Vec<f32>> {
        let end = rows.end.min(self.size_px);
        self.sampler.rows(rows.start.min(end)..end, progress)
    }

    /// Turns the light of the whole picture into what lens, eye and exposure leave of it. Texture,
    /// coverage and shadow are no light and stay.
    pub fn look(&self, pixels: &mut [f32]) {
        spread_glare(pixels, self.size_px, self.look.glare, self.look.glare_px);
        self.expose(pixels);
    }

    /// The look without glare, which needs the whole picture: of any pixels.
    pub fn expose(&self, pixels: &mut [f32]) {
        for pixel in pixels.chunks_exact_mut(CHANNELS) {
            for channel in &mut pixel[..PARTS[3].1.end] {
                *channel *= self.look.exposure;
            }
        }
    }

    /// Whether lens and eye spread any light.
    pub fn has_glare(&self) -> bool {
        self.look.glare > 0.0
    }

    /// The whole picture: linear light [row, column, channel] in the parts that [`PARTS`] names.
    pub fn picture(&self, progress: &Progress) -> Option<Vec<f32>> {
        let mut pixels = self.rows(0..self.size_px, progress)?;
        self.look(&mut pixels);
        Some(pixels)
    }
}

/// The light of pixels, three channels each: the sum of the first four parts.
pub fn light_of(pixels: &[f32]) -> Vec<f32> {
    pixels.chunks_exact(CHANNELS).flat_map(light_of_pixel).collect()
}

/// The light of one pixel.
pub fn light_of_pixel(pixel: &[f32]) -> [f32; 3] {
    [0, 1, 2].map(|i| pixel[i] + pixel[i + 3] + pixel[i + 6] + pixel[i + 9])
}
