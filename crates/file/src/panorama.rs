//! A panorama, the light from all around, from a user's file.
//!
//! Radiance `.hdr` (`radiance.rs`) and EXR `.exr`, both linear. Of an EXR file, the channels R, G and B; else its one
//! layer of colour, such as `ViewLayer.Combined.R`; of several layers, or parts with colours, the one called Combined.
//! Files that state other primaries are converted, all others are taken as Rec. 709. Values below zero, as
//! resampling leaves them around lamps, become zero; NaN and infinity are refused. Limits: [`crate::picture`].

use std::collections::BTreeSet;
use std::io::Cursor;
use std::path::Path;

use exr::meta::attribute::Chromaticities;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, ReadSpecificChannel, Vec2};

use crate::picture::{
    LinearPicture, PictureFileError, check_finite, check_size, guarded, read_bytes,
};
use crate::profile::{convert, srgb_from_rgb};
use crate::radiance;

/// Reads the panorama at `path`; see [`decode_panorama`].
///
/// # Errors
/// As [`decode_panorama`], and a path that is no readable file, each with the path in front.
pub fn read_panorama(path: &Path) -> Result<LinearPicture, PictureFileError> {
    read_bytes(path)
        .and_then(|bytes| guarded(|| decode_panorama(&bytes)))
        .map_err(|problem| problem.at(path))
}

/// Decodes the bytes of a `.hdr` or `.exr` file to linear-light sRGB, 0 or more.
///
/// # Errors
/// Another format, a damaged file, no R, G and B channels, a cropped picture, NaN or infinity, and
/// a size beyond the limits, found in the header before anything is decoded.
pub fn decode_panorama(bytes: &[u8]) -> Result<LinearPicture, PictureFileError> {
    let mut picture = match bytes {
        _ if bytes.starts_with(radiance::SIGNATURE) => radiance::decode(bytes)?,
        _ if bytes.starts_with(&exr::meta::magic_number::BYTES) => decode_exr(bytes)?,
        _ => return Err(PictureFileError::Format { allowed: "Radiance (.hdr), OpenEXR (.exr)" }),
    };
    check_finite(&picture.rgb, picture.width, 3)?;
    for value in &mut picture.rgb {
        *value = value.max(0.0);
    }
    Ok(picture)
}

fn decode_exr(bytes: &[u8]) -> Result<LinearPicture, PictureFileError> {
    let damaged = |problem: exr::error::Error| PictureFileError::exr(&problem);
    let reader = exr::block::read(Cursor::new(bytes), false).map_err(damaged)?;
    for header in reader.headers() {
        check_size(header.layer_size.width() as u64, header.layer_size.height() as u64)?;
    }
    let (header, layer) = colours_of(reader.headers())?;
    let header = header.clone();
    let [red, green, blue] = COLOURS.map(|letter| format!("{layer}{letter}"));
    if header.data_window() != header.shared_attributes.display_window {
        let problem = "is cropped (its data and display windows differ); a panorama must be whole";
        return Err(PictureFileError::Unsupported(problem.to_owned()));
    }
    let conversion = conversion(header.shared_attributes.chromaticities)?;
    let channels = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .specific_channels()
        .required(red.as_str())
        .required(green.as_str())
        .required(blue.as_str())
        .collect_pixels(
            |size, _| LinearPicture {
                width: size.width(),
                height: size.height(),
                rgb: vec![0.0; size.area() * 3],
            },
            |picture: &mut LinearPicture, Vec2(x, y), (r, g, b): (f32, f32, f32)| {
                let first = (y * picture.width + x) * 3;
                picture.rgb[first..first + 3].copy_from_slice(&[r, g, b]);
            },
        );
    let image = InPart { header, channels }
        .first_valid_layer()
        .all_attributes()
        .non_parallel() // a panic in a worker thread could not be caught
        .from_chunks(reader)
        .map_err(damaged)?;
    let mut picture = image.layer_data.channel_data.pixels;
    if let Some(matrix) = conversion {
        convert(&mut picture.rgb, matrix);
    }
    Ok(picture)
}

/// The last part of a channel's name that holds colour.
const COLOURS: [&str; 3] = ["R", "G", "B"];

/// Channels of one part of a file, and of no other.
struct InPart<C> {
    header: Header,
    channels: C,
}

