//! The binding of how far apart two pictures look.

use js_sys::{Float32Array, Object};
use nacreous_colour::RgbSpace;
use nacreous_image::{differences, summary};
use wasm_bindgen::prelude::*;

use crate::{picture::object, refused};

#[wasm_bindgen(typescript_custom_section)]
const DIFFERENCE: &str = "/** CIEDE2000 between two pictures. */
export interface Difference {
  /** Of each pixel. */
  readonly map: Float32Array<ArrayBuffer>;
  /** How many pixels are covered; the numbers below are of these, and 0 of none. */
  readonly pixels: number;
  readonly mean: number;
  readonly percentile95: number;
  readonly largest: number;
}";

/// CIEDE2000 between the codes RGBA of two pictures, and what it comes to over the pixels whose `covered` is not 0.
#[wasm_bindgen(unchecked_return_type = "Difference")]
pub fn difference(
    first: &[u8],
    second: &[u8],
    covered: &[u8],
    #[wasm_bindgen(unchecked_param_type = "Space")] space: &str,
) -> Result<Object, JsValue> {
    let space: RgbSpace = space.parse().map_err(refused)?;
    let lengths = (first.len(), second.len(), 4 * covered.len());
    if lengths.0 != lengths.1 || lengths.0 != lengths.2 {
        let (a, b, c) = (first.len(), second.len(), covered.len());
        let message = format!(
            "the pictures have {a} and {b} codes and {c} pixels; allowed: four codes a pixel"
        );
        return Err(refused(message).into());
    }
    let map = differences(first, second, space);
    let found = summary(&map, covered);
    let number = |of: fn(&nacreous_image::DifferenceSummary) -> f64| found.as_ref().map_or(0.0, of);
    object(&[
        ("map", Float32Array::from(map.as_slice()).into()),
        ("pixels", number(|found| found.pixels as f64).into()),
        ("mean", number(|found| found.mean).into()),
        ("percentile95", number(|found| found.percentile_95).into()),
        ("largest", number(|found| found.largest).into()),
    ])
}
