//! Answers dealt anew to the people who gave them, pair by pair: what people who share one scale would
//! look like.
//!
//! Each deal has random numbers of its own, keyed by the seed and its place, so neither threads nor
//! order matter.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rand_chacha::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};
use rayon::prelude::*;

use crate::ScalingError;

/// What several people said of one pair, and may be dealt to each other.
#[derive(Debug, Clone, Copy)]
pub struct Stratum {
    /// The pair's stimuli: a value counts for the first and against the second.
    pub pair: [u32; 2],
    /// Where its values end; they begin where those of the one before end.
    pub end: usize,
}

/// Values to be dealt, and how the people who get them are compared.
pub struct Dealing {
    /// How many people there are.
    pub people: usize,
    /// How many stimuli there are.
    pub stimuli: usize,
    /// One after the other.
    pub strata: Vec<Stratum>,
    /// Who has each value; within a stratum everyone once.
    pub person: Vec<u32>,
    /// By how much each of them chose the first more often than all people together.
    pub value: Vec<f64>,
    /// The metric of people's slopes, axis by axis, each with a number for every stimulus.
    pub axes: Vec<Vec<f64>>,
    /// Same seed, same deals.
    pub seed: u64,
}

/// How far people differ: sums of squares over people, of all axes and of the first.
pub type Spread = [f64; 2];

/// Values in their present deal, people's slopes by stimulus, and room for one axis.
struct Hand {
    value: Vec<f64>,
    slopes: Vec<f64>,
    axis: Vec<f64>,
}

impl Dealing {
    /// The same, checked.
    ///
    /// # Errors
    /// [`ScalingError::Length`] and [`ScalingError::Index`] where tables do not fit each other.
    pub fn checked(self) -> Result<Self, ScalingError> {
        let expected = self.strata.last().map_or(0, |last| last.end);
        for (table, found) in [("person", self.person.len()), ("value", self.value.len())] {
            if found != expected {
                return Err(ScalingError::Length { table, found, expected });
            }
        }
        for axis in &self.axes {
            if axis.len() != self.stimuli {
                let (found, expected) = (axis.len(), self.stimuli);
                return Err(ScalingError::Length { table: "metric", found, expected });
            }
        }
        let stimuli = self.strata.iter().flat_map(|one| one.pair).max();
        let ends = self.strata.iter().map(|one| one.end as u32);
        let unsorted = ends.clone().zip(ends.skip(1)).find(|(one, next)| one > next);
        for (table, found, count) in [
            ("pairs", stimuli, self.stimuli),
            ("person", self.person.iter().copied().max(), self.people),
            ("ends", unsorted.map(|(one, _)| one), 0),
        ] {
            if let Some(found) = found.map(|found| found as usize).filter(|&found| found >= count) {
                return Err(ScalingError::Index {
                    table,
                    found,
                    most: i64::try_from(count).unwrap_or(i64::MAX) - 1,
                });
            }
        }
        Ok(self)
    }

    /// How far people differ as they are.
    #[must_use]
    pub fn as_they_are(&self) -> Spread {
        let mut hand = self.hand();
        for (at, _) in self.strata.iter().enumerate() {
            self.count(at, &mut hand);
        }
        self.spread(&mut hand)
    }

    /// How far they differ in each of so many deals, on all threads. `done` counts them.
    ///
    /// # Errors
    /// [`ScalingError::Stopped`] once `stop` is set.
    pub fn run(
        &self,
        deals: usize,
        stop: &AtomicBool,
        done: &AtomicUsize,
    ) -> Result<Vec<Spread>, ScalingError> {
        (0..deals)
            .into_par_iter()
            .map_init(
                || self.hand(),
                |hand, deal| {
                    if stop.load(Ordering::Relaxed) {
                        return Err(ScalingError::Stopped);
                    }
                    let found = self.dealt(deal, hand);
                    done.fetch_add(1, Ordering::Relaxed);
                    Ok(found)
                },
            )
            .collect()
    }

    fn hand(&self) -> Hand {
        Hand {
            value: self.value.clone(),
            slopes: vec![0.0; self.stimuli * self.people],
            axis: vec![0.0; self.people],
        }
    }

    fn dealt(&self, deal: usize, hand: &mut Hand) -> Spread {
        let mut key = *b"-------- nacreous answers' deals";
        key[..8].copy_from_slice(&self.seed.to_le_bytes());
        let mut random = ChaCha8Rng::from_seed(key);
        random.set_stream(deal as u64);
        // From the same beginning, for a deal must not hang on those before it on this thread.
        hand.value.copy_from_slice(&self.value);
        hand.slopes.fill(0.0);
        for at in 0..self.strata.len() {
            shuffle(&mut hand.value[self.begin(at)..self.strata[at].end], &mut random);
            self.count(at, hand);
        }
        self.spread(hand)
    }

    fn begin(&self, stratum: usize) -> usize {
        if stratum == 0 { 0 } else { self.strata[stratum - 1].end }
    }

