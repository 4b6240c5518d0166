//! PNG: the display-referred picture, with its colour profile and the recipe it was made from.
//!
//! The file says its colour space twice: in `cICP` for programs that know the third edition of
//! PNG, in `iCCP` for all others. `sRGB` is left out, because the standard (section 11.3.2.3)
//! forbids it beside `iCCP`. Equal input gives equal bytes.
//!
//! Out of scope: palettes, animation; encoding light for a display is the colour room's.

use std::io::{self, BufRead, Cursor, Seek, Write};
use std::path::Path;

use nacreous_colour::RgbSpace;

use crate::icc::{icc_name, icc_profile};
use crate::picture::{
    PictureFileError, TEXT_BYTES_MAX, check_sample_count, check_text, guarded, read_bytes,
};

/// Primaries, transfer function, matrix (0: RGB) and full range, as ITU-T H.273 numbers them.
const fn cicp(space: RgbSpace) -> [u8; 4] {
    match space {
        RgbSpace::Srgb => [1, 13, 0, 1],
        RgbSpace::DisplayP3 => [12, 13, 0, 1],
    }
}

/// Display-referred pixels in the order [row, column, channel], 0 black and the largest integer white: red, green, blue, and
/// where there is a fourth channel, how opaque they are (colours not multiplied by it: section 6.2).
#[derive(Clone, Copy, Debug)]
pub enum PngPixels<'a> {
    /// 8 bits a channel.
    Eight(&'a [u8]),
    /// 16 bits a channel.
    Sixteen(&'a [u16]),
}

/// Writes a picture of `width` x `height` pixels, its colour profile and its `text`; four samples a pixel make a
/// picture with alpha.
///
/// `text` is a list of (keyword, text); each becomes one uncompressed `iTXt` chunk ahead of the
/// pixels, so that any program, even a text search, finds it.
///
/// # Errors
/// A buffer that does not fit the size, a keyword that PNG cannot hold, and whatever `out` says.
///
/// ```
/// use nacreous_colour::RgbSpace;
/// use nacreous_file::png::{PngPixels, png_text, write_png};
/// let text = vec![("Software".to_owned(), "nacreous".to_owned())];
/// let mut file = Vec::new();
/// write_png(&mut file, 1, 1, PngPixels::Eight(&[255, 240, 230]), RgbSpace::Srgb, &text)?;
/// assert_eq!(png_text(std::io::Cursor::new(file))?, text);
/// # Ok::<(), nacreous_file::picture::PictureFileError>(())
/// ```
pub fn write_png(
    out: &mut impl Write,
    width: u32,
    height: u32,
    pixels: PngPixels<'_>,
    space: RgbSpace,
    text: &[(String, String)],
) -> Result<(), PictureFileError> {
    let (depth, given) = match pixels {
        PngPixels::Eight(samples) => (png::BitDepth::Eight, samples.len()),
        PngPixels::Sixteen(samples) => (png::BitDepth::Sixteen, samples.len()),
    };
    let (columns, rows) = (width as usize, height as usize);
    let with_alpha = check_sample_count("the picture", given, (columns, rows, 4)).is_ok();
    if !with_alpha {
        check_sample_count("the picture", given, (columns, rows, 3))?;
    }
    check_text(text)?;
    let mut info = png::Info::with_size(width, height);
    info.color_type = if with_alpha { png::ColorType::Rgba } else { png::ColorType::Rgb };
    info.bit_depth = depth;
    info.utf8_text =
        text.iter().map(|(key, value)| png::text_metadata::ITXtChunk::new(key, value)).collect();
    encode(out, info, pixels, space).map_err(|problem| match problem {
        png::EncodingError::IoError(problem) => PictureFileError::Unwritable(problem),
        other => PictureFileError::Encoder(other.to_string()),
    })
}

fn encode(
    out: &mut impl Write,
    info: png::Info<'_>,
    pixels: PngPixels<'_>,
    space: RgbSpace,
) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::with_info(out, info)?;
    encoder.set_filter(png::Filter::Adaptive);
    // Measured on 512 x 512 pearls with and without grain: 7 to 25 ms at level 3; level 6 takes
    // three times as long for 2 to 10 % less. The low bytes of 16-bit samples are noise to
    // deflate, and level 1 (7 to 11 ms) comes out smaller than all levels above it.
    let level = if matches!(pixels, PngPixels::Eight(_)) { 3 } else { 1 };
    encoder.set_deflate_compression(png::DeflateCompression::Level(level));
    let mut writer = encoder.write_header()?;
    writer.write_chunk(png::chunk::ChunkType(*b"cICP"), &cicp(space))?;
    writer.write_chunk(png::chunk::iCCP, &named_profile(space)?)?;
    match pixels {
        PngPixels::Eight(samples) => writer.write_image_data(samples)?,
        PngPixels::Sixteen(samples) => {
            let bytes: Vec<u8> = samples.iter().flat_map(|sample| sample.to_be_bytes()).collect();
            writer.write_image_data(&bytes)?;
        }
    }
    writer.finish()
}

