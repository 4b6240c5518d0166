//! EXR: the linear picture and its layers, exactly as computed.
//!
//! One part, after the convention that viewers list: the picture in channels R, G, B (and A), the
//! layers beside it as `interference.R` and so on; Rec. 709 primaries; metadata as text attributes.
//! 32-bit floats, because 16-bit ones keep three digits, too few to hold one layer against another;
//! ZIP over 16 rows, lossless and read everywhere. Equal input gives equal bytes.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{Cursor, Write};
use std::path::Path;

use exr::meta::attribute::{AttributeValue, Chromaticities, Text};
use exr::meta::header::Header;
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels,
    ReadLayers, Vec2, WritableImage,
};

use crate::picture::{
    PictureFileError, check_finite, check_sample_count, check_size, check_text, guarded, read_bytes,
};

/// The channels of a plane.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Channels {
    /// One number a pixel, channel Y.
    Grey,
    /// Linear-light sRGB, channels R, G, B.
    Rgb,
    /// Linear-light sRGB and coverage (colour already multiplied by it), channels R, G, B, A.
    Rgba,
}

impl Channels {
    /// The channels' names, in the order of the samples.
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Grey => &["Y"],
            Self::Rgb => &["R", "G", "B"],
            Self::Rgba => &["R", "G", "B", "A"],
        }
    }

    /// The channels for so many samples a pixel; nothing unless 1, 3 or 4.
    pub fn of_count(count: usize) -> Option<Self> {
        [Self::Grey, Self::Rgb, Self::Rgba].into_iter().find(|own| own.names().len() == count)
    }
}

/// The picture itself (its name is empty) or one of its layers.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane<'a> {
    /// Empty for the picture; for a layer 1 to 29 letters, digits, `_` or `-`.
    pub name: String,
    /// What the samples of a pixel are.
    pub channels: Channels,
    /// Finite values in the order [row, column, channel].
    pub samples: Cow<'a, [f32]>,
}

/// The picture, its layers and its metadata, as [`read_exr`] finds them.
#[derive(Clone, Debug, PartialEq)]
pub struct Layers {
    /// Pixels in a row.
    pub width: usize,
    /// Rows, the topmost first.
    pub height: usize,
    /// Sorted by name, so that the picture comes first.
    pub planes: Vec<Plane<'static>>,
    /// Texts as (keyword, text), sorted by keyword.
    pub text: Vec<(String, String)>,
}

