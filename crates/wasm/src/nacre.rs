//! The bindings of nacre.

use js_sys::Float64Array;
use nacreous_nacre::{Index, LayerStack, Medium};
use nacreous_render::{spec::nacre::NacreSpec, stack_of};
use wasm_bindgen::prelude::*;

use crate::refused;

#[wasm_bindgen(typescript_custom_section)]
const MEDIUM: &str = "/** A name, a number n, or [n, k] or [n_o, k_o, n_e, k_e]. */
export type Medium = string | number | Float64Array;";

/// Aragonite layers from the surface inward, each followed by a protein layer, then the substrate.
#[wasm_bindgen]
pub struct Stack(pub(crate) LayerStack);

#[wasm_bindgen]
impl Stack {
    /// Thicknesses in nm, surface first; 1 to 5000 aragonite layers.
    #[wasm_bindgen(constructor)]
    pub fn new(
        thickness_nm: Vec<f64>,
        protein_nm: f64,
        #[wasm_bindgen(unchecked_param_type = "Medium")] aragonite: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Medium")] protein: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Medium")] ambient: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Medium")] substrate: JsValue,
    ) -> Result<Self, JsError> {
        LayerStack::new(
            thickness_nm,
            protein_nm,
            medium("aragonite", &aragonite)?,
            medium("protein", &protein)?,
            medium("ambient", &ambient)?,
            medium("substrate", &substrate)?,
        )
        .map(Self)
        .map_err(refused)
    }
}

#[wasm_bindgen]
impl Stack {
    /// The layers of a pearl, by the `nacre` of a recipe in JSON.
    #[wasm_bindgen(js_name = ofNacre)]
    pub fn of_nacre(
        #[wasm_bindgen(unchecked_param_type = "NacreJson")] nacre: &str,
    ) -> Result<Self, JsError> {
        let nacre = NacreSpec::from_json(nacre).map_err(refused)?;
        stack_of(&nacre).map(Self).map_err(refused)
    }

    /// Thickness of each aragonite layer in nm, the surface first.
    #[wasm_bindgen(getter = thicknessNm)]
    pub fn thickness_nm(&self) -> Vec<f64> {
        self.0.thickness_nm().to_vec()
    }
}

fn medium(quantity: &str, given: &JsValue) -> Result<Medium, JsError> {
    let index = |n: f64, k: f64| Index::new(quantity, n, k).map_err(refused);
    if let Some(name) = given.as_string() {
        return Medium::named(&name).ok_or_else(|| {
            let (name, names) = (name.chars().take(40).collect::<String>(), Medium::NAMES);
            refused(format!("{quantity} is '{name}'; allowed: {}", names.join(", ")))
        });
    }
    if let Some(n) = given.as_f64() {
        return Ok(index(n, 0.0)?.into());
    }
    match given.dyn_ref::<Float64Array>().map(Float64Array::to_vec).as_deref() {
        Some(&[n, k]) => Ok(index(n, k)?.into()),
        Some(&[n_o, k_o, n_e, k_e]) => Ok(Medium::uniaxial(index(n_o, k_o)?, index(n_e, k_e)?)),
        _ => Err(refused(format!(
            "{quantity} is not a medium; allowed: a name, a number, a Float64Array of 2 or 4"
        ))),
    }
}
