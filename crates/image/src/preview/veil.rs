//! A film's view of a pearl at the knots of its net: light inside and what its lobes mirror, ready for the pixels.
//!
//! Cubics to a fine net, straight lines between its knots.
//! Left out: what the film makes of the lobes' mean light, which changes faster and is left to the pixel.

use crate::{
    parallel,
    pearl::{
        net::{Net, cubic},
        reflection_cache::Around,
        response::Response,
        subsurface::Subsurface,
    },
    preview::glimpses::{Glimpses, LEAST_COSINE},
    shape::ball::Ball,
    view::camera::Camera,
};

/// Numbers at a knot: light inside through a film without colour, mean light of each lobe and what is
/// mirrored beyond it, and one to fill.
const KNOT: usize = 16;
pub(super) type Knot = [f32; KNOT];

/// Knots of the fine net from the middle of a pearl to its edge: straight lines between them are right to less than a
/// code **(ours)**.
const FINE: usize = 64;
/// Of the net of light inside, which changes softly.
const INSIDE: usize = 12;

/// All light of a pearl by place, as its film leaves it for the pixels.
#[derive(Debug)]
pub struct Veil {
    net: Net,
    knots: Vec<Knot>,
}

impl Veil {
    /// Of a pearl before a camera, with light inside.
    pub fn new(
        glimpses: &Glimpses,
        response: &Response,
        inside: &Subsurface,
        (camera, place): (&Camera, &Ball),
    ) -> Self {
        let net = fine_net(glimpses);
        let mut veil = Self { knots: vec![[0.0; KNOT]; net.side() * net.side()], net };
        let softly = Net::new(glimpses.seen, INSIDE);
        let of_inside = |knot| softly.normal(knot).map(|normal| inside.plain(normal));
        veil.lay(&softly, 0, |knot| of_inside(knot).unwrap_or_default());
        let lobes = glimpses.lobes.iter().zip(response.films().middle());
        for (number, (lobe, colours)) in lobes.enumerate() {
            let around = |knot: usize| {
                let normal = lobe.net.normal(knot)?;
                let view = camera.toward_eye(place.centre + normal * place.radius_mm).0;
                Some(lobe.around(knot, colours, normal.dot(view).max(LEAST_COSINE)))
            };
            veil.lay(&lobe.net, 3 + 6 * number, |knot| {
                let Around { light: [a, b, c], rest: [d, e, f] } = around(knot).unwrap_or_default();
                [a, b, c, d, e, f]
            });
        }
        veil
    }

    /// Between the four nearest knots.
    #[inline]
    pub(super) fn at(&self, [x, y]: [f32; 2]) -> Knot {
        let side = self.net.side();
        let (column, row) = (x as usize, y as usize);
        let (aside, below) = (x - column as f32, y - row as f32);
        let first = row * side + column;
        let shares = [
            (first, (1.0 - aside) * (1.0 - below)),
            (first + 1, aside * (1.0 - below)),
            (first + side, (1.0 - aside) * below),
            (first + side + 1, aside * below),
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

    /// Puts numbers that are known at the knots of a coarser net into each knot, from number `first` on.
    fn lay<const N: usize>(
        &mut self,
        coarse: &Net,
        first: usize,
        at: impl Fn(usize) -> [f64; N] + Sync,
    ) {
        let (side, coarse_side) = (self.net.side(), coarse.side());
        let known = parallel::map(coarse_side * coarse_side, |knot| at(knot).map(|n| n as f32));
        let taps: Vec<Tap> = (0..side).map(|knot| tap(&self.net, coarse, knot)).collect();
        let mut wide = vec![[0.0_f32; N]; coarse_side * side];
        for (row, wide) in wide.chunks_exact_mut(side).enumerate() {
            for (sum, (knot, weights)) in wide.iter_mut().zip(&taps) {
                *sum = weighted(&known, row * coarse_side + knot, 1, weights);
            }
        }
        for (row, knots) in self.knots.chunks_exact_mut(side).enumerate() {
            let (knot, weights) = &taps[row];
            for (column, to) in knots.iter_mut().enumerate() {
                let sum = weighted(&wide, knot * side + column, side, weights);
                to[first..first + N].copy_from_slice(&sum);
            }
        }
    }
}

/// The net in whose knots pixels have their place.
pub(super) fn fine_net(glimpses: &Glimpses) -> Net {
    Net::new(glimpses.seen, FINE)
}

/// The first of four knots around a place along an axis, and their weights.
type Tap = (usize, [f32; 4]);

/// Around a knot of a finer net.
fn tap(fine: &Net, coarse: &Net, knot: usize) -> Tap {
    let from_middle = knot as f64 - fine.middle();
    let x = from_middle * coarse.half() / fine.half() + coarse.middle();
    // Beyond the last knots that cubics have, the outermost cubic goes on.
    let first = (x as usize).saturating_sub(1).min(coarse.side() - 4);
    (first, cubic(x - (first + 1) as f64).map(|weight| weight as f32))
}

#[inline]
fn weighted<const N: usize>(
    knots: &[[f32; N]],
    first: usize,
    step: usize,
    weights: &[f32; 4],
) -> [f32; N] {
    let mut sum = [0.0; N];
    for (i, weight) in weights.iter().enumerate() {
        let knot = &knots[first + i * step];
        for k in 0..N {
            sum[k] += weight * knot[k];
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn between_knots_is_what_a_parabola_has_there() {
        let seen = (DVec3::Z, 1.4);
        let (net, coarse) = (Net::new(seen, FINE), Net::new(seen, 9));
        let law = |x: f64, y: f64| 1.0 + 0.3 * x - 0.2 * x * x + 0.1 * y * y - 0.3 * x * y;
        let mut veil = Veil { knots: vec![[0.0; KNOT]; net.side() * net.side()], net };
        let at = |knot: usize| {
            let along = |i: usize| (i as f64 - coarse.middle()) / coarse.half();
            [law(along(knot % coarse.side()), along(knot / coarse.side()))]
        };
        veil.lay(&coarse, 7, at);
        for i in 0..100 {
            let [x, y] = [f64::from(i % 10), f64::from(i / 10)].map(|i| 0.2 * i - 0.9);
            let place = [x, y].map(|x| (x * veil.net.half() + veil.net.middle()) as f32);
            let found = f64::from(veil.at(place)[7]);
            assert!((found - law(x, y)).abs() < 1e-3, "{x} {y}: {found} {}", law(x, y));
        }
    }
}