impl<'s, C: ReadChannels<'s>> ReadChannels<'s> for InPart<C> {
    type Reader = C::Reader;

    fn create_channels_reader(&'s self, header: &Header) -> exr::error::Result<Self::Reader> {
        if *header != self.header {
            return Err(exr::error::Error::NotSupported("another part".into()));
        }
        self.channels.create_channels_reader(header)
    }
}

/// The part that holds the picture, and what stands before R, G and B in the names of its channels: nothing, or
/// a layer and a dot.
fn colours_of(headers: &[Header]) -> Result<(&Header, String), PictureFileError> {
    let found: Vec<(&Header, String)> = headers
        .iter()
        .flat_map(|header| layers_of_colour(header).into_iter().map(move |layer| (header, layer)))
        .collect();
    let parts = headers.iter().filter(|header| !layers_of_colour(header).is_empty()).count();
    if let [(header, layer), ..] = &found[..]
        && (found.len() == 1 || (parts == 1 && layer.is_empty()))
    {
        return Ok((header, layer.clone()));
    }
    let names: Vec<String> = found.iter().map(|(header, layer)| name_of(header, layer)).collect();
    let is_combined = |name: &String| name.to_ascii_lowercase().ends_with("combined");
    let combined: Vec<usize> = (0..names.len()).filter(|&i| is_combined(&names[i])).collect();
    let problem = match combined[..] {
        [only] => return Ok(found[only].clone()),
        _ if found.is_empty() => {
            let channels = headers.iter().flat_map(|header| &header.channels.list);
            let channels: BTreeSet<String> = channels.map(|one| one.name.to_string()).collect();
            let channels = shown(channels.iter().map(String::as_str));
            format!("has no channels R, G and B, which a panorama needs, but {channels}")
        }
        _ => {
            let kind = if parts == 1 { "layers" } else { "parts" };
            let names = shown(names.iter().map(String::as_str));
            format!("has colours in several {kind} ({names}); save one as R, G and B")
        }
    };
    Err(PictureFileError::Unsupported(problem))
}

/// What a layer is called: by its channels, else by its part.
fn name_of(header: &Header, layer: &str) -> String {
    let part = || header.own_attributes.layer_name.as_ref().map(ToString::to_string);
    match layer.trim_end_matches('.') {
        "" => part().unwrap_or_default(),
        layer => layer.to_owned(),
    }
}

/// What stands before R, G and B in the names of a part's channels, in the order of the names.
fn layers_of_colour(header: &Header) -> BTreeSet<String> {
    let names = header.channels.list.iter().map(|channel| channel.name.to_string());
    let layers = names.filter_map(|name| name.strip_suffix(COLOURS[0]).map(ToOwned::to_owned));
    let whole =
        |layer: &String| (layer.is_empty() || layer.ends_with('.')) && has_colour(header, layer);
    layers.filter(whole).collect()
}

fn has_colour(header: &Header, layer: &str) -> bool {
    COLOURS.iter().all(|letter| {
        let name = format!("{layer}{letter}");
        header.channels.list.iter().any(|channel| channel.name.eq(name.as_str()))
    })
}

/// The first of some names, as a message shows them.
fn shown<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.take(8).map(|name| format!("{name:?}")).collect();
    names.join(", ")
}

/// The matrix to linear sRGB, or nothing where the file says or implies Rec. 709.
fn conversion(stated: Option<Chromaticities>) -> Result<Option<[[f64; 3]; 3]>, PictureFileError> {
    let Some(Chromaticities { red, green, blue, white }) = stated else { return Ok(None) };
    let [red, green, blue, white] = [red, green, blue, white].map(|Vec2(x, y)| [x, y]);
    let rec709 = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06], [0.3127, 0.3290]];
    let near = |(a, b): (&f32, &f32)| (a - b).abs() < 1e-3;
    if [red, green, blue, white].as_flattened().iter().zip(rec709.as_flattened()).all(near) {
        return Ok(None);
    }
    let matrix = srgb_from_rgb([red, green, blue], white).ok_or_else(|| {
        PictureFileError::ColourProfile("its chromaticities span no colour space".to_owned())
    })?;
    Ok(Some(matrix))
}

#[cfg(test)]
mod tests {
    use exr::prelude::{Image, SpecificChannels, WritableImage};

    use super::*;

