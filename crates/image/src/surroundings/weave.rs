//! Plain weave, averaged over a footprint.
//!
//! A Fourier series; its exponentials and circles by polynomials, right to 1e-15, since a picture asks for millions.
//! Left out: relief, and how the eye sees threads in perspective.
// Only what is inlined is compiled with the vector instructions of the function that calls it.
#![allow(clippy::inline_always)]

use std::f64::consts::{LN_2, LOG2_E, PI};

use multiversion::multiversion;

/// Plain weave: depth between threads, 0 on a crown, 1 in a gap, mean 1/2, with period 2; averaged over a Gaussian as
/// wide as even discs of these widths along x and z.
///
/// With p = cos(pi x) cos(pi z) and c = cos(pi (x + z)) it is 1/2 - p |c| / 2, here by the cosines of its Fourier series,
/// each faded by the Gaussian; where all are kept, they are right to 0.02.
pub(super) fn weave([x, z]: [f64; 2], [wide, deep]: [f64; 2]) -> f64 {
    let exponent = [exponent(wide), exponent(deep)];
    if exponent[0] + exponent[1] > FADED {
        return EVEN;
    }
    one(x, z, exponent[0], exponent[1])
}

/// So many places are looked at side by side.
pub(crate) const LANES: usize = 4;

/// [`weave`] at several places, each axis in turn: the same numbers, to the bit.
pub(super) fn weaves(places: Axes<LANES>, widths: Axes<LANES>) -> [f64; LANES] {
    let exponents = widths.map(|widths| widths.map(exponent));
    let is_even: [bool; LANES] =
        std::array::from_fn(|lane| exponents[0][lane] + exponents[1][lane] > FADED);
    if is_even == [true; LANES] {
        return [EVEN; LANES];
    }
    let depths = several(places, exponents);
    std::array::from_fn(|lane| if is_even[lane] { EVEN } else { depths[lane] })
}

/// Along x and along z, of places side by side.
pub(super) type Axes<const N: usize> = [[f64; N]; 2];

/// How a Gaussian as wide as an even disc fades the first harmonic.
fn exponent(width: f64) -> f64 {
    0.5 * (PI * 0.25 * width).powi(2)
}

#[multiversion(targets("x86_64+avx2"))]
fn one(x: f64, z: f64, wide: f64, deep: f64) -> f64 {
    let axes = Harmonics::new([x, z], [wide, deep]);
    depths(&axes.alone(0), &axes.alone(1))[0]
}

#[multiversion(targets("x86_64+avx2"))]
fn several(places: Axes<LANES>, exponents: Axes<LANES>) -> [f64; LANES] {
    let x = Harmonics::new(places[0], exponents[0]);
    let z = Harmonics::new(places[1], exponents[1]);
    depths(&x, &z)
}

#[inline(always)]
fn depths<const N: usize>(x: &Harmonics<N>, z: &Harmonics<N>) -> [f64; N] {
    let mut depths = [EVEN; N];
    for lane in 0..N {
        let difference = x.cos[0][lane] * z.cos[0][lane] + x.sin[0][lane] * z.sin[0][lane];
        depths[lane] -= 0.5 / PI * difference;
    }
    for i in 0..OWN.len() {
        let sum = x.sum(i, z, i);
        for lane in 0..N {
            depths[lane] -= OWN[i] * sum[lane];
        }
    }
    for i in 0..OTHER.len() {
        let (before, behind) = (x.sum(i + 1, z, i), x.sum(i, z, i + 1));
        for lane in 0..N {
            depths[lane] -= OTHER[i] * (before[lane] + behind[lane]);
        }
    }
    depths
}

/// The mean.
const EVEN: f64 = 0.5;
/// Of cos t |cos t| / 4, the odd harmonics.
const OWN: [f64; 4] =
    [2.0 / (3.0 * PI), 2.0 / (15.0 * PI), -2.0 / (105.0 * PI), 2.0 / (315.0 * PI)];
/// Of |cos t| / 8, the even harmonics from the second on.
const OTHER: [f64; 3] = [0.5 / (3.0 * PI), -0.5 / (15.0 * PI), 0.5 / (35.0 * PI)];
/// Beyond this exponent of a Gaussian a weave is even: of its contrast a thousandth is left.
const FADED: f64 = 6.9;

