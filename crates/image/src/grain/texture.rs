//! A seamless texture over the whole sphere, made from the spectrum of a patch.
//!
//! The paper (4.3) maps the filtered patch itself onto the pearl. A patch has edges and a sphere has
//! poles, so we draw instead **(ours)** an isotropic Gaussian random field that has the patch's
//! spectrum: every place and direction on the sphere is like every other, there is nothing to join.
//! Approximate: a flat patch's frequency f stands for the degree l + 1/2 = 2 pi f R of a sphere of
//! radius R, which is good to a part in l (flat-sky relation of cosmologists); phases are random, so
//! the stripes of terraces come out as short as their spectrum leaves them.

use crate::grain::level::Level;
use crate::grain::normal::normal_pair;
use crate::grain::spectrum::{GrainError, GrainSpectrum};
use crate::harmonics::{CHANNELS, Coefficients, Place};
use crate::parallel;
use glam::{DVec3, Vec3A};
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// The channel that is a surface's brightness, and its relief.
const VALUE: usize = 1;

/// The highest degree drawn: 20 cycles per mm on a pearl of 8 mm. What lies above is left out, and
/// [`Texture::lost_variance`] says how much that is.
pub const HIGHEST_DEGREE: usize = 512;

/// Deviations of hue (radians), value and chroma (relative) over a pearl, with mean 0.
///
/// ```
/// use glam::DVec3;
/// use nacreous_image::grain::{spectrum::GrainSpectrum, texture::Texture};
/// let texture = Texture::synthesise(&GrainSpectrum::procedural(), 1.0, 7, 0.0)?;
/// let [hue, value, chroma] = texture.at(DVec3::new(0.3, -0.2, 0.9), 0.0);
/// assert!(hue.abs() < 0.5 && value.abs() < 0.8 && chroma.abs() < 1.0);
/// # Ok::<(), nacreous_image::grain::spectrum::GrainError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Texture {
    /// The finest first; each next holds the lower half of the degrees. Shared, as they are large.
    levels: Arc<[Level]>,
    band_limit: usize,
    lost_variance: [f64; CHANNELS],
    /// Sum of the squares of the value's slopes in degrees up to each, per radian.
    steepness2: Vec<f64>,
}

/// A texture at a place, and how its value rises there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Relief {
    /// Hue, value and chroma.
    pub(crate) value: [f32; CHANNELS],
    pub(crate) gradient: DVec3,
    /// Share of the slopes' mean square that is seen.
    pub(crate) seen: f64,
}

impl Relief {
    /// Of a texture that is flat there.
    pub(crate) fn level(value: [f32; CHANNELS]) -> Self {
        Self { value, gradient: DVec3::ZERO, seen: 1.0 }
    }
}

impl Texture {
    /// Draws a texture for a pearl of `radius_mm`, without the levels that samples `footprint_rad` apart, and
    /// wider ones, never look at. Same seed, same bytes, on every machine.
    ///
    /// # Errors
    /// [`GrainError::Radius`] unless the radius is 0.1 to 100 mm.
    pub fn synthesise(
        spectrum: &GrainSpectrum,
        radius_mm: f64,
        seed: u64,
        footprint_rad: f64,
    ) -> Result<Self, GrainError> {
        if !(0.1..=100.0).contains(&radius_mm) {
            return Err(GrainError::Radius(radius_mm));
        }
        let circumference_mm = TAU * radius_mm;
        // Degree l holds the frequencies between l and l + 1 cycles round the pearl, so that no power
        // is lost between degrees. Degree 0, the mean, stays empty.
        let wanted = (spectrum.highest_frequency() * circumference_mm).ceil() as usize;
        let band_limit = wanted.saturating_sub(1).clamp(1, HIGHEST_DEGREE);
        let below = |channel, l| spectrum.variance_below(channel, l as f64 / circumference_mm);
        let share = |l| [0, 1, 2].map(|c| (below(c, l + 1) - below(c, l)).max(0.0));
        let shares: Vec<_> = (1..=band_limit).map(share).collect();
        let lost_variance = [0, 1, 2].map(|c| {
            let kept = below(c, band_limit + 1) - below(c, 1);
            (spectrum.variance(c) - kept).max(0.0)
        });
        let coefficients = draw(&shares, spectrum.mixing(), seed);
        let lowest = 1 + shares.iter().position(|s| s.iter().any(|&s| s > 0.0)).unwrap_or(0);
        let levels = (0..=HIGHEST_DEGREE.ilog2())
            .map(|k| band_limit >> k)
            .take_while(|&top| top >= lowest)
            // A level is looked at for what lies between it and the next, which is half as fine.
            .skip_while(|&top| top / 2 >= lowest && (top / 2) as f64 * footprint_rad > PI)
            .map(|top| Level::synthesise(&coefficients, top))
            .collect();
        let mut sum = 0.0;
        let steep = |(i, share): (usize, &[f64; CHANNELS])| {
            sum += share[VALUE] * ((i + 1) * (i + 2)) as f64;
            sum
        };
        let steepness2 = shares.iter().enumerate().map(steep).collect();
        Ok(Self { levels, band_limit, lost_variance, steepness2 })
    }

