//! Three by three matrices on colours, usable at compile time.

/// Rows of a linear map from one colour triple to another.
pub type Matrix = [[f64; 3]; 3];

/// The colour `matrix` maps `colour` to.
///
/// ```
/// use nacreous_colour::matrix::apply;
/// assert_eq!(apply(&[[1.0, 1.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]], [1.0; 3]), [2.0, 2.0, 3.0]);
/// ```
#[inline]
pub const fn apply(matrix: &Matrix, colour: [f64; 3]) -> [f64; 3] {
    [dot(matrix[0], colour), dot(matrix[1], colour), dot(matrix[2], colour)]
}

/// The map that applies `first` and then `then`.
///
/// ```
/// use nacreous_colour::matrix::{diagonal, product};
/// assert_eq!(product(&diagonal([2.0; 3]), &diagonal([3.0; 3])), diagonal([6.0; 3]));
/// ```
pub const fn product(then: &Matrix, first: &Matrix) -> Matrix {
    let columns = transpose(first);
    transpose(&[apply(then, columns[0]), apply(then, columns[1]), apply(then, columns[2])])
}

/// The map that undoes `matrix`, which must not be singular.
///
/// ```
/// use nacreous_colour::matrix::{diagonal, inverse};
/// assert_eq!(inverse(&diagonal([2.0, 4.0, 8.0])), diagonal([0.5, 0.25, 0.125]));
/// ```
pub const fn inverse(matrix: &Matrix) -> Matrix {
    let [a, b, c] = *matrix;
    // The columns of the adjugate are cross products of the rows.
    let adjugate = transpose(&[cross(b, c), cross(c, a), cross(a, b)]);
    let determinant = dot(a, cross(b, c));
    product(&diagonal([1.0 / determinant; 3]), &adjugate)
}

/// The map that scales each component by its own factor.
///
/// ```
/// use nacreous_colour::matrix::{apply, diagonal};
/// assert_eq!(apply(&diagonal([1.0, 2.0, 3.0]), [1.0; 3]), [1.0, 2.0, 3.0]);
/// ```
pub const fn diagonal(factors: [f64; 3]) -> Matrix {
    [[factors[0], 0.0, 0.0], [0.0, factors[1], 0.0], [0.0, 0.0, factors[2]]]
}

pub(crate) const fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) const fn transpose(m: &Matrix) -> Matrix {
    [[m[0][0], m[1][0], m[2][0]], [m[0][1], m[1][1], m[2][1]], [m[0][2], m[1][2], m[2][2]]]
}

const fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn inverse_undoes_the_matrix(
            rows in prop::array::uniform3(prop::array::uniform3(-0.9..0.9_f64)),
            colour in prop::array::uniform3(-1.0..1.0_f64),
        ) {
            // Dominant diagonal: far from singular.
            let matrix = std::array::from_fn(|i| {
                std::array::from_fn(|j| rows[i][j] + if i == j { 3.0 } else { 0.0 })
            });
            let back = apply(&inverse(&matrix), apply(&matrix, colour));
            for (before, after) in colour.iter().zip(back) {
                prop_assert!((before - after).abs() < 1e-12);
            }
        }
    }
}
