//! Munsell hue, value and chroma by the Mathematical Transform to Munsell (MTM).
//!
//! Miyahara and Yoshida, "Mathematical transform of (R, G, B) color data to Munsell (H, V, C) color
//! data", SPIE 1001 (1988). With X, Y, Z relative to white under illuminant C and V(x) the lightness
//! function on a scale of 0 to 10:
//!
//! ```text
//! M1 = V(X) - V(Y)     M2 = 0.4 (V(Z) - V(Y))     t = atan2(M2, M1)
//! S1 = (8.880 + 0.966 cos t) M1     S2 = (8.025 + 2.558 sin t) M2
//! hue = atan2(S2, S1)     value = V(Y)     chroma = hypot(S1, S2)
//! ```
//!
//! The way back is ours: t depends on hue alone, so Newton's method solves one equation in one angle,
//! for any chroma, and the rest is closed. V goes on in a straight line near 0 and below, so that
//! black and colours outside any gamut stay finite and return.
//!
//! On the 2538 real renotation colours of value 2 and more (`data/munsell_renotation.csv`, whose
//! luminance is relative to magnesium oxide: times 0.975): value within 0.105, chroma 0.76 rms
//! (worst 3.07), hue 8.0 degrees rms.

use std::f64::consts::TAU;

use libm::{atan2, hypot, sincos, sqrt};

use crate::adaptation::between;
use crate::lab::{cube, root};
use crate::matrix::{Matrix, apply, diagonal, inverse, product};
use crate::rgb::{WHITE_D65, XYZ_FROM_SRGB};
use crate::xyz::WHITE_C;

/// A colour by Munsell hue, value and chroma, as the MTM has them.
///
/// ```
/// use nacreous_colour::{Hvc, hvc_from_rgb, rgb_from_hvc};
///
/// let pearl = hvc_from_rgb([0.80, 0.72, 0.70]);
/// assert_eq!(pearl.notation(), "7.5R 8.9/0.8");
/// let less_red = rgb_from_hvc(Hvc { chroma: 0.5 * pearl.chroma, ..pearl });
/// assert!(less_red[0] < 0.80 && less_red[2] > 0.70);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hvc {
    /// Angle, -pi to pi, running R, RP, P, PB, B, BG, G, GY, Y, YR: against Munsell's order. Any angle
    /// is understood; at chroma 0 it means nothing.
    pub hue_rad: f64,
    /// Lightness: 0 black, 10 white.
    pub value: f64,
    /// Distance from grey, 0 and up; a pearl's body has 0 to 4.
    pub chroma: f64,
}

/// X, Y, Z relative to white C from linear sRGB: white D65 becomes white C by Bradford.
const C_RELATIVE_FROM_RGB: Matrix = product(
    &product(&diagonal([1.0 / WHITE_C[0], 1.0, 1.0 / WHITE_C[2]]), &between(WHITE_D65, WHITE_C)),
    &XYZ_FROM_SRGB,
);
const RGB_FROM_C_RELATIVE: Matrix = inverse(&C_RELATIVE_FROM_RGB);

/// Hue, value and chroma of linear sRGB, seen under D65 and adapted to C.
///
/// ```
/// let white = nacreous_colour::hvc_from_rgb([1.0; 3]);
/// assert!((white.value - 10.0).abs() < 1e-12 && white.chroma < 1e-12);
/// ```
#[inline]
pub fn hvc_from_rgb(rgb: [f64; 3]) -> Hvc {
    hvc_from_relative(apply(&C_RELATIVE_FROM_RGB, rgb))
}

/// The value alone, the same as [`hvc_from_rgb`] gives, at a fifth of its cost.
///
/// ```
/// use nacreous_colour::{hvc_from_rgb, value_from_rgb};
/// let pearl = [0.80, 0.72, 0.70];
/// assert_eq!(value_from_rgb(pearl).to_bits(), hvc_from_rgb(pearl).value.to_bits());
/// ```
#[inline]
pub fn value_from_rgb(rgb: [f64; 3]) -> f64 {
    lightness(apply(&C_RELATIVE_FROM_RGB, rgb)[1])
}

/// Linear sRGB of hue, value and chroma; leaves 0..1 where sRGB cannot show the colour.
///
/// ```
/// use nacreous_colour::{Hvc, rgb_from_hvc};
/// let black = rgb_from_hvc(Hvc { hue_rad: 1.0, value: 0.0, chroma: 0.0 });
/// assert!(black.iter().all(|channel| channel.abs() < 1e-15));
/// ```
#[inline]
pub fn rgb_from_hvc(hvc: Hvc) -> [f64; 3] {
    apply(&RGB_FROM_C_RELATIVE, relative_from_hvc(hvc))
}

/// Hue, value and chroma of XYZ under illuminant C, whose white is [`WHITE_C`].
///
/// ```
/// use nacreous_colour::{WHITE_C, hvc_from_xyz};
/// assert!((hvc_from_xyz(WHITE_C).value - 10.0).abs() < 1e-12);
/// ```
pub fn hvc_from_xyz(xyz: [f64; 3]) -> Hvc {
    hvc_from_relative(std::array::from_fn(|channel| xyz[channel] / WHITE_C[channel]))
}