    /// The deviations of hue, value and chroma at `direction`, seen with samples `footprint_rad` apart.
    ///
    /// `direction` is finite, not zero, of any length; colatitude counts from +z, longitude from +x to
    /// +y. `footprint_rad` is the distance, as an angle at the pearl's centre, of neighbouring samples on
    /// its surface: detail that they cannot carry (degrees above pi / footprint) fades out, down to
    /// the mean 0. Give 0 for all detail.
    #[inline]
    pub fn at(&self, direction: DVec3, footprint_rad: f64) -> [f32; CHANNELS] {
        let place = Place::towards(direction);
        if footprint_rad * self.band_limit as f64 <= PI {
            return self.levels[0].at(place).to_array();
        }
        self.filtered(place, (PI / footprint_rad) as f32).to_array()
    }

    /// [`Self::at`], and the gradient of the value at `direction`, of mean square 1 in any one direction over all places and
    /// detail, with the share of that mean square that samples `footprint_rad` apart see.
    pub(crate) fn with_relief(&self, direction: DVec3, footprint_rad: f64) -> Relief {
        let whole = self.steepness2.last().copied().unwrap_or(0.0);
        if whole <= 0.0 {
            return Relief::level(self.at(direction, footprint_rad));
        }
        let degree = PI / footprint_rad.max(1e-9);
        let highest = degree.min(self.band_limit as f64) as usize;
        let seen = self.steepness2[highest.clamp(1, self.band_limit) - 1] / whole;
        let (finer, coarser, weight) = if footprint_rad * self.band_limit as f64 <= PI {
            (&self.levels[0], None, 1.0)
        } else {
            self.enclosing(degree as f32)
        };
        let place = Place::towards(direction);
        let fine = finer.with_gradient(direction, place);
        let (value, gradient) = if let Some(coarser) = coarser {
            let between = coarser.with_gradient(direction, place).towards(&fine, weight);
            (between.value, between.gradient(VALUE))
        } else {
            (weight * fine.value, fine.gradient(VALUE) * f64::from(weight))
        };
        Relief { value: value.to_array(), gradient: gradient * (2.0 / whole).sqrt(), seen }
    }

    /// A mixture of the two levels whose highest degrees enclose `degree`.
    fn filtered(&self, place: Place, degree: f32) -> Vec3A {
        let (finer, coarser, weight) = self.enclosing(degree);
        let base = coarser.map_or(Vec3A::ZERO, |level| level.at(place));
        base + weight * (finer.at(place) - base)
    }

    /// The two levels whose highest degrees enclose `degree`, and the share of the finer; where there is none below, the
    /// next would hold nothing but the mean.
    fn enclosing(&self, degree: f32) -> (&Level, Option<&Level>, f32) {
        let coarser = self.levels.iter().skip(1).position(|level| (level.top() as f32) <= degree);
        let finer = coarser.unwrap_or(self.levels.len() - 1);
        let (finer, coarser) = (&self.levels[finer], self.levels.get(finer + 1));
        let low = coarser.map_or(finer.top() / 2, Level::top) as f32;
        let weight = ((degree - low) / (finer.top() as f32 - low)).clamp(0.0, 1.0);
        (finer, coarser, weight)
    }

