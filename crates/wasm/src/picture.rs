//! The binding of pixels: their layers, and codes for a screen.

use js_sys::{Array, Object, Reflect};
use nacreous_colour::{Gamut, RgbSpace};
use nacreous_image::{CHANNELS, PARTS, screen};
use nacreous_render::light_of_pixel;
use wasm_bindgen::{Clamped, prelude::*};

use crate::{job::check_pixels, refused};

#[wasm_bindgen(typescript_custom_section)]
const PICTURE: &str = r#"/** The parts of a pixel; the first four add up to its light. */
export type LayerName =
  | "interference"
  | "diffuse"
  | "mirror"
  | "surroundings"
  | "texture"
  | "coverage";

/** A part of a pixel, and which of its numbers it has: `first` up to and without `end`. */
export interface Layer {
  readonly name: LayerName;
  readonly first: number;
  readonly end: number;
}

/** A colour space of screens; a canvas knows them by the same names. */
export type Space = "srgb" | "display-p3";

/** What becomes of colours that a screen cannot show: bent towards grey, or cut channel by channel. */
export type GamutHandling = "soft" | "clip";

/** Codes for a screen. */
export interface Developed {
  /** Four a pixel, the last 255: what `new ImageData(codes, width, height, { colorSpace })` takes. */
  readonly codes: Uint8ClampedArray<ArrayBuffer>;
  /** Share of the pixels whose colour the screen cannot show; the gamut handling changed them. */
  readonly outOfGamut: number;
}"#;

/// The parts of a pixel.
#[wasm_bindgen(unchecked_return_type = "Layer[]")]
pub fn layers() -> Result<Array, JsValue> {
    let layer = |(name, numbers): &(&str, std::ops::Range<usize>)| {
        object(&[
            ("name", (*name).into()),
            ("first", (numbers.start as u32).into()),
            ("end", (numbers.end as u32).into()),
        ])
    };
    PARTS.iter().map(layer).collect()
}

/// Turns pixels of all layers, any number of them, into 8-bit codes.
#[wasm_bindgen(unchecked_return_type = "Developed")]
pub fn develop(
    pixels: &[f32],
    #[wasm_bindgen(unchecked_param_type = "Space")] space: &str,
    #[wasm_bindgen(unchecked_param_type = "GamutHandling")] gamut: &str,
) -> Result<Object, JsValue> {
    check_pixels(pixels)?;
    let space: RgbSpace = space.parse().map_err(refused)?;
    let gamut: Gamut = gamut.parse().map_err(refused)?;
    let light = |i: usize| light_of_pixel(&pixels[CHANNELS * i..]).map(f64::from);
    let screened = screen(pixels.len() / CHANNELS, light, space, gamut);
    object(&[
        ("codes", Clamped(screened.codes).into()),
        ("outOfGamut", screened.out_of_gamut.into()),
    ])
}

/// An object with these keys.
pub fn object(entries: &[(&str, JsValue)]) -> Result<Object, JsValue> {
    let made = Object::new();
    for (key, value) in entries {
        Reflect::set(&made, &(*key).into(), value)?;
    }
    Ok(made)
}
