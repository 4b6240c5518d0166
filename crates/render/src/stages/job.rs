//! A picture in the making, kept and asked again: only what changed is worked out anew.

mod sharing;

use std::{convert::Infallible, sync::Arc};

use nacreous_image::{
    Camera, FilmSampling, MAX_SIZE_PX, Model, Pearl, Progress, Reflections, Sampler, Solid,
};

use super::{
    around::{LitScene, Unlit},
    kept::Kept,
    optics::OpticsStage,
    preview::{GlowKey, PreviewStage},
    seen::{Asked, Before},
    view::{Look, View},
    work::Work,
};
use crate::{
    RenderError, Resources,
    arrangement::{Arrangement, Place, Sighted},
    lights::{Lights, LightsKey},
    pearl::shape::{SolidKey, solid_key},
    spec::{
        Recipe,
        pearl::PearlSpec,
        scene::{TableSpec, WallsSpec},
    },
};

pub use sharing::Shared;

/// The most samples a pixel, 32 x 32.
pub const MAX_SAMPLES: usize = 1024;

/// A recipe and all stages on its way to a picture.
///
/// [`Job::view`] works out what is not known yet; [`Job::change`] puts another recipe in its place, and
/// what both have in common stays known. Files are taken not to change behind their names.
#[derive(Debug)]
pub struct Job {
    recipe: Recipe,
    resources: Resources,
    solids: Kept<SolidKey, Solid>,
    arrangement: Arrangement,
    samples_side: usize,
    lights: Kept<LightsKey, Lights>,
    optics: OpticsStage,
    scene: Kept<SceneKey, LitScene>,
    reflections: Kept<ReflectionsKey, Reflections>,
    preview: PreviewStage,
}

/// What a lit scene is made from.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SceneKey {
    /// Without what only the eye sees.
    pearls: Vec<PearlSpec>,
    places: Vec<Place>,
    lights: LightsKey,
    table: TableSpec,
    walls: Option<WallsSpec>,
    samples_side: usize,
}

/// What the cached reflections of a view are made from.
#[derive(Debug, Clone, PartialEq)]
struct ReflectionsKey {
    scene: SceneKey,
    camera: Camera,
    size_px: usize,
}

impl Job {
    /// Takes a recipe, and the contents of the files that it names.
    ///
    /// # Errors
    /// [`RenderError`] for a size, a number of samples or an arrangement that cannot be.
    pub fn new(recipe: Recipe, resources: Resources) -> Result<Self, RenderError> {
        let mut solids = Kept::default();
        let (arrangement, samples_side) = checked(&recipe, &mut solids)?;
        Ok(Self {
            recipe,
            resources,
            solids,
            arrangement,
            samples_side,
            lights: Kept::default(),
            optics: OpticsStage::new(FilmSampling::WHOLE),
            preview: PreviewStage::default(),
            scene: Kept::default(),
            reflections: Kept::default(),
        })
    }

    /// Puts another recipe in the place of this one.
    ///
    /// # Errors
    /// As [`Job::new`]; then the job is as it was.
    pub fn change(&mut self, recipe: Recipe, resources: Resources) -> Result<(), RenderError> {
        (self.arrangement, self.samples_side) = checked(&recipe, &mut self.solids)?;
        (self.recipe, self.resources) = (recipe, resources);
        Ok(())
    }

    /// The recipe as it is now.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// The pearl that is seen in the middle of a pixel, if any; nothing of it is worked out.
    pub fn sight(&mut self, row: usize, column: usize) -> Option<Sighted> {
        let solids = solids_of(&self.recipe.pearls, &mut self.solids);
        let place = |at: usize| 2.0 * (at as f64 + 0.5) / self.recipe.size as f64 - 1.0;
        self.arrangement.sight((place(column), -place(row)), &solids)
    }

    /// Millimetres in a pixel, on the plane through the scene's middle.
    pub fn mm_per_pixel(&self) -> f64 {
        self.arrangement.field_mm() / self.recipe.size as f64
    }

    /// The scene before the camera; `None` once `progress` says to stop.
    ///
    /// # Errors
    /// [`RenderError`] for layers, lights or grains that cannot be.
    pub fn view(&mut self, progress: &Progress) -> Result<Option<View>, RenderError> {
        self.viewed(&Work::whole(progress))
    }

    /// Works out one more piece of the way to the view: the film of one pearl, its response to light, its
    /// grain, the light around all pearls, or what they mirror. The view once nothing is missing; `None`
    /// before, so that whoever calls can look at something else between two pieces.
    ///
    /// # Errors
    /// As [`Job::view`].
    pub fn step(&mut self, progress: &Progress) -> Result<Option<View>, RenderError> {
        self.viewed(&Work::one_piece(progress))
    }