/// Writes a picture, its layers and its metadata (keyword, text).
///
/// # Errors
/// No picture among the planes, names that are not allowed or not unique, samples that do not fit
/// the size or are not finite, keywords that the format keeps for itself, and whatever `out` says.
///
/// ```
/// use nacreous_file::exr::{Channels, Plane, read_exr, write_exr};
/// let plane = |name: &str, samples: Vec<f32>| Plane {
///     name: name.to_owned(),
///     channels: Channels::Rgb,
///     samples: samples.into(),
/// };
/// let planes = [plane("", vec![0.5, 0.25, 2.0]), plane("mirror", vec![0.0, 0.125, 1.0])];
/// let mut file = Vec::new();
/// write_exr(&mut file, 1, 1, &planes, &[])?;
/// assert_eq!(read_exr(&file)?.planes, planes);
/// # Ok::<(), nacreous_file::picture::PictureFileError>(())
/// ```
pub fn write_exr(
    out: &mut impl Write,
    width: usize,
    height: usize,
    planes: &[Plane<'_>],
    text: &[(String, String)],
) -> Result<(), PictureFileError> {
    check_planes(width, height, planes)?;
    check_text(text)?;
    let mut file = Vec::new();
    let channels = AnyChannels::sort(planes.iter().flat_map(separate).collect());
    let size = Vec2(width, height);
    let layer = Layer::new(size, LayerAttributes::default(), Encoding::SMALL_LOSSLESS, channels);
    let mut image = Image::from_layer(layer);
    image.attributes.chromaticities = Some(Chromaticities {
        red: Vec2(0.64, 0.33),
        green: Vec2(0.30, 0.60),
        blue: Vec2(0.15, 0.06),
        white: Vec2(0.3127, 0.3290),
    });
    for (keyword, value) in text {
        let value = AttributeValue::Text(Text::from_slice_unchecked(value.as_bytes())); // UTF-8
        image.attributes.other.insert(keyword.as_str().into(), value);
    }
    image
        .write()
        .to_buffered(Cursor::new(&mut file))
        .map_err(|problem| PictureFileError::Encoder(problem.to_string()))?;
    sort_attributes(&mut file);
    out.write_all(&file).map_err(PictureFileError::Unwritable)
}

fn check_planes(width: usize, height: usize, planes: &[Plane<'_>]) -> Result<(), PictureFileError> {
    let wrong = |name: &str, problem: &str| {
        Err(PictureFileError::Layer { name: name.to_owned(), problem: problem.to_owned() })
    };
    if !planes.iter().any(|plane| plane.name.is_empty()) {
        return wrong(
            "",
            "(the picture itself) is missing; it and any number of layers are needed",
        );
    }
    for (index, Plane { name, channels, samples }) in planes.iter().enumerate() {
        let letter = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'-';
        if name.len() > 29 || !name.bytes().all(letter) {
            return wrong(name, "is no layer name; allowed: at most 29 of a-z A-Z 0-9 _ -");
        }
        if planes[..index].iter().any(|earlier| earlier.name == *name) {
            return wrong(name, "is given twice; allowed: each layer once");
        }
        let count = channels.names().len();
        check_sample_count(&format!("layer {name:?}"), samples.len(), (width, height, count))?;
        check_finite(samples, width, count).map_err(|problem| PictureFileError::Layer {
            name: name.clone(),
            problem: problem.to_string(),
        })?;
    }
    Ok(())
}

/// The plane's channels, one after the other.
fn separate(plane: &Plane<'_>) -> Vec<AnyChannel<FlatSamples>> {
    let names = plane.channels.names();
    let channel = |(offset, letter): (usize, &&str)| {
        let name = match plane.name.as_str() {
            "" => (*letter).to_owned(),
            layer => format!("{layer}.{letter}"),
        };
        let samples = plane.samples.iter().skip(offset).step_by(names.len()).copied().collect();
        AnyChannel::new(name.as_str(), FlatSamples::F32(samples))
    };
    names.iter().enumerate().map(channel).collect()
}

/// Puts the header's attributes into the order of their names. The `exr` crate keeps texts in a
/// hash map, whose order changes from run to run; the header's length, and with it every offset
/// behind it, stays as it was.
///
/// A header is a list of (name, 0, type, 0, length as i32, value), closed by a 0, behind eight
/// bytes of magic number and version.
fn sort_attributes(file: &mut [u8]) {
    const START: usize = 8;
    let past_zero =
        |from: usize| file[from..].iter().position(|&byte| byte == 0).map(|n| from + n + 1);
    let mut attributes = Vec::new();
    let mut start = START;
    while file.get(start).is_some_and(|&byte| byte != 0) {
        let Some(length_at) = past_zero(start).and_then(past_zero) else { return };
        let Some(&[a, b, c, d]) = file.get(length_at..length_at + 4) else { return };
        let end = length_at + 4 + u32::from_le_bytes([a, b, c, d]) as usize;
        attributes.push(file[start..end].to_vec());
        start = end;
    }
    attributes.sort();
    file[START..start].copy_from_slice(&attributes.concat());
}

/// Refuses spectra by name: channels such as `S0.550,0nm` (Fichet et al. 2021) are no colours.
fn check_not_spectral(header: &Header) -> Result<(), PictureFileError> {
    let names = header.channels.list.iter().map(|channel| channel.name.to_string());
    match names.into_iter().find(|name| name.ends_with("nm")) {
        Some(name) => Err(PictureFileError::Unsupported(format!(
            "holds spectra (channel {name}), which are not read here; allowed: layers of Y, RGB or RGBA"
        ))),
        None => Ok(()),
    }
}

/// Reads what [`write_exr`] wrote: the first part's channels, grouped into planes by their names,
/// and its text attributes.
///
/// # Errors
/// Something that is not EXR, a damaged file, a size beyond the limits, spectra, and layers whose
/// channels are not Y, RGB or RGBA.
pub fn read_exr(bytes: &[u8]) -> Result<Layers, PictureFileError> {
    if !bytes.starts_with(&exr::meta::magic_number::BYTES) {
        return Err(PictureFileError::Format { allowed: "OpenEXR (.exr)" });
    }
    let damaged = |problem: exr::error::Error| PictureFileError::exr(&problem);
    let reader = exr::block::read(Cursor::new(bytes), false).map_err(damaged)?;
    for header in reader.headers() {
        check_size(header.layer_size.width() as u64, header.layer_size.height() as u64)?;
        check_not_spectral(header)?;
    }
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .non_parallel() // a panic in a worker thread could not be caught
        .from_chunks(reader)
        .map_err(damaged)?;
    let Vec2(width, height) = image.layer_data.size;
    let own = &image.layer_data.attributes.other;
    let text = texts(image.attributes.other.iter().chain(own));
    let planes = group(&image.layer_data.channel_data.list)?;
    Ok(Layers { width, height, planes, text })
}

/// The text attributes of the EXR file at `path`, sorted by keyword; its pixels are passed over.
///
/// # Errors
/// A path that is no readable EXR file, with the path in the message.
pub fn read_exr_text(path: &Path) -> Result<Vec<(String, String)>, PictureFileError> {
    read_bytes(path)
        .and_then(|bytes| guarded(|| header_text(&bytes)))
        .map_err(|problem| problem.at(path))
}

fn header_text(bytes: &[u8]) -> Result<Vec<(String, String)>, PictureFileError> {
    if !bytes.starts_with(&exr::meta::magic_number::BYTES) {
        return Err(PictureFileError::Format { allowed: "OpenEXR (.exr)" });
    }
    let reader = exr::block::read(Cursor::new(bytes), false)
        .map_err(|problem| PictureFileError::exr(&problem))?;
    let attributes = |header: &Header| {
        let own = header.own_attributes.other.clone().into_iter();
        header.shared_attributes.other.clone().into_iter().chain(own).collect::<Vec<_>>()
    };
    let all: Vec<_> = reader.headers().iter().flat_map(attributes).collect();
    Ok(texts(all.iter().map(|(keyword, value)| (keyword, value))))
}

/// The attributes that are texts, sorted.
fn texts<'a>(
    attributes: impl Iterator<Item = (&'a Text, &'a AttributeValue)>,
) -> Vec<(String, String)> {
    let text = |(keyword, value): (&Text, &AttributeValue)| match value {
        AttributeValue::Text(text) => {
            Some((keyword.to_string(), String::from_utf8_lossy(text.as_slice()).into_owned()))
        }
        _ => None,
    };
    let mut texts: Vec<_> = attributes.filter_map(text).collect();
    texts.sort();
    texts
}

/// Channels back to planes; a sorted map keeps the picture, whose name is empty, in front.
fn group(list: &[AnyChannel<FlatSamples>]) -> Result<Vec<Plane<'static>>, PictureFileError> {
    let mut layers: BTreeMap<String, BTreeMap<String, Vec<f32>>> = BTreeMap::new();
    for channel in list {
        let full = channel.name.to_string();
        let (layer, letter) = full.rsplit_once('.').unwrap_or(("", &full));
        let samples = channel.sample_data.values_as_f32().collect();
        layers.entry(layer.to_owned()).or_default().insert(letter.to_owned(), samples);
    }
    let plane = |(name, mut parts): (String, BTreeMap<String, Vec<f32>>)| {
        let channels = Channels::of_count(parts.len());
        let ordered: Option<Vec<_>> = channels
            .and_then(|own| own.names().iter().map(|&letter| parts.remove(letter)).collect());
        let (Some(channels), Some(ordered)) = (channels, ordered) else {
            let problem = "has channels other than Y, RGB or RGBA".to_owned();
            return Err(PictureFileError::Layer { name, problem });
        };
        let pixel = |index: usize| ordered.iter().map(move |samples| samples[index]);
        let samples = (0..ordered[0].len()).flat_map(pixel).collect();
        Ok(Plane { name, channels, samples })
    };
    layers.into_iter().map(plane).collect()
}
