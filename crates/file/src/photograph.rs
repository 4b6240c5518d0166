//! A photograph from a user's file, as linear light.
//!
//! PNG, JPEG and TIFF, 8 or 16 bits, grey or RGB. Without a colour profile the samples are taken
//! as sRGB, whatever their depth; with one they are converted to sRGB (out-of-gamut colours are
//! clipped). Alpha is ignored: the colour of a transparent pixel is used as it stands. The
//! orientation that a camera noted (EXIF) is applied. Limits: [`crate::picture`].
//!
//! TIFF also as BigTIFF. Not read: CMYK, TIFF of floats or of more than 16 bits, which are refused by name, and the
//! PNG chunks `gAMA` and `cICP`.

use std::io::Cursor;
use std::path::Path;

use image::codecs::{jpeg::JpegDecoder, png::PngDecoder, tiff::TiffDecoder};
use image::error::UnsupportedErrorKind;
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageFormat, Limits};

use crate::picture::{
    LinearPicture, PIXELS_MAX, PictureFileError, SIDE_MAX, check_size, guarded, read_bytes,
};
use crate::profile::{Samples, light_from_profile};

const ALLOWED: PictureFileError = PictureFileError::Format { allowed: "PNG, JPEG, TIFF" };

/// Reads the photograph at `path`; see [`decode_photograph`].
///
/// # Errors
/// As [`decode_photograph`], and a path that is no readable file, each with the path in front.
pub fn read_photograph(path: &Path) -> Result<LinearPicture, PictureFileError> {
    read_bytes(path)
        .and_then(|bytes| guarded(|| decode_photograph(&bytes)))
        .map_err(|problem| problem.at(path))
}

/// Decodes the bytes of a PNG, JPEG or TIFF file to linear-light sRGB in 0..1.
///
/// # Errors
/// Another format, a damaged file, a kind of pixel that is not read here, a colour profile that
/// does not fit, and a size beyond the limits, found in the header before anything is decoded.
pub fn decode_photograph(bytes: &[u8]) -> Result<LinearPicture, PictureFileError> {
    let mut decoder = open(bytes)?;
    let (width, height) = decoder.dimensions();
    check_size(width.into(), height.into())?;
    decoder.set_limits(limits()).map_err(|problem| PictureFileError::damaged(&problem))?;
    check_kind(decoder.original_color_type())?;
    let damaged = |problem: image::ImageError| PictureFileError::damaged(&problem);
    let profile = decoder.icc_profile().map_err(damaged)?;
    let orientation = decoder.orientation().map_err(damaged)?;
    let mut picture = DynamicImage::from_decoder(decoder).map_err(damaged)?;
    picture.apply_orientation(orientation);
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    let rgb = match profile {
        None => {
            let light = light_from_srgb16();
            let samples = picture.into_rgb16().into_raw();
            samples.into_iter().map(|sample| light[usize::from(sample)]).collect()
        }
        Some(profile) if picture.color().has_color() => {
            light_from_profile(&profile, Samples::Rgb(picture.into_rgb16().into_raw()))?
        }
        Some(profile) => {
            light_from_profile(&profile, Samples::Grey(picture.into_luma16().into_raw()))?
        }
    };
    Ok(LinearPicture { width, height, rgb })
}

/// A decoder that has read no more than the header.
fn open<'a>(bytes: &'a [u8]) -> Result<Box<dyn ImageDecoder + 'a>, PictureFileError> {
    let damaged = |problem: image::ImageError| PictureFileError::damaged(&problem);
    let file = Cursor::new(bytes);
    let format =
        if is_big_tiff(bytes) { Ok(ImageFormat::Tiff) } else { image::guess_format(bytes) };
    Ok(match format {
        Ok(ImageFormat::Png) => {
            // The `image` crate allocates rows as it opens a PNG, so the header is read before.
            let mut header = png::Decoder::new(file.clone());
            let info = header.read_header_info().map_err(|e| PictureFileError::damaged(&e))?;
            check_size(info.width.into(), info.height.into())?;
            Box::new(PngDecoder::with_limits(file, limits()).map_err(damaged)?)
        }
        Ok(ImageFormat::Jpeg) => {
            check_jpeg(bytes)?;
            Box::new(JpegDecoder::new(file).map_err(damaged)?)
        }
        Ok(ImageFormat::Tiff) => {
            Box::new(TiffDecoder::new(file).map_err(|problem| match problem {
                image::ImageError::Unsupported(problem) => {
                    PictureFileError::Unsupported(foreign_tiff(problem.kind()))
                }
                other => PictureFileError::damaged(&other),
            })?)
        }
        _ => return Err(ALLOWED),
    })
}