    /// The highest degree drawn.
    pub fn band_limit(&self) -> usize {
        self.band_limit
    }

    /// Variance of hue, value and chroma that the spectrum has and the texture has not.
    ///
    /// It lies in frequencies above the highest degree (512), and below one cycle round the pearl.
    pub fn lost_variance(&self) -> [f64; CHANNELS] {
        self.lost_variance
    }

    /// The finest grid: rows from pole to pole, twice as many columns, row-major.
    ///
    /// Row r lies at colatitude (r + 1/2) pi / rows, column c at longitude c pi / rows.
    pub fn rows(&self) -> usize {
        self.levels[0].rows()
    }

    /// The values on the finest grid.
    pub fn texels(&self) -> impl Iterator<Item = [f32; CHANNELS]> {
        self.levels[0].texels()
    }
}

/// Draws `a_lm` with variance `C_l`, where `shares` holds (2 l + 1) `C_l` / (4 pi) from l = 1 up.
///
/// Degree by degree, so that a finer texture keeps the coarser one's large features.
fn draw(
    shares: &[[f64; CHANNELS]],
    mixing: &[[f64; CHANNELS]; CHANNELS],
    seed: u64,
) -> Coefficients {
    let mut key = *b"-------- nacreous grain texture ";
    key[..8].copy_from_slice(&seed.to_le_bytes());
    let degree = |l: usize| {
        let mut random = ChaCha8Rng::from_seed(key);
        random.set_word_pos(WORDS_A_PLACE * places_below(l) as u128);
        let deviation = shares[l - 1].map(|s| (4.0 * PI * s / (2 * l + 1) as f64).sqrt());
        let place = |m: usize| {
            let normal: [_; CHANNELS] = std::array::from_fn(|_| normal_pair(&mut random));
            let part = if m == 0 { 1.0 } else { std::f64::consts::FRAC_1_SQRT_2 };
            let mixed =
                |c: usize, i: usize| (0..=c).map(|k| mixing[c][k] * normal[k][i]).sum::<f64>();
            std::array::from_fn(|c| [0, 1].map(|i| part * deviation[c] * mixed(c, i)))
        };
        (0..=l).map(place).collect::<Vec<_>>()
    };
    let mut coefficients = Coefficients::zero(shares.len());
    for (i, places) in parallel::map(shares.len(), |i| degree(i + 1)).into_iter().enumerate() {
        for (m, place) in places.into_iter().enumerate() {
            *coefficients.at_mut(i + 1, m) = place;
        }
    }
    coefficients
}

/// The stream's words for each degree and order: two numbers of 64 bits for each channel's pair.
const WORDS_A_PLACE: u128 = 4 * CHANNELS as u128;

