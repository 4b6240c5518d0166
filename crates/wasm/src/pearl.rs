//! The binding of a pearl's numbers: how it grew, what its film mirrors, what its knobs come to.

use js_sys::{Array, Float64Array, Object, Uint32Array};
use nacreous_render::{
    diary_of, film_spectra, resolved_of, season_of,
    spec::{nacre::NacreSpec, pearl::PearlSpec},
};
use wasm_bindgen::prelude::*;

use crate::{optics::fits, picture::object, refused};

#[wasm_bindgen(typescript_custom_section)]
const PEARL: &str = r"/**
 * JSON of everything that makes a picture, files apart: `pearls`, `scene`, `size` and `samples`, each key
 * written out, as `nacreous.image.recipe_json` and `nacreous presets --json` have it. Any string will do; the
 * name says which.
 */
export type RecipeJson = string & { readonly holds?: 'recipe' };

/** JSON of one of a recipe's pearls. */
export type PearlJson = string & { readonly holds?: 'pearl' };

/** JSON of the `nacre` of one of a recipe's pearls. */
export type NacreJson = string & { readonly holds?: 'nacre' };

/** The layers of aragonite as they grew, the first the innermost. */
export interface Growth {
  /** Days since seeding. */
  readonly day: Uint32Array;
  readonly thicknessNm: Float64Array;
  /** How summery each layer's day was: 1 at the top of the season, towards 0 in winter. */
  readonly warmth: Float64Array;
}";

/// What grew on which day; listed layers grew on none and are refused.
#[wasm_bindgen(unchecked_return_type = "Growth")]
pub fn grow(
    #[wasm_bindgen(unchecked_param_type = "NacreJson")] nacre: &str,
) -> Result<Object, JsValue> {
    grown(&NacreSpec::from_json(nacre).map_err(refused)?)
}

/// What grew on which day, as JavaScript has it.
pub fn grown(nacre: &NacreSpec) -> Result<Object, JsValue> {
    let NacreSpec::Growth(growth) = nacre else {
        return Err(refused("nacre.thickness_nm lists the layers; allowed here: growth").into());
    };
    let diary = diary_of(growth, growth.seed).map_err(refused)?;
    let (days, thickness_nm): (Vec<u32>, Vec<f64>) =
        diary.deposits().iter().map(|deposit| (deposit.day, deposit.thickness_nm)).unzip();
    let season = season_of(growth).map_err(refused)?;
    let warmth: Vec<f64> = days.iter().map(|&day| season.warmth(f64::from(day))).collect();
    object(&[
        ("warmth", Float64Array::from(warmth.as_slice()).into()),
        ("day", Uint32Array::from(days.as_slice()).into()),
        ("thicknessNm", Float64Array::from(thickness_nm.as_slice()).into()),
    ])
}

/// R and T of the film of a pearl, exact, unpolarised: means over its columns. Tables are
/// `[angle, wavelength]`, flat.
#[wasm_bindgen(
    js_name = filmSpectra,
    unchecked_return_type = "[Float64Array, Float64Array]"
)]
pub fn film_spectra_of(
    #[wasm_bindgen(unchecked_param_type = "PearlJson")] pearl: &str,
    angle_rad: &[f64],
    wavelength_nm: &[f64],
) -> Result<Array, JsError> {
    spectra_of(&PearlSpec::from_json(pearl).map_err(refused)?, angle_rad, wavelength_nm)
}

/// R and T of a pearl's film, as JavaScript has them.
pub fn spectra_of(
    pearl: &PearlSpec,
    angle_rad: &[f64],
    wavelength_nm: &[f64],
) -> Result<Array, JsError> {
    fits(angle_rad, wavelength_nm)?;
    let PearlSpec::Transport(pearl) = pearl else {
        return Err(refused("model is \"illuminant\"; allowed here: \"transport\""));
    };
    let film = film_spectra(pearl, angle_rad, wavelength_nm).map_err(refused)?;
    Ok([film.reflectance(), film.transmittance()].map(Float64Array::from).iter().collect())
}

/// What each key that a pearl leaves open comes to, by the key's path, such as "film.outer_um".
#[wasm_bindgen(js_name = resolvedKeys, unchecked_return_type = "Record<string, number>")]
pub fn resolved_keys(
    #[wasm_bindgen(unchecked_param_type = "PearlJson")] pearl: &str,
) -> Result<Object, JsValue> {
    let pearl = PearlSpec::from_json(pearl).map_err(refused)?;
    let keys = resolved_of(&pearl);
    object(&keys.iter().map(|(key, value)| (*key, (*value).into())).collect::<Vec<_>>())
}