/// XYZ under illuminant C of hue, value and chroma.
///
/// ```
/// use nacreous_colour::{Hvc, hvc_from_xyz, xyz_from_hvc};
/// let hvc = Hvc { hue_rad: 2.0, value: 5.0, chroma: 3.0 };
/// let back = hvc_from_xyz(xyz_from_hvc(hvc));
/// assert!((back.hue_rad - 2.0).abs() < 1e-9 && (back.chroma - 3.0).abs() < 1e-9);
/// ```
pub fn xyz_from_hvc(hvc: Hvc) -> [f64; 3] {
    let relative = relative_from_hvc(hvc);
    std::array::from_fn(|channel| relative[channel] * WHITE_C[channel])
}

/// V: lightness on the Munsell scale, L* / 10.
fn lightness(ratio: f64) -> f64 {
    11.6 * root(ratio) - 1.6
}

fn ratio(lightness: f64) -> f64 {
    cube((lightness + 1.6) / 11.6)
}

/// (S1, S2) for M = (cos t, sin t): direction and gain of the transform.
#[inline]
fn opponents([cos_t, sin_t]: [f64; 2]) -> [f64; 2] {
    [(8.880 + 0.966 * cos_t) * cos_t, (8.025 + 2.558 * sin_t) * sin_t]
}

#[inline]
fn hvc_from_relative(relative: [f64; 3]) -> Hvc {
    let [x, value, z] = relative.map(lightness);
    let (m1, m2) = (x - value, 0.4 * (z - value));
    let m = hypot(m1, m2);
    if m == 0.0 {
        return Hvc { hue_rad: 0.0, value, chroma: 0.0 };
    }
    let [g1, g2] = opponents([m1 / m, m2 / m]);
    Hvc { hue_rad: atan2(g2, g1), value, chroma: m * hypot(g1, g2) }
}

#[inline]
fn relative_from_hvc(Hvc { hue_rad, value, chroma }: Hvc) -> [f64; 3] {
    let [cos_t, sin_t] = inner_angle(hue_rad);
    let [g1, g2] = opponents([cos_t, sin_t]);
    let m = chroma / hypot(g1, g2);
    [ratio(value + m * cos_t), ratio(value), ratio(value + m * sin_t / 0.4)]
}

/// Cosine and sine of the t whose opponents point along the hue.
///
/// Newton on f(t) = S2 cos(hue) - S1 sin(hue), which vanishes where the directions agree. From
/// t = hue the way is 14 degrees at most and f' is positive all along, so that four or five steps
/// reach the rounding error. Each step turns the vector (cos t, sin t) by a tangent, without
/// trigonometry.
#[inline]
fn inner_angle(hue_rad: f64) -> [f64; 2] {
    let (sin_hue, cos_hue) = sincos(hue_rad);
    let (mut cos_t, mut sin_t) = (cos_hue, sin_hue);
    for _ in 0..8 {
        let [g1, g2] = opponents([cos_t, sin_t]);
        let slope_1 = -sin_t * (8.880 + 2.0 * 0.966 * cos_t);
        let slope_2 = cos_t * (8.025 + 2.0 * 2.558 * sin_t);
        let step = (g2 * cos_hue - g1 * sin_hue) / (slope_2 * cos_hue - slope_1 * sin_hue);
        let (cos_next, sin_next) = (cos_t + sin_t * step, sin_t - cos_t * step);
        let length = sqrt(1.0 + step * step);
        (cos_t, sin_t) = (cos_next / length, sin_next / length);
        if step.abs() < 1e-9 {
            break; // the error is squared at each step
        }
    }
    [cos_t, sin_t]
}

/// The families in Munsell's own order, each ten steps of hue wide.
const FAMILIES: [&str; 10] = ["R", "YR", "Y", "GY", "G", "BG", "B", "PB", "P", "RP"];
/// Hue angle of 10RP, the seam of Munsell's circle: fitted to the renotation colours.
const SEAM_RAD: f64 = -3.4 / 360.0 * TAU;

impl Hvc {
    /// The colour in Munsell notation, to one decimal, such as `5RP 6/8`; greys are `N 6/`.
    ///
    /// ```
    /// use nacreous_colour::Hvc;
    /// let grey = Hvc { hue_rad: 0.3, value: 6.0, chroma: 0.01 };
    /// assert_eq!(grey.notation(), "N 6/");
    /// ```
    pub fn notation(&self) -> String {
        let [value, chroma] = [self.value, self.chroma].map(to_tenth);
        if chroma == 0.0 {
            return format!("N {value}/");
        }
        // The angle runs against Munsell's order; its circle has 100 steps, ours here 1000 tenths.
        let turn = ((SEAM_RAD - self.hue_rad) / TAU).rem_euclid(1.0);
        let tenths = match (1000.0 * turn).round() as usize {
            0 => 1000, // 0R is written 10RP
            tenths => tenths,
        };
        let family = (tenths - 1) / 100;
        let step = (tenths - 100 * family) as f64 / 10.0;
        format!("{step}{} {value}/{chroma}", FAMILIES[family])
    }
}

