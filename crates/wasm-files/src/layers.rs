//! OpenEXR with layers in and out, the texts in picture files, and codes of one layer.

use std::borrow::Cow;
use std::io::Cursor;

use js_sys::{Array, Float32Array, Object};
use nacreous_colour::{Gamut, RgbSpace};
use nacreous_file::{
    exr::{Channels, Plane, read_exr, write_exr},
    png::png_text,
};
use nacreous_image::{CHANNELS, PARTS, screen};
use nacreous_render::{light_of_pixel, spec::pearl::PearlSpec, texture_seed_of};
use wasm_bindgen::{Clamped, prelude::*};

use crate::{check_bytes, object, pairs, refused};

#[wasm_bindgen(typescript_custom_section)]
const LAYERS: &str = r#"/** The picture (its name is empty) or a layer of it. */
export interface Plane {
  readonly name: string;
  readonly channels: readonly string[];
  /** Row by row, the channels of a pixel together. */
  readonly samples: Float32Array<ArrayBuffer>;
}

/** What an OpenEXR file of ours holds. */
export interface Layered {
  readonly width: number;
  readonly height: number;
  readonly planes: readonly Plane[];
  readonly texts: readonly (readonly [keyword: string, text: string])[];
}"#;

/// The layers of an OpenEXR file and its texts.
#[wasm_bindgen(js_name = openExr, unchecked_return_type = "Layered")]
pub fn open_exr(bytes: &[u8]) -> Result<Object, JsValue> {
    check_bytes(bytes)?;
    let read = read_exr(bytes).map_err(refused)?;
    let plane = |plane: &Plane<'_>| {
        let names: Array = plane.channels.names().iter().map(|name| JsValue::from(*name)).collect();
        object(&[
            ("name", plane.name.as_str().into()),
            ("channels", names.into()),
            ("samples", Float32Array::from(&*plane.samples).into()),
        ])
    };
    let planes: Array = read.planes.iter().map(plane).collect::<Result<_, _>>()?;
    object(&[
        ("width", (read.width as u32).into()),
        ("height", (read.height as u32).into()),
        ("planes", planes.into()),
        ("texts", pairs(&read.text).into()),
    ])
}

/// The texts of a PNG.
#[wasm_bindgen(js_name = pngTexts, unchecked_return_type = "[keyword: string, text: string][]")]
pub fn png_texts(bytes: &[u8]) -> Result<Array, JsError> {
    check_bytes(bytes)?;
    Ok(pairs(&png_text(Cursor::new(bytes)).map_err(refused)?))
}

/// An OpenEXR file of pixels of all layers, and texts as pairs (keyword, text), one after the other.
#[wasm_bindgen(js_name = writeExr)]
pub fn write_layers(
    #[wasm_bindgen(js_name = sizePx)] size_px: usize,
    pixels: &[f32],
    texts: Vec<String>,
) -> Result<Vec<u8>, JsError> {
    let plane = |name: &str, samples: Vec<f32>| {
        let count = samples.len() / size_px.pow(2).max(1);
        let channels = Channels::of_count(count);
        let channels =
            channels.ok_or_else(|| refused(format!("layer {name:?} has no channels")))?;
        Ok(Plane { name: name.to_owned(), channels, samples: Cow::Owned(samples) })
    };
    let whole = || pixels.chunks_exact(CHANNELS);
    let parts = PARTS.iter().map(|(name, part)| {
        plane(name, whole().flat_map(|pixel| &pixel[part.clone()]).copied().collect())
    });
    let opaque = whole().map(light_of_pixel).flat_map(|[r, g, b]| [r, g, b, 1.0]).collect();
    let planes = [plane("", opaque)].into_iter().chain(parts);
    let planes: Vec<Plane<'_>> = planes.collect::<Result<_, JsError>>()?;
    let (pairs, _) = texts.as_chunks::<2>();
    let texts: Vec<_> = pairs.iter().cloned().map(|[keyword, text]| (keyword, text)).collect();
    let mut file = Vec::new();
    write_exr(&mut file, size_px, size_px, &planes, &texts).map_err(refused)?;
    Ok(file)
}

/// Codes RGBA of linear light, three numbers a pixel.
#[wasm_bindgen(js_name = codesOf, unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
pub fn codes_of(rgb: &[f32], space: &str, gamut: &str) -> Result<Clamped<Vec<u8>>, JsError> {
    let space: RgbSpace = space.parse().map_err(refused)?;
    let gamut: Gamut = gamut.parse().map_err(refused)?;
    let (pixels, _) = rgb.as_chunks::<3>();
    Ok(Clamped(screen(pixels.len(), |i| pixels[i].map(f64::from), space, gamut).codes))
}

/// The seed of a pearl's grain, of the pearl in JSON.
#[wasm_bindgen(js_name = textureSeed)]
pub fn texture_seed(pearl: &str) -> Result<u64, JsError> {
    Ok(texture_seed_of(&PearlSpec::from_json(pearl).map_err(refused)?))
}

/// The version of Nacreous that this is.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
