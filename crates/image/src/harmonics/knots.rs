//! The four knots of a grid of directions that are nearest to a place, with their shares.
//!
//! Rows from pole to pole, twice as many columns, bilinear.
//! Left out: what lies at the knots.

use crate::harmonics::place::Place;

/// The knots around a place on a grid of `rows` rows as `synthesise` fills it, and how much each counts; the shares
/// add up to 1.
#[inline]
pub(crate) fn knots(rows: usize, place: Place) -> [(usize, f32); 4] {
    let scale = rows as f32 / std::f32::consts::PI;
    let (columns, last) = (2 * rows, rows as f32);
    // A turn and a row more keep both positive.
    let across = place.longitude * scale + columns as f32;
    let down = (place.colatitude * scale + 0.5).min(last + 0.4999);
    let (column, row) = (across as usize, down as usize);
    let (aside, below) = (across - column as f32, down - row as f32);
    // Beyond a pole lies the same ring, half way round.
    let ring = |row: usize| match row {
        0 => (0, rows),
        row if row > rows => (rows - 1, rows),
        row => (row - 1, 0),
    };
    let knot = |row: usize, column: usize| {
        let (ring, turn) = ring(row);
        ring * columns + (column + turn) % columns
    };
    [
        (knot(row, column), (1.0 - aside) * (1.0 - below)),
        (knot(row, column + 1), aside * (1.0 - below)),
        (knot(row + 1, column), (1.0 - aside) * below),
        (knot(row + 1, column + 1), aside * below),
    ]
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::harmonics::analysis::directions_of_grid;

    #[test]
    fn a_smooth_field_between_knots_is_what_it_is_there_poles_included() {
        let rows = 48;
        let field = |d: DVec3| 1.0 + d.x * d.z + 0.5 * d.y;
        let grid: Vec<f64> = directions_of_grid(rows).map(|(d, _)| field(d)).collect();
        let at = |d: DVec3| {
            let knots = knots(rows, Place::towards(d));
            knots.iter().map(|&(knot, share)| grid[knot] * f64::from(share)).sum::<f64>()
        };
        for i in 0..300 {
            let t = f64::from(i);
            let d = DVec3::new((0.7 * t).sin(), (1.3 * t).cos(), (0.3 * t).sin()).normalize();
            assert!((at(d) - field(d)).abs() < 3e-3, "{d}: {} {}", at(d), field(d));
        }
        for pole in [DVec3::Z, DVec3::NEG_Z] {
            assert!((at(pole) - 1.0).abs() < 3e-3);
        }
    }
}
