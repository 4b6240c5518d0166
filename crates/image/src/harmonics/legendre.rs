//! Associated Legendre functions, orthonormal, for many rings of latitude at once and any degree.
//!
//! Source of the recursion: any text on geodesy; of the scaling against underflow: Fukushima,
//! "Numerical computation of spherical harmonics of arbitrary degree and order by extending exponent
//! of floating point numbers", J. Geodesy 86 (2012), whose idea is taken in a coarser form.

use std::f64::consts::PI;

/// Ring pairs summed at once, as many as keep the processor's registers full.
pub(crate) const LANES: usize = 8;
/// Steps in l (an even number) between two looks at the scale; one step grows by less than 2^6, as
/// long as l is below 1000.
const STRIDE: usize = 16;
/// 2^400: a value at depth d stands for itself times 2^(-400 d).
const SCALE: f64 = f64::from_bits((1023 + 400) << 52);
/// 2^200: the bound between depths.
const HALF_SCALE: f64 = f64::from_bits((1023 + 200) << 52);

/// One number for each ring pair.
pub(crate) type Lanes = [f64; LANES];

/// Factors of `P_l = alpha x P_(l-1) - beta P_(l-2)` at fixed m, column m after column m - 1.
pub(crate) struct Recursion {
    top: usize,
    steps: Vec<[f64; 2]>,
}

impl Recursion {
    pub fn new(top: usize) -> Self {
        let mut steps = Vec::with_capacity((top + 1) * (top + 2) / 2);
        for m in 0..=top {
            let square = |n: usize| (n * n) as f64;
            let alpha = |l| ((4.0 * square(l) - 1.0) / (square(l) - square(m))).sqrt();
            // Factors that lead from l to l + 1, for l = m..=top.
            steps.push([alpha(m + 1), 0.0]);
            steps.extend((m + 1..=top).map(|l| [alpha(l + 1), alpha(l + 1) / alpha(l)]));
        }
        Self { top, steps }
    }

    pub fn column(&self, m: usize) -> &[[f64; 2]] {
        let start = m * (2 * self.top + 3 - m) / 2;
        &self.steps[start..=start + self.top - m]
    }
}

/// `P_mm` on every lane, scaled so that sin(theta)^m never underflows.
#[derive(Debug)]
pub(crate) struct Scaled {
    value: Lanes,
    depth: [u32; LANES],
}

impl Scaled {
    /// `P_00` = 1 / sqrt(4 pi).
    pub fn start() -> Self {
        Self { value: [1.0 / (4.0 * PI).sqrt(); LANES], depth: [0; LANES] }
    }

    /// From m to m + 1.
    pub fn step(&mut self, m: usize, sin: &Lanes) {
        let factor = -((2 * m + 3) as f64 / (2 * m + 2) as f64).sqrt();
        for ((value, depth), sin) in self.value.iter_mut().zip(&mut self.depth).zip(sin) {
            *value *= factor * sin;
            if value.abs() < 1.0 / HALF_SCALE {
                *value *= SCALE;
                *depth += 1;
            }
        }
    }
}

/// Fills `column` with `P_lm` for l = m, m + 1, ... and gives the first l - m worth summing.
///
/// None if all lanes stay below 2^-120 to the last l: then no higher order counts either.
pub(crate) fn legendre(
    steps: &[[f64; 2]],
    cos: &Lanes,
    start: &Scaled,
    column: &mut [Lanes],
) -> Option<usize> {
    let Scaled { value: mut now, mut depth } = *start;
    let mut before: Lanes = [0.0; LANES];
    let mut seen = None;
    for (chunk, steps) in steps.chunks(STRIDE).enumerate() {
        let mut visible = [0.0; LANES];
        for lane in 0..LANES {
            if depth[lane] > 0 && now[lane].abs().max(before[lane].abs()) > HALF_SCALE {
                now[lane] /= SCALE;
                before[lane] /= SCALE;
                depth[lane] -= 1;
            }
            visible[lane] = f64::from(u8::from(depth[lane] == 0));
        }
        if seen.is_none() && depth.contains(&0) {
            seen = Some(chunk * STRIDE);
        }
        for (&[alpha, beta], legendre) in steps.iter().zip(&mut column[chunk * STRIDE..]) {
            for lane in 0..LANES {
                legendre[lane] = now[lane] * visible[lane];
                let next = alpha * cos[lane] * now[lane] - beta * before[lane];
                before[lane] = now[lane];
                now[lane] = next;
            }
        }
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All `P_lm` at one colatitude, by the pass under test.
    fn table(top: usize, colatitude: f64) -> Vec<Vec<f64>> {
        let recursion = Recursion::new(top);
        let (sin, cos) = ([colatitude.sin(); LANES], [colatitude.cos(); LANES]);
        let mut sectoral = Scaled::start();
        let mut rows = Vec::new();
        for m in 0..=top {
            let mut column = vec![[0.0; LANES]; top + 1];
            legendre(recursion.column(m), &cos, &sectoral, &mut column);
            rows.push(column[..=top - m].iter().map(|lanes| lanes[0]).collect());
            sectoral.step(m, &sin);
        }
        rows
    }

    #[test]
    fn legendre_functions_obey_the_addition_theorem_to_degree_512() {
        for colatitude in [1e-4, 0.0015, 0.1, 0.7, 1.5, 1.57] {
            let table = table(512, colatitude);
            for l in [0, 1, 2, 17, 100, 384, 511, 512] {
                let sum: f64 =
                    (0..=l).map(|m| table[m][l - m].powi(2) * if m == 0 { 1.0 } else { 2.0 }).sum();
                let law = (2 * l + 1) as f64 / (4.0 * PI);
                // Near the pole the recursion loses digits as l squared: 2e-11 is what is seen.
                assert!((sum / law - 1.0).abs() < 1e-10, "l {l} at {colatitude}: {sum} for {law}");
            }
        }
    }

    #[test]
    fn low_degrees_have_their_closed_form() {
        let (sin, cos) = 0.6_f64.sin_cos();
        let table = table(3, 0.6);
        let expected = [
            (2, 0, (5.0 / (16.0 * PI)).sqrt() * (3.0 * cos * cos - 1.0)),
            (2, 1, -(15.0 / (8.0 * PI)).sqrt() * sin * cos),
            (3, 3, -(35.0 / (64.0 * PI)).sqrt() * sin.powi(3)),
        ];
        for (l, m, value) in expected {
            assert!((table[m][l - m] - value).abs() < 1e-15, "l {l} m {m}");
        }
    }
}
