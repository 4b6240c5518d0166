//! Chromatic adaptation: what a colour seen under one white looks like under another.

use crate::ColourError;
use crate::matrix::{Matrix, apply, diagonal, inverse, product};

/// Cone responses of XYZ after Lam (1985), the "Bradford" matrix as ICC.1 states it.
const CONES_FROM_XYZ: Matrix =
    [[0.895_1, 0.266_4, -0.161_4], [-0.750_2, 1.713_5, 0.036_7], [0.038_9, -0.068_5, 1.029_6]];
const XYZ_FROM_CONES: Matrix = inverse(&CONES_FROM_XYZ);

/// A cone that answers less than this share of the luminance does not see the light as white.
const LEAST_RESPONSE: f64 = 1e-3;

/// The map of XYZ seen under `from_white` to XYZ that look alike under `to_white`: each cone's
/// response is scaled by the ratio of its responses to the whites (linear Bradford, ICC.1 annex E).
///
/// # Errors
/// A white so far from white that one of the three cone responses is not positive.
///
/// ```
/// use nacreous_colour::{RgbSpace, WHITE_C, adaptation, matrix::apply};
/// let c_from_d65 = adaptation(RgbSpace::Srgb.white_xyz(), WHITE_C)?;
/// let white = apply(&c_from_d65, RgbSpace::Srgb.white_xyz());
/// assert!(white.iter().zip(WHITE_C).all(|(made, white)| (made - white).abs() < 1e-14));
/// # Ok::<(), nacreous_colour::ColourError>(())
/// ```
pub fn adaptation(from_white: [f64; 3], to_white: [f64; 3]) -> Result<Matrix, ColourError> {
    for white in [from_white, to_white] {
        let least = LEAST_RESPONSE * white[1];
        let is_white = white[1].is_normal()
            && white[1] > 0.0
            && apply(&CONES_FROM_XYZ, white).iter().all(|&response| response >= least);
        if !is_white {
            return Err(ColourError::White { white });
        }
    }
    Ok(between(from_white, to_white))
}

/// [`adaptation`] for whites that are known to be white.
pub(crate) const fn between(from_white: [f64; 3], to_white: [f64; 3]) -> Matrix {
    let from = apply(&CONES_FROM_XYZ, from_white);
    let to = apply(&CONES_FROM_XYZ, to_white);
    let gains = diagonal([to[0] / from[0], to[1] / from[1], to[2] / from[2]]);
    product(&XYZ_FROM_CONES, &product(&gains, &CONES_FROM_XYZ))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::xyz_from_xy;

    fn any_white() -> impl Strategy<Value = [f64; 3]> {
        (0.26..0.50, 0.30..0.40).prop_map(|(x, y)| xyz_from_xy([x, y]))
    }

    proptest! {
        #[test]
        fn white_becomes_white_and_the_way_back_undoes_it(
            from in any_white(),
            to in any_white(),
            colour in prop::array::uniform3(0.0..1.0_f64),
        ) {
            let there = adaptation(from, to).unwrap();
            let back = adaptation(to, from).unwrap();
            for (made, white) in apply(&there, from).iter().zip(to) {
                prop_assert!((made - white).abs() < 1e-13);
            }
            for (made, before) in apply(&back, apply(&there, colour)).iter().zip(colour) {
                prop_assert!((made - before).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn d65_to_d50_is_the_published_matrix() {
        // Lindbloom, "Chromatic Adaptation", Bradford, whites of ASTM E308.
        let matrix = between([0.950_47, 1.0, 1.088_83], [0.964_22, 1.0, 0.825_21]);
        let published = [
            [1.047_811_2, 0.022_886_6, -0.050_127_0],
            [0.029_542_4, 0.990_484_4, -0.017_049_1],
            [-0.009_234_5, 0.015_043_6, 0.752_131_6],
        ];
        for (made, published) in matrix.iter().flatten().zip(published.iter().flatten()) {
            assert!((made - published).abs() < 1e-6);
        }
    }

    #[test]
    fn violet_light_is_no_white() {
        let error = adaptation(xyz_from_xy([0.16, 0.02]), [1.0; 3]).unwrap_err();
        assert!(error.to_string().ends_with("allowed: a light that all three cones see"));
        assert!(adaptation([1.0; 3], [f64::NAN; 3]).is_err());
    }
}
