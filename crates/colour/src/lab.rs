//! CIE 1976 L*a*b* and the CIEDE2000 colour difference.

use std::f64::consts::{PI, TAU};

use libm::{atan2, cbrt, cos, exp, hypot, sin, sqrt};

/// Below this cube root CIE 015 goes on in a straight line, with the same slope.
const KNEE: f64 = 6.0 / 29.0;

/// The cube root of CIE 015, equation (8.4): straight near 0 and below.
#[inline]
pub(crate) fn root(ratio: f64) -> f64 {
    if ratio > KNEE * KNEE * KNEE { cbrt(ratio) } else { ratio / (3.0 * KNEE * KNEE) + 4.0 / 29.0 }
}

/// Undoes [`root`].
#[inline]
pub(crate) fn cube(root: f64) -> f64 {
    if root > KNEE { root * root * root } else { (root - 4.0 / 29.0) * (3.0 * KNEE * KNEE) }
}

/// L*, a*, b* of XYZ, relative to the XYZ of white, whose components must be positive (CIE 015, 8.2.1).
///
/// ```
/// use nacreous_colour::{RgbSpace, lab_from_xyz};
/// let white = RgbSpace::Srgb.white_xyz();
/// assert_eq!(lab_from_xyz(white, white), [100.0, 0.0, 0.0]);
/// ```
pub fn lab_from_xyz(xyz: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = std::array::from_fn(|channel| root(xyz[channel] / white[channel]));
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// XYZ of L*, a*, b*, relative to the XYZ of white.
///
/// ```
/// use nacreous_colour::{RgbSpace, xyz_from_lab};
/// let white = RgbSpace::Srgb.white_xyz();
/// let grey = xyz_from_lab([50.0, 0.0, 0.0], white);
/// assert!((grey[1] - 0.184).abs() < 1e-3);
/// ```
pub fn xyz_from_lab([lightness, a, b]: [f64; 3], white: [f64; 3]) -> [f64; 3] {
    let y = (lightness + 16.0) / 116.0;
    [white[0] * cube(y + a / 500.0), white[1] * cube(y), white[2] * cube(y - b / 200.0)]
}

/// CIEDE2000 difference of two L*, a*, b* colours, with all parametric factors 1 (ISO/CIE 11664-6).
///
/// The formula as Sharma, Wu and Dalal (2005) write it, mean hue included. About 1 is just visible.
///
/// ```
/// use nacreous_colour::delta_e_2000;
/// let difference = delta_e_2000([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485]);
/// assert!((difference - 2.0425).abs() < 5e-5);
/// ```
pub fn delta_e_2000(first: [f64; 3], second: [f64; 3]) -> f64 {
    let [plain_1, plain_2] = [first, second].map(|[_, a, b]| hypot(a, b));
    let stretch = 1.0 + red_green_gain(f64::midpoint(plain_1, plain_2));
    let (chroma_1, hue_1) = polar(first[1] * stretch, first[2]);
    let (chroma_2, hue_2) = polar(second[1] * stretch, second[2]);
    let product = chroma_1 * chroma_2;

    let lightness = f64::midpoint(first[0], second[0]);
    let chroma = f64::midpoint(chroma_1, chroma_2);
    let hue = if product == 0.0 { hue_1 + hue_2 } else { mean_hue(hue_1, hue_2) };

    let turn = if product == 0.0 { 0.0 } else { turn(hue_1, hue_2) };
    let (scale_l, scale_c, scale_h) = scales(lightness, chroma, hue);
    let delta_l = (second[0] - first[0]) / scale_l;
    let delta_c = (chroma_2 - chroma_1) / scale_c;
    let delta_h = 2.0 * sqrt(product) * sin(turn / 2.0) / scale_h;
    let squares = delta_l * delta_l + delta_c * delta_c + delta_h * delta_h;
    // The rotation term is below 2 in size, so the sum is not negative but for rounding.
    sqrt((squares + rotation(chroma, hue) * delta_c * delta_h).max(0.0))
}

/// G: greys are stretched along a*, strong colours are not.
fn red_green_gain(chroma: f64) -> f64 {
    0.5 * (1.0 - saturation(chroma))
}

/// sqrt(C^7 / (C^7 + 25^7)), the switch between weak and strong colours.
fn saturation(chroma: f64) -> f64 {
    let c = chroma / 25.0;
    let c7 = c * c * c * c * c * c * c;
    sqrt(c7 / (c7 + 1.0))
}

/// Chroma, and hue in 0..2 pi.
fn polar(a: f64, b: f64) -> (f64, f64) {
    let angle = atan2(b, a);
    (hypot(a, b), if angle < 0.0 { angle + TAU } else { angle })
}

/// The shorter way from one hue to the other.
fn turn(from: f64, to: f64) -> f64 {
    let turn = to - from;
    if turn > PI {
        turn - TAU
    } else if turn < -PI {
        turn + TAU
    } else {
        turn
    }
}

/// The hue half-way on the shorter way round.
fn mean_hue(first: f64, second: f64) -> f64 {
    let mean = f64::midpoint(first, second);
    if (first - second).abs() <= PI {
        mean
    } else if mean < PI {
        mean + PI
    } else {
        mean - PI
    }
}

/// `S_L`, `S_C` and `S_H`: how much of each difference the eye takes for one step.
fn scales(lightness: f64, chroma: f64, hue: f64) -> (f64, f64, f64) {
    let t = 1.0 - 0.17 * cos(hue - 30_f64.to_radians())
        + 0.24 * cos(2.0 * hue)
        + 0.32 * cos(3.0 * hue + 6_f64.to_radians())
        - 0.20 * cos(4.0 * hue - 63_f64.to_radians());
    let off_grey = (lightness - 50.0) * (lightness - 50.0);
    (1.0 + 0.015 * off_grey / sqrt(20.0 + off_grey), 1.0 + 0.045 * chroma, 1.0 + 0.015 * chroma * t)
}

/// `R_T`: in the blue, differences of chroma and hue are felt together.
fn rotation(chroma: f64, hue: f64) -> f64 {
    let steps = (hue.to_degrees() - 275.0) / 25.0;
    let angle = 60_f64.to_radians() * exp(-steps * steps);
    -2.0 * saturation(chroma) * sin(angle)
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exact where nothing is computed")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn delta_e_2000_has_the_values_of_sharma_wu_and_dalal() {
        // Color Research and Application 30 (2005), table 1: the pairs that try each branch.
        for (first, second, published) in [
            ([50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485], 2.0425),
            ([50.0, -1.3802, -84.2814], [50.0, 0.0, -82.7485], 1.0000),
            ([50.0, 0.0, 0.0], [50.0, -1.0, 2.0], 2.3669),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0010], 7.1792),
            ([50.0, 2.4900, -0.0010], [50.0, -2.4900, 0.0011], 7.2195),
            ([50.0, -0.0010, 2.4900], [50.0, 0.0010, -2.4900], 4.8045),
            ([50.0, -0.0010, 2.4900], [50.0, 0.0011, -2.4900], 4.7461),
            ([50.0, 2.5, 0.0], [50.0, 0.0, -2.5], 4.3065),
            ([50.0, 2.5, 0.0], [73.0, 25.0, -18.0], 27.1492),
            ([50.0, 2.5, 0.0], [56.0, -27.0, -3.0], 31.9030),
            ([60.2574, -34.0099, 36.2677], [60.4626, -34.1751, 39.4387], 1.2644),
            ([6.7747, -0.2908, -2.4247], [5.8714, -0.0985, -2.2286], 0.6377),
            ([2.0776, 0.0795, -1.1350], [0.9033, -0.0636, -0.5514], 0.9082),
        ] {
            let difference = delta_e_2000(first, second);
            assert!((difference - published).abs() < 5e-5, "{difference} {published}");
        }
    }

    fn any_lab() -> impl Strategy<Value = [f64; 3]> {
        (0.0..100.0, -128.0..128.0, -128.0..128.0).prop_map(|(l, a, b)| [l, a, b])
    }

    proptest! {
        #[test]
        fn delta_e_is_symmetric_and_zero_only_for_equals(first in any_lab(), second in any_lab()) {
            let there = delta_e_2000(first, second);
            prop_assert!((there - delta_e_2000(second, first)).abs() < 1e-9);
            prop_assert!(there > 0.0 || first == second);
            prop_assert!(delta_e_2000(first, first) < 1e-12);
        }

        #[test]
        fn lab_round_trip_returns_xyz(
            xyz in prop::array::uniform3(-0.5..2.0_f64),
            white in prop::array::uniform3(0.5..1.5_f64),
        ) {
            let back = xyz_from_lab(lab_from_xyz(xyz, white), white);
            for (before, after) in xyz.iter().zip(back) {
                prop_assert!((before - after).abs() < 1e-12);
            }
        }
    }
}