/// Odd harmonics of angles side by side, each faded as a Gaussian fades it: the first, third, fifth and seventh.
struct Harmonics<const N: usize> {
    cos: [[f64; N]; 4],
    sin: [[f64; N]; 4],
}

impl<const N: usize> Harmonics<N> {
    /// Of angles in half turns, the first faded by one over the exponential of an exponent.
    #[inline(always)]
    fn new(half_turns: [f64; N], exponents: [f64; N]) -> Self {
        let ((sin, cos), fade) = (circle(half_turns), faded(exponents));
        let mut harmonics = Self { cos: [cos; 4], sin: [sin; 4] };
        for lane in 0..N {
            let (sin, cos) = (sin[lane], cos[lane]);
            let (twice_cos, twice_sin) = (cos * cos - sin * sin, 2.0 * sin * cos);
            for i in 1..4 {
                let (cos, sin) = (harmonics.cos[i - 1][lane], harmonics.sin[i - 1][lane]);
                harmonics.cos[i][lane] = cos * twice_cos - sin * twice_sin;
                harmonics.sin[i][lane] = sin * twice_cos + cos * twice_sin;
            }
            // To the power of the square of each order: 1, 9, 25, 49.
            let fade = fade[lane];
            let square = fade * fade;
            let fourth = square * square;
            let eighth = fourth * fourth;
            let (ninth, sixteenth) = (eighth * fade, eighth * eighth);
            let faded =
                [fade, ninth, sixteenth * ninth, (sixteenth * sixteenth) * (sixteenth * fade)];
            for i in 0..4 {
                harmonics.cos[i][lane] *= faded[i];
                harmonics.sin[i][lane] *= faded[i];
            }
        }
        harmonics
    }

    /// Those of one angle.
    #[inline(always)]
    fn alone(&self, lane: usize) -> Harmonics<1> {
        let mut alone = Harmonics { cos: [[0.0]; 4], sin: [[0.0]; 4] };
        for i in 0..4 {
            alone.cos[i][0] = self.cos[i][lane];
            alone.sin[i][0] = self.sin[i][lane];
        }
        alone
    }

    /// The cosines of one harmonic's angle and of one of another's together.
    #[inline(always)]
    fn sum(&self, own: usize, other: &Self, others: usize) -> [f64; N] {
        let mut sum = [0.0; N];
        for lane in 0..N {
            sum[lane] = self.cos[own][lane] * other.cos[others][lane]
                - self.sin[own][lane] * other.sin[others][lane];
        }
        sum
    }
}

/// Added and taken away again, it leaves the nearest whole number, and that number in the last bits of the sum: beyond it
/// a number has no fraction.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Sines and cosines of angles in half turns, far below 1e15. Taylor's series within an eighth of a turn.
#[inline(always)]
fn circle<const N: usize>(half_turns: [f64; N]) -> ([f64; N], [f64; N]) {
    let (mut shifted, mut angle, mut square) = ([0.0_f64; N], [0.0_f64; N], [0.0; N]);
    for i in 0..N {
        shifted[i] = 2.0 * half_turns[i] + WHOLE;
        angle[i] = PI * (half_turns[i] - 0.5 * (shifted[i] - WHOLE));
        square[i] = angle[i] * angle[i];
    }
    let (mut sine, mut cosine) = ([0.0; N], [0.0; N]);
    for n in (0..SINE.len()).rev() {
        for lane in 0..N {
            sine[lane] = sine[lane] * square[lane] + SINE[n];
        }
    }
    for n in (0..COSINE.len()).rev() {
        for lane in 0..N {
            cosine[lane] = cosine[lane] * square[lane] + COSINE[n];
        }
    }
    let (mut turned_sin, mut turned_cos) = ([0.0; N], [0.0; N]);
    for i in 0..N {
        let (sin, cos) = (angle[i] * sine[i], cosine[i]);
        // The number of quarter turns: odd ones change places, and the sign's bit is that of two.
        let quarters = shifted[i].to_bits();
        let (a, b) = if quarters & 1 == 0 { (sin, cos) } else { (cos, sin) };
        turned_sin[i] = f64::from_bits(a.to_bits() ^ ((quarters & 2) << 62));
        turned_cos[i] = f64::from_bits(b.to_bits() ^ ((quarters.wrapping_add(1) & 2) << 62));
    }
    (turned_sin, turned_cos)
}

