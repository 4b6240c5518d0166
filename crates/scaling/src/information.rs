//! Fisher's information: how sharply the likelihood bends.

use crate::{
    Counts, Model,
    likelihood::{Penalty, landscape, leads, to_coefficients, to_parameters},
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
    let mut matrix = vec![0.0; size * size];
    for (&pair, &[aa, cross, ss]) in counts.pairs.iter().zip(bends) {
        add_pair(model, pair, aa, &mut matrix, size);
        if let Some(i) = model.order_at(n) {
            to_coefficients(model, pair, aa, &mut matrix[i * size..][..coefficients]);
            matrix[i * size + i] += aa;
        }
        if let Some(i) = model.ties_at(n) {
            to_parameters(model, n, pair, [cross, ss], &mut matrix[i * size..][..size]);
        }
    }
    for i in 0..size {
        matrix[i * size + i] += penalty.map_or(0.0, |penalty| penalty.precision[i]);
        for j in coefficients.max(i + 1)..size {
            matrix[i * size + j] = matrix[j * size + i];
        }
    }
    matrix
}

/// Adds what a pair says about its lead to the square of the coefficients.
fn add_pair(model: &Model, [left, right]: [u32; 2], bend: f64, matrix: &mut [f64], size: usize) {
    let (l, r) = (left as usize, right as usize);
    let Some(design) = &model.design else {
        matrix[l * size + l] += bend;
        matrix[r * size + r] += bend;
        matrix[l * size + r] -= bend;
        matrix[r * size + l] -= bend;
        return;
    };
    for i in 0..design.columns {
        let x = design.row(l)[i] - design.row(r)[i];
        if x != 0.0 {
            to_coefficients(
                model,
                [left, right],
                bend * x,
                &mut matrix[i * size..][..design.columns],
            );
        }
    }
}
