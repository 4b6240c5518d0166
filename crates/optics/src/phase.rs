//! Phases of layers, in half turns: what a layer does depends on its phase modulo one half turn only,
//! for a layer's matrix may change its sign.

use crate::real::{Real, Split};

/// What is left of `thickness * per_nm` half turns after whole ones, -1/2 to 1/2.
#[inline(always)]
pub(crate) fn reduced<T: Real, const FUSED: bool>(
    thickness: Split<T>,
    per_nm: T,
    per_nm_low: T,
) -> T {
    let whole = thickness.high.times_plus::<FUSED>(per_nm, T::ROUND) - T::ROUND;
    let rest = thickness.high.times_plus::<FUSED>(per_nm, -whole);
    if T::SPLIT {
        let rest = thickness.high.times_plus::<FUSED>(per_nm_low, rest);
        thickness.low.times_plus::<FUSED>(per_nm, rest)
    } else {
        rest
    }
}

/// Two numbers in the ratio of cos and sin of pi f, |f| <= 1/2; their norm lies between 1 and 1.15.
///
/// Two even polynomials P(f^2) and f Q(f^2): where only the ratio counts, as in a lossless layer, five
/// terms each do what takes nine for cosine and sine themselves.
#[inline(always)]
pub(crate) fn pair<T: Real, const FUSED: bool>(f: T) -> (T, T) {
    let f2 = f * f;
    let (mut p, mut q) = T::PAIR[0];
    for &(next_p, next_q) in &T::PAIR[1..] {
        p = p.times_plus::<FUSED>(f2, next_p);
        q = q.times_plus::<FUSED>(f2, next_q);
    }
    (p, q * f)
}

/// cos(pi f) and sin(pi f), |f| <= 1/2, to 4e-16.
#[inline(always)]
pub(crate) fn cos_sin<const FUSED: bool>(f: f64) -> (f64, f64) {
    let f2 = f * f;
    let (mut cos, mut sin) = COS_SIN[0];
    for &(next_cos, next_sin) in &COS_SIN[1..] {
        cos = cos.times_plus::<FUSED>(f2, next_cos);
        sin = sin.times_plus::<FUSED>(f2, next_sin);
    }
    (cos, sin * f)
}

/// cos(2 pi x) and sin(2 pi x) for a phase of x turns, |x| < 1e9, to 2e-15. Nothing is fused, so every
/// processor gives the same bits.
#[inline(always)]
pub(crate) fn cos_sin_of_turns(turns: f64) -> (f64, f64) {
    let half_turns = 2.0 * turns;
    let rounded = half_turns + f64::ROUND;
    let (cos, sin) = cos_sin::<false>(half_turns - (rounded - f64::ROUND));
    // An odd number of half turns, the last bit of `rounded`, changes both signs.
    let sign = rounded.to_bits() << 63;
    (f64::from_bits(cos.to_bits() ^ sign), f64::from_bits(sin.to_bits() ^ sign))
}

/// 2^t - 1 for t from -1000 to 0, with a small relative error where t is small too.
///
/// Smaller t count as -1000: 1e-301 is nothing beside 1.
#[inline(always)]
pub(crate) fn power_of_two_less_one<const FUSED: bool>(t: f64) -> f64 {
    let (scale, rest) = power::<FUSED>(t);
    scale.times_plus::<FUSED>(rest, scale - 1.0)
}

/// 2^t for t from -1000 to 0; smaller t count as -1000.
#[inline(always)]
pub(crate) fn power_of_two<const FUSED: bool>(t: f64) -> f64 {
    let (scale, rest) = power::<FUSED>(t);
    scale.times_plus::<FUSED>(rest, scale)
}

/// (s, r) with 2^t = s (1 + r), s a whole power of two.
#[inline(always)]
fn power<const FUSED: bool>(t: f64) -> (f64, f64) {
    let t = if t < -1000.0 { -1000.0 } else { t };
    let rounded = t + f64::ROUND;
    let f = t - (rounded - f64::ROUND);
    // The whole part stands in the last bits of `rounded`; put where the exponent stands it is 2^whole.
    let scale = f64::from_bits(rounded.to_bits().wrapping_add(1023) << 52);
    let mut p = POWER[0];
    for &next in &POWER[1..] {
        p = p.times_plus::<FUSED>(f, next);
    }
    (scale, p * f)
}