/// What a TIFF has that is not read here.
fn foreign_tiff(kind: UnsupportedErrorKind) -> String {
    let what = match kind {
        UnsupportedErrorKind::Color(ExtendedColorType::Unknown(bits)) => {
            format!("{bits} bits a pixel, floating-point or whole")
        }
        // TIFF 6.0, section 19: the kinds of numbers by their own numbers.
        UnsupportedErrorKind::GenericFeature(feature) => feature
            .replace("sample format 2", "signed whole numbers")
            .replace("sample format 3", "floating-point numbers"),
        other => format!("{other:?}"),
    };
    format!("is a TIFF of another kind ({what}); save it with 8 or 16 bits a channel, grey or RGB")
}

/// TIFF with offsets of eight bytes: 43 in place of 42, from either end.
fn is_big_tiff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"II\x2b\0") || bytes.starts_with(b"MM\0\x2b")
}

/// Limits for the decoders themselves: 16 bytes for each pixel allowed, decoded and in between.
fn limits() -> Limits {
    let mut limits = Limits::no_limits();
    limits.max_image_width = Some(SIDE_MAX);
    limits.max_image_height = Some(SIDE_MAX);
    limits.max_alloc = Some(16 * PIXELS_MAX);
    limits
}

fn check_kind(kind: ExtendedColorType) -> Result<(), PictureFileError> {
    let problem = match kind {
        ExtendedColorType::Cmyk8 | ExtendedColorType::Cmyk16 => {
            "has CMYK pixels, whose colours depend on a printer; save it as RGB"
        }
        ExtendedColorType::Rgb32F | ExtendedColorType::Rgba32F => {
            "has 32 bits a channel, floating-point or whole; save it with 8 or 16"
        }
        _ => return Ok(()),
    };
    Err(PictureFileError::Unsupported(problem.to_owned()))
}

/// Walks the segments of a JPEG (ITU-T T.81, annex B) for two things that its decoder forgives: a
/// file cut short, whose rest would come out grey, and CMYK.
fn check_jpeg(bytes: &[u8]) -> Result<(), PictureFileError> {
    const START_OF_SCAN: u8 = 0xda;
    const END_OF_IMAGE: [u8; 2] = [0xff, 0xd9];
    let cut = || PictureFileError::Damaged("the JPEG ends before its picture".to_owned());
    let mut rest = &bytes[2..];
    loop {
        let marker = rest.windows(2).position(|pair| pair[0] == 0xff && pair[1] != 0xff);
        rest = &rest[marker.ok_or_else(cut)?..];
        let [_, code, high, low, ..] = *rest else { return Err(cut()) };
        if code == START_OF_SCAN {
            break;
        }
        // Start of frame, all sorts but the tables DHT, JPG and DAC in between.
        if matches!(code, 0xc0..=0xcf) && !matches!(code, 0xc4 | 0xc8 | 0xcc) {
            let channels = rest.get(9).ok_or_else(cut)?;
            check_kind(if *channels == 4 {
                ExtendedColorType::Cmyk8
            } else {
                ExtendedColorType::Rgb8
            })?;
        }
        let length = 2 + usize::from(u16::from_be_bytes([high, low]));
        rest = rest.get(length..).ok_or_else(cut)?;
    }
    // Inside a scan 0xff is always escaped, so the first such pair is the end.
    if rest.windows(2).any(|pair| pair == END_OF_IMAGE) { Ok(()) } else { Err(cut()) }
}

