//! Newton's equations of many stimuli, by conjugate gradients on the graph of pairs.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::{
    Counts, Model,
    likelihood::{Penalty, to_coefficients},
    model::centre,
};

/// Finds x in H x = b, where H is minus the second derivative of the log-likelihood: Hestenes and
/// Stiefel 1952, scaled by the diagonal. For models without a design, where H times a constant is 0
/// and x has mean 0. None if `tolerance`, relative, was not reached.
pub fn solve(
    model: &Model,
    counts: &Counts,
    bends: &[[f64; 3]],
    penalty: Option<&Penalty>,
    b: &[f64],
    tolerance: f64,
    stop: &AtomicBool,
) -> Option<Vec<f64>> {
    let system = System { model, counts, bends, penalty };
    let diagonal = system.diagonal(b.len());
    let scaled = |r: &[f64]| -> Vec<f64> { r.iter().zip(&diagonal).map(|(r, d)| r / d).collect() };
    let mut x = vec![0.0; b.len()];
    let mut residual = b.to_vec();
    // What rounding puts on a common shift of the values has no answer.
    let floating = if penalty.is_none() { counts.stimuli } else { 0 };
    centre(&mut residual[..floating]);
    let mut search = scaled(&residual);
    let mut energy = dot(&residual, &search);
    let enough = tolerance * tolerance * energy;
    for _ in 0..20 * b.len() + 1000 {
        if energy <= enough || stop.load(Ordering::Relaxed) {
            return Some(x);
        }
        let image = system.times(&search);
        let step = energy / dot(&search, &image);
        if !step.is_finite() {
            return None;
        }
        for i in 0..x.len() {
            x[i] += step * search[i];
            residual[i] -= step * image[i];
        }
        centre(&mut residual[..floating]);
        let next = scaled(&residual);
        let before = std::mem::replace(&mut energy, dot(&residual, &next));
        for i in 0..search.len() {
            search[i] = next[i] + energy / before * search[i];
        }
    }
    None
}

struct System<'a> {
    model: &'a Model,
    counts: &'a Counts,
    bends: &'a [[f64; 3]],
    penalty: Option<&'a Penalty>,
}

impl System<'_> {
    fn times(&self, x: &[f64]) -> Vec<f64> {
        let (order_at, ties_at) = self.places();
        let (order, width) = (order_at.map_or(0.0, |i| x[i]), ties_at.map_or(0.0, |i| x[i]));
        let mut image = vec![0.0; x.len()];
        let (mut order_sum, mut width_sum) = (0.0, 0.0);
        for (&pair, &[aa, cross, ss]) in self.counts.pairs.iter().zip(self.bends) {
            let lead = x[pair[0] as usize] - x[pair[1] as usize] + order;
            let along = aa * lead + cross * width;
            to_coefficients(self.model, pair, along, &mut image);
            order_sum += along;
            width_sum += cross * lead + ss * width;
        }
        if let Some(i) = order_at {
            image[i] = order_sum;
        }
        if let Some(i) = ties_at {
            image[i] = width_sum;
        }
        if let Some(penalty) = self.penalty {
            for i in 0..x.len() {
                image[i] += penalty.precision[i] * x[i];
            }
        }
        image
    }

    fn diagonal(&self, size: usize) -> Vec<f64> {
        let (order_at, ties_at) = self.places();
        let mut diagonal =
            self.penalty.map_or_else(|| vec![0.0; size], |penalty| penalty.precision.clone());
        for (&[left, right], &[aa, _, ss]) in self.counts.pairs.iter().zip(self.bends) {
            diagonal[left as usize] += aa;
            diagonal[right as usize] += aa;
            if let Some(i) = order_at {
                diagonal[i] += aa;
            }
            if let Some(i) = ties_at {
                diagonal[i] += ss;
            }
        }
        diagonal.iter_mut().filter(|d| **d <= 0.0).for_each(|d| *d = 1.0);
        diagonal
    }

    fn places(&self) -> (Option<usize>, Option<usize>) {
        (self.model.order_at(self.counts.stimuli), self.model.ties_at(self.counts.stimuli))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
