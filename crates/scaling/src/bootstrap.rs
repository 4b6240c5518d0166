//! Bootstraps: the scale of answers drawn again, with replacement, from those that were given.
//!
//! Each sample has random numbers of its own, keyed by the seed and its place (`ChaCha8` has streams
//! for that), and starts from the fit to all answers, so neither threads nor order matter.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use rand_chacha::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};
use rand_distr::{Binomial, Distribution};
use rayon::prelude::*;

use crate::{
    Counts, Existence, Fit, Link, Model, ScalingError, counts::seen, existence::existence_of_seen,
    likelihood::Penalty, newton::climb, people::Ledger, spread,
};

/// What is drawn.
#[derive(Debug, Clone)]
pub enum Source {
    /// People, each with all answers.
    People(Ledger),
    /// Single answers, whoever gave them. Counts are whole numbers.
    Answers(Counts),
}

/// The scale of one sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Resampled {
    /// The stimuli's values, with mean 0.
    pub values: Vec<f64>,
    /// Their standard errors within the sample, people as clusters where people were drawn; empty if
    /// not asked for.
    pub se: Vec<f64>,
    /// Order effect, or 0.
    pub order: f64,
    /// Threshold or Davidson's ν, or 0.
    pub ties: f64,
    /// Whether the sample had a maximum of its own.
    pub placed: bool,
}

/// A bootstrap to be done.
pub struct Bootstrap<'a> {
    /// What is fitted.
    pub model: &'a Model,
    /// What is drawn from.
    pub source: &'a Source,
    /// The parameters of the fit to all answers.
    pub parameters: &'a [f64],
    /// How many samples.
    pub samples: usize,
    /// Same seed, same samples.
    pub seed: u64,
    /// Whether standard errors within samples are wanted.
    pub studentised: bool,
}

/// Samples that are drawn at once, so that answers are gone through once for all of them: of 1000 people
/// with 1770 answers each, the whole bootstrap takes half the time.
const LANES: usize = 8;

/// How far from the fit a sample without a maximum may lie, in z: see [`Bootstrap::leash`].
const LEASH: f64 = 3.0;

