//! Plain weave, averaged over a footprint.
//!
//! A Fourier series; its exponentials and circles by polynomials, right to 1e-15, since a picture asks for millions.
//! Left out: relief, and how the eye sees threads in perspective.

use std::f64::consts::{LN_2, LOG2_E, PI};

/// Plain weave: depth between threads, 0 on a crown, 1 in a gap, mean 1/2, with period 2; averaged over a Gaussian as
/// wide as even discs of these widths along x and z.
///
/// With p = cos(pi x) cos(pi z) and c = cos(pi (x + z)) it is 1/2 - p |c| / 2, here by the cosines of its Fourier series,
/// each faded by the Gaussian; where all are kept, they are right to 0.02.
pub(super) fn weave([x, z]: [f64; 2], widths: [f64; 2]) -> f64 {
    let exponent = widths.map(|width| 0.5 * (PI * 0.25 * width).powi(2));
    if exponent[0] + exponent[1] > FADED {
        return 0.5;
    }
    let [fade_x, fade_z] = exponent.map(|exponent| exponential(-exponent));
    let (wave_x, wave_z) = (Harmonics::new(x, fade_x), Harmonics::new(z, fade_z));
    let sum = |i, j| wave_x.cos[i] * wave_z.cos[j] - wave_x.sin[i] * wave_z.sin[j];
    let difference = wave_x.cos[0] * wave_z.cos[0] + wave_x.sin[0] * wave_z.sin[0];
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

/// Odd harmonics of an angle, each faded as a Gaussian fades it: the first, third, fifth and seventh.
struct Harmonics {
    cos: [f64; 4],
    sin: [f64; 4],
}

impl Harmonics {
    /// Of an angle in half turns.
    fn new(half_turns: f64, fade: f64) -> Self {
        let (sin, cos) = circle(half_turns);
        let (twice_cos, twice_sin) = (cos * cos - sin * sin, 2.0 * sin * cos);
        let mut harmonics = Self { cos: [cos; 4], sin: [sin; 4] };
        for i in 1..4 {
            let (cos, sin) = (harmonics.cos[i - 1], harmonics.sin[i - 1]);
            harmonics.cos[i] = cos * twice_cos - sin * twice_sin;
            harmonics.sin[i] = sin * twice_cos + cos * twice_sin;
        }
        // To the power of the square of each order: 1, 9, 25, 49.
        let square = |x: f64| x * x;
        let (eighth, sixteenth) =
            (square(square(square(fade))), square(square(square(square(fade)))));
        let ninth = eighth * fade;
        let faded = [fade, ninth, sixteenth * ninth, square(sixteenth) * (sixteenth * fade)];
        for (i, faded) in faded.into_iter().enumerate() {
            harmonics.cos[i] *= faded;
            harmonics.sin[i] *= faded;
        }
        harmonics
    }
}

/// Added and taken away again, it leaves the nearest whole number: beyond it a number has no fraction.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Sine and cosine of an angle in half turns, far below 1e15. Taylor's series within an eighth of a turn.
fn circle(half_turns: f64) -> (f64, f64) {
    let shifted = 2.0 * half_turns + WHOLE;
    let angle = PI * (half_turns - 0.5 * (shifted - WHOLE));
    let square = angle * angle;
    let series = |terms: &[f64]| terms.iter().rev().fold(0.0, |sum, term| sum * square + term);
    let (sin, cos) = (angle * series(&SINE), series(&COSINE));
    // Quarter turns are in the last bits of what was shifted.
    match shifted.to_bits() & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// The exponential of a number from -700 to 700: 2 to a whole power, and Taylor's series within half of one.
fn exponential(x: f64) -> f64 {
    let shifted = x * LOG2_E + WHOLE;
    let power = shifted - WHOLE;
    let rest = x - power * LN_2;
    let series = EXPONENTIAL.iter().rev().fold(0.0, |sum, term| sum * rest + term);
    let biased = (power as i64 + 1023) as u64;
    series * f64::from_bits(biased << 52)
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
            let (exact, found) = (libm::exp(-x.abs()), exponential(-x.abs()));
            assert!((found / exact - 1.0).abs() < 2e-15, "{x}: {found} {exact}");
            let ((sin, cos), (law_sin, law_cos)) = (circle(x), libm::sincos(PI * x));
            assert!((sin - law_sin).abs() < 1e-14 && (cos - law_cos).abs() < 1e-14, "{x}");
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
