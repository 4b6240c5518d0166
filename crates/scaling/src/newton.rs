//! The maximum of the likelihood, by Newton's method with step control.
//!
//! Both likelihoods are concave, so every step that goes up goes the right way, and near the top the
//! number of right digits doubles with each.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::{
    Counts, Link, Model, ScalingError,
    cholesky::Factor,
    conjugate,
    information::assembled,
    likelihood::{Landscape, Penalty, gradient_scale, landscape},
    model::centre,
    normal,
};

/// Above, the graph of pairs is cheaper than a dense matrix.
const DENSE: usize = 150;
/// Above, a dense matrix is too much where the graph of pairs fails.
const MOST_DENSE: usize = 3000;
/// Logit values of counts as uneven as 1e-300 need one step a unit.
const MOST_STEPS: usize = 2000;
/// Newton's decrement, squared, per answer, from which one more step ends in rounding.
const NEAR: f64 = 1e-18;

/// How far one step may move a value: beyond, all curves are flat.
const LONGEST: f64 = 6.0;

/// The most likely parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// Coefficients, order effect, width of ties, as the model has them.
    pub parameters: Vec<f64>,
    /// The stimuli's values, with mean 0.
    pub values: Vec<f64>,
    /// Without constant terms and without the prior.
    pub log_likelihood: f64,
    /// How many steps it took.
    pub steps: usize,
}

/// Fits a model to counts for which the maximum exists ([`crate::existence`]).
///
/// # Errors
/// [`ScalingError::NotConverged`], and [`ScalingError::Stopped`] if somebody asked for it.
pub fn fit(model: &Model, counts: &Counts, stop: &AtomicBool) -> Result<Fit, ScalingError> {
    let seen = counts.seen_by(model);
    let penalty = Penalty::of(model, seen.stimuli);
    climb(model, &seen, penalty.as_ref(), start(model, &seen), stop)
}

/// All stimuli alike, ties as wide as their share says.
fn start(model: &Model, seen: &Counts) -> Vec<f64> {
    let mut parameters = vec![0.0; model.parameters(seen.stimuli)];
    if let Some(i) = model.ties_at(seen.stimuli) {
        let [left, right, ties] = seen.totals();
        let share = (ties / (left + right + ties)).clamp(1e-6, 1.0 - 1e-6);
        parameters[i] = match model.link {
            // 2 Φ(τ) - 1 is the share; the slope of Φ at 0 is near enough for a start.
            Link::Probit => (0.5 * share / normal::density(0.0)).min(1.5),
            Link::Logit => libm::log(2.0 * share / (1.0 - share)),
        };
    }
    parameters
}

/// From some parameters to the top. `seen`: counts as the model sees them.
pub fn climb(
    model: &Model,
    seen: &Counts,
    penalty: Option<&Penalty>,
    mut parameters: Vec<f64>,
    stop: &AtomicBool,
) -> Result<Fit, ScalingError> {
    let ascent = Ascent { model, seen, penalty, stop };
    let mut here = landscape(model, seen, penalty, &parameters);
    let near = NEAR * seen.total().max(f64::MIN_POSITIVE);
    for steps in 1..=MOST_STEPS {
        if stop.load(Ordering::Relaxed) {
            return Err(ScalingError::Stopped);
        }
        let step = ascent.step(&here, 1e-3).ok_or(ScalingError::NotConverged(steps))?;
        let decrement: f64 = step.iter().zip(&here.gradient).map(|(s, g)| s * g).sum();
        // Where some counts are 1e12 times others, rounding alone keeps it from there.
        if decrement.abs() <= near || (steps > 100 && decrement.abs() <= 1e4 * near) {
            let last = ascent.step(&here, 1e-10).ok_or(ScalingError::NotConverged(steps))?;
            parameters = ascent.moved(&parameters, &last, 1.0);
            here = landscape(model, seen, penalty, &parameters);
            return ascent.ended(parameters, &here, steps);
        }
        (parameters, here) = ascent
            .risen(&parameters, &here, &step, decrement)
            .ok_or(ScalingError::NotConverged(steps))?;
    }
    Err(ScalingError::NotConverged(MOST_STEPS))
}

/// The x of matrix x = b, or, where rounding leaves the matrix flat along some direction, of one with
/// a larger diagonal: a shorter step, which still goes up.
fn solved(matrix: &[f64], b: &[f64]) -> Option<Vec<f64>> {
    let size = b.len();
    for ridge in [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 1.0] {
        let mut raised = matrix.to_vec();
        let most = (0..size).map(|i| matrix[i * size + i]).fold(0.0, f64::max);
        for i in 0..size {
            raised[i * size + i] += ridge * (matrix[i * size + i] + 1e-6 * most);
        }
        if let Some(factor) = Factor::of(raised, size) {
            let mut x = b.to_vec();
            factor.solve(&mut x);
            return Some(x);
        }
    }
    None
}

