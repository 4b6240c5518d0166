//! Light that lens and eye spread around bright things.
//!
//! The glare of the eye falls off about as the angle to the third power (Vos 1984, Disability glare, a
//! state of the art report, CIE J. 3, 39-53; Spencer, Shirley, Zimmerman and Greenberg 1995, Physically-
//! based glare effects for digital images, SIGGRAPH, p. 325-334: 20.91 / (angle + 0.02)^3). Ours is that law
//! between two angles: four round Gaussians, each twice as wide as the one before and with half its light
//! **(ours)**, so that sums over pixels stay separable. No rings, no streaks, no change of colour **(ours)**.

use crate::parallel;
use crate::picture::{
    channels::{CHANNELS, PARTS},
    resampling::{Resampling, mirrored},
};

/// Light of a pixel: the four parts that add up to the picture.
const LIGHT: usize = PARTS[3].1.end;
type Light = [f32; LIGHT];

/// Gaussians by width, in units of the narrowest's standard deviation, and their shares of the glare.
const GAUSSIANS: [(f64, f64); 4] =
    [(1.0, 8.0 / 15.0), (2.0, 4.0 / 15.0), (4.0, 2.0 / 15.0), (8.0, 1.0 / 15.0)];
/// The radius that holds half of the glare, in the same unit.
const HALF_RADIUS: f64 = 1.695_27;

/// Spreads the `share` of all light in the picture, square and [`CHANNELS`] numbers a pixel, such that half
/// of what is spread stays within `radius_px`. What would leave the picture is mirrored back at its edges,
/// so that the light of each part stays the same; a share of 0 changes no bit.
pub fn spread(pixels: &mut [f32], size_px: usize, share: f64, radius_px: f64) {
    if share <= 0.0 || size_px == 0 {
        return;
    }
    let narrowest_px = radius_px / HALF_RADIUS;
    let glare = glare(pixels, size_px, narrowest_px, &GAUSSIANS);
    let (kept, spread) = ((1.0 - share) as f32, share as f32);
    glare.rows(pixels, size_px * CHANNELS, CHANNELS, |pixel, light| {
        for (channel, glare) in pixel[..LIGHT].iter_mut().zip(light) {
            *channel = kept * *channel + spread * glare;
        }
    });
}

/// The glare of a picture on the finest sheet that it needs: each Gaussian is taken where its standard
/// deviation is two and a half cells, the wider ones on coarser sheets.
fn glare(pixels: &[f32], size_px: usize, narrowest_px: f64, gaussians: &[(f64, f64)]) -> Raised {
    let cell_px = (0.4 * narrowest_px * gaussians[0].0).max(1.0);
    let scale = Resampling::new(size_px, cell_px);
    let sheet = Sheet::lowered(&scale, |row, column| {
        let at = (row * size_px + column) * CHANNELS;
        std::array::from_fn(|i| pixels[at + i])
    });
    let widths: Vec<_> =
        gaussians.iter().map(|(wide, part)| (wide * narrowest_px, *part)).collect();
    let light = sheet.glare(cell_px, scale.variance(), &widths);
    Raised { light, scale }
}

/// Light in square cells.
#[derive(Debug)]
struct Sheet {
    side: usize,
    cells: Vec<Light>,
}

impl Sheet {
    /// A fine sheet, given by row and column, in coarser cells.
    fn lowered(scale: &Resampling, fine: impl Fn(usize, usize) -> Light + Sync) -> Self {
        let side = scale.down.len();
        let mut cells = vec![[0.0; LIGHT]; side * side];
        parallel::map_chunks(&mut cells, side, |row, out| {
            let (first, weights) = &scale.down[row];
            let mut line = vec![[0.0; LIGHT]; scale.fine];
            for (row, weight) in (*first..).zip(weights) {
                for (column, sum) in line.iter_mut().enumerate() {
                    add(sum, &fine(row, column), *weight);
                }
            }
            for (sum, (first, weights)) in out.iter_mut().zip(&scale.down) {
                weigh(sum, &line[*first..], weights);
            }
        });
        Self { side, cells }
    }

