//! From coefficients to a field on the whole sphere, in one Legendre pass.
//!
//! Rings of constant colatitude share their Legendre functions: they are summed over l
//! first, and one Fourier transform per ring finishes the work. A ring and its mirror image in the
//! equator differ by the sign of the odd l - m only, so that both come from the same two sums, and
//! travel through the transform as the real and the imaginary part of one signal.

use crate::harmonics::{
    coefficients::{CHANNELS, Coefficients},
    fourier::{InverseTransform, Signal},
    legendre::{LANES, Lanes, Recursion, Scaled, legendre},
};
use crate::parallel;
use std::f64::consts::PI;

/// Groups of `LANES` ring pairs that share the walk through the coefficients, which is long.
const GROUPS: usize = 4;

/// Fills `grid` with the fields of degree up to `top`, on `rows` rows and twice as many columns.
///
/// Row r lies at colatitude `(r + 1/2) pi / rows`, column c at longitude `c pi / rows`. `rows` is even,
/// greater than `top` (which does not exceed the coefficients' band limit), and 1 or 3 times a power of
/// two. The grid holds one row after the other, `pitch` cells from one to the next; cells beyond the
/// last column stay as they are. Each cell is what `texel` makes of the three channels' values.
pub fn synthesise<T: Send>(
    coefficients: &Coefficients,
    top: usize,
    (rows, pitch): (usize, usize),
    texel: impl Fn([f64; CHANNELS]) -> T + Sync,
    grid: &mut [T],
) {
    debug_assert!(rows > top && top <= coefficients.band_limit() && pitch >= 2 * rows);
    let pass = Pass { coefficients, recursion: Recursion::new(top), top, rows };
    let transform = InverseTransform::new(2 * rows);
    let pairs = LANES * GROUPS;
    let halves = grid.split_at_mut(rows / 2 * pitch);
    parallel::for_mirrored_chunks(halves, pairs * pitch, |block, north, south| {
        let groups = pass.sum_over_degrees(block * pairs);
        let mut signals = [(); CHANNELS].map(|()| Signal::zero(2 * rows));
        let mut scratch = Signal::zero(2 * rows);
        let rings = north.chunks_mut(pitch).zip(south.rchunks_mut(pitch));
        for (pair, (north, south)) in rings.enumerate() {
            for (channel, signal) in signals.iter_mut().enumerate() {
                load(signal, &groups[pair / LANES].orders, channel, pair % LANES);
                transform.apply(signal, &mut scratch);
            }
            for (column, (n, s)) in north.iter_mut().zip(south).take(2 * rows).enumerate() {
                *n = texel(signals.each_ref().map(|signal| signal.re[column]));
                *s = texel(signals.each_ref().map(|signal| signal.im[column]));
            }
        }
    });
}

/// One order m of a block of ring pairs: [channel][sum over even l - m, over odd l - m][re, im].
type Order = [[[Lanes; 2]; 2]; CHANNELS];

/// Puts north + i south of one channel and ring pair into `signal`, frequency by frequency.
fn load(signal: &mut Signal, orders: &[Order], channel: usize, lane: usize) {
    signal.re.fill(0.0);
    signal.im.fill(0.0);
    let length = signal.re.len();
    for (m, order) in orders.iter().enumerate() {
        let [even, odd] = order[channel].map(|sum| sum.map(|part| part[lane]));
        let (north, south) =
            ([even[0] + odd[0], even[1] + odd[1]], [even[0] - odd[0], even[1] - odd[1]]);
        if m == 0 {
            (signal.re[0], signal.im[0]) = (north[0], south[0]);
        } else {
            (signal.re[m], signal.im[m]) = (north[0] - south[1], north[1] + south[0]);
            (signal.re[length - m], signal.im[length - m]) =
                (north[0] + south[1], south[0] - north[1]);
        }
    }
}

/// What all blocks of rings share.
struct Pass<'a> {
    coefficients: &'a Coefficients,
    recursion: Recursion,
    top: usize,
    rows: usize,
}

impl Pass<'_> {
    /// The sums over l for every order m, for the ring pairs from row `first` on.
    fn sum_over_degrees(&self, first: usize) -> [Group; GROUPS] {
        let mut groups = std::array::from_fn(|group| Group::new(first + group * LANES, self.rows));
        let mut column = vec![[0.0; LANES]; self.top + 1];
        for m in 0..=self.top {
            let (steps, coefficients) =
                (self.recursion.column(m), self.coefficients.column(m, self.top));
            for group in &mut groups {
                group.sum_order(m, steps, coefficients, &mut column);
            }
        }
        groups
    }
}

/// Ring pairs that share registers, on their way from m = 0 up.
struct Group {
    sin: Lanes,
    cos: Lanes,
    sectoral: Scaled,
    /// Ends early near the poles, where high orders are smaller than 2^-120.
    orders: Vec<Order>,
}

impl Group {
    fn new(first: usize, rows: usize) -> Self {
        let angle: Lanes =
            std::array::from_fn(|lane| ((first + lane) as f64 + 0.5) * PI / rows as f64);
        let (sin, cos) = (angle.map(libm::sin), angle.map(libm::cos));
        Self { sin, cos, sectoral: Scaled::start(), orders: Vec::new() }
    }

    /// Adds order m, unless an order before was already too small to count.
    fn sum_order(
        &mut self,
        m: usize,
        steps: &[[f64; 2]],
        coefficients: &[[[f64; 2]; CHANNELS]],
        column: &mut [Lanes],
    ) {
        if self.orders.len() == m
            && let Some(seen) = legendre(steps, &self.cos, &self.sectoral, column)
        {
            self.orders.push(sum_order(&coefficients[seen..], &column[seen..]));
            self.sectoral.step(m, &self.sin);
        }
    }
}

/// Sums coefficient times Legendre function over l, even and odd l - m apart, an even one first.
fn sum_order(coefficients: &[[[f64; 2]; CHANNELS]], column: &[Lanes]) -> Order {
    let mut order = [[[[0.0; LANES]; 2]; 2]; CHANNELS];
    for (channel, sums) in order.iter_mut().enumerate() {
        for (parity, sum) in sums.iter_mut().enumerate() {
            let (mut re, mut im) = ([0.0; LANES], [0.0; LANES]);
            for (a, legendre) in coefficients.iter().zip(column).skip(parity).step_by(2) {
                let [a_re, a_im] = a[channel];
                for lane in 0..LANES {
                    re[lane] += a_re * legendre[lane];
                    im[lane] += a_im * legendre[lane];
                }
            }
            *sum = [re, im];
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_hemispheres_follow_a_harmonic_round_the_sphere() {
        let rows = 16;
        let mut coefficients = Coefficients::zero(3);
        coefficients.at_mut(3, 2)[1] = [0.25, -0.5];
        let mut grid = vec![[0.0; CHANNELS]; 2 * rows * rows];
        synthesise(&coefficients, 3, (rows, 2 * rows), |texel| texel, &mut grid);
        for (index, texel) in grid.iter().enumerate() {
            let theta = (index / (2 * rows)) as f64 * PI / 16.0 + PI / 32.0;
            let phi = (index % (2 * rows)) as f64 * PI / 16.0;
            let legendre = (105.0 / (32.0 * PI)).sqrt() * theta.sin().powi(2) * theta.cos();
            let wave = 0.25 * (2.0 * phi).cos() + 0.5 * (2.0 * phi).sin();
            assert!((texel[1] - 2.0 * legendre * wave).abs() < 1e-15);
            assert!(texel[0].abs() + texel[2].abs() < 1e-300);
        }
    }
}