/// Rounded to one decimal; adding 0 turns -0 into 0.
fn to_tenth(number: f64) -> f64 {
    (10.0 * number).round() / 10.0 + 0.0
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::xyz_from_xy;

    fn close(first: [f64; 3], second: [f64; 3], tolerance: f64) -> bool {
        first.iter().zip(second).all(|(a, b)| (a - b).abs() < tolerance)
    }

    proptest! {
        #[test]
        fn rgb_returns_from_hvc_in_and_around_the_cube(
            rgb in prop::array::uniform3(-0.5..2.0_f64),
        ) {
            prop_assert!(close(rgb_from_hvc(hvc_from_rgb(rgb)), rgb, 1e-10));
        }

        #[test]
        fn hvc_returns_from_rgb_at_any_chroma(
            hue_rad in -3.1..3.1_f64, value in -1.0..12.0_f64, chroma in 1e-6..60.0_f64,
        ) {
            let back = hvc_from_rgb(rgb_from_hvc(Hvc { hue_rad, value, chroma }));
            prop_assert!((back.value - value).abs() < 1e-9);
            prop_assert!((back.chroma - chroma).abs() < 1e-9);
            prop_assert!((back.hue_rad - hue_rad).abs() * chroma < 1e-9);
        }

        #[test]
        fn hue_may_be_given_on_any_turn(hue_rad in -3.0..3.0_f64, turns in -3..4_i32) {
            let colour = |hue_rad| rgb_from_hvc(Hvc { hue_rad, value: 5.0, chroma: 6.0 });
            prop_assert!(close(colour(hue_rad), colour(hue_rad + f64::from(turns) * TAU), 1e-12));
        }
    }

    #[test]
    fn greys_have_no_chroma_and_the_lightness_of_lab() {
        for grey in [0.0, 1e-9, 0.01, 0.18, 0.5, 1.0] {
            let hvc = hvc_from_rgb([grey; 3]);
            assert!(hvc.chroma < 1e-12, "{grey}: {hvc:?}");
            let lab = crate::lab_from_xyz([grey; 3], [1.0; 3]);
            assert!((hvc.value - lab[0] / 10.0).abs() < 1e-12);
        }
    }

    #[test]
    fn notation_goes_round_munsells_circle() {
        let notation =
            |turn: f64| Hvc { hue_rad: SEAM_RAD - turn * TAU, value: 6.0, chroma: 8.0 }.notation();
        assert_eq!(notation(0.05), "5R 6/8");
        assert_eq!(notation(0.25), "5Y 6/8");
        assert_eq!(notation(0.95), "5RP 6/8");
        assert_eq!(notation(0.0), "10RP 6/8");
        assert_eq!(notation(0.1), "10R 6/8");
        assert_eq!(notation(0.101), "0.1YR 6/8");
        assert_eq!(notation(0.99996), "10RP 6/8");
    }

    /// What MTM says of each renotation colour, less what is true: hue in degrees, value, chroma.
    fn renotation_errors() -> Vec<[f64; 3]> {
        let table = include_str!("../../../data/munsell_renotation.csv");
        let is_row = |line: &&str| line.starts_with(|first: char| first.is_ascii_digit());
        table.lines().filter(is_row).map(error_of_row).collect()
    }

    fn error_of_row(row: &str) -> [f64; 3] {
        let (hue, numbers) = row.split_once(',').unwrap();
        let (step, family) = hue.split_at(hue.find(char::is_alphabetic).unwrap());
        let family = FAMILIES.iter().position(|name| *name == family).unwrap();
        let turn = (10.0 * family as f64 + step.parse::<f64>().unwrap()) / 100.0;
        let numbers: Vec<f64> = numbers.split(',').map(|cell| cell.parse().unwrap()).collect();
        let [value, chroma, x, y, percent] = numbers[..] else { panic!("{row}") };
        // Percent of magnesium oxide, which reflects 0.975 of the light.
        let luminance = 0.975 * percent / 100.0;
        let hvc = hvc_from_xyz(xyz_from_xy([x, y]).map(|channel| channel * luminance));
        let off = hvc.hue_rad - (SEAM_RAD - turn * TAU);
        let shortest = (off + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
        [shortest.to_degrees(), hvc.value - value, hvc.chroma - chroma]
    }

    #[test]
    fn transform_stays_near_the_renotation() {
        let errors = renotation_errors();
        assert_eq!(errors.len(), 2538);
        let count = errors.len() as f64;
        let rms = [0, 1, 2].map(|quantity| {
            (errors.iter().map(|error| error[quantity].powi(2)).sum::<f64>() / count).sqrt()
        });
        let worst = [0, 1, 2]
            .map(|quantity| errors.iter().map(|error| error[quantity].abs()).fold(0.0, f64::max));
        assert!(rms[0] < 8.1 && worst[1] < 0.105 && rms[2] < 0.765 && worst[2] < 3.1);
        // The seam is placed where the mean error of hue vanishes.
        let mean_hue = errors.iter().map(|error| error[0]).sum::<f64>() / count;
        assert!(mean_hue.abs() < 0.1, "{mean_hue}");
    }
}
