//! The normal distribution, right in both tails.
//!
//! Everything rests on Mills' ratio (1 - Φ(x)) / φ(x), which has no tail to lose digits in, by the
//! rational approximations of W. J. Cody, Math. Comp. 23 (1969), 631, as in his CALERF.

use std::f64::consts::{FRAC_1_SQRT_2, LN_2, PI};

/// ln √(2π)
const LN_ROOT_TAU: f64 = 0.918_938_533_204_672_7;
/// 1 / √(2π)
const FRAC_1_ROOT_TAU: f64 = 0.398_942_280_401_432_7;
/// √(π/2)
const ROOT_HALF_PI: f64 = 1.253_314_137_315_500_3;

/// (1 - Φ(x)) / φ(x) for x >= 0, to a few units in the last place.
pub fn mills(x: f64) -> f64 {
    ROOT_HALF_PI * scaled_complement(x * FRAC_1_SQRT_2)
}

/// exp(y²) erfc(y) for y >= 0.
fn scaled_complement(y: f64) -> f64 {
    if y <= 0.468_75 {
        let square = y * y;
        let erf = y * ratio(&ERF, square);
        libm::exp(square) * (1.0 - erf)
    } else if y <= 4.0 {
        ratio(&MIDDLE, y)
    } else {
        let inverse = 1.0 / (y * y);
        let correction = inverse * ratio(&FAR, inverse);
        (1.0 / PI.sqrt() - correction) / y
    }
}

/// Numerator and denominator, highest power first.
type Rational<const N: usize> = ([f64; N], [f64; N]);

fn ratio<const N: usize>((above, below): &Rational<N>, x: f64) -> f64 {
    let polynomial = |c: &[f64; N]| c.iter().fold(0.0, |sum, c| sum * x + c);
    polynomial(above) / polynomial(below)
}

#[rustfmt::skip]
const ERF: Rational<5> = (
    [1.857_777_061_846_031_5e-1, 3.161_123_743_870_565_6, 1.138_641_541_510_501_6e2,
     3.774_852_376_853_02e2, 3.209_377_589_138_469_5e3],
    [1.0, 2.360_129_095_234_412_1e1, 2.440_246_379_344_441_7e2,
     1.282_616_526_077_372_3e3, 2.844_236_833_439_171e3],
);

#[rustfmt::skip]
const MIDDLE: Rational<9> = (
    [2.153_115_354_744_038_5e-8, 5.641_884_969_886_701e-1, 8.883_149_794_388_375,
     6.611_919_063_714_163e1, 2.986_351_381_974_001e2, 8.819_522_212_417_69e2,
     1.712_047_612_634_070_6e3, 2.051_078_377_826_071_5e3, 1.230_339_354_797_997_2e3],
    [1.0, 1.574_492_611_070_983_5e1, 1.176_939_508_913_125e2, 5.371_811_018_620_099e2,
     1.621_389_574_566_690_2e3, 3.290_799_235_733_459_6e3, 4.362_619_090_143_247e3,
     3.439_367_674_143_721_6e3, 1.230_339_354_803_749_4e3],
);

#[rustfmt::skip]
const FAR: Rational<6> = (
    [1.631_538_713_730_209_8e-2, 3.053_266_349_612_323_4e-1, 3.603_448_999_498_044_4e-1,
     1.257_817_261_112_292_5e-1, 1.608_378_514_874_228e-2, 6.587_491_615_298_378e-4],
    [1.0, 2.568_520_192_289_822, 1.872_952_849_923_467_3, 5.279_051_029_514_284e-1,
     6.051_834_131_244_132e-2, 2.335_204_976_268_691_9e-3],
);

/// ln φ(x); the density itself is its exponential.
pub fn log_density(x: f64) -> f64 {
    -0.5 * x * x - LN_ROOT_TAU
}

/// φ(x), with the square split so that the tail keeps its digits.
pub fn density(x: f64) -> f64 {
    let short = f64::from(x as f32); // squares without rounding
    if !short.is_finite() {
        return 0.0;
    }
    let rest = (x - short) * (x + short);
    FRAC_1_ROOT_TAU * libm::exp(-0.5 * short * short) * libm::exp(-0.5 * rest)
}

/// 1 - Φ(x) for x >= 0.
fn upper_tail(x: f64) -> f64 {
    mills(x) * density(x)
}

/// Φ(x).
pub fn cdf(x: f64) -> f64 {
    if x < 0.0 { upper_tail(-x) } else { 1.0 - upper_tail(x) }
}

