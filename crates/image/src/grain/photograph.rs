//! The grain on a photograph: patches, Munsell hue, value and chroma, Hanning window, Fourier transform, band-pass
//! (the paper's section 4.3), and the power at each spatial frequency.
//!
//! The same as `nacreous/texture.py` `analyse`, whose docstring has the choices; a test compares the two. Left out: the
//! paper's texture images themselves.

use std::f64::consts::{PI, TAU};

use nacreous_colour::hvc_from_rgb;
use thiserror::Error;

pub use crate::grain::crop::Photograph;
use crate::grain::{
    crop::{NoPatch, corners},
    spectrum::{GrainError, GrainSpectrum},
};

/// Below this mean chroma a patch counts as grey **(ours)**: relative deviations would be noise.
const GREY_CHROMA: f64 = 0.2;

/// How a photograph's grain is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measuring {
    /// Side of the patches, 8 to 1024.
    pub side_px: usize,
    /// Size of the photograph's pixels on the pearl; where left out, a patch counts as 1 mm.
    pub mm_per_pixel: Option<f64>,
    /// Lower limit of the band.
    pub low_per_mm: Option<f64>,
    /// Upper limit of the band.
    pub high_per_mm: Option<f64>,
}

/// Why a photograph's grain cannot be measured.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum PhotographError {
    /// Patches of a size that is not taken.
    #[error("texture: side_px is {0}; allowed: 8 to 1024")]
    Side(usize),
    /// Pixels without a sensible size.
    #[error("texture: mm_per_pixel is {0}; allowed: greater than 0")]
    Scale(f64),
    /// A photograph smaller than a patch.
    #[error(
        "texture: the photograph has {rows} x {columns} pixels; allowed: at least side_px = {side_px} each way"
    )]
    Small {
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
        /// A patch's side.
        side_px: usize,
    },
    /// Limits that are none.
    #[error(
        "texture: the band is {} to {} cycles per {unit}; allowed: 0 <= low < high <= {}",
        general(*low), general(*high), general(*highest)
    )]
    Band {
        /// The lower limit.
        low: f64,
        /// The upper one.
        high: f64,
        /// Half a cycle a pixel.
        highest: f64,
        /// mm, or patch.
        unit: &'static str,
    },
    /// No patch in the pearl that was found.
    #[error(transparent)]
    Patch(#[from] NoPatch),
    /// Numbers that are no spectrum.
    #[error(transparent)]
    Spectrum(#[from] GrainError),
}

/// Six digits, as Python's `:g` writes numbers of this kind.
fn general(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// The grain's spectrum, the mean over all patches of the pearl that is found in the photograph.
///
/// # Errors
/// [`PhotographError`]: a photograph smaller than a patch or without a free one, and limits that are none.
pub fn measured(
    photograph: &Photograph<'_>,
    how: &Measuring,
) -> Result<GrainSpectrum, PhotographError> {
    let side = how.side_px;
    if !(8..=1024).contains(&side) {
        return Err(PhotographError::Side(side));
    }
    if let Some(scale) = how.mm_per_pixel
        && !(scale > 0.0 && scale.is_finite())
    {
        return Err(PhotographError::Scale(scale));
    }
    let (rows, columns) = (photograph.height, photograph.width);
    if rows.min(columns) < side {
        return Err(PhotographError::Small { rows, columns, side_px: side });
    }
    let patch_mm = how.mm_per_pixel.map_or(1.0, |scale| side as f64 * scale);
    let found = corners(photograph, side)?;
    let band = band(how, patch_mm)?;
    let count = band.1 as usize + 3;
    let mut sums = Sums { power: vec![[0.0; 3]; count], product: [[0.0; 3]; 3] };
    let transform = Transform::new(side);
    for &corner in &found {
        let mut deviations = deviations(photograph, corner, side);
        window(&mut deviations, side);
        sums.add(&transform.of(&deviations, band.1), band.0);
    }
    let scale = patch_mm / found.len() as f64 / (side as f64).powi(4);
    let density =
        [0, 1, 2].map(|channel| sums.power.iter().map(|ring| ring[channel] * scale).collect());
    let frequency = (0..count).map(|ring| ring as f64 / patch_mm).collect();
    Ok(GrainSpectrum::new(frequency, density, correlation(&sums.product))?)
}

/// The limits in cycles per patch.
fn band(how: &Measuring, patch_mm: f64) -> Result<(f64, f64), PhotographError> {
    let highest = how.side_px as f64 / 2.0 / patch_mm;
    let low = how.low_per_mm.unwrap_or(2.0 / patch_mm);
    let high = how.high_per_mm.unwrap_or(0.75 * highest);
    if 0.0 <= low && low < high && high <= highest {
        return Ok((low * patch_mm, high * patch_mm));
    }
    let unit = if how.mm_per_pixel.is_some() { "mm" } else { "patch" };
    Err(PhotographError::Band { low, high, highest, unit })
}

/// Deviations from the patch's mean: hue in rad by chroma, value and chroma relative.
fn deviations(
    photograph: &Photograph<'_>,
    (top, left): (usize, usize),
    side: usize,
) -> Vec<[f64; 3]> {
    let pixel = |i: usize| hvc_from_rgb(photograph.at(top + i / side, left + i % side));
    let seen: Vec<_> = (0..side * side).map(pixel).collect();
    let mean = |of: &dyn Fn(usize) -> f64| (0..seen.len()).map(of).sum::<f64>() / seen.len() as f64;
    let along = mean(&|i| seen[i].chroma * libm::cos(seen[i].hue_rad));
    let beside = mean(&|i| seen[i].chroma * libm::sin(seen[i].hue_rad));
    let middle = libm::atan2(beside, along);
    let value = mean(&|i| seen[i].value).max(0.1);
    let chroma = mean(&|i| seen[i].chroma).max(GREY_CHROMA);
    let one = |hvc: &nacreous_colour::Hvc| {
        let turned = hvc.hue_rad - middle;
        let turned = turned - TAU * ((turned + PI) / TAU).floor();
        [turned * hvc.chroma / chroma, hvc.value / value - 1.0, hvc.chroma / chroma - 1.0]
    };
    seen.iter().map(one).collect()
}

/// Takes mean and slope away, and lays a Hanning window over the rest that keeps the variance.
fn window(deviations: &mut [[f64; 3]], side: usize) {
    let hanning: Vec<f64> =
        (0..side).map(|k| 0.5 - 0.5 * libm::cos(TAU * k as f64 / side as f64)).collect();
    let across = |k: usize| -1.0 + 2.0 * k as f64 / (side as f64 - 1.0);
    let place = |i: usize| [1.0, across(i / side), across(i % side)];
    let weight = |i: usize| hanning[i / side] * hanning[i % side];
    let mut normal = [[0.0; 3]; 3];
    let mut right = [[0.0; 3]; 3];
    let mut squares = 0.0;
    for (i, deviation) in deviations.iter().enumerate() {
        let (plane, weight) = (place(i), weight(i));
        squares += weight * weight;
        for row in 0..3 {
            for column in 0..3 {
                normal[row][column] += weight * plane[row] * plane[column];
                right[row][column] += weight * plane[row] * deviation[column];
            }
        }
    }
    // Weighted by the window, so that what the window leaves has neither mean nor slope.
    let slope = solved(normal, right);
    let keep = 1.0 / (squares / deviations.len() as f64).sqrt();
    for (i, deviation) in deviations.iter_mut().enumerate() {
        let (plane, weight) = (place(i), weight(i));
        for (channel, value) in deviation.iter_mut().enumerate() {
            let fitted: f64 = (0..3).map(|row| plane[row] * slope[row][channel]).sum();
            *value = (*value - fitted) * weight * keep;
        }
    }
}

/// Three equations with three right sides; the matrix is positive definite, so no pivot is zero.
fn solved(mut matrix: [[f64; 3]; 3], mut right: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    for pivot in 0..3 {
        for row in (0..3).filter(|&row| row != pivot) {
            let factor = matrix[row][pivot] / matrix[pivot][pivot];
            for column in 0..3 {
                matrix[row][column] -= factor * matrix[pivot][column];
                right[row][column] -= factor * right[pivot][column];
            }
        }
    }
    [0, 1, 2].map(|row| right[row].map(|value| value / matrix[row][row]))
}

/// A wave: its cycles per patch down and across, and its amplitude in each channel.
struct Wave {
    cycles: f64,
    amplitude: [[f64; 2]; 3],
}

/// The Fourier transform of a patch, of low frequencies only: photographs are measured once, not every frame.
struct Transform {
    side: usize,
    roots: Vec<[f64; 2]>,
}

impl Transform {
    fn new(side: usize) -> Self {
        let angle = |k: usize| -TAU * k as f64 / side as f64;
        let roots = (0..side).map(|k| [libm::cos(angle(k)), libm::sin(angle(k))]).collect();
        Self { side, roots }
    }

    /// All waves up to so many cycles.
    fn of(&self, patch: &[[f64; 3]], highest: f64) -> Vec<Wave> {
        let side = self.side;
        let most = (highest as usize).min(side / 2);
        let signed = |k: usize| if 2 * k < side { k as f64 } else { k as f64 - side as f64 };
        let low: Vec<usize> = (0..side).filter(|&k| signed(k).abs() <= most as f64).collect();
        let mut across = vec![[[0.0; 2]; 3]; side * low.len()];
        for row in 0..side {
            for (at, &k) in low.iter().enumerate() {
                let real = |column: usize| patch[row * side + column].map(|value| [value, 0.0]);
                across[row * low.len() + at] = self.sum(k, real);
            }
        }
        let mut waves = Vec::new();
        for &down in &low {
            for (at, &k) in low.iter().enumerate() {
                let cycles = signed(down).hypot(signed(k));
                if cycles > 0.0 && cycles <= highest {
                    let amplitude = self.sum(down, |row| across[row * low.len() + at]);
                    waves.push(Wave { cycles, amplitude });
                }
            }
        }
        waves
    }

    fn sum(&self, k: usize, value: impl Fn(usize) -> [[f64; 2]; 3]) -> [[f64; 2]; 3] {
        let mut sum = [[0.0; 2]; 3];
        for place in 0..self.side {
            let [c, s] = self.roots[k * place % self.side];
            for (sum, [re, im]) in sum.iter_mut().zip(value(place)) {
                sum[0] += re * c - im * s;
                sum[1] += re * s + im * c;
            }
        }
        sum
    }
}

/// What is summed over all waves of all patches.
struct Sums {
    power: Vec<[f64; 3]>,
    product: [[f64; 3]; 3],
}

impl Sums {
    /// Each wave is shared by the two nearest rings, so that the integral of the broken line is the sum of all waves
    /// (Parseval).
    fn add(&mut self, waves: &[Wave], low: f64) {
        for Wave { cycles, amplitude } in waves.iter().filter(|wave| wave.cycles >= low) {
            let (inner, share) = (*cycles as usize, cycles.fract());
            for a in 0..3 {
                let [re, im] = amplitude[a];
                let power = re * re + im * im;
                self.power[inner][a] += power * (1.0 - share);
                self.power[inner + 1][a] += power * share;
                for b in 0..3 {
                    self.product[a][b] += re * amplitude[b][0] + im * amplitude[b][1];
                }
            }
        }
    }
}

/// Correlation of hue, value and chroma over the whole band; of a flat channel 0.
fn correlation(product: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let scale = [0, 1, 2].map(|channel| product[channel][channel].sqrt());
    let one = |a: usize, b: usize| {
        let known = scale[a] * scale[b];
        if a == b {
            1.0
        } else if known > 0.0 {
            product[a][b] / known
        } else {
            0.0
        }
    };
    [0, 1, 2].map(|a| [0, 1, 2].map(|b| one(a, b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grating_is_found_at_its_frequency() {
        let rgb: Vec<f32> = (0..64 * 64)
            .flat_map(|i| {
                let wave = 0.5 + 0.05 * libm::cos(TAU * 8.0 * f64::from(i % 64) / 64.0);
                [0.9, 0.8, 0.75].map(|channel| (channel * wave) as f32)
            })
            .collect();
        let how = Measuring {
            side_px: 64,
            mm_per_pixel: Some(0.02),
            low_per_mm: None,
            high_per_mm: None,
        };
        let grain = measured(&Photograph { width: 64, height: 64, rgb: &rgb }, &how).unwrap();
        let value = &grain.density()[1];
        let peak = (0..value.len()).max_by(|&a, &b| value[a].total_cmp(&value[b])).unwrap();
        assert!((grain.cycles_per_mm()[peak] - 6.25).abs() < 1e-12);
    }
}