/// Coefficients of cos(pi f) and sin(pi f) / f in f^2, highest first, through the zeros of Chebyshev's
/// polynomial.
#[allow(clippy::approx_constant)] // pi is one of them
const COS_SIN: [(f64, f64); 9] = [
    (4.149_564_353_942_586e-6, 7.697_826_768_224_191e-7),
    (-0.000_104_566_553_387_487_38, -2.190_349_707_462_601_8e-5),
    (0.001_929_556_272_481_713_2, 0.000_466_299_816_189_839_4),
    (-0.025_806_888_737_002_202, -0.007_370_430_505_916_944),
    (0.235_330_630_129_532_84, 0.082_145_886_573_102_9),
    (-1.335_262_768_843_447, -0.599_264_529_318_944_7),
    (4.058_712_126_416_497, 2.550_164_039_877_300_7),
    (-4.934_802_200_544_676, -5.167_712_780_049_969),
    (1.0, 3.141_592_653_589_793),
];

/// Coefficients of (2^f - 1) / f for |f| <= 1/2, likewise.
#[allow(clippy::approx_constant)] // ln 2 is one of them
const POWER: [f64; 11] = [
    4.454_960_598_186_518_6e-10,
    7.072_585_949_269_223e-9,
    1.017_806_244_584_577_4e-7,
    1.321_544_258_792_169e-6,
    1.525_273_382_983_612e-5,
    0.000_154_035_304_417_360_5,
    0.001_333_355_814_641_693_6,
    0.009_618_129_107_606_888,
    0.055_504_108_664_821_6,
    0.240_226_506_959_100_97,
    0.693_147_180_559_945_3,
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn cosine_and_sine_agree_with_the_platform() {
        for step in -5000..=5000 {
            let f = f64::from(step) * 1e-4;
            let (cos, sin) = cos_sin::<true>(f);
            assert!((cos - (PI * f).cos()).abs() < 4e-16, "{f}");
            assert!((sin - (PI * f).sin()).abs() <= 4e-16 * (PI * f).sin().abs(), "{f}");
            let plain = cos_sin::<false>(f);
            assert!((cos - plain.0).abs() < 4e-16 && (sin - plain.1).abs() < 4e-16);
        }
    }

    #[test]
    fn whole_turns_agree_with_the_platform_over_many_of_them() {
        for step in 0..200_000 {
            let turns = f64::from(step) * 0.007_31 - 731.0;
            let (cos, sin) = cos_sin_of_turns(turns);
            let exact = 2.0 * PI * (turns - turns.round());
            assert!((cos - exact.cos()).abs() < 2e-15 && (sin - exact.sin()).abs() < 2e-15);
        }
    }

    #[test]
    fn the_pair_has_the_ratio_of_cosine_and_sine() {
        for step in -5000..=5000 {
            let f = f64::from(step) * 1e-4;
            let (p, q) = pair::<f64, true>(f);
            let norm = p.hypot(q);
            assert!((1.0 - 1e-15..1.15).contains(&norm));
            assert!((q * (PI * f).cos() - p * (PI * f).sin()).abs() < 5e-16 * norm, "{f}");
            let (p, q) = pair::<f32, true>(f as f32);
            let f = f64::from(f as f32);
            let off = f64::from(q) * (PI * f).cos() - f64::from(p) * (PI * f).sin();
            assert!(off.abs() < 2e-7, "{f}: {off}");
        }
    }

    #[test]
    fn powers_of_two_agree_with_the_platform_near_zero_and_far_off() {
        for step in 0..20_000 {
            let t = -1.0009_f64.powi(step - 10_000);
            let exact = (t * std::f64::consts::LN_2).exp_m1();
            let error = power_of_two_less_one::<true>(t) - exact;
            assert!(error.abs() <= 4e-16 * exact.abs(), "{t}: {error}");
            let (power, exact) = (power_of_two::<true>(t), t.max(-1000.0).exp2());
            assert!((power - exact).abs() <= 4e-16 * exact, "{t}: {power}");
        }
        assert!((power_of_two_less_one::<true>(-1e9) + 1.0).abs() < 1e-300);
    }

    #[test]
    fn the_split_phase_keeps_what_single_precision_loses() {
        let (thickness_nm, per_nm) = (437.123_456_789_f64, 2.0 * 1.683 / 555.5_f64);
        let exact = thickness_nm * per_nm - (thickness_nm * per_nm).round();
        let (d, k) = (Split::<f32>::of(thickness_nm), Split::<f32>::of(per_nm));
        let single = f64::from(reduced::<f32, true>(d, k.high, k.low));
        assert!((single - exact).abs() < 1e-7, "{single} {exact}");
    }
}
