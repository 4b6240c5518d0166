//! The grain of a pearl (kime-kan) as a spectrum: how much hue, value and chroma vary, and how finely.
//!
//! The paper (4.3) takes the high frequencies of a photograph by a two-dimensional Fourier transform.
//! We keep of them the power at each spatial frequency, averaged over all directions **(ours)**: what
//! a patch of 64 x 64 pixels knows about the whole sphere is its statistics, not its pixels. Phases and
//! the direction of the stripes are lost.

use crate::harmonics::CHANNELS;
use std::f64::consts::PI;
use thiserror::Error;

/// The most frequencies a spectrum may hold.
const MOST_FREQUENCIES: usize = 4096;
/// The highest density, per cycle per millimetre: far beyond any surface, far below overflow.
const HIGHEST_DENSITY: f64 = 1e6;

/// Why a grain cannot be used.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum GrainError {
    /// Too few or too many frequencies, or channels of another length.
    #[error(
        "grain spectrum: {channel} has {count} densities for {frequencies} frequencies; allowed: equally many, 2 to {MOST_FREQUENCIES}"
    )]
    Length {
        /// The channel that is wrong.
        channel: &'static str,
        /// Its number of densities.
        count: usize,
        /// The number of frequencies.
        frequencies: usize,
    },
    /// A frequency that is no number, negative, or not greater than the one before.
    #[error(
        "grain spectrum: cycles_per_mm[{index}] is {value}; allowed: 0 to 10000, each greater than the one before"
    )]
    Frequency {
        /// Which frequency.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A density that is no number, negative or absurdly high.
    #[error(
        "grain spectrum: density of {channel} at index {index} is {value}; allowed: 0 to {HIGHEST_DENSITY}"
    )]
    Density {
        /// The channel.
        channel: &'static str,
        /// Which density.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A matrix that is not a correlation matrix.
    #[error(
        "grain spectrum: correlation is {0:?}; allowed: symmetric, ones on the diagonal, no negative eigenvalue"
    )]
    Correlation([[f64; CHANNELS]; CHANNELS]),
    /// A band that is no part of the spectrum.
    #[error(
        "texture: the band is {low_per_mm} to {high_per_mm} cycles per mm; allowed: part of {first_per_mm} to {last_per_mm}"
    )]
    Band {
        /// Its lower limit.
        low_per_mm: f64,
        /// Its upper limit.
        high_per_mm: f64,
        /// The spectrum's first frequency.
        first_per_mm: f64,
        /// Its last.
        last_per_mm: f64,
    },
    /// A sphere without a sensible size.
    #[error("texture: radius_mm is {0}; allowed: 0.1 to 100")]
    Radius(f64),
}

/// Names of the channels, for messages.
const NAMES: [&str; CHANNELS] = ["hue", "value", "chroma"];

/// Radial power spectral densities of the texture in Munsell hue, value and chroma.
///
/// Hue varies in radians (weighted by chroma), value and chroma relative to their mean. The density of
/// a channel is piecewise linear between the given frequencies and zero outside; its integral over
/// frequency is the channel's variance: all power on the circle of radius f of the two-dimensional
/// spectrum P is in S(f) = 2 pi f P(f). The channels may be correlated, by the same amount at all
/// frequencies **(ours)**.
///
/// ```
/// use nacreous_image::grain::spectrum::GrainSpectrum;
/// let independent = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let band = vec![0.0, 0.01, 0.0];
/// let density = [band.clone(), band.clone(), band];
/// let grain = GrainSpectrum::new(vec![2.0, 4.0, 6.0], density, independent)?;
/// assert!((grain.variance(0) - 0.02).abs() < 1e-15);
/// # Ok::<(), nacreous_image::grain::spectrum::GrainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GrainSpectrum {
    cycles_per_mm: Vec<f64>,
    density: [Vec<f64>; CHANNELS],
    correlation: [[f64; CHANNELS]; CHANNELS],
    mixing: [[f64; CHANNELS]; CHANNELS],
}

impl GrainSpectrum {
    /// Checks and keeps a spectrum.
    ///
    /// # Errors
    /// [`GrainError`] for frequencies that do not increase, negative densities, unequal lengths, values
    /// that are no numbers, or a matrix that is not a correlation matrix.
    pub fn new(
        cycles_per_mm: Vec<f64>,
        density: [Vec<f64>; CHANNELS],
        correlation: [[f64; CHANNELS]; CHANNELS],
    ) -> Result<Self, GrainError> {
        let frequencies = cycles_per_mm.len();
        for (&channel, values) in NAMES.iter().zip(&density) {
            let count = values.len();
            if count != frequencies || !(2..=MOST_FREQUENCIES).contains(&frequencies) {
                return Err(GrainError::Length { channel, count, frequencies });
            }
            let wrong = |value: &f64| !(0.0..=HIGHEST_DENSITY).contains(value);
            if let Some(index) = values.iter().position(wrong) {
                return Err(GrainError::Density { channel, index, value: values[index] });
            }
        }
        for (index, &value) in cycles_per_mm.iter().enumerate() {
            let above = index == 0 || value > cycles_per_mm[index - 1];
            if !(above && (0.0..=1e4).contains(&value)) {
                return Err(GrainError::Frequency { index, value });
            }
        }
        let mixing = mixing(&correlation).ok_or(GrainError::Correlation(correlation))?;
        Ok(Self { cycles_per_mm, density, correlation, mixing })
    }

