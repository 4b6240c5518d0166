//! The part of a map around a region, and how far its places lie from the region's border.

use std::f64::consts::SQRT_2;

/// A region with what lies around it.
pub struct Window {
    /// Places of the map, row by row.
    pub places: Vec<usize>,
    /// Distance to the region in pixels, outside of it; to what is outside, below 0, within.
    pub away: Vec<f64>,
    /// How many pixels lie within, holes filled.
    pub area: usize,
    /// How many of them touch what is outside.
    pub border: usize,
}

impl Window {
    /// The window `pad` pixels around a region of a map that is so wide and high.
    pub fn around(region: &[usize], pad: usize, width: usize, height: usize) -> Self {
        let ends = |of: &dyn Fn(usize) -> usize, most: usize| {
            let (first, last) = region
                .iter()
                .fold((most, 0), |(first, last), &at| (first.min(of(at)), last.max(of(at))));
            (first.saturating_sub(pad), (last + pad + 1).min(most))
        };
        let (left, right) = ends(&|at| at % width, width);
        let (top, bottom) = ends(&|at| at / width, height);
        let columns = right - left;
        let places: Vec<usize> =
            (top..bottom).flat_map(|row| (left..right).map(move |c| row * width + c)).collect();
        let mut inside = vec![false; places.len()];
        for &at in region {
            inside[(at / width - top) * columns + at % width - left] = true;
        }
        fill(&mut inside, columns);
        let outside: Vec<bool> = inside.iter().map(|inside| !inside).collect();
        let (out, within) = (distance(&inside, columns), distance(&outside, columns));
        let away: Vec<f64> = out.iter().zip(&within).map(|(out, within)| out - within).collect();
        let area = inside.iter().filter(|inside| **inside).count();
        let border = within.iter().filter(|&&within| within > 0.0 && within < 1.2).count();
        Self { places, away, area, border }
    }
}

/// Holes become part of what has them.
fn fill(inside: &mut [bool], columns: usize) {
    let rows = inside.len() / columns;
    let on_edge = |at: &usize| {
        let (row, column) = (at / columns, at % columns);
        row == 0 || column == 0 || row + 1 == rows || column + 1 == columns
    };
    let mut next: Vec<usize> =
        (0..inside.len()).filter(on_edge).filter(|&at| !inside[at]).collect();
    let mut reached = vec![false; inside.len()];
    while let Some(at) = next.pop() {
        if reached[at] {
            continue;
        }
        reached[at] = true;
        let mut go = |near: usize| {
            if !inside[near] && !reached[near] {
                next.push(near);
            }
        };
        if at % columns > 0 {
            go(at - 1);
        }
        if at % columns + 1 < columns {
            go(at + 1);
        }
        if at >= columns {
            go(at - columns);
        }
        if at + columns < reached.len() {
            go(at + columns);
        }
    }
    for (inside, reached) in inside.iter_mut().zip(reached) {
        *inside = !reached;
    }
}

/// Distance to the nearest of some places, in steps to the side and aslant (Borgefors 1986); 0 on them.
fn distance(of: &[bool], columns: usize) -> Vec<f64> {
    let far = of.len() as f64;
    let mut away: Vec<f64> = of.iter().map(|of| if *of { 0.0 } else { far }).collect();
    let rows = of.len() / columns;
    let step = |away: &mut [f64], row: usize, column: usize, sign: isize| {
        let at = row * columns + column;
        for (right, down, length) in [(-1, 0, 1.0), (0, -1, 1.0), (-1, -1, SQRT_2), (1, -1, SQRT_2)]
        {
            let (x, y) = (column.cast_signed() + sign * right, row.cast_signed() + sign * down);
            let inside =
                (0..columns.cast_signed()).contains(&x) && (0..rows.cast_signed()).contains(&y);
            if inside {
                let near = y.cast_unsigned() * columns + x.cast_unsigned();
                away[at] = away[at].min(away[near] + length);
            }
        }
    };
    for row in 0..rows {
        for column in 0..columns {
            step(&mut away, row, column, 1);
        }
    }
    for row in (0..rows).rev() {
        for column in (0..columns).rev() {
            step(&mut away, row, column, -1);
        }
    }
    away
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holes_are_filled_and_distances_are_those_of_a_disc() {
        let (width, radius) = (41, 8.0);
        let away = |at: usize| ((at % width) as f64 - 20.0).hypot((at / width) as f64 - 20.0);
        let ring: Vec<usize> =
            (0..width * width).filter(|&at| (4.0..=radius).contains(&away(at))).collect();
        let window = Window::around(&ring, 6, width, width);
        let disc = (0..width * width).filter(|&at| away(at) <= radius).count();
        assert_eq!(window.area, disc);
        for (&place, &found) in window.places.iter().zip(&window.away) {
            assert!((found - (away(place) - radius)).abs() < 1.6, "{place}");
        }
    }
}
