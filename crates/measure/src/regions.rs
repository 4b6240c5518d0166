//! Closed regions of a map: what is lighter, darker or of another colour than all that borders on it.

use crate::spot::Map;
use crate::value::quantile;

/// Levels at which regions are looked for lie so far apart, in CIELAB **(ours)**.
const STEP: f64 = 0.25;
/// Of the places this share lies above the highest level, and twenty times that below the lowest.
const TAIL: f64 = 0.001;

/// At each level of each channel, upwards and downwards: what lies beyond it and hangs together, from `least`
/// to `most` pixels.
pub fn regions(map: &Map<'_>, least: usize, most: usize) -> Vec<Vec<usize>> {
    let mut found = Vec::new();
    for channel in 0..3 {
        for sign in [1.0, -1.0] {
            let light: Vec<f64> = map.residual.iter().map(|one| sign * one[channel]).collect();
            let mut looked: Vec<f64> =
                (0..light.len()).filter(|&at| map.held[at]).map(|at| light[at]).collect();
            let (top, bottom) =
                (quantile(&mut looked, 1.0 - TAIL), quantile(&mut looked, 20.0 * TAIL));
            let first = (bottom / STEP).floor();
            for number in 0..((top / STEP - first).ceil().max(0.0) as usize) {
                let level = STEP * (first + number as f64);
                let mut beyond: Vec<bool> =
                    (0..light.len()).map(|at| map.held[at] && light[at] > level).collect();
                collect(&mut beyond, map.width, least..=most, &mut found);
            }
        }
    }
    found
}

/// Takes what hangs together and is as large as wanted.
fn collect(
    free: &mut [bool],
    width: usize,
    sizes: std::ops::RangeInclusive<usize>,
    found: &mut Vec<Vec<usize>>,
) {
    for first in 0..free.len() {
        if !free[first] {
            continue;
        }
        free[first] = false;
        let (mut region, mut next) = (Vec::new(), vec![first]);
        while let Some(at) = next.pop() {
            region.push(at);
            for near in [at.wrapping_sub(1), at + 1, at.wrapping_sub(width), at + width] {
                if free.get(near).copied().unwrap_or(false) {
                    free[near] = false;
                    next.push(near);
                }
            }
        }
        if sizes.contains(&region.len()) {
            found.push(region);
        }
    }
}
