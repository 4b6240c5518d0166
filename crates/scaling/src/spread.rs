//! Standard errors within one sample of a bootstrap.

use crate::{
    Counts, Fit, Model, Outcome, ScalingError,
    cholesky::Factor,
    information::assembled,
    likelihood::{Penalty, landscape, leads, to_parameters},
    people::Ledger,
    terms,
};

/// Of the values, with people as clusters (Liang and Zeger 1986), each `people[i]` times there.
pub fn by_people(
    model: &Model,
    counts: &Counts,
    penalty: Option<&Penalty>,
    fit: &Fit,
    ledger: &Ledger,
    people: &[u32],
) -> Result<Vec<f64>, ScalingError> {
    let n = counts.stimuli;
    let bread = Bread::of(model, counts, penalty, fit)?;
    let size = fit.parameters.len();
    let scores = Scores::of(model, counts, &fit.parameters);
    // The sum of the products of each person's slopes: of millions of answers it costs least.
    let mut meat = vec![0.0; size * size];
    let mut score = vec![0.0; size];
    for (person, &times) in people.iter().enumerate().filter(|(_, times)| **times > 0) {
        scores.put(ledger.of(person), &mut score);
        for (row, &one) in meat.chunks_exact_mut(size).zip(&score) {
            let one = f64::from(times) * one;
            row.iter_mut().zip(&score).for_each(|(sum, other)| *sum += one * other);
        }
    }
    let moved: Vec<Vec<f64>> =
        meat.chunks_exact(size).map(|row| model.values(&bread.solved(row), n)).collect();
    let variance = (0..n).map(|i| {
        let row: Vec<f64> = moved.iter().map(|of| of[i]).collect();
        model.values(&bread.solved(&row), n)[i].max(0.0)
    });
    let all = people.len() as f64;
    Ok(variance.map(|sum| (sum * all / (all - 1.0)).sqrt()).collect())
}

/// What each answer says about the parameters.
struct Scores<'a> {
    model: &'a Model,
    counts: &'a Counts,
    /// Slopes of a row's answers by its lead and by the width of ties.
    slopes: Vec<[[f64; 2]; 3]>,
    /// Whether there is nothing but leads of single stimuli: then millions of answers take less
    /// than half the time.
    plain: bool,
}

impl<'a> Scores<'a> {
    fn of(model: &'a Model, counts: &'a Counts, parameters: &[f64]) -> Self {
        let (leads, width) = leads(model, &counts.pairs, counts.stimuli, parameters);
        let slope = |a, outcome| terms::of_outcome(model, a, width, outcome).slope;
        let slopes = leads.iter().map(|&a| Outcome::ALL.map(|outcome| slope(a, outcome))).collect();
        let plain = model.design.is_none() && !model.order && !model.ties;
        Self { model, counts, slopes, plain }
    }

    /// The slopes of the log-likelihood of one person's answers.
    fn put(&self, answers: &[(u32, [f32; 3])], into: &mut [f64]) {
        into.fill(0.0);
        for &(row, answers) in answers {
            let row = row as usize;
            let (each, pair) = (&self.slopes[row], self.counts.pairs[row]);
            let sum = |k: usize| (0..3).map(|o| f64::from(answers[o]) * each[o][k]).sum::<f64>();
            if self.plain {
                let slope = sum(0);
                into[pair[0] as usize] += slope;
                into[pair[1] as usize] -= slope;
            } else {
                to_parameters(self.model, self.counts.stimuli, pair, [sum(0), sum(1)], into);
            }
        }
    }
}

/// Of the values, by observed information.
pub fn by_answers(
    model: &Model,
    counts: &Counts,
    penalty: Option<&Penalty>,
    fit: &Fit,
) -> Result<Vec<f64>, ScalingError> {
    let n = counts.stimuli;
    let bread = Bread::of(model, counts, penalty, fit)?;
    // The variance of value i is c' H^-1 c for the c that makes it of the parameters.
    let variance = |i: usize| {
        let mut combination = vec![0.0; fit.parameters.len()];
        for j in 0..n {
            let share = f64::from(i == j) - 1.0 / n as f64;
            match &model.design {
                None => combination[j] += share,
                Some(design) => {
                    let row = combination.iter_mut().zip(design.row(j));
                    row.for_each(|(sum, x)| *sum += share * x);
                }
            }
        }
        let moved = bread.solved(&combination);
        combination.iter().zip(moved).map(|(c, m)| c * m).sum::<f64>()
    };
    Ok((0..n).map(|i| variance(i).max(0.0).sqrt()).collect())
}

/// Observed information, factored; the first value is held where all of them float.
struct Bread {
    factor: Factor,
    held: bool,
}

impl Bread {
    fn of(
        model: &Model,
        counts: &Counts,
        penalty: Option<&Penalty>,
        fit: &Fit,
    ) -> Result<Self, ScalingError> {
        let bends = landscape(model, counts, None, &fit.parameters).bends;
        let matrix = assembled(model, counts, &bends, penalty);
        let size = fit.parameters.len();
        let held = model.design.is_none() && penalty.is_none();
        let factor = if held {
            let rest = matrix.chunks(size).skip(1).flat_map(|row| &row[1..]).copied().collect();
            Factor::of(rest, size - 1)
        } else {
            Factor::of(matrix, size)
        };
        Ok(Self { factor: factor.ok_or(ScalingError::NotConverged(fit.steps))?, held })
    }

    fn solved(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        if self.held {
            x[0] = 0.0;
        }
        self.factor.solve(&mut x[usize::from(self.held)..]);
        x
    }
}
