//! The binding of measures.

use js_sys::JSON;
use nacreous_measure::{Circle, Given, Picture};
use nacreous_render::light_of;
use wasm_bindgen::prelude::*;

use crate::{job::check_pixels, refused};

#[wasm_bindgen(typescript_custom_section)]
const MEASURES: &str = r#"/** A measured number and its standard error, in the same unit; null where none can be had. */
export interface Measured {
  readonly value: number;
  readonly error: number | null;
}

/** A circle in pixels from the outer corner of the first one, y down. */
export interface Circle {
  readonly x_px: number;
  readonly y_px: number;
  readonly radius_px: number;
}

/** A colour in CIELAB relative to the white; a grey has no hue. */
export interface MeasuredColour {
  readonly lightness: Measured;
  readonly chroma: Measured;
  readonly hue_deg: Measured | null;
}

/** The colour between two distances from the middle, in radii. */
export interface MeasuredRing {
  readonly from: number;
  readonly to: number;
  readonly view_deg: number;
  readonly share: number;
  readonly colour: MeasuredColour | null;
}

/** What `nacreous measure` finds in a picture; what is null is in `refused`, with the reason. */
export interface Measures {
  readonly place: {
    readonly circle: Circle;
    readonly given: boolean;
    readonly share: number;
    readonly line: readonly (readonly [number, number])[];
  };
  readonly size: {
    readonly unit: "mm" | "px";
    readonly mean: Measured;
    readonly least: Measured;
    readonly greatest: Measured;
  };
  /** As a share, not in percent. */
  readonly roundness: Measured;
  readonly sphere: boolean;
  readonly colour: MeasuredColour | null;
  readonly rings: {
    readonly rings: readonly MeasuredRing[];
    readonly chroma: Measured;
    readonly orient: Measured;
    /** Saturated area in percent: red, yellow, green, blue-green, blue, purple. */
    readonly interference: readonly number[];
    readonly interference_total: Measured;
  } | null;
  readonly lamp: {
    readonly x_px: number;
    readonly y_px: number;
    readonly view_deg: number;
    readonly peak: number;
    readonly around: Measured;
    readonly half_width_deg: Measured;
    readonly contrast_gloss: Measured;
    readonly haze: Measured | null;
    readonly distinctness: Measured | null;
    readonly line: readonly (readonly [number, number])[];
    /** Degrees from its middle, and the mean luminance over directions. */
    readonly profile: readonly (readonly [number, number])[];
  } | null;
  readonly blemishes: {
    readonly area: Measured;
    readonly count: number;
    readonly looked_at: number;
    readonly threshold: number | null;
    readonly spots: readonly Circle[];
  } | null;
  readonly refused: readonly { readonly quantity: string; readonly reason: string }[];
}"#;

/// Linear light in the primaries of sRGB, three numbers a pixel, of pixels of all layers.
#[wasm_bindgen(js_name = lightOf)]
pub fn light_of_pixels(pixels: &[f32]) -> Result<Vec<f32>, JsError> {
    check_pixels(pixels)?;
    Ok(light_of(pixels))
}

/// Measures the one pearl in a square picture of linear light, relative to its own white. Without `mmPerPixel` sizes are
/// in pixels; `circle` says roughly where the pearl is: x, y and radius in pixels.
#[wasm_bindgen(unchecked_return_type = "Measures")]
pub fn measure(
    light: &[f32],
    width: usize,
    height: usize,
    #[wasm_bindgen(js_name = mmPerPixel)] mm_per_pixel: Option<f64>,
    circle: Option<Vec<f64>>,
) -> Result<JsValue, JsValue> {
    let circle = match circle.as_deref() {
        None => None,
        Some(&[x_px, y_px, radius_px]) => Some(Circle { x_px, y_px, radius_px }),
        Some(numbers) => {
            return Err(refused(format!("circle has {} numbers; allowed: 3", numbers.len())).into());
        }
    };
    let picture = Picture::new(light, width, height).map_err(refused)?;
    let given = Given { circle, mm_per_pixel, ..Given::default() };
    let found = nacreous_measure::measure(&picture, &given).map_err(refused)?;
    JSON::parse(&serde_json::to_string(&found).map_err(refused)?)
}
