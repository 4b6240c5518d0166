//! Symmetric positive definite systems, dense.

/// The lower factor L of a matrix L Lᵀ, row after row.
pub struct Factor {
    size: usize,
    lower: Vec<f64>,
}

impl Factor {
    /// Of a full symmetric matrix, of which the lower half is read; none if it is not positive.
    pub fn of(mut matrix: Vec<f64>, size: usize) -> Option<Self> {
        for j in 0..size {
            let (above, below) = matrix.split_at_mut(j * size);
            let row = &mut below[..size];
            for k in 0..j {
                let other = &above[k * size..][..=k];
                let sum = dot(&row[..k], &other[..k]);
                row[k] = (row[k] - sum) / other[k];
            }
            let left = row[j] - dot(&row[..j], &row[..j]);
            // What rounding leaves of a zero is no pivot.
            if !(left > 0.0 && left > 1e-15 * row[j] && left.is_finite()) {
                return None;
            }
            row[j] = left.sqrt();
        }
        Some(Self { size, lower: matrix })
    }

    /// The x of L Lᵀ x = b, in place.
    pub fn solve(&self, b: &mut [f64]) {
        for i in 0..self.size {
            let row = &self.lower[i * self.size..][..=i];
            b[i] = (b[i] - dot(&row[..i], &b[..i])) / row[i];
        }
        for i in (0..self.size).rev() {
            let row = &self.lower[i * self.size..][..=i];
            b[i] /= row[i];
            let value = b[i];
            for (rest, l) in b[..i].iter_mut().zip(row) {
                *rest -= l * value;
            }
        }
    }
}

/// In eight lanes, which the compiler turns into vectors.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; 8];
    let (a_parts, b_parts) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a_parts.remainder().iter().zip(b_parts.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a_parts.zip(b_parts) {
        for k in 0..8 {
            lanes[k] += x[k] * y[k];
        }
    }
    lanes.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_solution_solves() {
        let n = 19;
        let entry = |i: usize, j: usize| ((i * j) as f64 * 0.7).sin();
        let matrix: Vec<f64> = (0..n * n)
            .map(|at| {
                let (i, j) = (at / n, at % n);
                (0..n).map(|k| entry(i, k) * entry(j, k)).sum::<f64>() + f64::from(i == j)
            })
            .collect();
        let factor = Factor::of(matrix.clone(), n).expect("positive");
        for j in 0..n {
            let mut x: Vec<f64> = (0..n).map(|i| f64::from(i == j)).collect();
            factor.solve(&mut x);
            for i in 0..n {
                let product: f64 = (0..n).map(|k| matrix[i * n + k] * x[k]).sum();
                assert!((product - f64::from(i == j)).abs() < 1e-10);
            }
        }
    }

    #[test]
    fn a_singular_matrix_has_no_factor() {
        assert!(Factor::of(vec![1.0, -1.0, -1.0, 1.0], 2).is_none());
    }
}
