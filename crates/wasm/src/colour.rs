//! The binding of the colour room: chromaticities, and codes for colours that were measured.

use nacreous_colour::{Observer, RgbSpace, xy_from_xyz, xyz_from_lab};
use nacreous_image::screen;
use wasm_bindgen::{Clamped, prelude::*};

use crate::refused;

/// The spectral locus of the CIE 1931 observer: x, y by 1 nm from 380 to 780 nm, flat.
#[wasm_bindgen(js_name = spectralLocus)]
pub fn spectral_locus() -> Vec<f64> {
    let [x, y, z] = Observer::Cie1931.matching_functions();
    (0..x.len()).flat_map(|i| xy_from_xyz([x[i], y[i], z[i]])).collect()
}

/// x, y of a space's red, green, blue and white, flat.
#[wasm_bindgen(js_name = primariesOf)]
pub fn primaries_of(
    #[wasm_bindgen(unchecked_param_type = "Space")] space: &str,
) -> Result<Vec<f64>, JsError> {
    let space: RgbSpace = space.parse().map_err(refused)?;
    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]];
    Ok(corners.into_iter().flat_map(|rgb| xy_from_xyz(space.xyz_from_rgb(rgb))).collect())
}

/// x, y of each pixel of linear light in the primaries of sRGB, flat; NaN of black.
#[wasm_bindgen]
pub fn chromaticities(light: &[f32]) -> Vec<f32> {
    let xy = |rgb: &[f32]| {
        let rgb = [0, 1, 2].map(|i| f64::from(rgb[i]));
        xy_from_xyz(RgbSpace::Srgb.xyz_from_rgb(rgb)).map(|value| value as f32)
    };
    light.chunks_exact(3).flat_map(xy).collect()
}

/// Codes RGBA of colours in CIELAB relative to the screen's white, three numbers each.
#[wasm_bindgen(js_name = codesOfLab, unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
pub fn codes_of_lab(
    lab: &[f64],
    #[wasm_bindgen(unchecked_param_type = "Space")] space: &str,
    #[wasm_bindgen(unchecked_param_type = "GamutHandling")] gamut: &str,
) -> Result<Clamped<Vec<u8>>, JsError> {
    let (space, gamut) = (space.parse().map_err(refused)?, gamut.parse().map_err(refused)?);
    let srgb = RgbSpace::Srgb;
    let light = |i: usize| {
        let lab = [0, 1, 2].map(|channel| lab[3 * i + channel]);
        srgb.rgb_from_xyz(xyz_from_lab(lab, srgb.white_xyz()))
    };
    Ok(Clamped(screen(lab.len() / 3, light, space, gamut).codes))
}
