//! RGB spaces of screens: linear light, and the code values that are stored.

use std::fmt;
use std::str::FromStr;

use libm::{cbrt, pow, sqrt};

use crate::matrix::{Matrix, apply, diagonal, inverse, product, transpose};
use crate::xyz::xyz_from_xy;
use crate::{ColourError, matrix};

/// D65 as both standards round it.
pub(crate) const WHITE_D65: [f64; 3] = xyz_from_xy([0.312_7, 0.329_0]);

/// An RGB space with white D65 and the sRGB transfer function ([`encode`], [`decode`]).
///
/// Read from and written as `srgb` and `display-p3`. Linear RGB is relative: `[1, 1, 1]` is white.
///
/// ```
/// use nacreous_colour::RgbSpace;
/// let [red, green, blue] = RgbSpace::DisplayP3.rgb_from(RgbSpace::Srgb, [1.0, 0.0, 0.0]);
/// assert!(red < 1.0 && green > 0.0 && blue > 0.0); // the red of sRGB lies inside Display P3
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RgbSpace {
    /// IEC 61966-2-1.
    #[default]
    Srgb,
    /// The primaries of SMPTE RP 431-2 with white D65.
    DisplayP3,
}

/// Both ways between linear RGB and XYZ.
struct Matrices {
    xyz_from_rgb: Matrix,
    rgb_from_xyz: Matrix,
}

impl Matrices {
    /// From the chromaticities of red, green and blue: `[1, 1, 1]` must be white (SMPTE RP 177).
    const fn from_primaries([red, green, blue]: [[f64; 2]; 3]) -> Self {
        let primaries = transpose(&[xyz_from_xy(red), xyz_from_xy(green), xyz_from_xy(blue)]);
        let luminances = apply(&inverse(&primaries), WHITE_D65);
        let xyz_from_rgb = product(&primaries, &diagonal(luminances));
        Self { xyz_from_rgb, rgb_from_xyz: inverse(&xyz_from_rgb) }
    }
}

const SRGB: Matrices = Matrices::from_primaries([[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]]);
const DISPLAY_P3: Matrices =
    Matrices::from_primaries([[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]]);

/// For the maps that other files build at compile time.
pub(crate) const XYZ_FROM_SRGB: Matrix = SRGB.xyz_from_rgb;

impl RgbSpace {
    fn matrices(self) -> &'static Matrices {
        match self {
            Self::Srgb => &SRGB,
            Self::DisplayP3 => &DISPLAY_P3,
        }
    }

    /// Linear RGB of XYZ relative to D65; components leave 0..1 where the space cannot show them.
    ///
    /// ```
    /// use nacreous_colour::RgbSpace;
    /// let white = RgbSpace::Srgb.rgb_from_xyz(RgbSpace::Srgb.white_xyz());
    /// assert!(white.iter().all(|channel| (channel - 1.0).abs() < 1e-14));
    /// ```
    pub fn rgb_from_xyz(self, xyz: [f64; 3]) -> [f64; 3] {
        apply(&self.matrices().rgb_from_xyz, xyz)
    }

    /// XYZ relative to D65 of linear RGB.
    ///
    /// ```
    /// use nacreous_colour::RgbSpace;
    /// let [_, luminance, _] = RgbSpace::Srgb.xyz_from_rgb([0.0, 1.0, 0.0]);
    /// assert!((luminance - 0.7152).abs() < 1e-4);
    /// ```
    pub fn xyz_from_rgb(self, rgb: [f64; 3]) -> [f64; 3] {
        apply(&self.matrices().xyz_from_rgb, rgb)
    }

    /// Linear RGB in this space of linear RGB in another; both have the same white.
    pub fn rgb_from(self, other: Self, rgb: [f64; 3]) -> [f64; 3] {
        if self == other { rgb } else { self.rgb_from_xyz(other.xyz_from_rgb(rgb)) }
    }

    /// XYZ of `[1, 1, 1]`: D65 at x = 0.3127, y = 0.3290.
    pub fn white_xyz(self) -> [f64; 3] {
        WHITE_D65
    }

    /// Relative luminance Y of linear RGB.
    ///
    /// ```
    /// use nacreous_colour::RgbSpace;
    /// assert!((RgbSpace::DisplayP3.luminance([0.5; 3]) - 0.5).abs() < 1e-15);
    /// ```
    pub fn luminance(self, rgb: [f64; 3]) -> f64 {
        matrix::dot(self.matrices().xyz_from_rgb[1], rgb)
    }
}

