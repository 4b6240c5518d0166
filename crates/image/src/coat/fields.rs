//! Random fields over the sphere, smooth within a length, in bands about an axis where they shall be.
//!
//! Gaussian, correlation exp(-distance^2 / 2 length^2), by spherical harmonics as the grain's. One may go on from state to
//! state by a chaotic map of its waves.
//! Left out: anything finer; fields have no edges.

use std::f64::consts::PI;

use glam::DVec3;
use rand_chacha::ChaCha8Rng;
use rand_core::SeedableRng;

use crate::{
    grain::{
        level::{Level, Steep},
        normal::normal_pair,
    },
    harmonics::{CHANNELS, Coefficients, Place},
};

/// Three independent fields of mean 0 and variance 1.
#[derive(Debug)]
pub(crate) struct Fields {
    level: Level,
    steepness: [f64; CHANNELS],
}

/// Degrees that hold less than this share of a field's variance together are left out.
const LEAST: f64 = 1e-5;

/// The highest degree: features of 0.08 of the radius.
pub(crate) const TOP: usize = 80;

impl Fields {
    /// Fields that are alike within `length_rad`, seen from the centre; of `banding` from 0 to 1 a share of their
    /// variance depends on the distance from the pole alone.
    pub(crate) fn draw(length_rad: [f64; CHANNELS], banding: f64, seed: u64) -> Self {
        Self::drawn(length_rad, banding, seed, |pairs| pairs)
    }

    /// The next three states of the first of the fields that [`Self::draw`] gives for the same length, banding and seed.
    ///
    /// From one state to the next the phase of each wave doubles, which takes its part x, over its amplitude, to
    /// 2 x^2 - 1: the map of Ulam and von Neumann (1947), the logistic map at 4. States have one and the same variance and
    /// nothing in common; what two pearls differ by doubles (Lyapunov's exponent ln 2). Bands stay as they are.
    pub(crate) fn states(length_rad: f64, banding: f64, seed: u64) -> Self {
        Self::drawn([length_rad; CHANNELS], banding, seed, |pairs| {
            let mut state = pairs[0];
            pairs.map(|_| {
                state = doubled(state);
                state
            })
        })
    }

    /// Fields whose waves are what `made` makes of pairs of normal deviates, one for each field.
    fn drawn(
        length_rad: [f64; CHANNELS],
        banding: f64,
        seed: u64,
        made: impl Fn([[f64; 2]; CHANNELS]) -> [[f64; 2]; CHANNELS],
    ) -> Self {
        let shares = length_rad.map(shares);
        let top = shares.iter().map(Vec::len).max().unwrap_or(1);
        let mut random = ChaCha8Rng::from_seed(key(seed));
        let mut waves = Coefficients::zero(top);
        for l in 1..=top {
            let share = |c: usize| shares[c].get(l - 1).copied().unwrap_or(0.0);
            let alone: [f64; CHANNELS] =
                std::array::from_fn(|c| (4.0 * PI * share(c) / (2 * l + 1) as f64).sqrt());
            for m in 0..=l {
                let part = if m == 0 { 1.0 } else { std::f64::consts::FRAC_1_SQRT_2 };
                let even = part * (1.0 - banding).sqrt();
                let pairs = made(std::array::from_fn(|_| normal_pair(&mut random)));
                *waves.at_mut(l, m) =
                    std::array::from_fn(|c| pairs[c].map(|normal| even * alone[c] * normal));
            }
            // All of a degree's variance in the one wave that goes round without a change.
            let whole = (banding * (2 * l + 1) as f64).sqrt();
            let zonal = waves.at_mut(l, 0);
            for (c, wave) in zonal.iter_mut().enumerate() {
                wave[0] += whole * alone[c] * normal_pair(&mut random)[0];
            }
        }
        let steepness = shares.map(|shares| {
            let square = |(i, share): (usize, &f64)| share * ((i + 1) * (i + 2)) as f64;
            shares.iter().enumerate().map(square).sum::<f64>().sqrt()
        });
        Self { level: Level::synthesise(&waves, top), steepness }
    }

    /// Their values in a direction, and their gradients per radian.
    pub(crate) fn at(&self, direction: DVec3) -> Steep {
        self.level.with_gradient(direction, Place::towards(direction))
    }

    /// Root of the mean square of their gradients, per radian, over all seeds.
    pub(crate) fn steepness(&self) -> [f64; CHANNELS] {
        self.steepness
    }
}

/// A pair of normal deviates, its phase doubled.
fn doubled([x, y]: [f64; 2]) -> [f64; 2] {
    let amplitude = x.hypot(y).max(f64::MIN_POSITIVE);
    [(x * x - y * y) / amplitude, 2.0 * x * y / amplitude]
}

