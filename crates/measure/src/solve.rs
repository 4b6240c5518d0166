//! Small systems of normal equations.

use libm::{fabs, sqrt};

/// Tukey's biweight: residuals beyond this many robust standard deviations have no weight.
const CUT: f64 = 4.685;

/// The inverse of a symmetric positive matrix, by Cholesky; None where it is singular.
pub fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let size = matrix.len();
    let mut lower = vec![vec![0.0; size]; size];
    for row in 0..size {
        for column in 0..=row {
            let known: f64 = (0..column).map(|k| lower[row][k] * lower[column][k]).sum();
            let rest = matrix[row][column] - known;
            lower[row][column] = if row > column {
                rest / lower[column][column]
            } else if rest > 1e-12 * matrix[row][row] {
                sqrt(rest)
            } else {
                return None;
            };
        }
    }
    let mut result = vec![vec![0.0; size]; size];
    for unit in 0..size {
        let mut column = vec![0.0; size];
        for row in 0..size {
            let known: f64 = (0..row).map(|k| lower[row][k] * column[k]).sum();
            column[row] = (f64::from(u8::from(row == unit)) - known) / lower[row][row];
        }
        for row in (0..size).rev() {
            let known: f64 = (row + 1..size).map(|k| lower[k][row] * column[k]).sum();
            column[row] = (column[row] - known) / lower[row][row];
        }
        for row in 0..size {
            result[row][unit] = column[row];
        }
    }
    Some(result)
}

/// A matrix times a vector.
pub fn times(matrix: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| product(row, vector)).collect()
}

/// The weight of a residual in a robust fit: that of the least absolute differences, which starts from no guess,
/// or Tukey's.
pub fn robust_weight(left: f64, spread: f64, is_first: bool) -> f64 {
    if is_first {
        return spread / fabs(left).max(0.1 * spread);
    }
    let share = left / (CUT * spread);
    let rest = (1.0 - share * share).max(0.0);
    rest * rest
}

/// The sum of products.
pub fn product(first: &[f64], second: &[f64]) -> f64 {
    first.iter().zip(second).map(|(one, other)| one * other).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_times_matrix_is_one_and_a_singular_one_has_none() {
        let matrix = vec![vec![4.0, 1.0, 0.5], vec![1.0, 3.0, 0.2], vec![0.5, 0.2, 2.0]];
        let inverse = inverse(&matrix).unwrap();
        for unit in 0..3 {
            let column: Vec<f64> = matrix.iter().map(|row| row[unit]).collect();
            for (row, part) in times(&inverse, &column).iter().enumerate() {
                assert!((part - f64::from(u8::from(row == unit))).abs() < 1e-12);
            }
        }
        assert!(super::inverse(&[vec![1.0, 1.0], vec![1.0, 1.0]]).is_none());
    }
}
