/// How cells of a fine sheet make the cells of a coarser one: tents over equal steps, mirrored at the edges.
/// Seen the other way round, how the coarse cells are laid on the fine ones.
#[derive(Debug)]
pub(crate) struct Resampling {
    pub(crate) fine: usize,
    /// For each coarse cell, the first fine cell and the weights from there, which add up to 1.
    pub(crate) down: Vec<(usize, Vec<f32>)>,
    /// For each fine cell, the first coarse cell and the weights from there, which add up to 1.
    pub(crate) up: Vec<(usize, Vec<f32>)>,
}

impl Resampling {
    /// To cells about `step` fine cells wide.
    pub(crate) fn new(fine: usize, step: f64) -> Self {
        let coarse = ((fine as f64 / step).round().max(1.0) as usize).min(fine);
        let step = fine as f64 / coarse as f64;
        let down: Vec<_> = (0..coarse).map(|cell| Self::row(fine, coarse, cell)).collect();
        let mut up = vec![(0, Vec::new()); fine];
        for (cell, (first, weights)) in down.iter().enumerate() {
            for ((start, up), weight) in up[*first..].iter_mut().zip(weights) {
                if up.is_empty() {
                    *start = cell;
                }
                up.push(weight * step as f32);
            }
        }
        Self { fine, down, up }
    }

    /// First fine cell and weights of a coarse cell.
    fn row(fine: usize, coarse: usize, cell: usize) -> (usize, Vec<f32>) {
        if coarse == fine {
            return (cell, vec![1.0]);
        }
        let step = fine as f64 / coarse as f64;
        let middle = (cell as f64 + 0.5) * step;
        // Counted from well left of the edge, so that no cell is negative.
        let left = step.ceil() as usize;
        let place = |at: f64| (at + left as f64).max(0.0);
        let first = place(middle - step).floor() as usize;
        let last = place(middle + step).ceil() as usize;
        let mut weights = vec![0.0; fine.min(last - first + 2)];
        let start = first.saturating_sub(left).min(fine - weights.len());
        for i in first..last {
            let edge = |i: usize| tent_integral((i as f64 - left as f64 - middle) / step);
            weights[mirrored(i, left, fine) - start] += (edge(i + 1) - edge(i)) as f32;
        }
        (start, weights)
    }

    /// What going down and up again adds to the variance of a spread, in square fine cells.
    pub(crate) fn variance(&self) -> f64 {
        if self.down.len() == self.fine {
            return 0.0;
        }
        (self.fine as f64 / self.down.len() as f64).powi(2) / 3.0
    }
}

/// From minus infinity, of the tent of area 1 between -1 and 1.
fn tent_integral(x: f64) -> f64 {
    let x = x.clamp(-1.0, 1.0);
    0.5 + x - 0.5 * x * x.abs()
}

/// A cell beyond an edge is the cell as far on this side of it; `cell` is counted from `left` cells before
/// the first.
pub(crate) fn mirrored(cell: usize, left: usize, count: usize) -> usize {
    let period = 2 * count;
    let turn = (cell + period - left % period) % period;
    if turn < count { turn } else { period - 1 - turn }
}
