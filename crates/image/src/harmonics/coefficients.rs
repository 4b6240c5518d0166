/// How many fields are summed together: hue, value and chroma.
pub const CHANNELS: usize = 3;

/// The coefficients `a_lm` (0 <= m <= l <= band limit) of three real fields.
#[derive(Clone, Debug)]
pub struct Coefficients {
    band_limit: usize,
    /// Column m after column m - 1, each from l = m up: the order in which the sums walk.
    values: Vec<[[f64; 2]; CHANNELS]>,
}

impl Coefficients {
    /// All coefficients zero.
    pub fn zero(band_limit: usize) -> Self {
        let count = (band_limit + 1) * (band_limit + 2) / 2;
        Self { band_limit, values: vec![[[0.0; 2]; CHANNELS]; count] }
    }

    /// The highest degree l.
    pub fn band_limit(&self) -> usize {
        self.band_limit
    }

    /// The (real, imaginary) coefficient of degree `l` and order `m` for each channel.
    ///
    /// The imaginary part at m = 0 has no meaning for a real field and is not used.
    pub fn at_mut(&mut self, l: usize, m: usize) -> &mut [[f64; 2]; CHANNELS] {
        let start = self.start(m);
        &mut self.values[start + l - m]
    }

    /// The coefficient, as [`Self::at_mut`].
    pub fn at(&self, l: usize, m: usize) -> [[f64; 2]; CHANNELS] {
        self.values[self.start(m) + l - m]
    }

    /// Adds as much of another field's waves as `amounts` says for each channel.
    pub fn add(&mut self, other: &Self, amounts: [f64; CHANNELS]) {
        for (sum, wave) in self.values.iter_mut().zip(&other.values) {
            for (channel, amount) in amounts.into_iter().enumerate() {
                sum[channel][0] += amount * wave[channel][0];
                sum[channel][1] += amount * wave[channel][1];
            }
        }
    }

    fn start(&self, m: usize) -> usize {
        m * (2 * self.band_limit + 3 - m) / 2
    }

    /// Column m for l = m..=top.
    pub(super) fn column(&self, m: usize, top: usize) -> &[[[f64; 2]; CHANNELS]] {
        let start = self.start(m);
        &self.values[start..=start + top - m]
    }
}
