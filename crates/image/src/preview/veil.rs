//! A film's view of a pearl at the knots of its net: light inside and light in the lobes, ready for the pixels.
//!
//! Cubics to a net twice as fine, straight lines between its knots.
//! Left out: the film's colour, which is the pixel's.

use crate::{
    pearl::{
        net::{Net, cubic},
        subsurface::Subsurface,
    },
    preview::glimpses::{Glimpse, Glimpses},
};

/// Numbers at a knot: light inside through a film without colour, light and lean of each lobe, and one to fill.
const KNOT: usize = 16;
pub(super) type Knot = [f32; KNOT];

/// The knots of a net twice as fine.
#[derive(Debug)]
pub struct Veil {
    knots: Vec<Knot>,
    side: usize,
}

impl Veil {
    /// Of a pearl that sees and holds light so.
    pub fn new(glimpses: &Glimpses, inside: &Subsurface) -> Self {
        let net = &glimpses.net;
        let knot = |(number, seen): (usize, &[_; 2])| knot(net, inside, number, seen);
        let coarse: Vec<Knot> = glimpses.knots.iter().enumerate().map(knot).collect();
        let (knots, side) = finer(&coarse, net.side());
        Self { knots, side }
    }

    /// Between the four nearest knots, at a place in the coarse net.
    #[inline]
    pub(super) fn at(&self, [x, y]: [f32; 2]) -> Knot {
        let (x, y) = (2.0 * (x - FIRST), 2.0 * (y - FIRST));
        let (column, row) = (x as usize, y as usize);
        let (aside, below) = (x - column as f32, y - row as f32);
        let first = row * self.side + column;
        let shares = [
            (first, (1.0 - aside) * (1.0 - below)),
            (first + 1, aside * (1.0 - below)),
            (first + self.side, (1.0 - aside) * below),
            (first + self.side + 1, aside * below),
        ];
        let mut sum = [0.0; KNOT];
        for (knot, share) in shares {
            let knot = &self.knots[knot];
            for i in 0..KNOT {
                sum[i] += share * knot[i];
            }
        }
        sum
    }
}

/// The first knot of the coarse net, on either side, that is in the fine one: cubics need one more.
const FIRST: f32 = 1.0;

/// What there is at a knot.
fn knot(net: &Net, inside: &Subsurface, number: usize, seen: &[Glimpse; 2]) -> Knot {
    let plain = net.normal(number).map(|normal| inside.plain(normal)).unwrap_or_default();
    let of_lobes = seen.iter().flat_map(|glimpse| [glimpse.light, glimpse.lean]);
    let mut knot = [0.0; KNOT];
    for (to, from) in knot.iter_mut().zip(plain.into_iter().chain(of_lobes.flatten())) {
        *to = from as f32;
    }
    knot
}

/// The net with a knot more between each two, and how many it has along a side.
fn finer(coarse: &[Knot], side: usize) -> (Vec<Knot>, usize) {
    let finer_side = 2 * (side - 3) + 1;
    let halfway = cubic(0.5).map(|weight| weight as f32);
    let between = |knots: &[Knot], first: usize, step: usize| {
        let mut sum = [0.0; KNOT];
        for (i, weight) in halfway.into_iter().enumerate() {
            let knot = &knots[first + i * step];
            for k in 0..KNOT {
                sum[k] += weight * knot[k];
            }
        }
        sum
    };
    let mut wide = Vec::with_capacity(side * finer_side);
    for row in 0..side {
        for column in 0..finer_side {
            let first = row * side + column / 2;
            let is_knot = column % 2 == 0;
            wide.push(if is_knot { coarse[first + 1] } else { between(coarse, first, 1) });
        }
    }
    let mut fine = Vec::with_capacity(finer_side * finer_side);
    for row in 0..finer_side {
        for column in 0..finer_side {
            let first = row / 2 * finer_side + column;
            let is_knot = row % 2 == 0;
            let knot = || between(&wide, first, finer_side);
            fine.push(if is_knot { wide[first + finer_side] } else { knot() });
        }
    }
    (fine, finer_side)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_knots_is_what_a_parabola_has_there() {
        let side = 11;
        let law = |x: f64, y: f64| 1.0 + 0.3 * x - 0.02 * x * x + 0.01 * y * y - 0.03 * x * y;
        let knot = |i: usize| [law((i % side) as f64, (i / side) as f64) as f32; KNOT];
        let coarse: Vec<Knot> = (0..side * side).map(knot).collect();
        let (knots, side) = finer(&coarse, side);
        let veil = Veil { knots, side };
        for i in 0..100 {
            let [x, y] = [2.0 + 0.5 * f64::from(i % 13), 2.0 + 0.5 * f64::from(i / 13)];
            let found = f64::from(veil.at([x as f32, y as f32])[7]);
            assert!((found - law(x, y)).abs() < 1e-5, "{x} {y}: {found} {}", law(x, y));
        }
    }
}