    fn radiance(size: &str, pixels: &[[u8; 4]]) -> Vec<u8> {
        let header = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{size}\n");
        [header.as_bytes(), pixels.as_flattened()].concat()
    }

    fn open_exr(first: f32, chromaticities: Option<Chromaticities>) -> Vec<u8> {
        let value = |Vec2(x, _)| if x == 0 { (first, 0.25_f32, 4.0_f32) } else { (1.0, 1.0, 1.0) };
        let mut image = Image::from_channels((3, 2), SpecificChannels::rgb(value));
        image.attributes.chromaticities = chromaticities;
        let mut file = Cursor::new(Vec::new());
        image.write().to_buffered(&mut file).unwrap();
        file.into_inner()
    }

    fn message(bytes: &[u8]) -> String {
        decode_panorama(bytes).unwrap_err().to_string()
    }

    #[test]
    fn rgbe_is_mantissa_times_a_power_of_two() {
        // Ward, "Real Pixels" (1991): value = mantissa * 2^(exponent - 136).
        let file = radiance("-Y 1 +X 2", &[[128, 64, 32, 129], [128, 0, 0, 140]]);
        let picture = decode_panorama(&file).unwrap();
        assert_eq!(
            picture,
            LinearPicture { width: 2, height: 1, rgb: vec![1.0, 0.5, 0.25, 2048.0, 0.0, 0.0] }
        );
    }

    #[test]
    fn floats_pass_unchanged_and_undershoots_become_black() {
        assert_eq!(decode_panorama(&open_exr(1e6, None)).unwrap().rgb[..3], [1e6, 0.25, 4.0]);
        assert_eq!(decode_panorama(&open_exr(-0.01, None)).unwrap().rgb[..3], [0.0, 0.25, 4.0]);
    }

    #[test]
    fn white_stays_white_from_other_primaries() {
        let xy = |x, y| Vec2(x, y);
        let rec2020 = Chromaticities {
            red: xy(0.708, 0.292),
            green: xy(0.170, 0.797),
            blue: xy(0.131, 0.046),
            white: xy(0.3127, 0.3290),
        };
        let picture = decode_panorama(&open_exr(0.5, Some(rec2020))).unwrap();
        assert!(picture.rgb[3..6].iter().all(|value| (value - 1.0).abs() < 1e-5));
        // ITU-R BT.2087: green of Rec. 709 is -0.1246 R + 1.1329 G - 0.0083 B of Rec. 2020.
        let green = -0.1246 * 0.5 + 1.1329 * 0.25 - 0.0083 * 4.0;
        assert!((picture.rgb[1] - green).abs() < 1e-3, "{}", picture.rgb[1]);
    }

    #[test]
    fn values_that_are_no_numbers_are_refused() {
        let place = "the first at row 0, column 0, channel 0";
        for value in [f32::NAN, f32::INFINITY] {
            let expected = format!("holds 2 values that are not finite, {place}");
            assert_eq!(message(&open_exr(value, None)), expected);
        }
    }

    #[test]
    fn huge_broken_and_foreign_files_are_refused() {
        let huge = message(&radiance("-Y 20000 +X 40000", &[]));
        assert!(huge.starts_with("is 40000 x 20000 pixels; allowed:"), "{huge}");
        assert!(message(&radiance("-Y 9 +X 9", &[[1; 4]])).contains("damaged or cut short"));
        let whole = open_exr(1.0, None);
        assert!(message(&whole[..whole.len() / 2]).contains("damaged or cut short"));
        assert!(message(b"\x89PNG\r\n\x1a\n").contains("allowed: Radiance (.hdr), OpenEXR (.exr)"));
    }

    #[test]
    fn no_broken_file_brings_the_decoders_down() {
        let mut state = 1_u32;
        let mut random = move |below: usize| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as usize % below
        };
        for whole in [open_exr(0.5, None), radiance("-Y 2 +X 2", &[[9, 8, 7, 128]; 4])] {
            for _ in 0..2000 {
                let mut broken = whole.clone();
                for _ in 0..=random(4) {
                    let place = random(broken.len());
                    broken[place] = random(256) as u8;
                }
                if let Ok(LinearPicture { rgb, .. }) = decode_panorama(&broken) {
                    assert!(rgb.iter().all(|value| *value >= 0.0 && value.is_finite()));
                }
            }
        }
    }
}
