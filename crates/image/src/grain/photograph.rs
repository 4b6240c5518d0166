//! The grain on a photograph: patches, Munsell hue, value and chroma, Hanning window, Fourier transform, band-pass
//! (the paper's section 4.3), and the power at each spatial frequency.

pub use crate::grain::crop::{Photograph, Samples};
pub use crate::grain::measuring::{Measuring, PhotographError};
use crate::grain::{
    crop::corners,
    measuring::{band, check, check_light, inside},
    patch::{Window, deviations},
    spectrum::GrainSpectrum,
    transform::Transform,
    waves::{Band, Sums, Waves},
};
use crate::parallel;

/// What a photograph's grain is found to be.
#[derive(Clone, Debug, PartialEq)]
pub struct Analysis {
    /// The mean over the patches.
    pub spectrum: GrainSpectrum,
    /// The paper's texture images, fading at the edges: patch by patch, row by row, hue, value and chroma.
    pub textures: Vec<f64>,
    /// Row and column of each patch's first pixel.
    pub corners: Vec<(usize, usize)>,
}

/// The grain's spectrum, the mean over all patches of the pearl that is found in the photograph.
///
/// # Errors
/// [`PhotographError`]: a photograph smaller than a patch or without a free one, or not of light, and limits that are
/// none.
pub fn measured(
    photograph: &Photograph<'_>,
    how: &Measuring,
) -> Result<GrainSpectrum, PhotographError> {
    let task = Task::new(photograph, how, None)?;
    let sums = parallel::map(task.corners.len(), |patch| Sums::of(&task.waves(patch), task.band));
    task.spectrum(&sums)
}

/// The same with the texture images, and with patches that may be given by their first pixels (row, column).
///
/// # Errors
/// As [`measured`], and for patches outside the photograph.
pub fn analysed(
    photograph: &Photograph<'_>,
    how: &Measuring,
    given: Option<&[(i64, i64)]>,
) -> Result<Analysis, PhotographError> {
    let task = Task::new(photograph, how, given)?;
    let found = parallel::map(task.corners.len(), |patch| {
        let waves = task.waves(patch);
        (Sums::of(&waves, task.band), task.texture(waves))
    });
    let (sums, textures): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    let spectrum = task.spectrum(&sums)?;
    Ok(Analysis { spectrum, textures: textures.concat(), corners: task.corners })
}

/// What the patches have in common.
struct Task<'a> {
    photograph: &'a Photograph<'a>,
    side: usize,
    patch_mm: f64,
    band: Band,
    corners: Vec<(usize, usize)>,
    window: Window,
    transform: Transform,
}

impl<'a> Task<'a> {
    fn new(
        photograph: &'a Photograph<'a>,
        how: &Measuring,
        given: Option<&[(i64, i64)]>,
    ) -> Result<Self, PhotographError> {
        let side = how.side_px;
        check(photograph, how)?;
        let patch_mm = how.mm_per_pixel.map_or(1.0, |scale| side as f64 * scale);
        let band = band(how, patch_mm)?;
        let corners = match given {
            Some(given) => inside(photograph, side, given)?,
            None => corners(photograph, side)?,
        };
        corners.iter().try_for_each(|&corner| check_light(photograph, corner, side))?;
        let (window, transform) = (Window::new(side), Transform::new(side));
        Ok(Self { photograph, side, patch_mm, band, corners, window, transform })
    }

    /// Hue, value and chroma of a patch.
    fn waves(&self, patch: usize) -> [Waves; 3] {
        let mut room = self.transform.room();
        deviations(self.photograph, self.corners[patch], self.side).map(|mut channel| {
            self.window.apply(&mut channel);
            Waves::of(&channel, self.band, &self.transform, &mut room)
        })
    }

    /// The picture that waves make, three numbers a pixel.
    fn texture(&self, waves: [Waves; 3]) -> Vec<f64> {
        let mut room = self.transform.room();
        let channels = waves.map(|waves| waves.channel(&self.transform, &mut room));
        let pixels = 0..self.side * self.side;
        pixels.flat_map(|i| [0, 1, 2].map(|channel| channels[channel][i])).collect()
    }

    fn spectrum(&self, of_patches: &[Sums]) -> Result<GrainSpectrum, PhotographError> {
        let mut sums = Sums::zero(self.band);
        for patch in of_patches {
            sums.add(patch);
        }
        let scale = self.patch_mm / of_patches.len() as f64 / (self.side as f64).powi(4);
        let density =
            [0, 1, 2].map(|channel| sums.power.iter().map(|ring| ring[channel] * scale).collect());
        let frequency = (0..sums.power.len()).map(|ring| ring as f64 / self.patch_mm).collect();
        Ok(GrainSpectrum::new(frequency, density, sums.correlation())?)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

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
        let grain =
            measured(&Photograph { width: 64, height: 64, rgb: Samples::Single(&rgb) }, &how)
                .unwrap();
        let value = &grain.density()[1];
        let peak = (0..value.len()).max_by(|&a, &b| value[a].total_cmp(&value[b])).unwrap();
        assert!((grain.cycles_per_mm()[peak] - 6.25).abs() < 1e-12);
    }
}
