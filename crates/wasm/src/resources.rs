//! The binding of what a recipe names and does not hold: the contents of files.

use js_sys::{Array, Float32Array, Float64Array, Object, Reflect};
use nacreous_colour::Spectrum;
use nacreous_image::grain::spectrum::GrainSpectrum;
use nacreous_render::Resources;
use wasm_bindgen::prelude::*;

use crate::refused;

#[wasm_bindgen(typescript_custom_section)]
const RESOURCES: &str = r"/** The contents of the files that a recipe names, by the text that names them. */
export interface Resources {
  /** Measured lights: 401 values of each, from 380 to 780 nm. */
  readonly spectra?: Readonly<Record<string, Float64Array>>;
  readonly panoramas?: readonly Panorama[];
  readonly grains?: readonly MeasuredGrain[];
}

/** Light from all around. */
export interface Panorama {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  /** Linear light in the primaries of sRGB, three numbers a pixel, row by row from the zenith down. */
  readonly rgb: Float32Array;
}

/** The grain of a photograph. */
export interface MeasuredGrain {
  /** The pearl's number among those of the recipe. */
  readonly pearl: number;
  readonly cyclesPerMm: Float64Array;
  /** Power spectral densities of hue, value and chroma, one after the other. */
  readonly density: Float64Array;
  /** Correlations of the three, row by row. */
  readonly correlation: Float64Array;
}";

/// The resources of a page; undefined has none.
pub fn resources_of(given: &JsValue) -> Result<Resources, JsError> {
    let mut resources = Resources::default();
    if given.is_undefined() {
        return Ok(resources);
    }
    let spectra = field(given, "spectra")?;
    if !spectra.is_undefined() {
        for entry in Object::entries(spectra.unchecked_ref()) {
            let entry: Array = entry.unchecked_into();
            let name = text(&entry.get(0), "a spectrum's name")?;
            let values = doubles(&entry.get(1), &name)?;
            resources.spectra.insert(name, Spectrum::from_values(&values).map_err(refused)?);
        }
    }
    for panorama in list(given, "panoramas")? {
        add_panorama(&mut resources, &panorama)?;
    }
    for grain in list(given, "grains")? {
        let pearl = whole(&field(&grain, "pearl")?, "grains.pearl")?;
        resources.grains.insert(pearl, grain_of(&grain)?);
    }
    Ok(resources)
}

fn add_panorama(resources: &mut Resources, panorama: &JsValue) -> Result<(), JsError> {
    let name = text(&field(panorama, "name")?, "panoramas.name")?;
    let width = whole(&field(panorama, "width")?, "panoramas.width")?;
    let height = whole(&field(panorama, "height")?, "panoramas.height")?;
    let rgb = field(panorama, "rgb")?;
    let rgb: &Float32Array =
        rgb.dyn_ref().ok_or_else(|| refused("panoramas.rgb is not a Float32Array"))?;
    resources.add_panorama(&name, (width, height), &rgb.to_vec()).map_err(refused)
}

fn grain_of(given: &JsValue) -> Result<GrainSpectrum, JsError> {
    let numbers = |key: &str| doubles(&field(given, key)?, &format!("grains.{key}"));
    let (cycles_per_mm, density) = (numbers("cyclesPerMm")?, numbers("density")?);
    let correlation = numbers("correlation")?;
    let count = cycles_per_mm.len();
    if density.len() != 3 * count || correlation.len() != 9 {
        let (density, correlation) = (density.len(), correlation.len());
        return Err(refused(format!(
            "grains: density has {density} and correlation {correlation} numbers; allowed: {} and 9",
            3 * count
        )));
    }
    let densities = [0, 1, 2].map(|i| density[i * count..(i + 1) * count].to_vec());
    let rows = [0, 1, 2].map(|i| [0, 1, 2].map(|j| correlation[3 * i + j]));
    GrainSpectrum::new(cycles_per_mm, densities, rows).map_err(refused)
}

fn field(object: &JsValue, key: &str) -> Result<JsValue, JsError> {
    Reflect::get(object, &key.into()).map_err(|_| refused(format!("{key}: there is no object")))
}

/// The entries of a list; none where it is left out.
fn list(object: &JsValue, key: &str) -> Result<Array, JsError> {
    let value = field(object, key)?;
    if value.is_undefined() {
        return Ok(Array::new());
    }
    value.dyn_into().map_err(|_| refused(format!("{key} is not an array")))
}

fn text(value: &JsValue, what: &str) -> Result<String, JsError> {
    value.as_string().ok_or_else(|| refused(format!("{what} is not a string")))
}

fn doubles(value: &JsValue, what: &str) -> Result<Vec<f64>, JsError> {
    let array = value.dyn_ref().map(Float64Array::to_vec);
    array.ok_or_else(|| refused(format!("{what} is not a Float64Array")))
}

fn whole(value: &JsValue, what: &str) -> Result<usize, JsError> {
    match value.as_f64() {
        Some(number) if number >= 0.0 && number < f64::from(u32::MAX) && number.fract() == 0.0 => {
            Ok(number as usize)
        }
        _ => Err(refused(format!("{what} is not a whole number from 0"))),
    }
}