    /// A stand-in for pearls of which there is no photograph. **Not measured**: show it as "procedural".
    ///
    /// Chosen **(ours)**, by eye, for the look of an Akoya pearl of 8 mm at arm's length: terraces in
    /// irregular stripes some 0.3 mm wide. S(f) falls as f^-3 from 4 to 12 cycles per mm. A surface of
    /// sharp steps would fall as f^-2; nacre is translucent and blurs them. Below 4 the density ends in
    /// a cosine flank down to 2, which is what makes stripes and keeps clouds away; 12 is what a pearl
    /// 500 pixels wide can just show without aliasing, and the flank there begins at 10. Standard
    /// deviations: hue 0.06 rad, value 0.10, chroma 0.12, to be weighted by the grain knob. Value and
    /// chroma are correlated by -0.3, as a lighter place looks paler; hue goes its own way.
    pub fn procedural() -> Self {
        let (first, last, points) = (2.0, 12.0, 101);
        let deviation = [0.06, 0.10, 0.12];
        let frequency = |i: usize| first + (last - first) * i as f64 / (points - 1) as f64;
        let cycles_per_mm: Vec<f64> = (0..points).map(frequency).collect();
        let flank = |x: f64| 0.5 - 0.5 * libm::cos(PI * x.clamp(0.0, 1.0));
        let shape = |f: &f64| flank((f - first) / 2.0) * flank((last - f) / 2.0) / (f * f * f);
        let shape: Vec<f64> = cycles_per_mm.iter().map(shape).collect();
        let total = integral(&cycles_per_mm, &shape, f64::INFINITY);
        let scaled = |d: f64| shape.iter().map(|s| s * d * d / total).collect();
        let correlation = [[1.0, 0.0, 0.0], [0.0, 1.0, -0.3], [0.0, -0.3, 1.0]];
        let mixing = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -0.3, 0.91_f64.sqrt()]];
        Self { cycles_per_mm, density: deviation.map(scaled), correlation, mixing }
    }

    /// The part of the spectrum between two frequencies, as an ideal band-pass leaves it.
    ///
    /// # Errors
    /// [`GrainError::Band`] for limits in the wrong order, or a band outside the spectrum.
    ///
    /// ```
    /// use nacreous_image::grain::spectrum::GrainSpectrum;
    /// let (whole, part) = (GrainSpectrum::procedural(), GrainSpectrum::procedural().limited(3.0, 6.0)?);
    /// assert!(part.variance(0) < whole.variance(0));
    /// assert!(whole.limited(13.0, 15.0).is_err());
    /// # Ok::<(), nacreous_image::grain::spectrum::GrainError>(())
    /// ```
    pub fn limited(&self, low_per_mm: f64, high_per_mm: f64) -> Result<Self, GrainError> {
        let points = &self.cycles_per_mm;
        let (first_per_mm, last_per_mm) = (points[0], points[points.len() - 1]);
        let [from, to] =
            [low_per_mm, high_per_mm].map(|limit| limit.clamp(first_per_mm, last_per_mm));
        if !(low_per_mm < high_per_mm && from < to) {
            return Err(GrainError::Band { low_per_mm, high_per_mm, first_per_mm, last_per_mm });
        }
        let inner = points.iter().copied().filter(|point| (from < *point) && (*point < to));
        let cycles_per_mm: Vec<f64> = [from].into_iter().chain(inner).chain([to]).collect();
        let density = self.density.each_ref().map(|values| {
            cycles_per_mm.iter().map(|point| interpolated(points, values, *point)).collect()
        });
        Self::new(cycles_per_mm, density, self.correlation)
    }

    /// Frequencies, increasing.
    pub fn cycles_per_mm(&self) -> &[f64] {
        &self.cycles_per_mm
    }

    /// Densities of hue, value and chroma, per cycle per millimetre.
    pub fn density(&self) -> &[Vec<f64>; CHANNELS] {
        &self.density
    }

    /// Correlation matrix of hue, value and chroma.
    pub fn correlation(&self) -> &[[f64; CHANNELS]; CHANNELS] {
        &self.correlation
    }

    /// Lower triangular matrix that turns independent channels into correlated ones.
    pub(crate) fn mixing(&self) -> &[[f64; CHANNELS]; CHANNELS] {
        &self.mixing
    }

    /// The highest frequency that carries power, or 0.
    pub(crate) fn highest_frequency(&self) -> f64 {
        let power = |i: usize| self.density.iter().any(|density| density[i] > 0.0);
        let last = (0..self.cycles_per_mm.len()).rev().find(|&i| power(i));
        // The slope behind the last value that is not zero still carries power.
        last.map_or(0.0, |i| self.cycles_per_mm[(i + 1).min(self.cycles_per_mm.len() - 1)])
    }

    /// Variance of a channel (0 hue, 1 value, 2 chroma): the integral of its density.
    pub fn variance(&self, channel: usize) -> f64 {
        self.variance_below(channel, f64::INFINITY)
    }

    /// Variance of a channel in frequencies up to `cycles_per_mm`.
    pub fn variance_below(&self, channel: usize, cycles_per_mm: f64) -> f64 {
        integral(&self.cycles_per_mm, &self.density[channel], cycles_per_mm)
    }
}