/// What `iCCP` holds (section 11.3.2.3): the profile's name, a zero, 0 for deflate, and the profile. The `png` crate's own
/// calls every profile `_`.
fn named_profile(space: RgbSpace) -> io::Result<Vec<u8>> {
    let mut chunk = [icc_name(space).as_bytes(), &[0, 0]].concat();
    let mut packed = flate2::write::ZlibEncoder::new(&mut chunk, flate2::Compression::best());
    packed.write_all(&icc_profile(space))?;
    packed.finish()?;
    Ok(chunk)
}

/// All texts of the PNG file at `path`, as [`png_text`] finds them.
///
/// # Errors
/// A path that is no readable PNG file, with the path in the message.
pub fn read_png_text(path: &Path) -> Result<Vec<(String, String)>, PictureFileError> {
    read_bytes(path)
        .and_then(|bytes| guarded(|| png_text(Cursor::new(bytes))))
        .map_err(|problem| problem.at(path))
}

/// All texts of a PNG, as (keyword, text): Latin-1 ones first, then compressed, then UTF-8, each
/// in the order of the file. The pixels are passed over.
///
/// # Errors
/// Something that is not a PNG, or a damaged one, or a text beyond [`TEXT_BYTES_MAX`].
pub fn png_text(file: impl BufRead + Seek) -> Result<Vec<(String, String)>, PictureFileError> {
    let mut decoder = png::Decoder::new(file);
    if let Err(png::DecodingError::Format(problem)) = decoder.read_header_info() {
        return Err(match problem.to_string() {
            signature if signature.contains("signature") => {
                PictureFileError::Format { allowed: "PNG" }
            }
            other => PictureFileError::damaged(&other),
        });
    }
    let damaged = |problem: png::DecodingError| PictureFileError::damaged(&problem);
    let mut reader = decoder.read_info().map_err(damaged)?;
    reader.finish().map_err(damaged)?; // other programs put their texts behind the pixels
    let info = reader.info();
    let mut texts = Vec::new();
    for chunk in &info.uncompressed_latin1_text {
        texts.push((chunk.keyword.clone(), chunk.text.clone()));
    }
    for mut chunk in info.compressed_latin1_text.iter().cloned() {
        chunk.decompress_text_with_limit(TEXT_BYTES_MAX).map_err(damaged)?;
        texts.push((chunk.keyword.clone(), chunk.get_text().map_err(damaged)?));
    }
    for mut chunk in info.utf8_text.iter().cloned() {
        chunk.decompress_text_with_limit(TEXT_BYTES_MAX).map_err(damaged)?;
        texts.push((chunk.keyword.clone(), chunk.get_text().map_err(damaged)?));
    }
    Ok(texts)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: (u32, u32) = (37, 23);

    fn samples() -> Vec<u16> {
        (0..37 * 23 * 3).map(|index: u32| (index * 40_503 % 65_536) as u16).collect()
    }

    fn written(pixels: PngPixels<'_>, space: RgbSpace, text: &[(&str, &str)]) -> Vec<u8> {
        let text: Vec<_> =
            text.iter().map(|&(key, value)| (key.to_owned(), value.to_owned())).collect();
        let mut file = Vec::new();
        write_png(&mut file, SIZE.0, SIZE.1, pixels, space, &text).unwrap();
        file
    }

    fn place(file: &[u8], chunk: &[u8]) -> Option<usize> {
        file.windows(4).position(|name| name == chunk)
    }

    #[test]
    fn another_reader_gets_every_sample_of_8_and_16_bits() {
        let wide = samples();
        let file = written(PngPixels::Sixteen(&wide), RgbSpace::Srgb, &[]);
        let picture = image::load_from_memory(&file).unwrap();
        assert_eq!(picture.color(), image::ColorType::Rgb16);
        assert_eq!(picture.into_rgb16().into_raw(), wide);
        let narrow: Vec<u8> = wide.iter().map(|sample| (sample >> 8) as u8).collect();
        let file = written(PngPixels::Eight(&narrow), RgbSpace::DisplayP3, &[]);
        assert_eq!(image::load_from_memory(&file).unwrap().into_rgb8().into_raw(), narrow);
    }

    #[test]
    fn the_colour_space_stands_in_cicp_and_iccp_ahead_of_the_pixels() {
        for (space, primaries) in [(RgbSpace::Srgb, 1), (RgbSpace::DisplayP3, 12)] {
            let file = written(PngPixels::Sixteen(&samples()), space, &[]);
            let cicp = place(&file, b"cICP").unwrap();
            assert_eq!(file[cicp + 4..cicp + 8], [primaries, 13, 0, 1]);
            let pixels = place(&file, b"IDAT").unwrap();
            let (profile, name) = (place(&file, b"iCCP").unwrap() + 4, icc_name(space));
            assert_eq!(&file[profile..][..name.len()], name.as_bytes());
            assert!(cicp < pixels && place(&file, b"iCCP").unwrap() < pixels);
            // The standard forbids both; the chunk is one byte long, the profile's name is not it.
            assert_eq!(file.windows(8).position(|head| head == b"\0\0\0\x01sRGB"), None);
        }
    }

    #[test]
    fn a_fourth_sample_is_alpha() {
        let codes: Vec<u16> = (0..SIZE.0 * SIZE.1 * 4).map(|i| (i * 257 % 65_536) as u16).collect();
        let file = written(PngPixels::Sixteen(&codes), RgbSpace::Srgb, &[]);
        let read = image::load_from_memory(&file).unwrap();
        assert_eq!(read.color(), image::ColorType::Rgba16);
        assert_eq!(read.into_rgba16().into_raw(), codes);
    }

    #[test]
    fn equal_input_gives_equal_bytes() {
        let text = [("Software", "nacreous"), ("nacreous:seed", "7")];
        let write = || written(PngPixels::Sixteen(&samples()), RgbSpace::DisplayP3, &text);
        assert_eq!(write(), write());
    }

    #[test]
    fn texts_come_back_in_order_and_in_any_script() {
        let text = [("nacreous:spec", "thickness = 450 # 真珠, µm\n"), ("Software", "")];
        let file = written(PngPixels::Sixteen(&samples()), RgbSpace::Srgb, &text);
        let read = png_text(Cursor::new(file)).unwrap();
        let read: Vec<_> = read.iter().map(|(key, value)| (key.as_str(), value.as_str())).collect();
        assert_eq!(read, text);
    }

    #[test]
    fn what_a_png_cannot_hold_is_refused() {
        let attempt = |keyword: &str, value: &str, given: usize| {
            let text = [(keyword.to_owned(), value.to_owned())];
            let pixels = vec![0; given];
            let pixels = PngPixels::Eight(&pixels);
            let outcome = write_png(&mut Vec::new(), 2, 2, pixels, RgbSpace::Srgb, &text);
            outcome.map_err(|problem| problem.to_string())
        };
        assert_eq!(attempt("spec", "x", 12), Ok(()));
        assert_eq!(
            attempt("spec", "x", 11).unwrap_err(),
            "the picture has 11 samples; 2 x 2 x 3 are needed"
        );
        for keyword in ["", " spec", "a  b", "größe", &"k".repeat(80)] {
            let message = attempt(keyword, "x", 12).unwrap_err();
            assert!(message.contains("allowed: 1 to 79 printable ASCII"), "{message}");
        }
        assert!(attempt("spec", "a\0b", 12).unwrap_err().contains("NUL"));
    }

    #[test]
    fn a_full_disk_is_told() {
        let mut room = [0_u8; 64];
        let outcome = write_png(
            &mut room.as_mut_slice(),
            SIZE.0,
            SIZE.1,
            PngPixels::Sixteen(&samples()),
            RgbSpace::Srgb,
            &[],
        );
        assert!(matches!(outcome, Err(PictureFileError::Unwritable(_))));
    }
}
