//! Light over a plane that changes softly.
//!
//! Worked out at the nodes of a grid, straight lines between.
//! Left out: edges; whoever asks for a map knows that there are none.

use crate::{
    parallel,
    rgb::{self, Rgb},
};

/// Light over a plane that changes softly, worked out on a grid; straight lines between.
#[derive(Debug, Clone)]
pub(crate) struct LightMap {
    corner_mm: [f64; 2],
    step_mm: [f64; 2],
    /// So far from the corner is beyond the grid, by more than any rounding.
    beyond_mm: [f64; 2],
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
        Self::of([corner_mm, step_mm], [columns, rows], light)
    }

    /// Of points so far apart, row by row.
    fn of(
        [corner_mm, step_mm]: [[f64; 2]; 2],
        [columns, rows]: [usize; 2],
        light: Vec<Rgb>,
    ) -> Self {
        let beyond_mm = [step_mm[0] * columns as f64, step_mm[1] * rows as f64];
        Self { corner_mm, step_mm, beyond_mm, columns, rows, light }
    }

    /// The same, worked out no finer than needed: between points where straight lines were right to `tolerance`
    /// of the light, at five places half-way, they stand for it.
    pub(crate) fn adaptive(
        corner_mm: [f64; 2],
        opposite_mm: [f64; 2],
        counts: [usize; 2],
        tolerance: f64,
        light: impl Fn([f64; 2]) -> Rgb + Sync,
    ) -> Self {
        let step_mm = [0, 1].map(|i| (opposite_mm[i] - corner_mm[i]) / counts[i] as f64);
        // Whole blocks, which may reach a little beyond.
        let blocks = counts.map(|count| count.div_ceil(COARSEST));
        let [columns, rows] = blocks.map(|count| count * COARSEST + 1);
        let mut points = Points { columns, light: vec![None; columns * rows] };
        let place = |i: usize| {
            let place = [i % columns, i / columns];
            [0, 1].map(|i| corner_mm[i] + place[i] as f64 * step_mm[i])
        };
        let first = |block: usize| COARSEST * (block / blocks[0] * columns + block % blocks[0]);
        let mut open: Vec<usize> = (0..blocks[0] * blocks[1]).map(first).collect();
        let (mut width, mut settled) = (COARSEST, Vec::new());
        while width > 1 {
            points.work_out(&open, width, |i| light(place(i)));
            let (rough, smooth): (Vec<usize>, Vec<usize>) =
                open.into_iter().partition(|&block| points.bend(block, width) > tolerance);
            settled.push((width, smooth));
            width /= 2;
            let [aside, down] = [width, width * columns];
            let quarters = |block| [block, block + aside, block + down, block + aside + down];
            open = rough.into_iter().flat_map(quarters).collect();
        }
        for (width, blocks) in settled {
            points.fill(&blocks, width);
        }
        let light = points.light.into_iter().map(Option::unwrap_or_default).collect();
        Self::of([corner_mm, step_mm], [columns, rows], light)
    }

    /// The light at a place, unless it lies beyond the grid.
    #[inline]
    pub(crate) fn at(&self, [x_mm, y_mm]: [f64; 2]) -> Option<Rgb> {
        self.between(x_mm, y_mm)
    }

    /// The same. Numbers one by one come in registers, and lines of sight ask for millions.
    fn between(&self, x_mm: f64, y_mm: f64) -> Option<Rgb> {
        let from_mm = [x_mm - self.corner_mm[0], y_mm - self.corner_mm[1]];
        // Most lie well beyond a small grid, which needs no division.
        if from_mm[0] > self.beyond_mm[0] || from_mm[1] > self.beyond_mm[1] {
            return None;
        }
        let (x, y) = (from_mm[0] / self.step_mm[0], from_mm[1] / self.step_mm[1]);
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

/// Steps along a side of the coarsest blocks.
const COARSEST: usize = 8;

/// A grid in the making, row by row. A block of it is named by its first point.
struct Points {
    columns: usize,
    light: Vec<Option<Rgb>>,
}

impl Points {
    /// The nine points of a block: corners, middles of its sides, and its middle.
    fn nine(&self, block: usize, width: usize) -> [[usize; 3]; 3] {
        let half = width / 2;
        [0, 1, 2].map(|row| [0, 1, 2].map(|i| block + (row * self.columns + i) * half))
    }

    /// Works out those of some blocks that are not known yet.
    fn work_out(&mut self, blocks: &[usize], width: usize, light: impl Fn(usize) -> Rgb + Sync) {
        let mut wanted: Vec<usize> = blocks
            .iter()
            .flat_map(|&block| self.nine(block, width).into_iter().flatten())
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        wanted.retain(|&i| self.light[i].is_none());
        let found = parallel::map(wanted.len(), |i| light(wanted[i]));
        for (i, light) in wanted.into_iter().zip(found) {
            self.light[i] = Some(light);
        }
    }

    fn known(&self, point: usize) -> Rgb {
        self.light[point].unwrap_or_default()
    }

    /// The most by which straight lines between a block's corners miss the other five points, as a share of
    /// its light.
    fn bend(&self, block: usize, width: usize) -> f64 {
        let nine = self.nine(block, width).map(|row| row.map(|point| self.known(point)));
        let [[a, top, b], [left, middle, right], [c, bottom, d]] = nine;
        let (above, below) = (rgb::mix(a, b, 0.5), rgb::mix(c, d, 0.5));
        let pairs = [
            (top, above),
            (bottom, below),
            (left, rgb::mix(a, c, 0.5)),
            (right, rgb::mix(b, d, 0.5)),
            (middle, rgb::mix(above, below, 0.5)),
        ];
        let most = nine.as_flattened().as_flattened().iter().copied().fold(0.0, f64::max);
        let misses = pairs.iter().flat_map(|(a, b)| [0, 1, 2].map(|i| (a[i] - b[i]).abs()));
        if most > 0.0 { misses.fold(0.0, f64::max) / most } else { 0.0 }
    }

    /// Puts straight lines between the nine points of each block.
    fn fill(&mut self, blocks: &[usize], width: usize) {
        let half = width / 2;
        for &block in blocks {
            let nine = self.nine(block, width).map(|row| row.map(|point| self.known(point)));
            for place in 0..(width + 1) * (width + 1) {
                let (row, column) = (place / (width + 1), place % (width + 1));
                let (r, c) = ((row / half).min(1), (column / half).min(1));
                let [down, aside] =
                    [row - r * half, column - c * half].map(|steps| steps as f64 / half as f64);
                let line = |r: usize| rgb::mix(nine[r][c], nine[r][c + 1], aside);
                let between = rgb::mix(line(r), line(r + 1), down);
                self.light[block + row * self.columns + column].get_or_insert(between);
            }
        }
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

    #[test]
    fn fewer_points_are_asked_where_light_hardly_bends_and_the_tolerance_is_kept() {
        let asked = std::sync::atomic::AtomicUsize::new(0);
        // A dark disc with a soft edge, in light that slopes.
        let light = |[x, y]: [f64; 2]| {
            let shadow = 1.0 / (1.0 + libm::exp(4.0 * (1.0 - (x * x + y * y).sqrt())));
            [0.5 + 0.3 * shadow, 1.0 + 0.01 * x, 1.0]
        };
        let counted = |place| {
            asked.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            light(place)
        };
        let light_map = LightMap::adaptive([-20.0; 2], [20.0; 2], [160; 2], 1e-3, counted);
        for i in 0..2000 {
            let t = f64::from(i);
            let place = [19.0 * libm::sin(0.37 * t), 19.0 * libm::cos(0.71 * t)];
            let (found, exact) = (light_map.at(place).unwrap(), light(place));
            // A step of 0.25 alone misses the edge by 0.005.
            assert!((0..3).all(|i| (found[i] - exact[i]).abs() < 0.006), "{place:?}");
        }
        assert!(asked.into_inner() < 161 * 161 / 5);
    }
}
