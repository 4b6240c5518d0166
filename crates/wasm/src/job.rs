//! The binding of the render room's job: a recipe in JSON in, rows of light out.

use js_sys::{Array, Float64Array, Object};
use nacreous_image::{CHANNELS, Development, Progress};
use nacreous_render::{
    Asked, Shared, View,
    spec::{Recipe, pearl::PearlSpec},
    stack_of,
};
use wasm_bindgen::{Clamped, prelude::*};

use crate::{
    pearl::{grown, spectra_of},
    picture::object,
    refused,
    resources::resources_of,
};

#[wasm_bindgen(typescript_custom_section)]
const SIGHT: &str = r"/** What a line of sight meets. */
export interface Sight {
  /** The pearl's number among those of the recipe. */
  readonly pearl: number;
  /** The angle between the surface's normal, relief left out, and the line of sight. */
  readonly viewRad: number;
}";

#[wasm_bindgen(typescript_custom_section)]
const SHARING: &str = r#"/** Work before the pixels that workers share out. */
export type Shared = "films" | "reflections";"#;

/// A picture in the making, kept and asked again: only what changed is worked out anew.
#[wasm_bindgen]
pub struct Job {
    made: nacreous_render::Job,
    resources: nacreous_render::Resources,
    view: Option<View>,
}

