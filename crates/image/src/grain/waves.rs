//! The waves in a patch: the two-dimensional Fourier transform, band-pass, and the way back.
//!
//! A patch is real, so its waves come in pairs, of which one is kept. Two rows are transformed as one complex signal,
//! never two channels: what one channel has must not round into another that has nothing.

use crate::grain::transform::{Room, Transform};
use crate::harmonics::fourier::Signal;

/// A band in cycles per patch, its ends included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Band {
    pub low: f64,
    pub high: f64,
}

impl Band {
    /// Whether it has a wave: not the mean, whatever it begins with.
    fn holds(self, cycles: f64) -> bool {
        cycles > 0.0 && (self.low..=self.high).contains(&cycles)
    }
}

/// The waves of one channel, by cycles across from 0 up, and in each by cycles down as a transform orders them.
pub(super) struct Waves {
    side: usize,
    columns: Vec<Signal>,
}

impl Waves {
    /// Those of a channel that a band holds.
    pub(super) fn of(channel: &[f64], band: Band, transform: &Transform, room: &mut Room) -> Self {
        let side = channel.len().isqrt();
        let mut columns = vec![Signal::zero(side); (band.high as usize).min(side / 2) + 1];
        let mut pair = Signal::zero(side);
        for (at, rows) in channel.chunks(2 * side).enumerate() {
            let (first, second) = rows.split_at(side);
            pair.re.copy_from_slice(first);
            pair.im.fill(0.0);
            pair.im[..second.len()].copy_from_slice(second);
            transform.forward(&mut pair, room);
            for (k, column) in columns.iter_mut().enumerate() {
                let mirrored = (side - k) % side;
                let (re, im) = (pair.re[k], pair.im[k]);
                let (other_re, other_im) = (pair.re[mirrored], pair.im[mirrored]);
                let row = 2 * at;
                (column.re[row], column.im[row]) = (0.5 * (re + other_re), 0.5 * (im - other_im));
                if !second.is_empty() {
                    let values = (0.5 * (im + other_im), 0.5 * (other_re - re));
                    (column.re[row + 1], column.im[row + 1]) = values;
                }
            }
        }
        for (across, column) in columns.iter_mut().enumerate() {
            transform.forward(column, room);
            for down in (0..side).filter(|&down| !band.holds(cycles(side, across, down))) {
                (column.re[down], column.im[down]) = (0.0, 0.0);
            }
        }
        Self { side, columns }
    }

    /// The channel that these waves make, row by row.
    pub(super) fn channel(mut self, transform: &Transform, room: &mut Room) -> Vec<f64> {
        let side = self.side;
        for column in &mut self.columns {
            transform.inverse(column, room);
        }
        let mut channel = vec![0.0; side * side];
        let mut pair = Signal::zero(side);
        for (at, rows) in channel.chunks_mut(2 * side).enumerate() {
            pair.re.fill(0.0);
            pair.im.fill(0.0);
            let next = if rows.len() > side { 2 * at + 1 } else { 2 * at };
            for (k, column) in self.columns.iter().enumerate() {
                let (re, im) = (column.re[2 * at], column.im[2 * at]);
                let (next_re, next_im) = (column.re[next], column.im[next]);
                let mirrored = (side - k) % side;
                (pair.re[mirrored], pair.im[mirrored]) = (re + next_im, next_re - im);
                (pair.re[k], pair.im[k]) = (re - next_im, im + next_re);
            }
            transform.inverse(&mut pair, room);
            let (first, second) = rows.split_at_mut(side);
            for (rows, values) in [(first, &pair.re), (second, &pair.im)] {
                for (value, sum) in rows.iter_mut().zip(values) {
                    *value = sum / (side * side) as f64;
                }
            }
        }
        channel
    }
}

/// How often a wave goes up and down along a patch.
fn cycles(side: usize, across: usize, down: usize) -> f64 {
    let down = down.min(side - down);
    ((across * across + down * down) as f64).sqrt()
}

/// What is summed over the waves of hue, value and chroma.
pub(super) struct Sums {
    /// At 0, 1, 2 ... cycles per patch.
    pub power: Vec<[f64; 3]>,
    /// Of each channel with each.
    pub product: [[f64; 3]; 3],
}