/// Orders 0 to k of all degrees k from 1 to below l.
fn places_below(l: usize) -> usize {
    (l - 1) * (l + 2) / 2
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grain::spectrum::GrainSpectrum;

    /// A small pearl's texture: degrees up to 23.
    fn small(seed: u64) -> Texture {
        let frequency = vec![0.5, 1.0, 2.0, 3.6];
        let density = [0.01, 0.02, 0.03].map(|d| vec![0.0, d, d / 2.0, 0.0]);
        let correlation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.5], [0.0, 0.5, 1.0]];
        let spectrum = GrainSpectrum::new(frequency, density, correlation).unwrap();
        Texture::synthesise(&spectrum, 1.0, seed, 0.0).unwrap()
    }

    fn towards(colatitude: f64, longitude: f64) -> DVec3 {
        let (sin, cos) = colatitude.sin_cos();
        DVec3::new(sin * longitude.cos(), sin * longitude.sin(), cos)
    }

    #[test]
    fn same_seed_gives_the_same_bytes_on_every_machine() {
        let sum = |seed| {
            let bytes = small(seed).texels().flatten().collect::<Vec<_>>().into_iter();
            bytes.flat_map(f32::to_le_bytes).fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
                (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
            })
        };
        // The hash (FNV-1a) as first computed on x86-64 Linux.
        assert_eq!(sum(7), 0x7101_c665_1de1_c7ea);
        assert_ne!(sum(7), sum(8));
    }

    #[test]
    fn look_up_at_a_texel_gives_the_texel() {
        let texture = small(7);
        let rows = texture.rows();
        for (index, texel) in texture.texels().enumerate() {
            let (row, column) = (index / (2 * rows), index % (2 * rows));
            let step = PI / rows as f64;
            let seen = texture.at(towards((row as f64 + 0.5) * step, column as f64 * step), 0.0);
            for (a, b) in seen.into_iter().zip(texel) {
                assert!((a - b).abs() < 1e-4, "row {row}, column {column}: {a} for {b}");
            }
        }
    }

    #[test]
    fn what_is_left_out_is_not_missed() {
        let frequency = vec![0.5, 1.0, 8.0, 12.0];
        let density = [0.01, 0.02, 0.03].map(|d| vec![0.0, d, d, 0.0]);
        let unit = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let spectrum = GrainSpectrum::new(frequency, density, unit).unwrap();
        let whole = Texture::synthesise(&spectrum, 1.0, 3, 0.0).unwrap();
        for footprint_rad in [0.1, 0.2, 0.4] {
            let part = Texture::synthesise(&spectrum, 1.0, 3, footprint_rad).unwrap();
            assert!(part.levels.len() < whole.levels.len());
            for wider in [1.0, 1.7, 4.0] {
                let direction = towards(1.1, 0.4 * wider);
                let seen = |texture: &Texture| texture.at(direction, footprint_rad * wider);
                let error = seen(&part).into_iter().zip(seen(&whole)).map(|(a, b)| (a - b).abs());
                assert!(error.fold(0.0, f32::max) < 1e-7, "{footprint_rad} {wider}");
            }
        }
    }

    #[test]
    fn poles_and_date_line_are_crossed_without_a_step() {
        let texture = small(7);
        let tiny = 1e-5;
        let mut pairs = vec![];
        for i in 0..64 {
            let angle = f64::from(i) * PI / 32.0;
            for pole in [tiny, PI - tiny] {
                pairs.push((towards(pole, angle), towards(pole, angle + PI)));
            }
            let colatitude = angle / 2.0 + 0.01;
            pairs.push((towards(colatitude, PI - tiny), towards(colatitude, PI + tiny)));
            pairs.push((towards(colatitude, -tiny), towards(colatitude, tiny)));
        }
        for (here, there) in pairs {
            let (a, b) = (texture.at(here, 0.0), texture.at(there, 0.0));
            let step = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            assert!(step < 1e-4, "from {here} to {there}: {step}");
        }
    }

    #[test]
    fn relief_has_slopes_of_one_and_a_footprint_sees_the_share_it_states() {
        let textures: Vec<Texture> = (0..8).map(small).collect();
        let square = |footprint: f64| -> (f64, f64) {
            let places: Vec<DVec3> = (0..2000)
                .map(|i| towards((1.0 - f64::from(i) / 1000.0).acos(), f64::from(i)))
                .collect();
            let all = textures.iter().flat_map(|texture| {
                places.iter().map(|place| texture.with_relief(*place, footprint))
            });
            let count = (textures.len() * places.len()) as f64;
            let (mut sum, mut share) = (0.0, 0.0);
            for Relief { gradient, seen, .. } in all {
                (sum, share) = (sum + 0.5 * gradient.length_squared() / count, seen);
            }
            (sum, share)
        };
        assert!((square(0.0).0 - 1.0).abs() < 0.1, "{:?}", square(0.0));
        let (seen, stated) = square(0.3);
        assert!(seen < 0.8 && (seen - stated).abs() < 0.15, "{seen} {stated}");
    }

    #[test]
    fn far_samples_see_less_and_less_down_to_the_mean() {
        let texture = small(7);
        let power = |footprint| -> f32 {
            let places =
                (0..4000).map(|i| towards((1.0 - f64::from(i) / 2000.0).acos(), f64::from(i)));
            places.map(|place| texture.at(place, footprint)[1].powi(2)).sum()
        };
        let powers = [0.0, 0.1, 0.2, 0.4, 0.8, 1e6].map(power);
        assert!(powers[1] <= powers[0]);
        assert!(
            powers.windows(2).skip(1).all(|pair| pair[1] < pair[0] || pair[1] == 0.0),
            "{powers:?}"
        );
        assert!(powers[5] < 1e-9 * powers[0]);
    }
}
