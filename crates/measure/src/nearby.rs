//! What is usual nearby: a running quantile; the median which follows slopes and edges of light, and no spots.

use crate::disc::Disc;
use crate::value::quantile;

/// How far around a place its neighbours lie, in radii: a spot of 0.2 radii fills under half of that **(ours)**.
const REACH: f64 = 0.3;
/// Places at which the median is worked out, in a radius; between them it is taken as straight.
const NODES: f64 = 24.0;
/// About as many neighbours are enough.
const ENOUGH: f64 = 300.0;

/// A running quantile of each channel, where something is looked at; 0 elsewhere.
pub fn nearby<const N: usize>(
    rest: &[[f64; N]],
    held: &[bool],
    disc: &Disc,
    radius: f64,
    share: f64,
) -> Vec<[f64; N]> {
    let side = (radius / NODES).max(1.0);
    let (width, height) = (disc.width, rest.len() / disc.width);
    let (columns, rows) = ((width as f64 / side) as usize + 2, (height as f64 / side) as usize + 2);
    let reach = REACH * radius;
    let step = ((2.0 * reach / ENOUGH.sqrt()) as usize).max(1);
    let own = |node: usize| {
        let (x, y) = ((node % columns) as f64 * side, (node / columns) as f64 * side);
        let along = |middle: f64, most: usize| {
            let first = (middle - reach).max(0.0) as usize;
            (first..((middle + reach) as usize + 1).min(most)).step_by(step)
        };
        let mut parts = [const { Vec::new() }; N];
        for row in along(y, height) {
            for column in along(x, width) {
                let (right, down) = (column as f64 - x, row as f64 - y);
                let at = row * width + column;
                if held[at] && right * right + down * down < reach * reach {
                    for channel in 0..N {
                        parts[channel].push(rest[at][channel]);
                    }
                }
            }
        }
        (!parts[0].is_empty()).then(|| parts.map(|mut part| quantile(&mut part, share)))
    };
    let nodes: Vec<Option<[f64; N]>> = (0..columns * rows).map(own).collect();
    let usual = |at: usize| {
        let (x, y) = ((at % width) as f64 / side, (at / width) as f64 / side);
        let first = y as usize * columns + x as usize;
        let (right, down) = (x.fract(), y.fract());
        let shares = [
            (1.0 - right) * (1.0 - down),
            right * (1.0 - down),
            (1.0 - right) * down,
            right * down,
        ];
        let (mut sum, mut whole) = ([0.0; N], 0.0);
        for (part, node) in
            shares.into_iter().zip([first, first + 1, first + columns, first + columns + 1])
        {
            if let Some(node) = nodes[node] {
                sum = std::array::from_fn(|channel| sum[channel] + part * node[channel]);
                whole += part;
            }
        }
        if whole > 0.0 { sum.map(|one| one / whole) } else { [0.0; N] }
    };
    (0..rest.len()).map(|at| if held[at] { usual(at) } else { [0.0; N] }).collect()
}
