use glam::DVec3;
use rayon::prelude::*;

use crate::{
    ball::Ball,
    rgb::{self, Rgb},
};

/// Light on the table around the pearls that changes softly, worked out on a grid: sky, windows and the
/// pearls' own light. What lamps throw has edges and is left to each point.
#[derive(Debug, Clone)]
pub(crate) struct Floor {
    /// The corner with the least x and z, mm.
    corner: [f64; 2],
    step_mm: f64,
    columns: usize,
    rows: usize,
    light: Vec<Rgb>,
}

/// How finely a floor is worked out, and how far.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    /// Steps for each radius of the smallest pearl.
    pub steps: f64,
    /// Around the pearls, in radii of the largest.
    pub radii: f64,
}

/// Near the pearls: the contact shadow, which is as wide as that, is met within
/// 0.8 % of the light, at its darkest.
pub(crate) const NEAR: Reach = Reach { steps: 10.0, radii: 3.0 };
/// Farther off shadows are wide and weak.
pub(crate) const FAR: Reach = Reach { steps: 2.0, radii: 40.0 };
/// A grid over pearls of very unlike sizes stays this small.
const MOST_CELLS: f64 = 400_000.0;

impl Floor {
    /// `None` without pearls. `light` works out a point of the table.
    pub(crate) fn new(
        balls: &[Ball],
        table_y_mm: f64,
        reach: Reach,
        light: impl Fn(DVec3) -> Rgb + Sync,
    ) -> Option<Self> {
        let least = balls.iter().map(|ball| ball.radius_mm).reduce(f64::min)?;
        let margin_mm = reach.radii * balls.iter().map(|ball| ball.radius_mm).fold(0.0, f64::max);
        let end = |sign: f64, axis: fn(DVec3) -> f64| {
            let reach = |ball: &Ball| sign * axis(ball.centre) + margin_mm;
            balls.iter().map(reach).fold(f64::NEG_INFINITY, f64::max)
        };
        let (left, right) = (-end(-1.0, |p| p.x), end(1.0, |p| p.x));
        let (back, front) = (-end(-1.0, |p| p.z), end(1.0, |p| p.z));
        let area_mm2 = (right - left) * (front - back);
        let step_mm = (least / reach.steps).max((area_mm2 / MOST_CELLS).sqrt());
        let count = |width_mm: f64| (width_mm / step_mm) as usize + 2;
        let (columns, rows) = (count(right - left), count(front - back));
        let at = |i: usize| {
            let (row, column) = (i / columns, i % columns);
            let (x, z) = (left + column as f64 * step_mm, back + row as f64 * step_mm);
            light(DVec3::new(x, table_y_mm, z))
        };
        let light = (0..columns * rows).into_par_iter().map(at).collect();
        Some(Self { corner: [left, back], step_mm, columns, rows, light })
    }

    /// The light at a point of the table, unless it lies beyond the grid.
    pub(crate) fn at(&self, point: DVec3) -> Option<Rgb> {
        let x = (point.x - self.corner[0]) / self.step_mm;
        let z = (point.z - self.corner[1]) / self.step_mm;
        if !(x >= 0.0 && z >= 0.0) {
            return None;
        }
        let (column, row) = (x as usize, z as usize);
        if column + 1 >= self.columns || row + 1 >= self.rows {
            return None;
        }
        let first = row * self.columns + column;
        let pair = |first: usize| rgb::mix(self.light[first], self.light[first + 1], x.fract());
        Some(rgb::mix(pair(first), pair(first + self.columns), z.fract()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contact_shadows_are_met_and_the_grid_ends() {
        let ball = Ball::alone(4.0);
        let exact = |point: DVec3| [ball.sky_past(point), 1.0, 0.0];
        let floor = Floor::new(&[ball], -4.0, NEAR, exact).unwrap();
        let far = Floor::new(&[ball], -4.0, FAR, exact).unwrap();
        for i in 0..160 {
            let point = DVec3::new(0.07 * f64::from(i), -4.0, 0.031 * f64::from(i));
            let got = floor.at(point).unwrap();
            assert!((got[0] - exact(point)[0]).abs() < 0.008, "{point}: {}", got[0]);
            let point = DVec3::new(8.0 + 0.9 * f64::from(i), -4.0, 12.0);
            let got = far.at(point).unwrap();
            assert!((got[0] - exact(point)[0]).abs() < 0.003, "{point}: {}", got[0]);
        }
        assert_eq!(floor.at(DVec3::new(30.0, -4.0, 0.0)), None);
        assert!(Floor::new(&[], 0.0, NEAR, exact).is_none());
    }
}