    /// The sum of Gaussians, (standard deviation, share) from the narrowest up, of the light on this sheet.
    /// Both are in a unit of which a cell has `cell`; `variance` is what the way here and back adds.
    fn glare(self, cell: f64, variance: f64, gaussians: &[(f64, f64)]) -> Self {
        let Some(((width, part), wider)) = gaussians.split_first() else {
            return Self { side: self.side, cells: vec![[0.0; LIGHT]; self.side * self.side] };
        };
        let sigma = (width * width - variance).max(0.0).sqrt() / cell;
        let mut own = self.blurred(sigma);
        let part = *part as f32;
        let coarser = wider.first().map(|_| {
            let scale = Resampling::new(self.side, if self.side > 1 { 2.0 } else { 1.0 });
            let sheet = Self::lowered(&scale, |row, column| self.cells[row * self.side + column]);
            let step = self.side as f64 / sheet.side as f64;
            let variance = variance + scale.variance() * cell * cell;
            Raised { light: sheet.glare(cell * step, variance, wider), scale }
        });
        for light in own.cells.iter_mut().flatten() {
            *light *= part;
        }
        if let Some(raised) = coarser {
            raised.rows(&mut own.cells, self.side, 1, |cell, light| {
                add(&mut cell[0], light, 1.0);
            });
        }
        own
    }

    /// Spread by a Gaussian of a standard deviation of `sigma` cells, along columns and along rows.
    fn blurred(&self, sigma: f64) -> Self {
        let weights = gaussian(sigma);
        let (side, reach) = (self.side, weights.len() / 2);
        let mut cells = vec![[0.0; LIGHT]; self.cells.len()];
        parallel::map_chunks(&mut cells, side, |row, out| {
            let mut wide = vec![[0.0; LIGHT]; side + 2 * reach];
            for (near, weight) in (row..).zip(&weights) {
                let line = &self.cells[mirrored(near, reach, side) * side..][..side];
                for (sum, light) in wide[reach..].iter_mut().zip(line) {
                    add(sum, light, *weight);
                }
            }
            for beyond in (0..reach).chain(side + reach..side + 2 * reach) {
                wide[beyond] = wide[reach + mirrored(beyond, reach, side)];
            }
            for (sum, near) in out.iter_mut().zip(wide.windows(weights.len())) {
                weigh(sum, near, &weights);
            }
        });
        Self { side, cells }
    }
}

/// A sheet to be laid on a finer one.
struct Raised {
    light: Sheet,
    scale: Resampling,
}

impl Raised {
    /// Hands each cell of the finer sheet, `size` numbers of a row of `length`, the light that lies on it.
    fn rows<T: Send>(
        &self,
        finer: &mut [T],
        length: usize,
        size: usize,
        lay: impl Fn(&mut [T], &Light) + Sync,
    ) {
        let coarse = self.light.side;
        parallel::map_chunks(finer, length, |row, cells| {
            let (first, weights) = &self.scale.up[row];
            let mut line = vec![[0.0; LIGHT]; coarse];
            for (j, weight) in (*first..).zip(weights) {
                for (sum, light) in line.iter_mut().zip(&self.light.cells[j * coarse..]) {
                    add(sum, light, *weight);
                }
            }
            for (cell, (first, weights)) in cells.chunks_exact_mut(size).zip(&self.scale.up) {
                let mut light = [0.0; LIGHT];
                weigh(&mut light, &line[*first..], weights);
                lay(cell, &light);
            }
        });
    }
}

/// The weights of a Gaussian over whole cells, which add up to 1.
fn gaussian(sigma: f64) -> Vec<f32> {
    let reach = (4.5 * sigma).ceil() as u32;
    let height = |i: u32| {
        let away = f64::from(i) - f64::from(reach);
        if sigma > 0.0 { libm::exp(-0.5 * (away / sigma).powi(2)) } else { 1.0 }
    };
    let sum: f64 = (0..=2 * reach).map(height).sum();
    (0..=2 * reach).map(|i| (height(i) / sum) as f32).collect()
}

