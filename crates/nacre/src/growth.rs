use rand_chacha::{
    ChaCha8Rng,
    rand_core::{Rng, SeedableRng},
};

use crate::{MAX_LAYERS, NacreError, Season, error::within};

/// Twenty years, longer than any pearl oyster is kept.
const MAX_DAYS: u32 = 7305;

/// How nacre grows from seeding to harvest (paper, section 3.2.1).
///
/// On each day the oyster lays down a number of layers, each of some thickness. Both follow a bell
/// curve over the season, highest in summer, plus uniform noise. The paper gives the ranges 400 to
/// 700 nm and 1 to 3 layers a day; the widths of the noise are **(ours)**.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// Days from seeding to harvest, both counted.
    pub days: u32,
    /// When it is summer.
    pub season: Season,
    /// Thickness far from summer.
    pub thickness_winter_nm: f64,
    /// Thickness at the top of the bell.
    pub thickness_summer_nm: f64,
    /// Layers a day far from summer.
    pub layers_winter: f64,
    /// Layers a day at the top of the bell.
    pub layers_summer: f64,
    /// Half width of the uniform noise on each thickness.
    pub thickness_noise_nm: f64,
    /// Half width of the uniform noise on the number of layers a day, before rounding.
    pub layers_noise: f64,
}

/// One aragonite layer and the day on which it was laid down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deposit {
    /// Days since seeding.
    pub day: u32,
    /// Thickness of the layer.
    pub thickness_nm: f64,
}

/// What was laid down, in the order of growth: from the nucleus outward.
#[derive(Debug, Clone, PartialEq)]
pub struct Diary(Vec<Deposit>);

impl Growth {
    /// Grows the nacre, one day after the other. Same seed, same diary, on every platform.
    ///
    /// # Errors
    /// [`NacreError::OutOfRange`] or [`NacreError::NoiseTooLarge`] for parameters that cannot be,
    /// [`NacreError::LayerCount`] if no layer grew or more than [`MAX_LAYERS`].
    ///
    /// ```
    /// use nacreous_nacre::{Growth, Season};
    /// let growth = Growth {
    ///     days: 245,
    ///     season: Season { peak_day: 108.0, width_days: 45.0 },
    ///     thickness_winter_nm: 400.0,
    ///     thickness_summer_nm: 700.0,
    ///     layers_winter: 1.0,
    ///     layers_summer: 3.0,
    ///     thickness_noise_nm: 20.0,
    ///     layers_noise: 0.5,
    /// };
    /// let diary = growth.grow(7)?;
    /// assert_eq!(diary, growth.grow(7)?);
    /// assert_ne!(diary, growth.grow(8)?);
    /// # Ok::<(), nacreous_nacre::NacreError>(())
    /// ```
    pub fn grow(&self, seed: u64) -> Result<Diary, NacreError> {
        self.check()?;
        let mut noise = Noise::new(seed);
        let mut deposits = Vec::new();
        for day in 0..self.days {
            let warmth = self.season.warmth(f64::from(day));
            let rate = mix(self.layers_winter, self.layers_summer, warmth);
            let layers = libm::rint(rate + self.layers_noise * noise.uniform()).max(0.0) as usize;
            let bell_nm = mix(self.thickness_winter_nm, self.thickness_summer_nm, warmth);
            deposits.extend((0..layers).map(|_| Deposit {
                day,
                thickness_nm: bell_nm + self.thickness_noise_nm * noise.uniform(),
            }));
        }
        if (1..=MAX_LAYERS).contains(&deposits.len()) {
            Ok(Diary(deposits))
        } else {
            Err(NacreError::LayerCount(deposits.len()))
        }
    }

    fn check(&self) -> Result<(), NacreError> {
        let thickness = |name, value| within(name, value, 1.0..=1e5, "1 to 100000 nm");
        let a_day = |name, value| within(name, value, 0.0..=100.0, "0 to 100 layers a day");
        within("days", f64::from(self.days), 1.0..=f64::from(MAX_DAYS), "1 to 7305 days")?;
        within("peak_day", self.season.peak_day, -1e6..=1e6, "a finite number of days")?;
        within("season_days", self.season.width_days, 1.0..=1e6, "1 or more days")?;
        let winter_nm = thickness("thickness_winter_nm", self.thickness_winter_nm)?;
        let summer_nm = thickness("thickness_summer_nm", self.thickness_summer_nm)?;
        a_day("layers_winter", self.layers_winter)?;
        a_day("layers_summer", self.layers_summer)?;
        a_day("layers_noise", self.layers_noise)?;
        within("thickness_noise_nm", self.thickness_noise_nm, 0.0..=1e5, "0 to 100000 nm")?;
        let thinnest_nm = winter_nm.min(summer_nm);
        if self.thickness_noise_nm < thinnest_nm {
            Ok(())
        } else {
            Err(NacreError::NoiseTooLarge { noise_nm: self.thickness_noise_nm, thinnest_nm })
        }
    }
}

impl Diary {
    /// The layers in the order of growth.
    pub fn deposits(&self) -> &[Deposit] {
        &self.0
    }
}

/// From `winter` to `summer` as warmth goes from 0 to 1.
fn mix(winter: f64, summer: f64, warmth: f64) -> f64 {
    winter + (summer - winter) * warmth
}

/// Uniform noise whose values depend on the seed alone, not on platform or crate version: the seed
/// fills the `ChaCha` key directly.
struct Noise(ChaCha8Rng);

impl Noise {
    fn new(seed: u64) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        Self(ChaCha8Rng::from_seed(key))
    }

    /// In [-1, 1), on a grid of 2^-52.
    fn uniform(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * (2.0 / (1_u64 << 53) as f64) - 1.0
    }
}