impl Sums {
    /// Nothing, with room for a band.
    pub(super) fn zero(band: Band) -> Self {
        Self { power: vec![[0.0; 3]; band.high as usize + 3], product: [[0.0; 3]; 3] }
    }

    /// Of one patch. Each wave is shared by the two nearest rings, so that the integral of the broken line is the sum
    /// of all waves (Parseval).
    pub(super) fn of(waves: &[Waves; 3], band: Band) -> Self {
        let mut sums = Self::zero(band);
        let side = waves[0].side;
        for across in 0..waves[0].columns.len() {
            // Its mirror image has the same power.
            let times = if across == 0 || 2 * across == side { 1.0 } else { 2.0 };
            for down in 0..side {
                let cycles = cycles(side, across, down);
                if band.holds(cycles) {
                    let wave = |channel: usize| {
                        let column = &waves[channel].columns[across];
                        (column.re[down], column.im[down])
                    };
                    sums.count(cycles, [0, 1, 2].map(wave), times);
                }
            }
        }
        sums
    }

    fn count(&mut self, cycles: f64, wave: [(f64, f64); 3], times: f64) {
        let (inner, share) = (cycles as usize, cycles.fract());
        for a in 0..3 {
            for b in 0..3 {
                self.product[a][b] += times * (wave[a].0 * wave[b].0 + wave[a].1 * wave[b].1);
            }
            let power = times * (wave[a].0 * wave[a].0 + wave[a].1 * wave[a].1);
            self.power[inner][a] += power * (1.0 - share);
            self.power[inner + 1][a] += power * share;
        }
    }

    /// Together with those of another patch.
    pub(super) fn add(&mut self, other: &Self) {
        let ours = self.power.as_flattened_mut().iter_mut();
        ours.zip(other.power.as_flattened()).for_each(|(sum, value)| *sum += value);
        let ours = self.product.as_flattened_mut().iter_mut();
        ours.zip(other.product.as_flattened()).for_each(|(sum, value)| *sum += value);
    }

    /// Correlation of the channels over the whole band; of a flat channel 0.
    pub(super) fn correlation(&self) -> [[f64; 3]; 3] {
        let scale = [0, 1, 2].map(|channel| self.product[channel][channel].sqrt());
        let one = |a: usize, b: usize| {
            let known = scale[a] * scale[b];
            if a == b {
                1.0
            } else if known > 0.0 {
                self.product[a][b] / known
            } else {
                0.0
            }
        };
        [0, 1, 2].map(|a| [0, 1, 2].map(|b| one(a, b)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Noise without a pattern.
    fn noise(side: usize, seed: f64) -> Vec<f64> {
        (0..side * side).map(|i| libm::sin(seed + 12.9 * (i * i % 7919) as f64)).collect()
    }

    #[test]
    fn the_power_of_all_waves_is_that_of_the_patch_and_they_make_it_again() {
        for side in [8, 9, 30, 64, 65] {
            let transform = Transform::new(side);
            let mut room = transform.room();
            let all = Band { low: 0.0, high: side as f64 };
            let mut channel = noise(side, 1.0);
            let mean = channel.iter().sum::<f64>() / channel.len() as f64;
            for value in &mut channel {
                *value -= mean;
            }
            let mut of = || Waves::of(&channel, all, &transform, &mut room);
            let power = Sums::of(&[of(), of(), of()], all).product[0][1];
            let squares: f64 = channel.iter().map(|value| value * value).sum();
            assert!((power / (side * side) as f64 / squares - 1.0).abs() < 1e-13);
            let again = of().channel(&transform, &mut room);
            let far = again.iter().zip(&channel).map(|(one, other)| (one - other).abs());
            assert!(far.fold(0.0, f64::max) < 1e-14);
        }
    }

    #[test]
    fn a_channel_that_has_nothing_goes_with_no_other() {
        let transform = Transform::new(20);
        let mut room = transform.room();
        let band = Band { low: 2.0, high: 7.5 };
        let mut of = |channel: &[f64]| Waves::of(channel, band, &transform, &mut room);
        let waves = [of(&[0.0; 400]), of(&noise(20, 2.0)), of(&noise(20, 3.0))];
        let correlation = Sums::of(&waves, band).correlation();
        assert!(correlation[0][1] == 0.0 && correlation[0][2] == 0.0);
        assert!((0.0..1.0).contains(&correlation[1][2].abs()));
    }
}
