//! A number and its standard error.

use libm::sqrt;
use serde::Serialize;

/// A measured number; its standard error where one can be had.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Value {
    /// The number.
    pub value: f64,
    /// Its standard error, in the same unit.
    pub error: Option<f64>,
}

impl Value {
    /// A number, its error None where that is no number.
    pub(crate) fn new(value: f64, error: f64) -> Self {
        Self { value, error: error.is_finite().then_some(error) }
    }

    /// In another unit.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, error: self.error.map(|error| factor * error) }
    }
}

/// The standard error by the jackknife (Efron and Stein 1981): the spread of what is found with each
/// group left out in turn. NaN for fewer than 3 groups.
pub fn jackknife(left_out: &[f64]) -> f64 {
    let count = left_out.len() as f64;
    if left_out.len() < 3 {
        return f64::NAN;
    }
    let mean = left_out.iter().sum::<f64>() / count;
    let squares: f64 = left_out.iter().map(|one| (one - mean) * (one - mean)).sum();
    sqrt(squares * (count - 1.0) / count)
}

/// The middle of some numbers; NaN of none. They are put in order.
pub fn median(values: &mut [f64]) -> f64 {
    quantile(values, 0.5)
}

/// What so large a share of some numbers lies below; NaN of none. They are put in order.
pub fn quantile(values: &mut [f64], share: f64) -> f64 {
    if values.is_empty() {
        return f64::NAN;
    }
    let middle = ((share * values.len() as f64) as usize).min(values.len() - 1);
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_jackknife_of_a_mean_is_the_textbook_standard_error() {
        let values = [1.0, 2.0, 4.0, 7.0];
        let sum: f64 = values.iter().sum();
        let left_out: Vec<f64> = values.iter().map(|value| (sum - value) / 3.0).collect();
        let squares: f64 = values.iter().map(|value| (value - 3.5_f64).powi(2)).sum();
        assert!((jackknife(&left_out) - (squares / 12.0).sqrt()).abs() < 1e-12);
    }
}