/// Code value of a linear component by the sRGB transfer function (IEC 61966-2-1), odd about 0.
///
/// ```
/// use nacreous_colour::encode;
/// assert!((encode(0.5) - 0.7354).abs() < 1e-4);
/// ```
pub fn encode(linear: f64) -> f64 {
    let size = linear.abs();
    let code = if size <= 0.003_130_8 {
        12.92 * size
    } else {
        // The power 1 / 2.4 is five twelfth roots: three times as fast as a general power.
        let root = sqrt(sqrt(cbrt(size)));
        1.055 * (root * root * root * root * root) - 0.055
    };
    code.copysign(linear)
}

/// Linear component of a code value; undoes [`encode`].
///
/// ```
/// use nacreous_colour::{decode, encode};
/// assert!((decode(encode(0.3)) - 0.3).abs() < 1e-15);
/// ```
pub fn decode(code: f64) -> f64 {
    let size = code.abs();
    let linear = if size <= 0.040_45 { size / 12.92 } else { pow((size + 0.055) / 1.055, 2.4) };
    linear.copysign(code)
}

impl FromStr for RgbSpace {
    type Err = ColourError;

    fn from_str(name: &str) -> Result<Self, ColourError> {
        match name {
            "srgb" => Ok(Self::Srgb),
            "display-p3" => Ok(Self::DisplayP3),
            _ => Err(ColourError::Name {
                quantity: "RGB space",
                value: name.to_owned(),
                allowed: "srgb, display-p3",
            }),
        }
    }
}

impl fmt::Display for RgbSpace {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Srgb => "srgb",
            Self::DisplayP3 => "display-p3",
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn derived_matrix_rounds_to_the_published_one() {
        // IEC 61966-2-1, four decimals.
        let published =
            [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
        for (derived, published) in XYZ_FROM_SRGB.iter().flatten().zip(published.iter().flatten()) {
            assert!((derived - published).abs() < 6e-5);
        }
    }

    #[test]
    fn white_is_equal_rgb_in_both_spaces() {
        for space in [RgbSpace::Srgb, RgbSpace::DisplayP3] {
            for (made, white) in space.xyz_from_rgb([1.0; 3]).iter().zip(space.white_xyz()) {
                assert!((made - white).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn encoding_keeps_black_and_white() {
        assert!(encode(0.0).abs() < 1e-15 && (encode(1.0) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn unknown_spaces_are_refused_with_the_names_that_exist() {
        let error = "p3".parse::<RgbSpace>().unwrap_err();
        assert_eq!(error.to_string(), "RGB space is \"p3\"; allowed: srgb, display-p3");
    }

    proptest! {
        #[test]
        fn rgb_round_trips_through_the_other_space(rgb in prop::array::uniform3(-1.0..2.0_f64)) {
            let p3 = RgbSpace::DisplayP3.rgb_from(RgbSpace::Srgb, rgb);
            let back = RgbSpace::Srgb.rgb_from(RgbSpace::DisplayP3, p3);
            for (before, after) in rgb.iter().zip(back) {
                prop_assert!((before - after).abs() < 1e-13);
            }
        }

        #[test]
        fn display_p3_holds_all_of_srgb(rgb in prop::array::uniform3(0.0..=1.0_f64)) {
            let p3 = RgbSpace::DisplayP3.rgb_from(RgbSpace::Srgb, rgb);
            prop_assert!(p3.iter().all(|channel| (-1e-12..=1.0 + 1e-12).contains(channel)));
        }

        #[test]
        fn decode_undoes_encode(linear in -1.0..4.0_f64) {
            // The two branches of the standard miss each other by 3e-8 where they meet.
            prop_assert!((decode(encode(linear)) - linear).abs() < 5e-8);
        }

        #[test]
        fn encode_increases(linear in -0.1..1.5_f64, step in 1e-6..0.1_f64) {
            prop_assert!(encode(linear + step) > encode(linear));
        }
    }
}
