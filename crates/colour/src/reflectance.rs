//! A smooth reflectance for a colour of a screen.

use std::sync::LazyLock;

use crate::matrix::{apply, inverse, product, transpose};
use crate::rgb::XYZ_FROM_SRGB;
use crate::{Illuminant, Matrix, Observer, SAMPLES, Spectrum, xyz_from_spectrum};

/// Up to the first, at the second and from the third wavelength on, the reflectance has its three
/// values; straight lines lie between **(ours)**, placed so that many colours stay within 0 to 1.
const KNOTS_NM: [f64; 3] = [455.0, 545.0, 610.0];

/// What each of the three values takes part in the reflectance; at every wavelength the parts add to 1.
static PARTS: LazyLock<[Spectrum; 3]> = LazyLock::new(|| {
    let [first, middle, last] = KNOTS_NM;
    let rise = |nm: f64, from: f64, to: f64| ((nm - from) / (to - from)).clamp(0.0, 1.0);
    let part = |value: fn(f64, f64) -> f64| {
        Spectrum::from_fn(|nm| value(rise(nm, first, middle), rise(nm, middle, last)))
    };
    [part(|lower, _| 1.0 - lower), part(|lower, upper| lower - upper), part(|_, upper| upper)]
});

/// How far the three values lie below 1, of how far linear sRGB lies below white.
static DARKENING: LazyLock<Matrix> = LazyLock::new(|| {
    let weights = Observer::Cie1931.weights(&Illuminant::D65.spectrum());
    let weights = weights.expect("D65 is a light");
    let columns = PARTS.each_ref().map(|part| xyz_from_spectrum(&weights, part.values()));
    product(&inverse(&transpose(&columns)), &XYZ_FROM_SRGB)
});

/// A smooth reflectance, 0 to 1, that has this linear sRGB colour under D65.
///
/// White `[1, 1, 1]` is exactly 1 at every wavelength, and greys are level. Colours too strong for three
/// straight pieces come out paler: what would leave 0 to 1 is cut.
///
/// ```
/// use nacreous_colour::reflectance_from_rgb;
/// assert_eq!(reflectance_from_rgb([1.0; 3]).values(), &[1.0; 401]);
/// let cream = reflectance_from_rgb([0.9, 0.8, 0.6]);
/// assert!(cream.values()[20] < cream.values()[300]);
/// ```
pub fn reflectance_from_rgb(rgb: [f64; 3]) -> Spectrum {
    let darkening = apply(&DARKENING, rgb.map(|channel| 1.0 - channel));
    let loss: [f64; 3] = darkening.map(|loss| loss.clamp(0.0, 1.0));
    let at = |i: usize| PARTS.iter().zip(loss).map(|(part, loss)| part.0[i] * loss).sum::<f64>();
    Spectrum(std::array::from_fn::<f64, SAMPLES, _>(|i| (1.0 - at(i)).clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{RgbSpace, decode, delta_e_2000, lab_from_xyz};

    fn returned(rgb: [f64; 3]) -> [f64; 3] {
        let weights = Observer::Cie1931.weights(&Illuminant::D65.spectrum()).unwrap();
        xyz_from_spectrum(&weights, reflectance_from_rgb(rgb).values())
    }

    fn apart(rgb: [f64; 3]) -> f64 {
        let white = RgbSpace::Srgb.white_xyz();
        let lab = |xyz| lab_from_xyz(xyz, white);
        delta_e_2000(lab(returned(rgb)), lab(RgbSpace::Srgb.xyz_from_rgb(rgb)))
    }

    #[test]
    fn shell_and_its_dyes_come_back_within_half_a_step() {
        let codes = [
            [0xf4, 0xf1, 0xea],
            [0xf3, 0xed, 0xe4],
            [0xff, 0xff, 0xff],
            [0xd8, 0xc9, 0xa8],
            [0xe8, 0xc8, 0xc0],
            [0x8f, 0xb0, 0xc8],
            [0x80, 0x80, 0x80],
            [0x20, 0x20, 0x20],
        ];
        for code in codes {
            let rgb = code.map(|code: u8| decode(f64::from(code) / 255.0));
            assert!(apart(rgb) < 0.5, "{code:?}: {}", apart(rgb));
        }
    }

    proptest! {
        #[test]
        fn pale_colours_come_back_within_half_a_step(
            grey in 0.05..0.8_f64, lean in proptest::array::uniform3(-0.2..0.2_f64)
        ) {
            let rgb = lean.map(|lean| grey * (1.0 + lean));
            prop_assert!(apart(rgb) < 0.5, "{:?}: {}", rgb, apart(rgb));
        }

        #[test]
        fn every_colour_has_a_reflectance_from_0_to_1(rgb in proptest::array::uniform3(0.0..=1.0_f64)) {
            prop_assert!(reflectance_from_rgb(rgb).values().iter().all(|r| (0.0..=1.0).contains(r)));
        }
    }
}
