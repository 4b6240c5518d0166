//! What the samples of a photograph stand for: a curve and primaries, or an ICC profile.

use image::DynamicImage;

use crate::picture::PictureFileError;
use crate::profile::{Samples, convert, light_from_profile, srgb_from_rgb};

/// Rec. 709's primaries, which sRGB has too, and D65, as CIE x, y (IEC 61966-2-1).
pub(crate) const BT_709: Primaries =
    Primaries { rgb: [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]], white: [0.3127, 0.3290] };

/// The numbers of BT.709's curve to the digits with which its two pieces meet (ITU-T H.273, table 3).
const BT_709_SCALE: f64 = 1.099_296_826_809_442;
const BT_709_TOE: f64 = 0.018_053_968_510_807;

/// How samples become light.
#[derive(Debug, PartialEq)]
pub(crate) enum Encoding {
    /// By an ICC profile.
    Profile(Vec<u8>),
    /// By a curve, and primaries where they are not those of sRGB.
    Curve(Curve, Option<Primaries>),
}

/// From a sample in 0..1 to light in 0..1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Curve {
    /// IEC 61966-2-1.
    Srgb,
    /// The inverse of Rec. ITU-R BT.709's, which BT.2020 shares.
    Bt709,
    /// The sample to this power.
    Power(f64),
}

/// Chromaticities, CIE x, y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Primaries {
    /// Red, green and blue.
    pub(crate) rgb: [[f32; 2]; 3],
    /// White.
    pub(crate) white: [f32; 2],
}

impl Encoding {
    /// What samples stand for where a file says nothing.
    pub(crate) const SRGB: Self = Self::Curve(Curve::Srgb, None);

    /// Linear-light sRGB in 0..1, three values a pixel; alpha is left out.
    ///
    /// # Errors
    /// A profile that is broken or describes another number of channels, and primaries that span no
    /// colours.
    pub(crate) fn light(&self, picture: DynamicImage) -> Result<Vec<f32>, PictureFileError> {
        match self {
            Self::Profile(profile) if picture.color().has_color() => {
                light_from_profile(profile, Samples::Rgb(picture.into_rgb16().into_raw()))
            }
            Self::Profile(profile) => {
                light_from_profile(profile, Samples::Grey(picture.into_luma16().into_raw()))
            }
            Self::Curve(curve, primaries) => {
                let light = curve.table();
                let samples = picture.into_rgb16().into_raw();
                let mut rgb: Vec<f32> =
                    samples.into_iter().map(|sample| light[usize::from(sample)]).collect();
                if let Some(primaries) = primaries {
                    convert(&mut rgb, primaries.to_srgb()?);
                    for value in &mut rgb {
                        *value = value.clamp(0.0, 1.0);
                    }
                }
                Ok(rgb)
            }
        }
    }
}

impl Primaries {
    fn to_srgb(self) -> Result<[[f64; 3]; 3], PictureFileError> {
        srgb_from_rgb(self.rgb, self.white).ok_or_else(|| {
            let Self { rgb: [red, green, blue], white } = self;
            PictureFileError::Unsupported(format!(
                "has primaries that span no colours (CIE x, y: red {red:?}, green {green:?}, blue \
                 {blue:?}, white {white:?}); save it as sRGB"
            ))
        })
    }

    /// Whether they are those of sRGB, to the three digits that some programs write.
    pub(crate) fn are_srgb(&self) -> bool {
        let own = self.rgb.as_flattened().iter().chain(&self.white);
        let srgb = BT_709.rgb.as_flattened().iter().chain(&BT_709.white);
        own.zip(srgb).all(|(own, srgb)| (own - srgb).abs() < 1e-3)
    }
}

impl Curve {
    /// The light of each 16-bit sample.
    fn table(self) -> Vec<f32> {
        let light = |sample: u16| self.light(f64::from(sample) / f64::from(u16::MAX)) as f32;
        (0..=u16::MAX).map(light).collect()
    }

    fn light(self, encoded: f64) -> f64 {
        match self {
            Self::Srgb if encoded <= 0.040_45 => encoded / 12.92,
            Self::Srgb => libm::pow((encoded + 0.055) / 1.055, 2.4),
            Self::Bt709 if encoded < 4.5 * BT_709_TOE => encoded / 4.5,
            Self::Bt709 => libm::pow((encoded + BT_709_SCALE - 1.0) / BT_709_SCALE, 1.0 / 0.45),
            Self::Power(power) => libm::pow(encoded, power),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_full_code_is_a_fifth_of_full_light() {
        // IEC 61966-2-1: 0.5 encodes 0.214041; the linear toe ends at 0.04045.
        let light = Curve::Srgb.table();
        assert!((light[32_768] - 0.214_05).abs() < 1e-5);
        assert!((light[1310] - 1310.0 / 65_535.0 / 12.92).abs() < 1e-9);
    }

    #[test]
    fn every_curve_rises_from_black_to_white() {
        for curve in [Curve::Srgb, Curve::Bt709, Curve::Power(1.0), Curve::Power(2.2)] {
            let light = curve.table();
            assert_eq!((light[0], light[65_535]), (0.0, 1.0));
            assert!(light.windows(2).all(|pair| pair[0] <= pair[1]), "{curve:?}");
        }
    }

    #[test]
    fn bt_709_gives_back_what_its_camera_encodes() {
        // Rec. ITU-R BT.709-6, 1.2, whose numbers have three digits.
        for light in [0.001_f64, 0.017, 0.019, 0.18, 0.9] {
            let code = if light < 0.018 { 4.5 * light } else { 1.099 * light.powf(0.45) - 0.099 };
            assert!((Curve::Bt709.light(code) - light).abs() < 3e-4, "{light}");
        }
    }
}