/// A piecewise linear function at a place between its first point and its last.
fn interpolated(points: &[f64], values: &[f64], place: f64) -> f64 {
    let above = points.partition_point(|point| *point < place).min(points.len() - 1);
    if points[above].to_bits() == place.to_bits() || above == 0 {
        return values[above];
    }
    let slope = (values[above] - values[above - 1]) / (points[above] - points[above - 1]);
    values[above - 1] + slope * (place - points[above - 1])
}

/// Integral of a piecewise linear function from its first point to `upper`.
fn integral(points: &[f64], values: &[f64], upper: f64) -> f64 {
    let pairs = points.windows(2).zip(values.windows(2));
    pairs
        .take_while(|(point, _)| point[0] < upper)
        .map(|(point, value)| {
            let part = (upper.min(point[1]) - point[0]) / (point[1] - point[0]);
            let end = value[0] + part * (value[1] - value[0]);
            0.5 * (value[0] + end) * part * (point[1] - point[0])
        })
        .sum()
}

/// Cholesky's factor of a correlation matrix; None if it is not one.
fn mixing(r: &[[f64; CHANNELS]; CHANNELS]) -> Option<[[f64; CHANNELS]; CHANNELS]> {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-9;
    let symmetric = near(r[0][1], r[1][0]) && near(r[0][2], r[2][0]) && near(r[1][2], r[2][1]);
    if !symmetric || !(0..CHANNELS).all(|i| near(r[i][i], 1.0)) {
        return None;
    }
    let rest_value = 1.0 - r[0][1] * r[0][1];
    let shared = r[1][2] - r[0][1] * r[0][2];
    if rest_value < -1e-9 {
        return None;
    }
    let value = rest_value.max(0.0).sqrt();
    // Two channels that move as one leave nothing of the second for the third to share.
    let share = if value > 1e-6 { shared / value } else { 0.0 };
    let rest_chroma = 1.0 - r[0][2] * r[0][2] - share * share;
    let possible = rest_chroma >= -1e-6 && (value > 1e-6 || shared.abs() < 1e-6);
    let chroma = rest_chroma.max(0.0).sqrt();
    possible.then_some([[1.0, 0.0, 0.0], [r[0][1], value, 0.0], [r[0][2], share, chroma]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mixing_gives_the_correlation_back() {
        for (hv, hc, vc) in [(0.0, 0.0, 0.0), (0.3, -0.2, 0.8), (1.0, -1.0, -1.0), (0.0, 0.6, 0.8)]
        {
            let r = [[1.0, hv, hc], [hv, 1.0, vc], [hc, vc, 1.0]];
            let a = mixing(&r).unwrap();
            for i in 0..CHANNELS {
                for j in 0..CHANNELS {
                    let product: f64 = (0..CHANNELS).map(|k| a[i][k] * a[j][k]).sum();
                    assert!((product - r[i][j]).abs() < 1e-12);
                }
            }
        }
        for (hv, hc, vc) in
            [(1.1, 0.0, 0.0), (0.9, 0.9, -0.9), (1.0, 0.5, 0.4), (f64::NAN, 0.0, 0.0)]
        {
            assert_eq!(mixing(&[[1.0, hv, hc], [hv, 1.0, vc], [hc, vc, 1.0]]), None);
        }
    }

    #[test]
    fn procedural_grain_passes_its_own_check_and_has_the_stated_variances() {
        let grain = GrainSpectrum::procedural();
        for (channel, deviation) in [0.06, 0.10, 0.12].into_iter().enumerate() {
            assert!((grain.variance(channel).sqrt() - deviation).abs() < 1e-12);
        }
        let again = GrainSpectrum::new(
            grain.cycles_per_mm.clone(),
            grain.density.clone(),
            grain.correlation,
        );
        assert_eq!(again, Ok(grain));
    }

    #[test]
    fn variance_below_cuts_a_triangle_exactly() {
        let triangle = [vec![0.0, 1.0, 0.0], vec![0.0; 3], vec![0.0; 3]];
        let independent = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let grain = GrainSpectrum::new(vec![1.0, 2.0, 3.0], triangle, independent).unwrap();
        for (upper, area) in [(0.5, 0.0), (1.5, 0.125), (2.0, 0.5), (2.5, 0.875), (9.0, 1.0)] {
            assert!((grain.variance_below(0, upper) - area).abs() < 1e-15);
        }
    }
}