/// The share of the variance in each degree from 1 up.
fn shares(length_rad: f64) -> Vec<f64> {
    let share = |l: usize| {
        let l = l as f64;
        (2.0 * l + 1.0) * libm::exp(-0.5 * l * (l + 1.0) * length_rad * length_rad)
    };
    let mut shares: Vec<f64> = (1..=TOP).map(share).collect();
    let sum: f64 = shares.iter().sum();
    let mut beyond = 1.0;
    let last = shares.iter().position(|share| {
        beyond -= share / sum;
        beyond < LEAST
    });
    shares.truncate(last.map_or(TOP, |last| last + 1));
    let kept: f64 = shares.iter().sum();
    shares.iter().map(|share| share / kept).collect()
}

fn key(seed: u64) -> [u8; 32] {
    let mut key = *b"-------- nacreous coat's fields ";
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::direction::directions;

    const LENGTHS: [f64; 3] = [0.7, 0.3, 0.1];

    #[test]
    fn fields_have_variance_one_and_the_slopes_of_their_length() {
        let (mut variance, mut slopes) = ([0.0; 3], [0.0; 3]);
        let seeds = 40;
        for seed in 0..seeds {
            let fields = Fields::draw(LENGTHS, 0.3 * (seed % 3) as f64, seed);
            for (direction, share) in directions(12) {
                let here = fields.at(direction);
                let values = here.value.to_array().map(f64::from);
                let gradients = [0, 1, 2].map(|c| here.gradient(c));
                for c in 0..3 {
                    variance[c] += share * values[c] * values[c] / seeds as f64;
                    slopes[c] += share * gradients[c].length_squared() / seeds as f64;
                }
            }
        }
        let steepness = Fields::draw(LENGTHS, 0.0, 0).steepness();
        for c in 0..3 {
            assert!((variance[c] - 1.0).abs() < 0.25, "{variance:?}");
            assert!(
                (slopes[c] / steepness[c].powi(2) - 1.0).abs() < 0.2,
                "{slopes:?} {steepness:?}"
            );
            // Two dimensions, each 1 / length^2.
            assert!((steepness[c] * LENGTHS[c] / 2.0_f64.sqrt() - 1.0).abs() < 0.2);
        }
    }

    #[test]
    fn states_have_one_variance_and_nothing_in_common() {
        let (mut squares, mut products) = ([0.0; 4], [0.0; 3]);
        let seeds = 600;
        for seed in 0..seeds {
            let first = Fields::draw([0.3; 3], 0.0, seed);
            let states = Fields::states(0.3, 0.0, seed);
            for (direction, share) in directions(10) {
                let next = states.at(direction).value;
                let all = [first.at(direction).value[0], next[0], next[1], next[2]].map(f64::from);
                for i in 0..4 {
                    squares[i] += share * all[i] * all[i] / seeds as f64;
                }
                for i in 0..3 {
                    products[i] += share * all[i] * all[i + 1] / seeds as f64;
                }
            }
        }
        assert!(squares.iter().all(|square| (square - 1.0).abs() < 0.1), "{squares:?}");
        assert!(products.iter().all(|product| product.abs() < 0.06), "{products:?}");
    }

    #[test]
    fn what_two_waves_differ_by_doubles_from_state_to_state() {
        let mut pair = [[0.6, -0.8], [0.6 + 0.8e-6, -0.8 + 0.6e-6]];
        for step in 1..8 {
            pair = pair.map(doubled);
            let apart = (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1]);
            assert!((apart / (1e-6 * f64::from(1 << step)) - 1.0).abs() < 1e-3, "{step}: {apart}");
        }
    }

    #[test]
    fn bands_go_round_the_axis_without_a_change() {
        let fields = Fields::draw(LENGTHS, 1.0, 5);
        let at = |turn: f64| fields.at(DVec3::new(0.6 * turn.cos(), 0.6 * turn.sin(), 0.8)).value;
        let first = at(0.0);
        for step in 1..9 {
            let there = at(f64::from(step) * 0.7);
            assert!((0..3).all(|c| (there[c] - first[c]).abs() < 1e-3), "{first:?} {there:?}");
        }
    }

    #[test]
    fn gradients_are_those_of_the_values_at_poles_too() {
        let fields = Fields::draw(LENGTHS, 0.2, 9);
        let at =
            |direction: DVec3| fields.at(direction.normalize()).value.to_array().map(f64::from);
        for direction in [
            DVec3::Z,
            DVec3::new(0.019, 0.0, 1.0),
            DVec3::new(0.021, 0.003, -1.0),
            DVec3::new(0.5, -0.6, 0.3),
        ] {
            let direction = direction.normalize();
            let here = fields.at(direction);
            let (x, y) = direction.any_orthonormal_pair();
            for aside in [x, y, (x + y) / 2.0_f64.sqrt()] {
                let (there, back) = (at(direction + aside * 0.01), at(direction - aside * 0.01));
                for c in 0..3 {
                    let (law, found) = ((there[c] - back[c]) / 0.02, here.gradient(c).dot(aside));
                    let scale = fields.steepness()[c];
                    assert!((law - found).abs() < 0.03 * scale, "{direction} {c}: {law} {found}");
                }
            }
        }
    }
}