/// ln Φ(x), to a relative 1e-14 wherever it is a normal number.
///
/// ```
/// assert!((nacreous_scaling::log_cdf(-20.0) + 203.917_155_371_097_26).abs() < 1e-11);
/// ```
pub fn log_cdf(x: f64) -> f64 {
    if x < 0.0 { libm::log(mills(-x)) + log_density(x) } else { libm::log1p(-upper_tail(x)) }
}

/// The slope of ln Φ at x, λ = φ / Φ, and -λ' = λ (λ + x), both positive.
pub fn slope_and_bend(x: f64) -> (f64, f64) {
    if x >= 0.0 {
        let density = density(x);
        let slope = density / (1.0 - mills(x) * density);
        return (slope, slope * (slope + x));
    }
    let slope = 1.0 / mills(-x);
    // λ + x cancels in the tail; there its asymptotic series stands in (from that of Mills' ratio).
    let inverse = 1.0 / (x * x);
    let excess = if x < -40.0 {
        (1.0 - inverse * (2.0 - inverse * (10.0 - inverse * 74.0))) / -x
    } else {
        slope + x
    };
    (slope, slope * excess)
}

/// ln(Φ(high) - Φ(low)) for low < high.
pub fn log_interval(low: f64, high: f64) -> f64 {
    if low > 0.0 {
        return log_interval(-high, -low);
    }
    if high > 0.0 {
        return libm::log1p(-(upper_tail(high) + upper_tail(-low)));
    }
    let (log_low, log_high) = (log_cdf(low), log_cdf(high));
    let step = log_high - log_low;
    // Mächler, Accurately computing log(1 - exp(-|a|)), 2012.
    log_high
        + if step < LN_2 { libm::log(-libm::expm1(-step)) } else { libm::log1p(-libm::exp(-step)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From mpmath with 40 digits.
    const KNOWN: [(f64, f64); 9] = [
        (-1e5, -5_000_000_012.431_864),
        (-40.0, -804.608_442_013_753_8),
        (-5.0, -15.064_998_393_988_726),
        (-1.0, -1.841_021_645_009_263_5),
        (-0.25, -0.913_061_764_811_135),
        (0.0, -std::f64::consts::LN_2),
        (1.0, -0.172_753_779_023_449_9),
        (6.0, -9.865_876_455_243_757e-10),
        (30.0, -4.906_713_927_148_187e-198),
    ];

    #[test]
    fn log_cdf_is_right_in_both_tails() {
        for (x, expected) in KNOWN {
            let found = log_cdf(x);
            assert!((found / expected - 1.0).abs() < 1e-14, "ln Φ({x}) = {found}, not {expected}");
        }
    }

    #[test]
    fn cdf_and_its_mirror_add_to_one() {
        for i in -400..=400 {
            let x = f64::from(i) / 50.0;
            assert!((cdf(x) + cdf(-x) - 1.0).abs() < 4e-16);
        }
    }

    #[test]
    fn mills_ratio_has_no_seams() {
        for seam in [0.468_75, 4.0] {
            let x = seam / FRAC_1_SQRT_2;
            let (below, above) = (mills(x * (1.0 - 1e-15)), mills(x * (1.0 + 1e-15)));
            assert!((below / above - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn slope_and_bend_are_derivatives() {
        for x in [-300.0, -41.0, -39.0, -3.0, -0.1, 0.0, 0.4, 2.0, 8.0] {
            let h = 1e-4 * f64::max(1.0, f64::abs(x));
            let (slope, bend) = slope_and_bend(x);
            let difference = (log_cdf(x + h) - log_cdf(x - h)) / (2.0 * h);
            assert!((slope - difference).abs() < 1e-6 * slope.max(1e-9), "slope at {x}");
            let change = (slope_and_bend(x - h).0 - slope_and_bend(x + h).0) / (2.0 * h);
            assert!((bend - change).abs() < 1e-5 * bend.max(1e-9), "bend at {x}: {bend} {change}");
        }
    }

    #[test]
    fn an_interval_is_a_difference() {
        for (low, high) in [(-1.0, 2.0), (-3.0, -2.0), (2.0, 3.0), (-0.1, 0.1), (0.5, 0.6)] {
            let difference = libm::log(cdf(high) - cdf(low));
            assert!((log_interval(low, high) - difference).abs() < 1e-13);
        }
        let far = log_interval(-50.0, -49.0); // below any number, its logarithm is not
        assert!(
            (far - (log_cdf(-49.0) + libm::log1p(-libm::exp(log_cdf(-50.0) - log_cdf(-49.0)))))
                .abs()
                < 1e-9
        );
    }
}
