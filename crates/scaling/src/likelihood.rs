//! The log-likelihood of all counts with its slopes, and what a prior takes from it.

use rayon::prelude::*;

use crate::{
    Counts, Model,
    terms::{self, Terms},
};

/// Rows one thread takes at a time; also what is summed at a time, so that threads change no bit.
const AT_ONCE: usize = 4096;

/// A normal prior on the parameters.
#[derive(Debug, Clone)]
pub struct Penalty {
    /// Where each parameter is pulled to.
    pub centre: Vec<f64>,
    /// 1 / spread² of each; 0 where nothing pulls.
    pub precision: Vec<f64>,
}

impl Penalty {
    /// The model's own prior, if it has one.
    pub fn of(model: &Model, stimuli: usize) -> Option<Self> {
        let spread = model.prior?;
        let (all, pulled) = (model.parameters(stimuli), model.coefficients(stimuli));
        let precision = |i| if i < pulled { 1.0 / (spread * spread) } else { 0.0 };
        Some(Self { centre: vec![0.0; all], precision: (0..all).map(precision).collect() })
    }
}

/// The log-likelihood near some parameters.
pub struct Landscape {
    /// Without the prior.
    pub log_likelihood: f64,
    /// With it: what is maximised.
    pub height: f64,
    /// The slope along each parameter.
    pub gradient: Vec<f64>,
    /// Minus the second derivatives (aa, as, ss) of each row.
    pub bends: Vec<[f64; 3]>,
}

/// What the counts, as the model sees them, and the prior say at these parameters.
pub fn landscape(
    model: &Model,
    counts: &Counts,
    penalty: Option<&Penalty>,
    parameters: &[f64],
) -> Landscape {
    let terms = row_terms(model, counts, parameters);
    let log_likelihood = terms
        .chunks(AT_ONCE)
        .map(|part| part.iter().map(|terms| terms.value).sum::<f64>())
        .sum::<f64>();
    let mut gradient = vec![0.0; parameters.len()];
    for (&pair, terms) in counts.pairs.iter().zip(&terms) {
        to_parameters(model, counts.stimuli, pair, terms.slope, &mut gradient);
    }
    let mut height = log_likelihood;
    if let Some(penalty) = penalty {
        for (i, &value) in parameters.iter().enumerate() {
            let away = value - penalty.centre[i];
            height -= 0.5 * penalty.precision[i] * away * away;
            gradient[i] -= penalty.precision[i] * away;
        }
    }
    let bends = terms.iter().map(|terms| terms.bend).collect();
    Landscape { log_likelihood, height, gradient, bends }
}

/// What the parts of each slope would add to if they did not cancel: rounding may move the slope by
/// eps times that. At the top the slopes of answers do cancel; the roots of their squares do not.
pub fn gradient_scale(model: &Model, counts: &Counts, bends: &[[f64; 3]], size: usize) -> Vec<f64> {
    let n = counts.stimuli;
    let mut scale = vec![0.0; size];
    for ((&[left, right], answers), bend) in counts.pairs.iter().zip(&counts.answers).zip(bends) {
        let total: f64 = answers.iter().sum();
        let [lead, width] = [bend[0], bend[2]].map(|bend| (total * bend).sqrt());
        match &model.design {
            None => {
                scale[left as usize] += lead;
                scale[right as usize] += lead;
            }
            Some(design) => {
                let rows = design.row(left as usize).iter().zip(design.row(right as usize));
                for (sum, (x, y)) in scale.iter_mut().zip(rows) {
                    *sum += (x - y).abs() * lead;
                }
            }
        }
        if let Some(i) = model.order_at(n) {
            scale[i] += lead;
        }
        if let Some(i) = model.ties_at(n) {
            scale[i] += width;
        }
    }
    scale
}

/// The log-likelihood of counts, without constant terms and without a prior.
pub fn log_likelihood(model: &Model, counts: &Counts, parameters: &[f64]) -> f64 {
    landscape(model, &counts.seen_by(model), None, parameters).log_likelihood
}

/// Adds what a row says about its lead, and about the width of ties, to the parameters behind them.
pub fn to_parameters(
    model: &Model,
    stimuli: usize,
    pair: [u32; 2],
    [lead, width]: [f64; 2],
    into: &mut [f64],
) {
    to_coefficients(model, pair, lead, into);
    if let Some(i) = model.order_at(stimuli) {
        into[i] += lead;
    }
    if let Some(i) = model.ties_at(stimuli) {
        into[i] += width;
    }
}

/// The same for the coefficients alone.
pub fn to_coefficients(model: &Model, [left, right]: [u32; 2], lead: f64, into: &mut [f64]) {
    match &model.design {
        None => {
            into[left as usize] += lead;
            into[right as usize] -= lead;
        }
        Some(design) => {
            let rows = design.row(left as usize).iter().zip(design.row(right as usize));
            for (sum, (x, y)) in into.iter_mut().zip(rows) {
                *sum += (x - y) * lead;
            }
        }
    }
}

/// The lead of the left one in each pair, order effect included, and the width of ties.
pub fn leads(
    model: &Model,
    pairs: &[[u32; 2]],
    stimuli: usize,
    parameters: &[f64],
) -> (Vec<f64>, f64) {
    let values = match &model.design {
        None => parameters[..stimuli].to_vec(),
        Some(_) => model.values(parameters, stimuli),
    };
    let order = model.order_at(stimuli).map_or(0.0, |i| parameters[i]);
    let width = model.ties_at(stimuli).map_or(0.0, |i| parameters[i]);
    let lead = |&[left, right]: &[u32; 2]| values[left as usize] - values[right as usize] + order;
    (pairs.iter().map(lead).collect(), width)
}

fn row_terms(model: &Model, counts: &Counts, parameters: &[f64]) -> Vec<Terms> {
    let (leads, width) = leads(model, &counts.pairs, counts.stimuli, parameters);
    let of_row = |(row, &a): (&[f64; 3], &f64)| terms::of_counts(model, a, width, row);
    if leads.len() < 2 * AT_ONCE {
        return counts.answers.iter().zip(&leads).map(of_row).collect();
    }
    (&counts.answers, &leads).into_par_iter().with_min_len(AT_ONCE).map(of_row).collect()
}
