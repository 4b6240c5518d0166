//! Cosine and sine of a phase given in cycles.
//!
//! The platform's own are slower and differ in the last bit between platforms; a picture must not.
//! Plain arithmetic, so the compiler runs a whole row of wavelengths at once.

use std::f64::consts::PI;

/// Adding and subtracting 1.5 * 2^52 rounds to the nearest integer for |x| < 2^51.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Taylor coefficients of sin(pi f) and cos(pi f) in f^2, enough for |f| <= 1/2 in double precision.
const TERMS: usize = 11;
const SIN: [f64; TERMS] = taylor(1);
const COS: [f64; TERMS] = taylor(0);

/// (-1)^j pi^m / m! for m = first, first + 2, ...
const fn taylor(first: usize) -> [f64; TERMS] {
    let mut series = [0.0; TERMS];
    let mut term = if first == 1 { PI } else { 1.0 };
    let mut j = 0;
    while j < TERMS {
        series[j] = term;
        let m = (first + 2 * j) as f64;
        term = -term * PI * PI / ((m + 1.0) * (m + 2.0));
        j += 1;
    }
    series
}

/// (cos, sin) of 2 pi `cycles`, to 2e-15, for |cycles| < 1e9.
#[inline(always)]
pub(crate) fn cos_sin(cycles: f64) -> (f64, f64) {
    let f = cycles - ((cycles + ROUND) - ROUND);
    let f2 = f * f;
    let (mut half_sin, mut half_cos) = (SIN[TERMS - 1], COS[TERMS - 1]);
    for j in (0..TERMS - 1).rev() {
        half_sin = half_sin * f2 + SIN[j];
        half_cos = half_cos * f2 + COS[j];
    }
    half_sin *= f;
    (1.0 - 2.0 * half_sin * half_sin, 2.0 * half_sin * half_cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_platform_over_many_cycles() {
        for step in 0..200_000 {
            let cycles = f64::from(step) * 0.007_31 - 731.0;
            let (cos, sin) = cos_sin(cycles);
            let exact = 2.0 * PI * (cycles - cycles.round());
            assert!((cos - exact.cos()).abs() < 2e-15 && (sin - exact.sin()).abs() < 2e-15);
        }
    }
}