/// One over the exponentials of numbers from 0 to 700: 2 to a whole power, and Taylor's series within half of one. Of
/// others something, without an error.
#[inline(always)]
fn faded<const N: usize>(exponents: [f64; N]) -> [f64; N] {
    let (mut shifted, mut rest, mut series) = ([0.0_f64; N], [0.0_f64; N], [0.0; N]);
    for i in 0..N {
        let x = -exponents[i];
        shifted[i] = x * LOG2_E + WHOLE;
        rest[i] = x - (shifted[i] - WHOLE) * LN_2;
    }
    for n in (0..EXPONENTIAL.len()).rev() {
        for lane in 0..N {
            series[lane] = series[lane] * rest[lane] + EXPONENTIAL[n];
        }
    }
    // The last bits of what was shifted are the power.
    for i in 0..N {
        series[i] *= f64::from_bits(shifted[i].to_bits().wrapping_add(1023) << 52);
    }
    series
}

/// 1 / n! with signs in turn: odd n, even n.
const SINE: [f64; 8] = alternating(1);
const COSINE: [f64; 9] = alternating(0);
/// 1 / n!
const EXPONENTIAL: [f64; 14] = {
    let mut terms = [1.0; 14];
    let mut n = 1;
    while n < 14 {
        terms[n] = terms[n - 1] / n as f64;
        n += 1;
    }
    terms
};

const fn alternating<const N: usize>(first: usize) -> [f64; N] {
    let mut terms = [1.0; N];
    let mut i = 1;
    while i < N {
        let n = 2 * i + first;
        terms[i] = -terms[i - 1] / (n * (n - 1)) as f64;
        i += 1;
    }
    terms
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponentials_and_circles_are_those_of_libm() {
        for i in 0..2000 {
            let x = f64::from(i) * 0.0137 - 13.0;
            let both = [x, 0.3 - 0.7 * x];
            let (found, (sin, cos)) = (faded(both.map(f64::abs)), circle(both));
            for (i, x) in both.into_iter().enumerate() {
                let exact = libm::exp(-x.abs());
                assert!((found[i] / exact - 1.0).abs() < 2e-15, "{x}: {} {exact}", found[i]);
                let (law_sin, law_cos) = libm::sincos(PI * x);
                assert!(
                    (sin[i] - law_sin).abs() < 1e-14 && (cos[i] - law_cos).abs() < 1e-14,
                    "{x}"
                );
            }
        }
    }

    #[test]
    fn places_side_by_side_have_the_depths_of_each_alone() {
        for i in 0..500 {
            let lane = |k: usize, step: f64| step * (LANES * i + k) as f64;
            let places = [0.0371, -0.0713].map(|step| std::array::from_fn(|k| lane(k, step)));
            // The last ones are faded.
            let widths = [0.0013, 0.0031].map(|step| std::array::from_fn(|k| lane(k, step)));
            for (k, depth) in weaves(places, widths).into_iter().enumerate() {
                let alone = weave(places.map(|x| x[k]), widths.map(|width| width[k]));
                assert_eq!(depth.to_bits(), alone.to_bits(), "{places:?} {widths:?}");
            }
        }
    }

    #[test]
    fn a_weave_under_a_footprint_is_its_mean_there() {
        let exact = |x: f64, z: f64| {
            let product = (PI * x).cos() * (PI * z).cos();
            0.5 - 0.5 * product * (PI * (x + z)).cos().abs()
        };
        for (width, deep) in [(1e-6, 1e-6), (0.3, 0.5), (1.0, 1.2), (1.5, 3.0)] {
            for (x, z) in [(0.0, 0.0), (0.3, 0.9), (1.0, 0.2), (0.5, 0.5)] {
                let (mut sum, mut weights) = (0.0, 0.0);
                for i in -40..=40 {
                    for j in -40..=40 {
                        let (u, v) = (0.1 * f64::from(i), 0.1 * f64::from(j));
                        let weight = (-0.5 * (u * u + v * v)).exp();
                        sum += weight * exact(x + 0.25 * width * u, z + 0.25 * deep * v);
                        weights += weight;
                    }
                }
                let found = weave([x, z], [width, deep]);
                assert!((found - sum / weights).abs() < 0.02, "{width} {x} {z}: {found}");
            }
        }
    }
}