    /// Add a stratum's values to the slopes of those who have them.
    fn count(&self, at: usize, hand: &mut Hand) {
        let (begin, Stratum { pair, end }) = (self.begin(at), self.strata[at]);
        let [first, second] = pair.map(|stimulus| stimulus as usize * self.people);
        for (&person, &value) in self.person[begin..end].iter().zip(&hand.value[begin..end]) {
            hand.slopes[first + person as usize] += value;
            hand.slopes[second + person as usize] -= value;
        }
    }

    fn spread(&self, hand: &mut Hand) -> Spread {
        let mut found = [0.0; 2];
        for (at, axis) in self.axes.iter().enumerate() {
            hand.axis.fill(0.0);
            for (slopes, &weight) in hand.slopes.chunks_exact(self.people).zip(axis) {
                for (sum, slope) in hand.axis.iter_mut().zip(slopes) {
                    *sum += weight * slope;
                }
            }
            let squares: f64 = hand.axis.iter().map(|sum| sum * sum).sum();
            found[0] += squares;
            if at == 0 {
                found[1] = squares;
            }
        }
        found
    }
}

/// Every order as likely as any other (Fisher and Yates 1938); none where all values are the same.
fn shuffle(values: &mut [f64], random: &mut ChaCha8Rng) {
    if values.iter().all(|value| value.to_bits() == values[0].to_bits()) {
        return;
    }
    for at in (1..values.len()).rev() {
        // Of 2^64 equal numbers; the bias is below 1e-13 for a million people.
        let other = (u128::from(random.next_u64()) * (at as u128 + 1)) >> 64;
        values.swap(at, other as usize);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three people and two pairs of three stimuli; the axes are the stimuli themselves.
    fn dealing(value: Vec<f64>) -> Dealing {
        Dealing {
            people: 3,
            stimuli: 3,
            strata: vec![Stratum { pair: [0, 1], end: 3 }, Stratum { pair: [1, 2], end: 6 }],
            person: vec![0, 1, 2, 0, 1, 2],
            value,
            axes: (0..3).map(|at| (0..3).map(|s| f64::from(u8::from(s == at))).collect()).collect(),
            seed: 1,
        }
    }

    fn deals(of: &Dealing, count: usize) -> Vec<Spread> {
        of.run(count, &AtomicBool::new(false), &AtomicUsize::new(0)).unwrap()
    }

    #[test]
    fn the_true_spread_is_the_sum_of_squared_slopes() {
        // Slopes: (1, 0, -1), (-1, 2, -1), (0, -2, 2).
        let found = dealing(vec![1.0, -1.0, 0.0, 1.0, 1.0, -2.0]).as_they_are();
        assert_eq!(found.map(f64::to_bits), [2.0 + 6.0 + 8.0_f64, 2.0].map(f64::to_bits));
    }

    #[test]
    fn every_deal_is_as_likely_as_any_other() {
        let found = deals(&dealing(vec![1.0, -1.0, 0.0, 1.0, -1.0, 0.0]), 6000);
        // The 6 ways to lay values y beside values x, by the sum of x² + (y - x)² + y².
        let mut times = std::collections::BTreeMap::new();
        for [whole, _] in found {
            *times.entry(whole as u64).or_insert(0.0) += 1.0;
        }
        let ways = [(4, 1.0), (6, 2.0), (10, 2.0), (12, 1.0)];
        assert_eq!(times.len(), ways.len());
        for (whole, many) in ways {
            let share: f64 = times[&whole] / 6000.0;
            assert!((share - many / 6.0).abs() < 0.03, "{whole}: {share}");
        }
    }

    #[test]
    fn deals_hang_on_seed_and_place_alone() {
        let of = dealing(vec![1.0, -1.0, 0.5, 1.0, -2.0, 0.25]);
        assert_eq!(deals(&of, 50)[..20], deals(&of, 20)[..]);
        let other = Dealing { seed: 2, ..dealing(of.value.clone()) };
        assert_ne!(deals(&of, 20), deals(&other, 20));
    }

    #[test]
    fn tables_that_do_not_fit_are_refused() {
        let good = || dealing(vec![0.0; 6]);
        assert!(good().checked().is_ok());
        let index = |of: Dealing| matches!(of.checked(), Err(ScalingError::Index { .. }));
        let length = |of: Dealing| matches!(of.checked(), Err(ScalingError::Length { .. }));
        assert!(length(Dealing { value: vec![0.0; 5], ..good() }));
        assert!(length(Dealing { stimuli: 4, ..good() }));
        assert!(index(Dealing { people: 2, ..good() }));
        let mut turned = good();
        turned.strata[0].end = 7;
        assert!(index(turned));
        let mut strange = good();
        strange.strata[0].pair = [0, 3];
        assert!(index(strange));
    }

    #[test]
    fn people_who_all_said_the_same_are_dealt_nothing_new() {
        let of = dealing(vec![0.5, 0.5, 0.5, -0.25, -0.25, -0.25]);
        let still = of.as_they_are().map(f64::to_bits);
        assert!(deals(&of, 5).iter().all(|found| found.map(f64::to_bits) == still));
    }
}