/// The linear light of each 16-bit sRGB sample (IEC 61966-2-1).
fn light_from_srgb16() -> Vec<f32> {
    (0..=u16::MAX)
        .map(|sample| {
            let encoded = f64::from(sample) / f64::from(u16::MAX);
            let light = if encoded <= 0.040_45 {
                encoded / 12.92
            } else {
                libm::pow((encoded + 0.055) / 1.055, 2.4)
            };
            light as f32
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use image::{ImageBuffer, Luma, Rgb, Rgba};

    use super::*;

    fn encoded(picture: &DynamicImage, format: ImageFormat) -> Vec<u8> {
        let mut file = Cursor::new(Vec::new());
        picture.write_to(&mut file, format).unwrap();
        file.into_inner()
    }

    fn message(bytes: &[u8]) -> String {
        decode_photograph(bytes).unwrap_err().to_string()
    }

    /// A PNG that has nothing but the header of a 1-bit grey picture.
    fn header_of(width: u32, height: u32) -> Vec<u8> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, width, height);
        encoder.set_depth(png::BitDepth::One);
        drop(encoder.write_header().unwrap());
        file
    }

    #[test]
    fn half_of_full_code_is_a_fifth_of_full_light() {
        // IEC 61966-2-1: 0.5 encodes 0.214041; the linear toe ends at 0.04045.
        let light = light_from_srgb16();
        assert!((light[32_768] - 0.214_05).abs() < 1e-5);
        assert!((light[1310] - 1310.0 / 65_535.0 / 12.92).abs() < 1e-9);
        assert_eq!((light[0], light[65_535]), (0.0, 1.0));
        assert!(light.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn eight_and_sixteen_bits_mean_the_same_light() {
        let narrow = ImageBuffer::from_fn(16, 16, |x, y| Luma([(y * 16 + x) as u8]));
        let wide = ImageBuffer::from_fn(16, 16, |x, y| Rgb([((y * 16 + x) * 257) as u16; 3]));
        let light = |picture: DynamicImage, format| decode_photograph(&encoded(&picture, format));
        let first = light(narrow.clone().into(), ImageFormat::Png).unwrap();
        for format in [ImageFormat::Png, ImageFormat::Tiff] {
            assert_eq!(light(narrow.clone().into(), format).unwrap(), first);
            assert_eq!(light(wide.clone().into(), format).unwrap(), first);
        }
    }

    #[test]
    fn alpha_changes_nothing() {
        let clear = ImageBuffer::from_pixel(3, 2, Rgba([200_u8, 100, 50, 0]));
        let solid = ImageBuffer::from_pixel(3, 2, Rgb([200_u8, 100, 50]));
        let light = |picture: DynamicImage| {
            decode_photograph(&encoded(&picture, ImageFormat::Png)).unwrap()
        };
        assert_eq!(light(clear.into()), light(solid.into()));
    }

    #[cfg(feature = "png")]
    #[test]
    fn our_own_display_p3_picture_comes_back_in_srgb() {
        use crate::png::{PngPixels, write_png};
        use nacreous_colour::RgbSpace;
        let grey = [32_768_u16; 3];
        let mut file = Vec::new();
        let pixels = PngPixels::Sixteen(&grey);
        write_png(&mut file, 1, 1, pixels, RgbSpace::DisplayP3, &[]).unwrap();
        for value in decode_photograph(&file).unwrap().rgb {
            assert!((value - 0.214_05).abs() < 5e-5, "{value}"); // grey is grey in both
        }
    }

    #[test]
    fn a_huge_picture_is_refused_by_its_header() {
        let limit = "allowed: 1 to 16384 a side and at most 67108864 pixels in all";
        assert_eq!(
            message(&header_of(20_000, 20_000)),
            format!("is 20000 x 20000 pixels; {limit}")
        );
        assert_eq!(message(&header_of(16_384, 4097)), format!("is 16384 x 4097 pixels; {limit}"));
        assert!(message(&header_of(16_384, 4096)).contains("damaged or cut short"));
    }

    #[test]
    fn whatever_is_cut_off_is_noticed() {
        let picture: DynamicImage =
            ImageBuffer::from_fn(40, 30, |x, y| Rgb([(x * 6) as u8, (y * 8) as u8, 77])).into();
        for format in [ImageFormat::Png, ImageFormat::Jpeg, ImageFormat::Tiff] {
            let whole = encoded(&picture, format);
            assert!(decode_photograph(&whole).is_ok());
            for length in [whole.len() * 9 / 10, whole.len() / 2, 24] {
                let message = message(&whole[..length]);
                assert!(message.starts_with("is damaged or cut short"), "{format:?}: {message}");
            }
        }
    }

    #[test]
    fn no_broken_file_brings_the_decoders_down() {
        let picture: DynamicImage =
            ImageBuffer::from_fn(12, 9, |x, y| Rgb([(x * 20) as u8, (y * 25) as u8, 7])).into();
        let mut state = 1_u32;
        let mut random = move |below: usize| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as usize % below
        };
        for format in [ImageFormat::Png, ImageFormat::Jpeg, ImageFormat::Tiff] {
            let whole = encoded(&picture, format);
            for _ in 0..2000 {
                let mut broken = whole.clone();
                for _ in 0..=random(4) {
                    let place = random(broken.len());
                    broken[place] = random(256) as u8;
                }
                if let Ok(LinearPicture { rgb, .. }) = decode_photograph(&broken) {
                    assert!(rgb.iter().all(|value| (0.0..=1.0).contains(value)));
                }
            }
        }
    }

    #[test]
    fn other_kinds_of_file_are_named() {
        assert_eq!(
            message(b"once upon a time"),
            "is not a picture that can be read here; allowed: PNG, JPEG, TIFF"
        );
        let float = ImageBuffer::from_pixel(2, 2, Rgb([0.5_f32; 3]));
        assert!(message(&encoded(&float.into(), ImageFormat::Tiff)).contains("floating-point"));
    }
}
