use crate::{
    parallel,
    rgb::{self, Rgb},
};

/// Light over a plane that changes softly, worked out on a grid; straight lines between.
#[derive(Debug, Clone)]
pub(crate) struct LightMap {
    corner_mm: [f64; 2],
    step_mm: [f64; 2],
    columns: usize,
    rows: usize,
    light: Vec<Rgb>,
}

impl LightMap {
    /// Over a rectangle from one corner to the other, in `counts` steps or so. `light` works out a place.
    pub(crate) fn new(
        corner_mm: [f64; 2],
        opposite_mm: [f64; 2],
        counts: [usize; 2],
        light: impl Fn([f64; 2]) -> Rgb + Sync,
    ) -> Self {
        let step_mm = [0, 1].map(|i| (opposite_mm[i] - corner_mm[i]) / counts[i] as f64);
        let [columns, rows] = counts.map(|count| count + 1);
        let at = |i: usize| {
            let place = [i % columns, i / columns];
            light([0, 1].map(|i| corner_mm[i] + place[i] as f64 * step_mm[i]))
        };
        let light = parallel::map(columns * rows, at);
        Self { corner_mm, step_mm, columns, rows, light }
    }

    /// The light at a place, unless it lies beyond the grid.
    pub(crate) fn at(&self, place_mm: [f64; 2]) -> Option<Rgb> {
        let [x, y] = [0, 1].map(|i| (place_mm[i] - self.corner_mm[i]) / self.step_mm[i]);
        if !(x >= 0.0 && y >= 0.0) {
            return None;
        }
        let (column, row) = (x as usize, y as usize);
        if column + 1 >= self.columns || row + 1 >= self.rows {
            return None;
        }
        let first = row * self.columns + column;
        let (aside, down) = (x - column as f64, y - row as f64);
        let pair = |first: usize| rgb::mix(self.light[first], self.light[first + 1], aside);
        Some(rgb::mix(pair(first), pair(first + self.columns), down))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slope_comes_back_and_ends_at_the_edges() {
        let light_map =
            LightMap::new([-1.0, 2.0], [3.0, 4.0], [8, 5], |[x, y]| [x, y, x + 2.0 * y]);
        for place in [[-1.0, 2.0], [0.3, 2.9], [2.99, 3.99]] {
            let [x, y] = place;
            let found = light_map.at(place).unwrap();
            assert!((0..3).all(|i| (found[i] - [x, y, x + 2.0 * y][i]).abs() < 1e-12));
        }
        for outside in [[-1.1, 3.0], [3.1, 3.0], [0.0, 1.9], [0.0, 4.1], [f64::NAN, 3.0]] {
            assert_eq!(light_map.at(outside), None);
        }
    }
}
