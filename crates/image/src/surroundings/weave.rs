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
#[multiversion(targets("x86_64+avx2"))]
pub(super) fn weave(place: [f64; 2], widths: [f64; 2]) -> f64 {
    let exponent = widths.map(|width| 0.5 * (PI * 0.25 * width).powi(2));
    if exponent[0] + exponent[1] > FADED {
        return 0.5;
    }
    let wave = Harmonics::new(place, exponential(exponent.map(|exponent| -exponent)));
    let sum =
        |i: usize, j: usize| wave.cos[i][0] * wave.cos[j][1] - wave.sin[i][0] * wave.sin[j][1];
    let difference = wave.cos[0][0] * wave.cos[0][1] + wave.sin[0][0] * wave.sin[0][1];
    let mut depth = 0.5 - 0.5 / PI * difference;
    for (i, own) in OWN.iter().enumerate() {
        depth -= own * sum(i, i);
    }
    for (i, other) in OTHER.iter().enumerate() {
        depth -= other * (sum(i + 1, i) + sum(i, i + 1));
    }
    depth
}

/// Of cos t |cos t| / 4, the odd harmonics.
const OWN: [f64; 4] =
    [2.0 / (3.0 * PI), 2.0 / (15.0 * PI), -2.0 / (105.0 * PI), 2.0 / (315.0 * PI)];
/// Of |cos t| / 8, the even harmonics from the second on.
const OTHER: [f64; 3] = [0.5 / (3.0 * PI), -0.5 / (15.0 * PI), 0.5 / (35.0 * PI)];
/// Beyond this exponent of a Gaussian a weave is even: of its contrast a thousandth is left.
const FADED: f64 = 6.9;

/// Odd harmonics of two angles side by side, each faded as a Gaussian fades it: the first, third, fifth and seventh.
struct Harmonics {
    cos: [[f64; 2]; 4],
    sin: [[f64; 2]; 4],
}

impl Harmonics {
    /// Of angles in half turns.
    #[inline(always)]
    fn new(half_turns: [f64; 2], fade: [f64; 2]) -> Self {
        let (sin, cos) = circle(half_turns);
        let mut harmonics = Self { cos: [cos; 4], sin: [sin; 4] };
        for axis in 0..2 {
            let (sin, cos) = (sin[axis], cos[axis]);
            let (twice_cos, twice_sin) = (cos * cos - sin * sin, 2.0 * sin * cos);
            for i in 1..4 {
                let (cos, sin) = (harmonics.cos[i - 1][axis], harmonics.sin[i - 1][axis]);
                harmonics.cos[i][axis] = cos * twice_cos - sin * twice_sin;
                harmonics.sin[i][axis] = sin * twice_cos + cos * twice_sin;
            }
            // To the power of the square of each order: 1, 9, 25, 49.
            let square = |x: f64| x * x;
            let fade = fade[axis];
            let eighth = square(square(square(fade)));
            let (ninth, sixteenth) = (eighth * fade, square(eighth));
            let faded = [fade, ninth, sixteenth * ninth, square(sixteenth) * (sixteenth * fade)];
            for (i, faded) in faded.into_iter().enumerate() {
                harmonics.cos[i][axis] *= faded;
                harmonics.sin[i][axis] *= faded;
            }
        }
        harmonics
    }
}

/// Added and taken away again, it leaves the nearest whole number: beyond it a number has no fraction.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Sines and cosines of two angles in half turns, far below 1e15. Taylor's series within an eighth of a turn.
#[inline(always)]
fn circle(half_turns: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let shifted = half_turns.map(|half_turns| 2.0 * half_turns + WHOLE);
    let angle = [0, 1].map(|i| PI * (half_turns[i] - 0.5 * (shifted[i] - WHOLE)));
    // Both series of both angles side by side; the sine's lacks the last term.
    let square = [0, 1, 0, 1].map(|i: usize| angle[i] * angle[i]);
    let mut sum = [0.0; 4];
    for n in (0..COSINE.len()).rev() {
        let sine = if n < SINE.len() { SINE[n] } else { 0.0 };
        let terms = [sine, sine, COSINE[n], COSINE[n]];
        for lane in 0..4 {
            sum[lane] = sum[lane] * square[lane] + terms[lane];
        }
    }
    let turned = [0, 1].map(|i| {
        let (sin, cos) = (angle[i] * sum[i], sum[i + 2]);
        // Quarter turns are in the last bits of what was shifted.
        match shifted[i].to_bits() & 3 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    });
    (turned.map(|(sin, _)| sin), turned.map(|(_, cos)| cos))
}

/// The exponentials of two numbers from -700 to 700: 2 to a whole power, and Taylor's series within half of one.
#[inline(always)]
fn exponential(x: [f64; 2]) -> [f64; 2] {
    let shifted = x.map(|x| x * LOG2_E + WHOLE);
    let power = shifted.map(|shifted| shifted - WHOLE);
    let rest = [0, 1].map(|i| x[i] - power[i] * LN_2);
    let mut series = [0.0; 2];
    for term in EXPONENTIAL.iter().rev() {
        for lane in 0..2 {
            series[lane] = series[lane] * rest[lane] + term;
        }
    }
    [0, 1].map(|i| {
        let biased = (power[i] as i64 + 1023) as u64;
        series[i] * f64::from_bits(biased << 52)
    })
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
            let (found, (sin, cos)) = (exponential(both.map(|x| -x.abs())), circle(both));
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
