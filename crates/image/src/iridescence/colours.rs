//! Colours that a stack reflects, lets through, or shows by interference, by angle.
//!
//! Exact optics or the model of 1996, both by `nacreous-optics`; CIE XYZ.
//! Left out: the surface's facets, and columns that differ.

use std::sync::atomic::AtomicBool;

use nacreous_colour::{FIRST_NM, SAMPLES, WAVELENGTH_NM, xyz_from_spectrum};
use nacreous_nacre::LayerStack;
use nacreous_optics::{IlluminantModel, OpticsError, Polarisation, Precision, TransferModel};

use crate::iridescence::by_angle::ByAngle;

/// What each wavelength adds to X, Y and Z: illuminant times observer, from
/// [`nacreous_colour::Observer::weights`].
pub type Weights = [[f64; SAMPLES]; 3];

/// The colours, XYZ relative to the light, that a stack reflects and lets through, by the angle of
/// incidence; exact optics.
#[derive(Debug, Clone, PartialEq)]
pub struct Iridescence {
    /// White where everything comes back.
    pub reflected: ByAngle,
    /// White where everything goes in.
    pub transmitted: ByAngle,
}

/// Samples for each fringe that the whole stack draws at 400 nm; below it the eye sees next to nothing.
/// Fewer let fringes and samples beat, in colours that are not there.
const SAMPLES_PER_FRINGE: f64 = 5.0;
const FRINGES_AT_NM: f64 = 400.0;
/// Enough for 700 layers; the fringes of more are too weak and too many to matter much.
const MOST_SAMPLES_PER_NM: usize = 32;
/// Angles computed at a time, which bounds the memory.
const ANGLES: usize = 16;

impl Iridescence {
    /// On a grid of angles so fine that straight lines stay within CIEDE2000 0.2, and of wavelengths of
    /// 1 nm or less, so fine that fringes do not beat with it.
    ///
    /// `None` once `stop` is set.
    ///
    /// # Errors
    /// What [`TransferModel::energies`] refuses.
    ///
    /// ```
    /// use nacreous_colour::{Illuminant, Observer};
    /// use nacreous_image::Iridescence;
    /// use nacreous_nacre::{Index, LayerStack};
    /// let index = |n| Index::new("medium", n, 0.0);
    /// let (air, aragonite) = (index(1.0)?, index(1.53)?);
    /// let stack = LayerStack::new(vec![420.0; 50], 20.0, aragonite, index(1.43)?, air, aragonite)?;
    /// let weights = Observer::Cie1931.weights(&Illuminant::D65.spectrum())?;
    /// let colours = Iridescence::new(&stack, Default::default(), &weights, &Default::default())?.unwrap();
    /// let ([_, r, _], [_, t, _]) = (colours.reflected.at(0.9), colours.transmitted.at(0.9));
    /// assert!((r + t - 1.0).abs() < 1e-4); // nothing absorbs
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        stack: &LayerStack,
        polarisation: Polarisation,
        weights: &Weights,
        stop: &AtomicBool,
    ) -> Result<Option<Self>, OpticsError> {
        let precision = Precision::Single;
        let model = TransferModel { polarisation, precision, ..TransferModel::default() };
        let per_nm = samples_per_nm(stack)?;
        let last = (SAMPLES - 1) * per_nm;
        let fine_nm: Vec<f64> = (0..=last).map(|i| FIRST_NM + i as f64 / per_nm as f64).collect();
        let xyz = |row: &[f64]| xyz_from_spectrum(weights, &by_nm(row, per_nm));
        let tables = ByAngle::refined(white(weights), |cosines| {
            let mut colours = Vec::with_capacity(cosines.len());
            for some in cosines.chunks(ANGLES) {
                let angle_rad: Vec<f64> = some.iter().map(|cosine| libm::acos(*cosine)).collect();
                let Some(shares) = model.energies(stack, &angle_rad, &fine_nm, stop)? else {
                    return Ok(None);
                };
                let reflected = shares.reflectance().chunks(fine_nm.len()).map(xyz);
                let transmitted = shares.transmittance().chunks(fine_nm.len()).map(xyz);
                colours.extend(reflected.zip(transmitted).map(|(r, t)| [r, t]));
            }
            Ok(Some(colours))
        })?;
        Ok(tables.map(|[reflected, transmitted]| Self { reflected, transmitted }))
    }
}

/// The colours of nacre lit from within, XYZ by the view angle, the brightest with Y = 1: the model has no
/// scale of its own.
///
/// The steps are half as long as those of [`crate::Rings`]. The model ends each interference after a
/// whole layer, so that its colours jump, by about CIEDE2000 0.5 in grown nacre and by 5 where all layers are
/// equal; no grid is fine enough for a jump. Between jumps straight lines stay within 0.2. Wavelengths
/// are 1 nm apart: path differences end at the coherence length, so there are no finer fringes.
/// `None` once `stop` is set.
///
/// # Errors
/// What [`IlluminantModel::spectra`] refuses.
pub fn interference_colours(
    stack: &LayerStack,
    model: &IlluminantModel,
    weights: &Weights,
    stop: &AtomicBool,
) -> Result<Option<ByAngle>, OpticsError> {
    let steps = 2 * interference_steps(stack, model)?;
    let Some(spectra) = interference_spectra(stack, model, steps, stop)? else {
        return Ok(None);
    };
    let colours: Vec<_> = spectra.iter().map(|row| xyz_from_spectrum(weights, row)).collect();
    let brightest = colours.iter().map(|[_, y, _]| *y).fold(0.0, f64::max);
    let scale = if brightest > 0.0 { 1.0 / brightest } else { 0.0 };
    Ok(Some(ByAngle::new(colours).scaled(scale)))
}

