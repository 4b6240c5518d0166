//! The way from a photograph's own ICC profile, or a panorama's own primaries, to sRGB.
//!
//! A profile describes colours relative to D50; D65 is brought there by the Bradford transform
//! (ICC.1:2022, annex E).

use std::sync::Arc;

use moxcms::{
    Chromaticity, CmsError, ColorPrimaries, ColorProfile, DataColorSpace, Layout, Matrix3d,
    ToneReprCurve, TransformF32Executor, TransformOptions, XyY, Xyzd, adaption_matrix_d,
};

use crate::picture::PictureFileError;

/// The white of sRGB and Display P3 (IEC 61966-2-1).
pub(crate) const D65: XyY = XyY { x: 0.3127, y: 0.3290, yb: 1.0 };
/// The white of the profile connection space (ICC.1:2022, 7.2.16).
pub(crate) const D50: Xyzd = Xyzd { x: 0.9642, y: 1.0, z: 0.8249 };

/// The matrix from linear RGB with these primaries and white to XYZ relative to D50.
pub(crate) fn d50_from_rgb(primaries: ColorPrimaries, white: XyY) -> Matrix3d {
    let columns = [primaries.red, primaries.green, primaries.blue].map(|xy| xy.to_xyzd());
    let directions = Matrix3d {
        v: [columns.map(|xyz| xyz.x), columns.map(|xyz| xyz.y), columns.map(|xyz| xyz.z)],
    };
    let xyz_from_rgb = ColorProfile::rgb_to_xyz_d(directions, white.to_xyzd());
    adaption_matrix_d(white.to_xyz(), D50.to_xyz()).mat_mul(xyz_from_rgb)
}

/// The matrix from linear RGB with other primaries and white, given as CIE x, y, to linear sRGB.
/// Nothing if those chromaticities span no colour space.
pub(crate) fn srgb_from_rgb(primaries: [[f32; 2]; 3], white: [f32; 2]) -> Option<[[f64; 3]; 3]> {
    let [red, green, blue] = primaries.map(|[x, y]| Chromaticity { x, y });
    // Twice the area of the triangle of primaries; that of Rec. 709 is 0.22.
    let area = (green.x - red.x) * (blue.y - red.y) - (blue.x - red.x) * (green.y - red.y);
    if area.is_nan() || area.abs() < 1e-3 {
        return None;
    }
    let white = XyY { x: f64::from(white[0]), y: f64::from(white[1]), yb: 1.0 };
    let source = d50_from_rgb(ColorPrimaries { red, green, blue }, white);
    let srgb = d50_from_rgb(ColorPrimaries::BT_709, D65);
    let matrix = srgb.inverse().mat_mul(source).v;
    matrix.iter().flatten().all(|entry| entry.is_finite()).then_some(matrix)
}

/// Turns linear RGB, three values a pixel, by a matrix.
pub(crate) fn convert(rgb: &mut [f32], matrix: [[f64; 3]; 3]) {
    for pixel in rgb.chunks_exact_mut(3) {
        let source = [pixel[0], pixel[1], pixel[2]].map(f64::from);
        for (value, row) in pixel.iter_mut().zip(matrix) {
            *value = row.iter().zip(source).map(|(a, b)| a * b).sum::<f64>() as f32;
        }
    }
}

/// Sixteen-bit samples of a decoded photograph.
pub(crate) enum Samples {
    /// One sample a pixel.
    Grey(Vec<u16>),
    /// Three samples a pixel.
    Rgb(Vec<u16>),
}

/// Brings samples from their own ICC profile to linear-light sRGB in 0..1, three values a pixel.
/// Colours that sRGB cannot hold are clipped channel by channel.
///
/// # Errors
/// A profile that is broken or describes another number of channels.
pub(crate) fn light_from_profile(
    profile: &[u8],
    samples: Samples,
) -> Result<Vec<f32>, PictureFileError> {
    let unusable = |_: CmsError| {
        PictureFileError::ColourProfile("it is broken, or of a kind that is not read".to_owned())
    };
    let mut source = ColorProfile::new_from_slice(profile).map_err(unusable)?;
    source.cicp = None; // the curves are what other programs use
    let (layout, channels, samples) = match (samples, source.color_space) {
        (Samples::Grey(grey), DataColorSpace::Gray) => (Layout::Gray, 1, grey),
        (Samples::Grey(grey), DataColorSpace::Rgb) => {
            (Layout::Rgb, 3, grey.into_iter().flat_map(|sample| [sample; 3]).collect())
        }
        (Samples::Rgb(rgb), DataColorSpace::Rgb) => (Layout::Rgb, 3, rgb),
        (_, other) => {
            let problem = format!("made for {other:?} pixels, which these are not");
            return Err(PictureFileError::ColourProfile(problem));
        }
    };
    let mut light = vec![0.0; samples.len() / channels * 3];
    let transform = to_linear_srgb(&source, layout).map_err(unusable)?;
    // Piece by piece, so that the samples never stand in memory as floats as well.
    for (from, to) in samples.chunks(4096 * channels).zip(light.chunks_mut(4096 * 3)) {
        let from: Vec<f32> = from.iter().map(|&own| f32::from(own) / 65_535.0).collect();
        transform.transform(&from, to).map_err(unusable)?;
    }
    if light.iter().any(|value| value.is_nan()) {
        let problem = "its curves give values that are no numbers".to_owned();
        return Err(PictureFileError::ColourProfile(problem));
    }
    for value in &mut light {
        *value = value.clamp(0.0, 1.0);
    }
    Ok(light)
}

