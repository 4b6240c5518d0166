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
    let (leads, width) = leads(model, &counts.pairs, n, &fit.parameters);
    let slopes: Vec<[[f64; 2]; 3]> = leads
        .iter()
        .map(|&a| Outcome::ALL.map(|outcome| terms::of_outcome(model, a, width, outcome).slope))
        .collect();
    let size = fit.parameters.len();
    // The sum of the products of each person's slopes: of millions of answers it costs least.
    let mut meat = vec![0.0; size * size];
    let mut score = vec![0.0; size];
    for (person, &times) in people.iter().enumerate().filter(|(_, times)| **times > 0) {
        score.fill(0.0);
        for &(row, answers) in ledger.of(person) {
            let (each, answers) = (&slopes[row as usize], answers.map(f64::from));
            let slope = [0, 1].map(|k| (0..3).map(|o| answers[o] * each[o][k]).sum::<f64>());
            to_parameters(model, n, counts.pairs[row as usize], slope, &mut score);
        }
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