impl Bootstrap<'_> {
    /// All samples, on all threads. `done` counts them.
    ///
    /// # Errors
    /// [`ScalingError::Count`] for single answers of counts that are not whole numbers, else as
    /// [`crate::fit`].
    pub fn run(
        &self,
        stop: &AtomicBool,
        done: &AtomicUsize,
    ) -> Result<Vec<Resampled>, ScalingError> {
        let drawer = Drawer::of(self.source, self.model)?;
        let blocks: Result<Vec<Vec<Resampled>>, ScalingError> = (0..self.samples.div_ceil(LANES))
            .into_par_iter()
            .map_init(
                || drawer.empty(),
                |drawn, block| {
                    let samples = block * LANES..self.samples.min((block + 1) * LANES);
                    let mut randoms: Vec<_> = samples.map(|sample| self.random(sample)).collect();
                    drawer.draw(&mut randoms, drawn);
                    let fitted = drawn.each.iter().take(randoms.len()).map(|(counts, people)| {
                        let found = self.scale_of(counts, people, stop);
                        done.fetch_add(1, Ordering::Relaxed);
                        found
                    });
                    fitted.collect()
                },
            )
            .collect();
        Ok(blocks?.into_iter().flatten().collect())
    }

    /// The random numbers of one sample.
    fn random(&self, sample: usize) -> ChaCha8Rng {
        let mut key = *b"-------- nacreous bootstrap seed";
        key[..8].copy_from_slice(&self.seed.to_le_bytes());
        let mut random = ChaCha8Rng::from_seed(key);
        random.set_stream(sample as u64);
        random
    }

    fn scale_of(
        &self,
        counts: &Counts,
        people: &[u32],
        stop: &AtomicBool,
    ) -> Result<Resampled, ScalingError> {
        // Without a tie their most likely width is 0.
        let untied = self.model.ties && counts.totals()[2] == 0.0;
        let own = Model { ties: self.model.ties && !untied, ..self.model.clone() };
        let (model, n) = (if untied { &own } else { self.model }, counts.stimuli);
        let (fit, penalty, placed) = self.climbed(model, counts, stop)?;
        let se = match (self.studentised, self.source) {
            (false, _) => Vec::new(),
            (true, Source::People(ledger)) => {
                spread::by_people(model, counts, penalty.as_ref(), &fit, ledger, people)?
            }
            (true, Source::Answers(_)) => {
                spread::by_answers(model, counts, penalty.as_ref(), &fit)?
            }
        };
        let width = model.ties_at(n).map(|i| fit.parameters[i]);
        let ties = width.map_or(0.0, |s| if model.link == Link::Logit { libm::exp(s) } else { s });
        let order = model.order_at(n).map_or(0.0, |i| fit.parameters[i]);
        Ok(Resampled { values: fit.values, se, order, ties, placed })
    }

    /// The fit to a sample, what held it, and whether it had a maximum of its own.
    fn climbed(
        &self,
        model: &Model,
        counts: &Counts,
        stop: &AtomicBool,
    ) -> Result<(Fit, Option<Penalty>, bool), ScalingError> {
        let n = counts.stimuli;
        let start = self.parameters[..model.parameters(n)].to_vec();
        let prior = Penalty::of(model, n);
        if model.design.is_some() || existence_of_seen(model, counts) == Existence::Exists {
            match climb(model, counts, prior.as_ref(), start.clone(), stop) {
                Ok(fit) if !self.ran_away(&fit, model, n) => return Ok((fit, prior, true)),
                Err(ScalingError::Stopped) => return Err(ScalingError::Stopped),
                _ => {}
            }
        }
        let leash = self.leash(model, &start, prior.as_ref(), n);
        let fit = climb(model, counts, Some(&leash), start, stop)?;
        Ok((fit, Some(leash), false))
    }

    /// A design has no test for existence as cheap as a fit: what is farther apart than any answers
    /// could tell has none.
    fn ran_away(&self, fit: &Fit, model: &Model, n: usize) -> bool {
        let (low, high) = range(&fit.values);
        let (low_before, high_before) = range(&model.values(self.parameters, n));
        model.design.is_some() && high - low > 12.0 * self.unit() + 2.0 * (high_before - low_before)
    }

    /// What holds a sample without a maximum: a normal prior about the fit to all answers, so wide
    /// that what the sample does say, it says unhindered, and the rest goes as far as is plausible.
    ///
    /// Leaving such samples out, or drawing them again, would keep just those in which nobody
    /// disagreed out of the interval, and make it too short on the side that is open.
    fn leash(&self, model: &Model, centre: &[f64], prior: Option<&Penalty>, n: usize) -> Penalty {
        let (low, high) = range(&model.values(centre, n));
        let spread = LEASH * self.unit() + (high - low);
        let added = |i: usize| prior.map_or(0.0, |prior| prior.precision[i]);
        let precision = (0..centre.len()).map(|i| added(i) + 1.0 / (spread * spread)).collect();
        Penalty { centre: centre.to_vec(), precision }
    }

    fn unit(&self) -> f64 {
        if self.model.link == Link::Logit { 1.7 } else { 1.0 }
    }
}

fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::MAX, f64::MIN), |(low, high), &v| (low.min(v), high.max(v)))
}

/// Samples, drawn into again and again.
struct Drawn {
    /// Each one's counts, and how often each person is in it.
    each: Vec<(Counts, Vec<u32>)>,
    /// Of people's answers: the counts of all samples, [row][answer][sample].
    sums: Vec<[[f64; LANES]; 3]>,
}

/// Draws counts that the model sees, always for the same rows.
enum Drawer<'a> {
    People(&'a Ledger),
    Answers { counts: &'a Counts, seen: Counts, rows: Vec<u32>, model: &'a Model },
}