/// The transform from a profile to linear-light sRGB, its curves evaluated, not tabulated: a table
/// is coarse where sRGB is dark.
fn to_linear_srgb(
    source: &ColorProfile,
    layout: Layout,
) -> Result<Arc<TransformF32Executor>, CmsError> {
    let mut linear = ColorProfile::new_srgb();
    let colourants = d50_from_rgb(ColorPrimaries::BT_709, D65).v;
    let column = |channel: usize| {
        let [x, y, z] = colourants.map(|row| row[channel]);
        Xyzd { x, y, z }
    };
    (linear.red_colorant, linear.green_colorant, linear.blue_colorant) =
        (column(0), column(1), column(2));
    linear.cicp = None;
    let identity = Some(ToneReprCurve::Lut(Vec::new()));
    (linear.red_trc, linear.green_trc, linear.blue_trc) =
        (identity.clone(), identity.clone(), identity);
    let options =
        TransformOptions { allow_extended_range_rgb_xyz: true, ..TransformOptions::default() };
    source.create_transform_f32(layout, &linear, Layout::Rgb, options)
}

#[cfg(test)]
mod tests {
    use nacreous_colour::RgbSpace;

    use super::*;
    use crate::icc::icc_profile;

    #[test]
    fn a_profile_of_srgb_gives_the_light_of_srgb() {
        let profile = icc_profile(RgbSpace::Srgb);
        let samples: Vec<u16> =
            (0..=u16::MAX).step_by(5).flat_map(|own| [own, 65_535 - own, 999]).collect();
        let light = light_from_profile(&profile, Samples::Rgb(samples.clone())).unwrap();
        for (sample, light) in samples.into_iter().zip(light) {
            let encoded = f64::from(sample) / 65_535.0;
            let exact = if encoded <= 0.040_45 {
                encoded / 12.92
            } else {
                ((encoded + 0.055) / 1.055).powf(2.4)
            };
            assert!((f64::from(light) - exact).abs() < 3e-5, "{sample}: {light} {exact}");
        }
    }

    #[test]
    fn pure_srgb_red_in_display_p3_comes_back_as_red() {
        // CSS Color Module Level 4, sample conversions: color(display-p3 0.91749 0.20029 0.13856).
        let p3 =
            [0.917_488, 0.200_287, 0.138_561].map(|value: f64| (value * 65_535.0).round() as u16);
        let profile = icc_profile(RgbSpace::DisplayP3);
        let light = light_from_profile(&profile, Samples::Rgb(p3.to_vec())).unwrap();
        for (own, other) in light.iter().zip([1.0, 0.0, 0.0]) {
            assert!((own - other).abs() < 2e-4, "{light:?}");
        }
    }

    #[test]
    fn a_grey_profile_of_gamma_2_squares_the_sample() {
        let profile = ColorProfile::new_gray_with_gamma(2.0).encode().unwrap();
        let light = light_from_profile(&profile, Samples::Grey(vec![0, 32_768, 65_535])).unwrap();
        for (own, other) in light.iter().zip([0.0, 0.0, 0.0, 0.25, 0.25, 0.25, 1.0, 1.0, 1.0]) {
            assert!((own - other).abs() < 1e-4, "{light:?}");
        }
    }

    #[test]
    fn aces_primaries_give_the_published_matrix() {
        // AP1 with the ACES white to Rec. 709, Bradford adapted (as in Lagarde, 2014).
        let published = [
            [1.705_05, -0.621_79, -0.083_26],
            [-0.130_26, 1.140_80, -0.010_55],
            [-0.024_00, -0.128_97, 1.152_97],
        ];
        let own =
            srgb_from_rgb([[0.713, 0.293], [0.165, 0.830], [0.128, 0.044]], [0.32168, 0.33767]);
        for (own, other) in own.unwrap().as_flattened().iter().zip(published.as_flattened()) {
            assert!((own - other).abs() < 2e-4, "{own} {other}");
        }
        assert_eq!(srgb_from_rgb([[0.3, 0.3]; 3], [0.3127, 0.3290]), None);
        assert_eq!(srgb_from_rgb([[0.0; 2]; 3], [0.0; 2]), None);
    }

    #[test]
    fn a_broken_or_unfit_profile_is_refused() {
        let message =
            |profile: &[u8], samples| light_from_profile(profile, samples).unwrap_err().to_string();
        assert!(message(b"nonsense", Samples::Rgb(vec![0; 3])).contains("colour profile"));
        let grey = ColorProfile::new_gray_with_gamma(2.2).encode().unwrap();
        assert!(message(&grey, Samples::Rgb(vec![0; 3])).contains("made for Gray pixels"));
    }
}
