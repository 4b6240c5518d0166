use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use nacreous_colour::{hvc_from_rgb, rgb_from_hvc};
use rayon::prelude::*;

use crate::{
    camera::Camera,
    pearl::Pearl,
    rgb::{self, Rgb},
    surroundings::Surroundings,
};

/// Numbers per pixel: four parts of three channels, the texture's three, and the pearl's coverage.
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
    pub(crate) fn stop_flag(&self) -> &AtomicBool {
        &self.stop
    }

    /// Asks the render to stop at the end of the row.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

/// Renders a square picture, `size_px` a side, `samples_side` squared samples a pixel: linear light,
/// [`CHANNELS`] numbers a pixel, row by row from the top. `None` if it was stopped.
///
/// No random numbers: every sample stands for its cell, and lamps, table and silhouette are averaged
/// over the cell in closed form. Memory: 64 bytes a pixel.
pub fn render(
    pearl: &Pearl<'_>,
    surroundings: &Surroundings,
    camera: &Camera,
    size_px: usize,
    samples_side: usize,
    progress: &Progress,
) -> Option<Vec<f32>> {
    let mut pixels = vec![0.0_f32; size_px * size_px * CHANNELS];
    let eye = Eye { pearl, surroundings, camera, offsets: tent(samples_side), size_px };
    pixels.par_chunks_mut(size_px * CHANNELS).enumerate().for_each(|(row, out)| {
        if !progress.stop.load(Ordering::Relaxed) {
            for (column, pixel) in out.chunks_mut(CHANNELS).enumerate() {
                eye.pixel(row, column).store(pixel);
            }
            progress.rows_done.fetch_add(1, Ordering::Relaxed);
        }
    });
    (!progress.stop.load(Ordering::Relaxed)).then_some(pixels)
}

/// Positions of the samples along one side, in pixels from the pixel's middle, such that equal weights
/// make a tent filter two pixels wide. The same pattern on both axes and in every pixel: pixels that
/// mirror each other about the pearl's centre see the same view angles.
fn tent(samples_side: usize) -> Vec<f64> {
    (0..samples_side)
        .map(|i| {
            let u = (i as f64 + 0.5) / samples_side as f64;
            if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() }
        })
        .collect()
}

struct Eye<'a> {
    pearl: &'a Pearl<'a>,
    surroundings: &'a Surroundings,
    camera: &'a Camera,
    offsets: Vec<f64>,
    size_px: usize,
}

/// One pixel's light in parts, averaged over its samples.
#[derive(Debug, Default)]
struct Pixel {
    interference: Rgb,
    diffuse: Rgb,
    mirror: Rgb,
    surroundings: Rgb,
    texture: Rgb,
    coverage: f64,
}

impl Eye<'_> {
    fn pixel(&self, row: usize, column: usize) -> Pixel {
        let mut pixel = Pixel::default();
        let samples = self.offsets.len() * self.offsets.len();
        let middle = 0.5 * self.size_px as f64;
        for &down in &self.offsets {
            for &aside in &self.offsets {
                let x = (column as f64 + 0.5 + aside - middle) / middle;
                let y = (middle - row as f64 - 0.5 - down) / middle;
                self.sample(x, y, 1.0 / samples as f64, &mut pixel);
            }
        }
        self.lay_texture(&mut pixel);
        pixel
    }

    fn sample(&self, x: f64, y: f64, weight: f64, pixel: &mut Pixel) {
        let ray = self.camera.ray(x, y);
        let cell_mm = self.camera.cell_mm(self.size_px * self.offsets.len());
        let pixel_mm = self.camera.cell_mm(self.size_px);
        let hit = self.surroundings.pearl.hit(&ray, cell_mm);
        let covered = hit.map_or(0.0, |hit| hit.coverage);
        if covered < 1.0 {
            let seen = self.surroundings.seen(&ray, pixel_mm / self.camera.reach_mm(&ray));
            rgb::add(&mut pixel.surroundings, rgb::scaled(seen.radiance, weight * (1.0 - covered)));
        }
        if let Some(hit) = hit {
            let weight = weight * hit.coverage;
            let pearl = self.pearl;
            let shade = pearl.shade(self.surroundings, &hit, -ray.along, pixel_mm);
            rgb::add(&mut pixel.interference, rgb::scaled(shade.interference, weight));
            rgb::add(&mut pixel.diffuse, rgb::scaled(shade.diffuse, weight));
            rgb::add(&mut pixel.mirror, rgb::scaled(shade.mirror, weight));
            rgb::add(&mut pixel.texture, rgb::scaled(shade.texture, weight));
            pixel.coverage += weight;
        }
    }

    /// Grain: H and C of the body colour and the brightness of what is mirrored, each changed in
    /// proportion to lightness (paper, section 4.4). Once a pixel, for its samples share the texture.
    fn lay_texture(&self, pixel: &mut Pixel) {
        let weights = self.pearl.grain;
        if pixel.coverage <= 0.0 || self.pearl.texture.is_none() {
            return;
        }
        let [hue, value, chroma] = pixel.texture.map(|t| t / pixel.coverage);
        let lightness = |part: Rgb| {
            hvc_from_rgb(rgb::scaled(part, 1.0 / pixel.coverage)).value.clamp(0.0, 10.0) / 10.0
        };
        let glint = 1.0 + weights.value * lightness(pixel.mirror) * value;
        let mut body = hvc_from_rgb(rgb::scaled(pixel.diffuse, 1.0 / pixel.coverage));
        let light = body.value.clamp(0.0, 10.0) / 10.0;
        body.hue_rad += weights.hue_rad * light * hue;
        body.chroma *= (1.0 + weights.chroma * light * chroma).max(0.0);
        pixel.diffuse = rgb::scaled(rgb_from_hvc(body), pixel.coverage);
        pixel.mirror = rgb::scaled(pixel.mirror, glint.max(0.0));
        pixel.texture = [hue, value, chroma];
    }
}

impl Pixel {
    fn store(&self, out: &mut [f32]) {
        let parts = [
            self.interference,
            self.diffuse,
            self.mirror,
            self.surroundings,
            self.texture,
            [self.coverage, 0.0, 0.0],
        ];
        for (channel, value) in out.iter_mut().zip(parts.into_iter().flatten()) {
            *channel = value as f32;
        }
    }
}