    /// A first picture, as codes RGBA row by row: colours looked up where [`Job::view`] works them out, tens of times as
    /// fast. What lies between changes of the recipe is kept, apart from what the view needs; light that the pearls send
    /// out is taken as it last was, while they and the table stay. `None` once `progress` says to stop.
    ///
    /// # Errors
    /// As [`Job::view`], and [`RenderError`] for a size beyond [`MAX_SIZE_PX`].
    pub fn preview(
        &mut self,
        asked: &Asked,
        progress: &Progress,
    ) -> Result<Option<Vec<u8>>, RenderError> {
        check_size(asked.size_px)?;
        let work = Work::whole(progress);
        let (recipe, arrangement) = (&self.recipe, &self.arrangement);
        let lights_key = LightsKey::new(&recipe.scene, arrangement);
        let make =
            |_: &LightsKey| Lights::new(&recipe.scene, arrangement, &self.resources).map(Some);
        let Some(lights) = self.lights.one(lights_key.clone(), make)? else { return Ok(None) };
        let pixel_mm = arrangement.pixel_mm(recipe.size);
        let skins = self.optics.skins(&recipe.pearls, &self.resources, pixel_mm, &work)?;
        let Some(skins) = skins else { return Ok(None) };
        let before = Before {
            recipe,
            arrangement,
            solids: &solids_of(&recipe.pearls, &mut self.solids),
            lights: (&lights_key, &lights),
            skins: &skins,
        };
        self.preview.preview(&before, asked, &work)
    }

    /// The scene before the camera; `None` where `work` ends before.
    fn viewed(&mut self, work: &Work<'_>) -> Result<Option<View>, RenderError> {
        let Some((scene_key, scene)) = self.lit_scene(work)? else { return Ok(None) };
        let Some(pearls) = self.pearls(&scene, work)? else { return Ok(None) };
        let (camera, size_px) = (self.arrangement.camera(), self.recipe.size);
        let key = ReflectionsKey { scene: scene_key, camera, size_px };
        let make = |_: &ReflectionsKey| {
            work.piece(|progress| {
                let reflections =
                    Reflections::new(&scene.models, &scene.surroundings, &camera, size_px);
                Ok::<_, RenderError>((!progress.is_stopped()).then_some(reflections))
            })
        };
        let Some(reflections) = self.reflections.one(key, make)? else { return Ok(None) };
        let surroundings = Arc::clone(&scene.surroundings);
        let counts = (size_px, self.samples_side);
        let sampler = Sampler::new(pearls, surroundings, camera, counts, reflections)
            .exposed(self.recipe.scene.camera.exposure);
        let look = Look::new(&self.recipe.scene, self.arrangement.field_mm(), size_px);
        Ok(Some(View::new(Arc::new(sampler), look, size_px)))
    }

    /// First and second stage.
    fn lit_scene(
        &mut self,
        work: &Work<'_>,
    ) -> Result<Option<(SceneKey, Arc<LitScene>)>, RenderError> {
        let (recipe, arrangement) = (&self.recipe, &self.arrangement);
        let lights_key = LightsKey::new(&recipe.scene, arrangement);
        let make =
            |_: &LightsKey| Lights::new(&recipe.scene, arrangement, &self.resources).map(Some);
        let Some(lights) = self.lights.one(lights_key.clone(), make)? else { return Ok(None) };
        let known = (&lights_key, &*lights);
        let Some(optics) = self.optics.optics(&recipe.pearls, known, work)? else {
            return Ok(None);
        };
        let unlit = Unlit {
            pearls: &recipe.pearls,
            optics: &optics,
            arrangement,
            solids: &solids_of(&recipe.pearls, &mut self.solids),
            lights: &lights,
            scene: &recipe.scene,
            samples_side: self.samples_side,
        };
        let key = SceneKey::new(recipe, arrangement, lights_key, self.samples_side);
        let make = |_: &SceneKey| work.piece(|progress| Ok::<_, RenderError>(unlit.lit(progress)));
        let Some(scene) = self.scene.one(key.clone(), make)? else { return Ok(None) };
        self.preview.learn(GlowKey::new(recipe, arrangement), &scene.surroundings.glows());
        Ok(Some((key, scene)))
    }

    /// The pearls in their places, with their grain; `None` where `work` ends before.
    fn pearls(
        &mut self,
        scene: &LitScene,
        work: &Work<'_>,
    ) -> Result<Option<Vec<Pearl>>, RenderError> {
        let pixel_mm = self.arrangement.pixel_mm(self.recipe.size);
        let skins = self.optics.skins(&self.recipe.pearls, &self.resources, pixel_mm, work)?;
        let Some(skins) = skins else { return Ok(None) };
        let pearl = |(model, place): (&Arc<Model>, &Place)| Pearl {
            model: Arc::clone(model),
            skin: skins[place.pearl].clone(),
        };
        Ok(Some(scene.models.iter().zip(self.arrangement.places()).map(pearl).collect()))
    }
}

impl SceneKey {
    pub(super) fn new(
        recipe: &Recipe,
        arrangement: &Arrangement,
        lights: LightsKey,
        samples_side: usize,
    ) -> Self {
        Self {
            pearls: recipe.pearls.iter().map(PearlSpec::without_grain).collect(),
            places: arrangement.places().to_vec(),
            lights,
            table: recipe.scene.table.clone(),
            walls: recipe.scene.walls.clone(),
            samples_side,
        }
    }
}