impl<'a> Drawer<'a> {
    fn of(source: &'a Source, model: &'a Model) -> Result<Self, ScalingError> {
        match source {
            Source::People(ledger) => Ok(Self::People(ledger)),
            Source::Answers(counts) => {
                let odd = |c: &&f64| c.fract() != 0.0 || **c > 9e15;
                if let Some(&bad) = counts.answers.iter().flatten().find(odd) {
                    return Err(ScalingError::OutOfRange {
                        quantity: "a count of which answers are drawn",
                        value: bad,
                        allowed: "whole numbers below 9e15",
                    });
                }
                let all = counts.seen_by(model);
                let place = |&pair: &[u32; 2]| {
                    let (pair, _) = seen(model, pair, [0.0; 3]);
                    all.pairs.binary_search(&pair).unwrap_or(usize::MAX) as u32
                };
                let rows = counts.pairs.iter().map(place).collect();
                Ok(Self::Answers { counts, seen: all, rows, model })
            }
        }
    }

    /// What to draw into.
    fn empty(&self) -> Drawn {
        let (one, rows) = match self {
            Self::People(ledger) => {
                ((ledger.counts.clone(), vec![0; ledger.people()]), ledger.counts.pairs.len())
            }
            Self::Answers { seen, .. } => ((seen.clone(), Vec::new()), 0),
        };
        Drawn { each: vec![one; LANES], sums: vec![[[0.0; LANES]; 3]; rows] }
    }

    /// As many samples as there are random numbers for.
    fn draw(&self, randoms: &mut [ChaCha8Rng], into: &mut Drawn) {
        match self {
            Self::People(ledger) => draw_people(ledger, randoms, into),
            Self::Answers { counts, rows, model, .. } => {
                for (random, (drawn, _)) in randoms.iter_mut().zip(&mut into.each) {
                    draw_answers(counts, rows, model, random, drawn);
                }
            }
        }
    }
}

/// People, each with all answers. Counts are whole or half, so their sums are exact in any order.
fn draw_people(ledger: &Ledger, randoms: &mut [ChaCha8Rng], into: &mut Drawn) {
    for (random, (_, people)) in randoms.iter_mut().zip(&mut into.each) {
        people.fill(0);
        for _ in 0..people.len() {
            // Of 2^64 equal numbers; the bias is below 1e-13 for a million people.
            let one = (u128::from(random.next_u64()) * people.len() as u128) >> 64;
            people[one as usize] += 1;
        }
    }
    into.sums.fill([[0.0; LANES]; 3]);
    for person in 0..ledger.people() {
        let mut times = [0.0; LANES];
        for (lane, (_, people)) in into.each.iter().enumerate().take(randoms.len()) {
            times[lane] = f64::from(people[person]);
        }
        for (row, answers) in ledger.of(person) {
            let sums = &mut into.sums[*row as usize];
            for (sum, answers) in sums.iter_mut().zip(answers).filter(|(_, count)| **count > 0.0) {
                for lane in 0..LANES {
                    sum[lane] += times[lane] * f64::from(*answers);
                }
            }
        }
    }
    for (lane, (counts, _)) in into.each.iter_mut().enumerate().take(randoms.len()) {
        for (answers, sums) in counts.answers.iter_mut().zip(&into.sums) {
            *answers = sums.map(|sum| sum[lane]);
        }
    }
}

/// Single answers, by the binomial distributions that make up the multinomial one.
fn draw_answers(
    counts: &Counts,
    rows: &[u32],
    model: &Model,
    random: &mut ChaCha8Rng,
    into: &mut Counts,
) {
    into.answers.fill([0.0; 3]);
    let mut left = counts.total();
    let mut to_draw = left as u64;
    for ((&pair, answers), &row) in counts.pairs.iter().zip(&counts.answers).zip(rows) {
        let drawn = answers.map(|count| {
            if count == 0.0 {
                return 0.0;
            }
            let share = (count / left).clamp(0.0, 1.0);
            left -= count;
            let one = Binomial::new(to_draw, share).map_or(0, |b| b.sample(random));
            to_draw -= one;
            one as f64
        });
        let (_, drawn) = seen(model, pair, drawn);
        if let Some(sum) = into.answers.get_mut(row as usize) {
            for k in 0..3 {
                sum[k] += drawn[k];
            }
        }
    }
}