#[wasm_bindgen]
impl Job {
    /// Takes a complete recipe, and the contents of the files that it names.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "RecipeJson")] recipe: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "Resources")] resources: JsValue,
    ) -> Result<Self, JsError> {
        let recipe = Recipe::from_json(recipe).map_err(refused)?;
        let resources = resources_of(&resources)?;
        let made = nacreous_render::Job::new(recipe, resources.clone()).map_err(refused)?;
        Ok(Self { made, resources, view: None })
    }

    /// Puts another recipe in the place of this one; what both have in common stays known. Without
    /// resources, those handed over before stay. A refused change leaves the job as it was.
    pub fn change(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "RecipeJson")] recipe: &str,
        #[wasm_bindgen(unchecked_optional_param_type = "Resources")] resources: JsValue,
    ) -> Result<(), JsError> {
        let recipe = Recipe::from_json(recipe).map_err(refused)?;
        let resources = if resources.is_undefined() {
            self.resources.clone()
        } else {
            resources_of(&resources)?
        };
        self.made.change(recipe, resources.clone()).map_err(refused)?;
        (self.resources, self.view) = (resources, None);
        Ok(())
    }

    /// Works out one more piece of what comes before the pixels; whether all of it is there. A worker looks
    /// at its messages between two pieces. Nobody has to call it: rows work out what is missing.
    pub fn step(&mut self) -> Result<bool, JsError> {
        if self.view.is_none() {
            self.view = self.made.step(&Progress::default()).map_err(refused)?;
        }
        Ok(self.view.is_some())
    }

    /// What can be shared out among workers, each with a job of the same recipe, and this one lacks first; undefined where
    /// it lacks nothing. The first that any of them lacks, "films" before "reflections", is what all work on.
    #[wasm_bindgen(unchecked_return_type = "Shared | undefined")]
    pub fn lacks(&mut self) -> Result<Option<String>, JsError> {
        let lacked = self.made.lacks().map_err(refused)?;
        Ok(lacked.map(|shared| name_of(shared).to_owned()))
    }

    /// Part `part` of `parts` of that work.
    pub fn part(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Shared")] shared: &str,
        part: usize,
        parts: usize,
    ) -> Result<Vec<f64>, JsError> {
        if !(1..=MOST_PARTS).contains(&parts) || part >= parts {
            let message =
                format!("part {part} of {parts}; allowed: 0 to below parts, of 1 to {MOST_PARTS}");
            return Err(refused(message));
        }
        self.made.part(shared_of(shared)?, (part, parts)).map_err(refused)
    }

    /// Takes over what `part` gave of all parts of the same work, in their order.
    pub fn join(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Shared")] shared: &str,
        parts: Vec<Float64Array>,
    ) -> Result<(), JsError> {
        let parts: Vec<Vec<f64>> = parts.iter().map(Float64Array::to_vec).collect();
        let parts: Vec<&[f64]> = parts.iter().map(Vec::as_slice).collect();
        self.made.join(shared_of(shared)?, &parts).map_err(refused)
    }

    /// A first picture, as codes RGBA row by row, in a few hundredths of a second: colours looked up where rows work them out.
    #[wasm_bindgen(unchecked_return_type = "Uint8ClampedArray<ArrayBuffer>")]
    pub fn preview(
        &mut self,
        #[wasm_bindgen(js_name = sizePx)] size_px: usize,
        #[wasm_bindgen(unchecked_param_type = "Space")] space: &str,
        #[wasm_bindgen(unchecked_param_type = "GamutHandling")] gamut: &str,
    ) -> Result<Clamped<Vec<u8>>, JsError> {
        let (space, gamut) = (space.parse().map_err(refused)?, gamut.parse().map_err(refused)?);
        let development = Development { exposure: 1.0, space, gamut };
        let asked = Asked { size_px, development };
        let codes = self.made.preview(&asked, &Progress::default()).map_err(refused)?;
        Ok(Clamped(codes.ok_or_else(broken_off)?))
    }

    /// Light of some rows from the top, before the look: 17 numbers a pixel, named by `layers`. Rows beyond
    /// the last are left out.
    pub fn rows(&mut self, first: usize, end: usize) -> Result<Vec<f32>, JsError> {
        let size_px = self.size();
        let rows = end.min(size_px).saturating_sub(first);
        if rows * size_px > MOST_PIXELS {
            let message = format!(
                "rows {first} to {end} have {} pixels; allowed: up to {MOST_PIXELS}",
                rows * size_px
            );
            return Err(refused(message));
        }
        self.view()?.rows(first..end, &Progress::default()).ok_or_else(broken_off)
    }

    /// Turns the light of the whole picture into what lens, eye and exposure leave of it, in place.
    pub fn look(&mut self, pixels: &mut [f32]) -> Result<(), JsError> {
        let (whole, given) = (self.size().pow(2) * CHANNELS, pixels.len());
        if given != whole {
            let message = format!("pixels has {given} numbers; allowed: {whole}, all of a picture");
            return Err(refused(message));
        }
        self.view()?.look(pixels);
        Ok(())
    }

    /// The look without glare, which needs the whole picture: of any pixels, in place.
    pub fn expose(&mut self, pixels: &mut [f32]) -> Result<(), JsError> {
        check_pixels(pixels)?;
        self.view()?.expose(pixels);
        Ok(())
    }

    /// Whether lens and eye spread any light: then rows alone do not look as they do in the whole picture.
    #[wasm_bindgen(getter = hasGlare)]
    pub fn has_glare(&self) -> bool {
        self.made.recipe().scene.camera.glare > 0.0
    }

    /// The pearl that is seen in the middle of a pixel; undefined beside all pearls. Nothing else is worked out.
    #[wasm_bindgen(unchecked_return_type = "Sight | undefined")]
    pub fn sight(&mut self, row: usize, column: usize) -> Result<JsValue, JsValue> {
        let Some(sighted) = self.made.sight(row, column) else { return Ok(JsValue::UNDEFINED) };
        let found =
            [("pearl", (sighted.pearl as u32).into()), ("viewRad", sighted.view_rad.into())];
        Ok(object(&found)?.into())
    }

    /// What grew on which day of one of the recipe's pearls, as `grow` has it.
    #[wasm_bindgen(unchecked_return_type = "Growth")]
    pub fn grow(&self, pearl: usize) -> Result<Object, JsValue> {
        grown(self.pearl(pearl)?.common().nacre)
    }

    /// The thickness of each aragonite layer of one of the recipe's pearls in nm, the surface first.
    #[wasm_bindgen(js_name = thicknessNm)]
    pub fn thickness_nm(&self, pearl: usize) -> Result<Vec<f64>, JsError> {
        let stack = stack_of(self.pearl(pearl)?.common().nacre).map_err(refused)?;
        Ok(stack.thickness_nm().to_vec())
    }

    /// R and T of the film of one of the recipe's pearls, as `filmSpectra` has them.
    #[wasm_bindgen(js_name = filmSpectra, unchecked_return_type = "[Float64Array, Float64Array]")]
    pub fn film_spectra(
        &self,
        pearl: usize,
        angle_rad: &[f64],
        wavelength_nm: &[f64],
    ) -> Result<Array, JsError> {
        spectra_of(self.pearl(pearl)?, angle_rad, wavelength_nm)
    }

    /// Millimetres in a pixel, on the plane through the scene's middle.
    #[wasm_bindgen(getter = mmPerPixel)]
    pub fn mm_per_pixel(&self) -> f64 {
        self.made.mm_per_pixel()
    }

    /// Pixels a side.
    #[wasm_bindgen(getter)]
    pub fn size(&self) -> usize {
        self.made.recipe().size
    }

    fn pearl(&self, number: usize) -> Result<&PearlSpec, JsError> {
        let pearls = &self.made.recipe().pearls;
        let last = pearls.len() - 1;
        let message = || refused(format!("pearl is {number}; allowed: 0 to {last}"));
        pearls.get(number).ok_or_else(message)
    }

    fn view(&mut self) -> Result<&View, JsError> {
        if self.view.is_none() {
            self.view = self.made.view(&Progress::default()).map_err(refused)?;
        }
        self.view.as_ref().ok_or_else(broken_off)
    }
}

/// Holds the number of channels against whole pixels.
pub fn check_pixels(pixels: &[f32]) -> Result<(), JsError> {
    if pixels.len().is_multiple_of(CHANNELS) {
        return Ok(());
    }
    let given = pixels.len();
    Err(refused(format!("pixels has {given} numbers; allowed: a multiple of {CHANNELS}")))
}

fn broken_off() -> JsError {
    refused("the picture broke off; please report this")
}

const SHARED: [(&str, Shared); 2] =
    [("films", Shared::Films), ("reflections", Shared::Reflections)];

fn name_of(shared: Shared) -> &'static str {
    SHARED.iter().find(|(_, one)| *one == shared).map_or("films", |(name, _)| name)
}

fn shared_of(name: &str) -> Result<Shared, JsError> {
    let found = SHARED.iter().find(|(known, _)| *known == name).map(|(_, shared)| *shared);
    found.ok_or_else(|| refused(format!("shared is {name}; allowed: films, reflections")))
}

/// Workers of a page.
const MOST_PARTS: usize = 64;

/// What the memory of a page holds at once: a GB. More than there is ends the program.
const MOST_PIXELS: usize = 1 << 24;