/// The arrangement of a recipe, and how many samples stand along a pixel's side.
fn checked(
    recipe: &Recipe,
    solids: &mut Kept<SolidKey, Solid>,
) -> Result<(Arrangement, usize), RenderError> {
    check_size(recipe.size)?;
    let samples_side = recipe.samples.isqrt();
    if !(1..=MAX_SAMPLES).contains(&recipe.samples) || samples_side.pow(2) != recipe.samples {
        let allowed = format!("a square number from 1 to {MAX_SAMPLES}, such as 16");
        return Err(RenderError::out_of_range("samples", recipe.samples, allowed));
    }
    Ok((Arrangement::of_forms(recipe, &solids_of(&recipe.pearls, solids))?, samples_side))
}

fn check_size(size_px: usize) -> Result<(), RenderError> {
    if (1..=MAX_SIZE_PX).contains(&size_px) {
        return Ok(());
    }
    let allowed = format!("a whole number from 1 to {MAX_SIZE_PX}");
    Err(RenderError::out_of_range("size", size_px, allowed))
}

/// The forms of pearls that are not round.
fn solids_of(pearls: &[PearlSpec], solids: &mut Kept<SolidKey, Solid>) -> Vec<Option<Arc<Solid>>> {
    let keys: Vec<Option<SolidKey>> = pearls.iter().map(solid_key).collect();
    let make = |key: &SolidKey| Ok::<_, Infallible>(Some(key.solid()));
    let Ok(made) = solids.all(keys.iter().flatten().cloned().collect(), make);
    let mut made = made.unwrap_or_default().into_iter();
    keys.iter().map(|key| key.as_ref().and_then(|_| made.next())).collect()
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;

    fn recipe(changes: &[(&str, Value)]) -> Recipe {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/recipes");
        let path = format!("{folder}/akoya-rg-north-window-white.json");
        let text = std::fs::read_to_string(path).expect("a golden recipe");
        let mut value: Value = serde_json::from_str(&text).expect("JSON");
        let thin = [("/pearls/0/film/columns", json!(2)), ("/pearls/0/film/outer_um", json!(2.0))];
        for (place, new) in thin.iter().chain(changes) {
            *value.pointer_mut(place).expect("a key") = new.clone();
        }
        Recipe::from_json(&value.to_string()).expect("a recipe")
    }

    /// Whether the light around, and the reflections that the eye sees, are kept through a change.
    fn kept(changes: &[(&str, Value)]) -> (bool, bool) {
        let progress = Progress::default();
        let mut job = Job::new(recipe(&[]), Resources::default()).unwrap();
        let look = |job: &mut Job| {
            job.view(&progress).unwrap();
            let (scene_key, scene) = job.lit_scene(&Work::whole(&progress)).unwrap().unwrap();
            let make = |_: &ReflectionsKey| Err("made anew");
            let (camera, size_px) = (job.arrangement.camera(), job.recipe.size);
            let key = ReflectionsKey { scene: scene_key, camera, size_px };
            (scene, job.reflections.one(key, make).unwrap().unwrap())
        };
        let before = look(&mut job);
        job.change(recipe(changes), Resources::default()).unwrap();
        let after = look(&mut job);
        (Arc::ptr_eq(&before.0, &after.0), Arc::ptr_eq(&before.1, &after.1))
    }

    #[test]
    fn what_only_the_eye_sees_relights_nothing() {
        for change in [
            ("/scene/camera/exposure", json!(0.5)),
            ("/scene/camera/glare", json!(0.1)),
            ("/pearls/0/grain", json!(0.9)),
            ("/pearls/0/texture/seed", json!(5)),
            ("/scene/name", json!("other")),
        ] {
            assert!(kept(std::slice::from_ref(&change)).0, "{change:?}");
        }
        assert_eq!(kept(&[("/scene/camera/azimuth_deg", json!(9.0))]), (true, false));
        assert_eq!(kept(&[("/size", json!(32))]), (true, false));
    }

    #[test]
    fn the_sine_of_the_view_angle_is_the_distance_from_the_middle() {
        let mut job = Job::new(recipe(&[("/size", json!(101))]), Resources::default()).unwrap();
        let (mm, middle) = (job.mm_per_pixel(), 50);
        for aside in [0, 10, 25] {
            let sighted = job.sight(middle, middle + aside).expect("the pearl");
            let radius_mm = 0.5 * job.recipe().pearls[0].common().diameter_mm;
            let sine = aside as f64 * mm / radius_mm;
            assert!((libm::sin(sighted.view_rad) - sine).abs() < 0.05 * sine + 1e-9, "{aside}");
        }
        assert_eq!(job.sight(0, 0), None);
    }

    #[test]
    fn what_sends_other_light_relights_all() {
        for change in [
            ("/pearls/0/depth", json!(0.2)),
            ("/pearls/0/body/pigment", json!("gold")),
            ("/scene/windows/0/luminance", json!(3.0)),
            ("/scene/table/colour", json!("#ff0000")),
        ] {
            assert_eq!(kept(std::slice::from_ref(&change)), (false, false), "{change:?}");
        }
    }
}
