//! Fisher's information: how sharply the likelihood bends.

use crate::{
    Counts, Model,
    likelihood::{Penalty, landscape, leads},
    terms,
};

/// Which information.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Its mean over the answers that the model expects to the pairs shown.
    Expected,
    /// That of the answers given.
    Observed,
}

/// The information about all parameters, [parameter, parameter] row after row, prior included.
///
/// Without a design and a prior a constant added to all values is not known, and the matrix is
/// singular along it.
pub fn information(model: &Model, counts: &Counts, parameters: &[f64], kind: Kind) -> Vec<f64> {
    let counts = counts.seen_by(model);
    let penalty = Penalty::of(model, counts.stimuli);
    let bends = match kind {
        Kind::Observed => landscape(model, &counts, None, parameters).bends,
        Kind::Expected => {
            let (leads, width) = leads(model, &counts.pairs, counts.stimuli, parameters);
            let rows = leads.iter().zip(&counts.answers);
            rows.map(|(&a, row)| terms::expected_bend(model, a, width, row.iter().sum())).collect()
        }
    };
    assembled(model, &counts, &bends, penalty.as_ref())
}

/// The dense matrix of bends (aa, as, ss) by row.
pub fn assembled(
    model: &Model,
    counts: &Counts,
    bends: &[[f64; 3]],
    penalty: Option<&Penalty>,
) -> Vec<f64> {
    let (n, size) = (counts.stimuli, model.parameters(counts.stimuli));
    let coefficients = model.coefficients(n);
    let (order_at, ties_at) = (model.order_at(n), model.ties_at(n));
    let mut matrix = vec![0.0; size * size];
    let mut difference = vec![0.0; coefficients];
    for (&[left, right], &[aa, cross, ss]) in counts.pairs.iter().zip(bends) {
        let (l, r) = (left as usize, right as usize);
        match &model.design {
            None => {
                matrix[l * size + l] += aa;
                matrix[r * size + r] += aa;
                matrix[l * size + r] -= aa;
                matrix[r * size + l] -= aa;
            }
            Some(design) => {
                let rows = design.row(l).iter().zip(design.row(r));
                difference.iter_mut().zip(rows).for_each(|(d, (x, y))| *d = x - y);
                for (i, x) in difference.iter().enumerate() {
                    for (j, y) in difference.iter().enumerate() {
                        matrix[i * size + j] += aa * x * y;
                    }
                }
            }
        }
        for (place, amount) in [(order_at, aa), (ties_at, cross)] {
            if let Some(row) = place {
                let into = &mut matrix[row * size..][..coefficients];
                crate::likelihood::spread_out(model, [left, right], amount, into);
            }
        }
        if let Some(i) = order_at {
            matrix[i * size + i] += aa;
        }
        if let Some(i) = ties_at {
            matrix[i * size + i] += ss;
        }
        if let (Some(i), Some(j)) = (order_at, ties_at) {
            matrix[j * size + i] += cross;
        }
    }
    for i in 0..size {
        matrix[i * size + i] += penalty.map_or(0.0, |penalty| penalty.precision[i]);
        for j in i + 1..size {
            if j >= coefficients {
                matrix[i * size + j] = matrix[j * size + i];
            }
        }
    }
    matrix
}
