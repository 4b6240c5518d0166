//! A photograph from a user's file, as linear light.
//!
//! PNG, JPEG and TIFF, 8 or 16 bits, grey or RGB. Where a file does not say what its samples stand for they
//! are taken as sRGB, whatever their depth; by an ICC profile, and in a PNG by `cICP`, `gAMA` and `cHRM`
//! (`png_colour.rs`), they are converted to sRGB (out-of-gamut colours are clipped). Alpha is ignored: the
//! colour of a transparent pixel is used as it stands, and where a TIFF has it multiplied by alpha, divided by it.
//! The orientation that a camera noted (EXIF) is applied. Limits: [`crate::picture`].
//!
//! TIFF also as BigTIFF. Not read, and refused by name: CMYK, and what `tiff.rs` says of TIFF.

use std::io::Cursor;
use std::path::Path;

use image::codecs::{jpeg::JpegDecoder, png::PngDecoder, tiff::TiffDecoder};
use image::{DynamicImage, ImageDecoder, ImageFormat, Limits};

use crate::encoding::Encoding;
use crate::jpeg::check_jpeg;
use crate::picture::{
    LinearPicture, PIXELS_MAX, PictureFileError, SIDE_MAX, check_size, guarded, read_bytes,
};
use crate::png_colour::png_encoding;
use crate::tiff::{TiffHeader, is_big_tiff};

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
    let format =
        if is_big_tiff(bytes) { Ok(ImageFormat::Tiff) } else { image::guess_format(bytes) };
    let (encoding, picture) = match format {
        Ok(ImageFormat::Png) => decode_png(bytes)?,
        Ok(ImageFormat::Jpeg) => decode_jpeg(bytes)?,
        Ok(ImageFormat::Tiff) => decode_tiff(bytes)?,
        _ => return Err(ALLOWED),
    };
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    Ok(LinearPicture { width, height, rgb: encoding.light(picture)? })
}

fn decode_png(bytes: &[u8]) -> Result<(Encoding, DynamicImage), PictureFileError> {
    // The `image` crate allocates rows as it opens a PNG, so the header is read before.
    let mut header = png::Decoder::new(Cursor::new(bytes));
    let info = header.read_header_info().map_err(|e| PictureFileError::damaged(&e))?;
    check_size(info.width.into(), info.height.into())?;
    let said = png_encoding(bytes)?; // before the decoder, which calls what it lacks damage
    let mut decoder = PngDecoder::with_limits(Cursor::new(bytes), limits()).map_err(damaged)?;
    // It passes over a profile that it cannot unpack.
    let profile = decoder.icc_profile().map_err(damaged)?.map(Encoding::Profile);
    let packed = || PictureFileError::ColourProfile("iCCP cannot be unpacked".to_owned());
    Ok((said.or(profile).ok_or_else(packed)?, decoded(decoder)?))
}

fn decode_jpeg(bytes: &[u8]) -> Result<(Encoding, DynamicImage), PictureFileError> {
    let has_profile = check_jpeg(bytes)?;
    let mut decoder = JpegDecoder::new(Cursor::new(bytes)).map_err(damaged)?;
    let profile = decoder.icc_profile().map_err(damaged)?;
    if has_profile && profile.is_none() {
        return Err(PictureFileError::ColourProfile("pieces of it are missing".to_owned()));
    }
    Ok((profile.map_or(Encoding::SRGB, Encoding::Profile), decoded(decoder)?))
}

fn decode_tiff(bytes: &[u8]) -> Result<(Encoding, DynamicImage), PictureFileError> {
    let header = TiffHeader::new(bytes)?;
    header.check()?;
    let profile = header.profile()?;
    let picture = decoded(TiffDecoder::new(Cursor::new(bytes)).map_err(damaged)?)?;
    let picture = if header.has_associated_alpha() { without_alpha(picture) } else { picture };
    Ok((profile.map_or(Encoding::SRGB, Encoding::Profile), picture))
}

/// By value, as `map_err` hands it on.
#[allow(clippy::needless_pass_by_value)]
fn damaged(problem: image::ImageError) -> PictureFileError {
    PictureFileError::damaged(&problem)
}

/// The samples, upright.
fn decoded(mut decoder: impl ImageDecoder) -> Result<DynamicImage, PictureFileError> {
    let (width, height) = decoder.dimensions();
    check_size(width.into(), height.into())?;
    decoder.set_limits(limits()).map_err(damaged)?;
    let orientation = decoder.orientation().map_err(damaged)?;
    let mut picture = DynamicImage::from_decoder(decoder).map_err(damaged)?;
    picture.apply_orientation(orientation);
    Ok(picture)
}

/// Colours that were multiplied by alpha, divided by it; black where nothing is left of them.
fn without_alpha(picture: DynamicImage) -> DynamicImage {
    let mut rgba = picture.into_rgba16();
    for image::Rgba([colours @ .., alpha]) in rgba.pixels_mut() {
        for colour in colours {
            let whole = u64::from(*colour) * u64::from(u16::MAX) + u64::from(*alpha) / 2;
            let divided = whole.checked_div(u64::from(*alpha)).unwrap_or(0);
            *colour = divided.min(u64::from(u16::MAX)) as u16;
        }
    }
    rgba.into()
}

/// Limits for the decoders themselves: 16 bytes for each pixel allowed, decoded and in between.
fn limits() -> Limits {
    let mut limits = Limits::no_limits();
    limits.max_image_width = Some(SIDE_MAX);
    limits.max_image_height = Some(SIDE_MAX);
    limits.max_alloc = Some(16 * PIXELS_MAX);
    limits
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