fn add(sum: &mut Light, light: &Light, weight: f32) {
    for (sum, light) in sum.iter_mut().zip(light) {
        *sum += weight * light;
    }
}

fn weigh(sum: &mut Light, cells: &[Light], weights: &[f32]) {
    for (cell, weight) in cells.iter().zip(weights) {
        add(sum, cell, *weight);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A dark picture with one bright pixel.
    fn point(size_px: usize, row: usize, column: usize) -> Vec<f32> {
        let mut pixels = vec![0.0; size_px * size_px * CHANNELS];
        pixels[(row * size_px + column) * CHANNELS + 7] = 1000.0;
        pixels
    }

    fn channel(pixels: &[f32]) -> impl Iterator<Item = f64> {
        pixels.iter().skip(7).step_by(CHANNELS).map(|light| f64::from(*light))
    }

    #[test]
    fn all_light_is_kept() {
        for (size_px, radius_px) in [(1, 3.0), (7, 0.4), (64, 1.0), (97, 9.0), (120, 400.0)] {
            for place in [0, size_px / 3] {
                let mut pixels = point(size_px, place, size_px - 1);
                spread(&mut pixels, size_px, 0.5, radius_px);
                let sum: f64 = channel(&pixels).sum();
                assert!((sum / 1000.0 - 1.0).abs() < 1e-5, "{size_px} {radius_px}: {sum}");
            }
        }
    }

    #[test]
    fn even_light_stays_even() {
        let mut pixels = vec![1.0_f32; 83 * 83 * CHANNELS];
        spread(&mut pixels, 83, 0.4, 11.0);
        assert!(pixels.iter().all(|light| (light - 1.0).abs() < 1e-5));
    }

    #[test]
    fn a_point_becomes_the_stated_function() {
        let (size_px, radius_px) = (401, 8.0);
        for middle in [200, 203] {
            let mut pixels = point(size_px, middle, middle);
            spread(&mut pixels, size_px, 0.5, radius_px);
            let narrowest_px = radius_px / HALF_RADIUS;
            let stated = |r: f64| -> f64 {
                let gaussian = |(wide, part): (f64, f64)| {
                    let variance = (wide * narrowest_px).powi(2);
                    part * (-0.5 * r * r / variance).exp() / (2.0 * std::f64::consts::PI * variance)
                };
                500.0 * GAUSSIANS.into_iter().map(gaussian).sum::<f64>()
            };
            for (down, right) in [(0, 2), (3, 4), (8, 0), (9, 12), (30, 0), (28, 28), (0, 70)] {
                let at = ((middle + down) * size_px + middle + right) * CHANNELS + 7;
                let (got, want) =
                    (f64::from(pixels[at]), stated((down as f64).hypot(right as f64)));
                assert!((got / want - 1.0).abs() < 0.03, "{down} {right}: {got} {want}");
            }
        }
    }

    #[test]
    fn half_of_the_glare_falls_within_its_radius() {
        let (size_px, radius_px) = (301, 12.0);
        let mut pixels = point(size_px, 150, 150);
        spread(&mut pixels, size_px, 0.5, radius_px);
        let near =
            |i: usize| (i / size_px).abs_diff(150).pow(2) + (i % size_px).abs_diff(150).pow(2);
        let within: f64 = channel(&pixels)
            .enumerate()
            .filter(|(i, _)| near(*i) < 144)
            .map(|(_, light)| light)
            .sum();
        // Whole pixels make a disc of 437 in place of 452.
        assert!((within - 750.0).abs() < 10.0, "{within}");
    }

    #[test]
    fn texture_and_coverage_are_no_light() {
        let mut pixels = vec![0.0_f32; 9 * 9 * CHANNELS];
        pixels[40 * CHANNELS + 15] = 1.0;
        let before = pixels.clone();
        spread(&mut pixels, 9, 0.3, 2.0);
        assert_eq!(pixels, before);
    }
}