struct Ascent<'a> {
    model: &'a Model,
    seen: &'a Counts,
    penalty: Option<&'a Penalty>,
    stop: &'a AtomicBool,
}

impl Ascent<'_> {
    /// Whether a constant added to all values changes nothing.
    fn floats(&self) -> bool {
        self.model.design.is_none() && self.penalty.is_none()
    }

    /// Newton's step; none if the equations have no solution.
    fn step(&self, here: &Landscape, tolerance: f64) -> Option<Vec<f64>> {
        let mut step = self.raw_step(here, tolerance)?;
        if self.model.design.is_none() {
            // Its mean is 0 but for rounding, which a weak prior would blow up.
            centre(&mut step[..self.seen.stimuli]);
        }
        Some(step)
    }

    fn raw_step(&self, here: &Landscape, tolerance: f64) -> Option<Vec<f64>> {
        let size = here.gradient.len();
        if self.model.design.is_none() && size > DENSE {
            let (bends, b) = (&here.bends, &here.gradient);
            let found = conjugate::solve(
                self.model,
                self.seen,
                bends,
                self.penalty,
                b,
                tolerance,
                self.stop,
            );
            if found.is_some() || size > MOST_DENSE {
                return found;
            }
        }
        let matrix = assembled(self.model, self.seen, &here.bends, self.penalty);
        if !self.floats() {
            return solved(&matrix, &here.gradient);
        }
        // The first stimulus stays: what is left is as well conditioned as the data.
        let rest: Vec<f64> =
            matrix.chunks(size).skip(1).flat_map(|row| &row[1..]).copied().collect();
        let mut step = solved(&rest, &here.gradient[1..])?;
        step.insert(0, 0.0);
        Some(step)
    }

    fn moved(&self, parameters: &[f64], step: &[f64], share: f64) -> Vec<f64> {
        let mut moved: Vec<f64> =
            parameters.iter().zip(step).map(|(value, step)| value + share * step).collect();
        if self.floats() {
            centre(&mut moved[..self.seen.stimuli]);
        }
        moved
    }

    /// Along the step, halved until it goes up; none if it never does.
    fn risen(
        &self,
        parameters: &[f64],
        here: &Landscape,
        step: &[f64],
        decrement: f64,
    ) -> Option<(Vec<f64>, Landscape)> {
        let mut share = self.longest(parameters, step);
        let rounding = 1e-13 * here.height.abs();
        for _ in 0..60 {
            let there = self.moved(parameters, step, share);
            let view = landscape(self.model, self.seen, self.penalty, &there);
            if view.height >= here.height + 1e-4 * share * decrement - rounding {
                return Some((there, view));
            }
            share *= 0.5;
        }
        None
    }

    /// The share of a step that leaves a probit threshold above 0 and lands where the likelihood
    /// still bends.
    fn longest(&self, parameters: &[f64], step: &[f64]) -> f64 {
        let most = match &self.model.design {
            None => step.iter().fold(LONGEST, |most, part| part.abs().max(most)),
            Some(_) => LONGEST,
        };
        match self.model.ties_at(self.seen.stimuli) {
            Some(i) if self.model.link == Link::Probit && parameters[i] + step[i] <= 0.0 => {
                (0.9 * parameters[i] / -step[i]).min(LONGEST / most)
            }
            _ => LONGEST / most,
        }
    }

    fn ended(
        &self,
        parameters: Vec<f64>,
        here: &Landscape,
        steps: usize,
    ) -> Result<Fit, ScalingError> {
        let mut scale = gradient_scale(self.model, self.seen, &here.bends, parameters.len());
        if let Some(penalty) = self.penalty {
            for (i, sum) in scale.iter_mut().enumerate() {
                *sum += penalty.precision[i] * (1.0 + (parameters[i] - penalty.centre[i]).abs());
            }
        }
        // Rounding of the largest counts reaches all slopes. Also false for what is no number.
        let rounding = 1e-15 * scale.iter().copied().fold(0.0, f64::max);
        let slopes = here.gradient.iter().zip(&scale);
        let flat = slopes.into_iter().all(|(g, scale)| g.abs() <= 1e-8 * scale + rounding);
        if !flat || self.stop.load(Ordering::Relaxed) {
            return Err(if flat {
                ScalingError::Stopped
            } else {
                ScalingError::NotConverged(steps)
            });
        }
        let values = self.model.values(&parameters, self.seen.stimuli);
        Ok(Fit { parameters, values, log_likelihood: here.log_likelihood, steps })
    }
}
