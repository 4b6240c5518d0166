//! Files that a recipe names: panoramas, photographs of grain, measured lights.

use js_sys::{Float32Array, Float64Array, Object};
use nacreous_colour::Spectrum;
use nacreous_file::{panorama::decode_panorama, photograph::decode_photograph};
use nacreous_image::grain::photograph::{Measuring, Photograph, Samples, measured};
use wasm_bindgen::prelude::*;

use crate::{check_bytes, object, refused};

#[wasm_bindgen(typescript_custom_section)]
const LIGHT: &str =
    "/** A picture of linear light in the primaries of sRGB, three numbers a pixel, row by row. */
export interface LinearPicture {
  readonly width: number;
  readonly height: number;
  readonly rgb: Float32Array<ArrayBuffer>;
}

/** The grain of a photograph, as a job takes it. */
export interface Grain {
  readonly cyclesPerMm: Float64Array<ArrayBuffer>;
  readonly density: Float64Array<ArrayBuffer>;
  readonly correlation: Float64Array<ArrayBuffer>;
}";

/// The light in a panorama's file: Radiance or OpenEXR.
#[wasm_bindgen(unchecked_return_type = "LinearPicture")]
pub fn panorama(bytes: &[u8]) -> Result<Object, JsValue> {
    check_bytes(bytes)?;
    let picture = decode_panorama(bytes).map_err(refused)?;
    object(&[
        ("width", (picture.width as u32).into()),
        ("height", (picture.height as u32).into()),
        ("rgb", Float32Array::from(picture.rgb.as_slice()).into()),
    ])
}

/// The grain on a photograph: PNG, JPEG or TIFF.
#[wasm_bindgen(js_name = photographedGrain, unchecked_return_type = "Grain")]
pub fn photographed_grain(
    bytes: &[u8],
    #[wasm_bindgen(js_name = sidePx)] side_px: usize,
    #[wasm_bindgen(js_name = mmPerPixel)] mm_per_pixel: Option<f64>,
    #[wasm_bindgen(js_name = lowPerMm)] low_per_mm: Option<f64>,
    #[wasm_bindgen(js_name = highPerMm)] high_per_mm: Option<f64>,
) -> Result<Object, JsValue> {
    check_bytes(bytes)?;
    let picture = decode_photograph(bytes).map_err(refused)?;
    let (width, height) = (picture.width, picture.height);
    let photograph = Photograph { width, height, rgb: Samples::Single(&picture.rgb) };
    let how = Measuring { side_px, mm_per_pixel, low_per_mm, high_per_mm };
    let grain = measured(&photograph, &how).map_err(refused)?;
    let correlation = grain.correlation().as_flattened();
    object(&[
        ("cyclesPerMm", Float64Array::from(grain.cycles_per_mm()).into()),
        ("density", Float64Array::from(grain.density().concat().as_slice()).into()),
        ("correlation", Float64Array::from(correlation).into()),
    ])
}

/// A measured light: 401 values from 380 to 780 nm, of the text of a table. `place` names it in messages.
#[wasm_bindgen(js_name = measuredLight)]
pub fn measured_light(text: &str, place: &str) -> Result<Vec<f64>, JsError> {
    let spectrum = Spectrum::from_csv(text, place).map_err(refused)?;
    Ok(spectrum.values().to_vec())
}