/// Steps in the cosine of the view angle at the paper's coherence length. Between two of them the phase
/// of the longest path difference turns by 0.12 rad at most, so a straight line between them errs by
/// 0.2 % of a fringe.
const STEPS: f64 = 256.0;
const STEPS_FOR_COHERENCE_NM: f64 = 5000.0;
const MOST_STEPS: f64 = 4096.0;

/// Steps in the cosine of the view angle that the model of 1996 needs.
pub(crate) fn interference_steps(
    stack: &LayerStack,
    model: &IlluminantModel,
) -> Result<usize, OpticsError> {
    let n1 = stack.aragonite().at("aragonite", FRINGES_AT_NM)?.ordinary.n();
    let reach_nm = model.coherence_nm.min(2e3 * n1 * stack.total_um());
    Ok((STEPS * reach_nm / STEPS_FOR_COHERENCE_NM).clamp(STEPS, MOST_STEPS) as usize)
}

/// Its spectra at the cosines that [`ByAngle::cosines`] gives; `None` once `stop` is set.
pub(crate) fn interference_spectra(
    stack: &LayerStack,
    model: &IlluminantModel,
    steps: usize,
    stop: &AtomicBool,
) -> Result<Option<Vec<[f64; SAMPLES]>>, OpticsError> {
    let view_rad: Vec<f64> = ByAngle::cosines(steps).map(libm::acos).collect();
    let spectra = model.spectra_unless(stack, &view_rad, &WAVELENGTH_NM, stop)?;
    Ok(spectra.map(|table| table.as_chunks::<SAMPLES>().0.to_vec()))
}

/// XYZ of 1 at every wavelength.
fn white(weights: &Weights) -> [f64; 3] {
    weights.each_ref().map(|channel| channel.iter().sum())
}

fn samples_per_nm(stack: &LayerStack) -> Result<usize, OpticsError> {
    let n = stack.aragonite().at("aragonite", FRINGES_AT_NM)?.ordinary.n();
    let path_nm = 2e3 * n * stack.total_um();
    let fringes_per_nm = path_nm / (FRINGES_AT_NM * FRINGES_AT_NM);
    let wanted = (SAMPLES_PER_FRINGE * fringes_per_nm).ceil() as usize;
    Ok(wanted.clamp(1, MOST_SAMPLES_PER_NM))
}

/// A spectrum of `per_nm` samples a nm as one sample a nm, so that its integral against straight lines
/// between the weights stays the same: means weighted by triangles.
fn by_nm(fine: &[f64], per_nm: usize) -> [f64; SAMPLES] {
    let reach = per_nm - 1;
    std::array::from_fn(|sample| {
        let middle = sample * per_nm;
        let (from, to) = (middle.saturating_sub(reach), (middle + reach).min(fine.len() - 1));
        let weight = |i: usize| (per_nm - i.abs_diff(middle)) as f64;
        let sum: f64 = (from..=to).map(|i| weight(i) * fine[i]).sum();
        sum / (from..=to).map(weight).sum::<f64>()
    })
}

#[cfg(test)]
mod tests {
    use nacreous_colour::{Illuminant, Observer};

    use super::*;

    #[test]
    fn means_of_a_straight_line_are_the_line() {
        for per_nm in [1, 2, 7] {
            let fine: Vec<f64> =
                (0..=400 * per_nm).map(|i| 0.3 + 0.001 * i as f64 / per_nm as f64).collect();
            // The two ends have no sample beyond them.
            for (sample, mean) in by_nm(&fine, per_nm).iter().enumerate().skip(1).take(399) {
                assert!((mean - (0.3 + 0.001 * sample as f64)).abs() < 1e-12, "{per_nm} {sample}");
            }
        }
    }

    #[test]
    fn thicker_stacks_are_sampled_finer() {
        let stack = |layers| {
            let index = |n| nacreous_nacre::Index::new("medium", n, 0.0).unwrap();
            let (air, aragonite) = (index(1.0), index(1.53));
            LayerStack::new(vec![380.0; layers], 20.0, aragonite, index(1.43), air, aragonite)
                .unwrap()
        };
        assert_eq!([10, 100, 5000].map(|n| samples_per_nm(&stack(n)).unwrap()), [1, 4, 32]);
        let weights = Observer::Cie1931.weights(&Illuminant::D65.spectrum()).unwrap();
        let stop = AtomicBool::new(true);
        let stopped = Iridescence::new(&stack(10), Polarisation::S, &weights, &stop);
        assert_eq!(stopped, Ok(None));
    }
}
