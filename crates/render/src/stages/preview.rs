//! The first picture after a change, from what is kept and tables of a quickly asked film.
//!
//! Its stages: the light around, what lobes see of it through a net, the points under the pixels, what each pixel looks at
//! there, and the film's colours on it.
//! Each is kept until what it is made from changes; light that pearls send out, while pearls and table stay. Pearls of the
//! model of 1996 have no such tables: one sample a pixel of a smaller picture shows them.

use std::{convert::Infallible, sync::Arc};

use nacreous_image::{
    Development, Dyes, FilmSampling, Glow, Lit, Model, Painted, Pearl, Progress, Reflections,
    Response, Sampler, Subsurface, develop, eight_bit, paint,
};

use super::{
    around::{LitScene, Unlit},
    job::SceneKey,
    kept::{Kept, Same},
    optics::{Optics, OpticsStage},
    seen::{Asked, Before, SMALL_PX, Seen},
    sized::Sized,
    view::light_of,
    work::Work,
};
use crate::{
    RenderError,
    arrangement::{Arrangement, Place},
    lights::LightsKey,
    spec::{
        Recipe,
        scene::{TableSpec, WallsSpec},
    },
};

/// What previews keep.
#[derive(Debug)]
pub(crate) struct PreviewStage {
    optics: OpticsStage,
    glows: Kept<GlowKey, Vec<Glow>>,
    lit: Kept<LitKey, Lit>,
    dyes: Kept<Same<Response>, Dyes>,
    inside: Kept<InsideKey, Subsurface>,
    /// Of small previews, and of large ones: whoever turns knobs goes from one to the other.
    sized: [Sized; 2],
    /// For pearls that no table shows.
    scene: Kept<SceneKey, LitScene>,
}

/// Where light that pearls sent out before stands for what they send out now.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct GlowKey {
    places: Vec<Place>,
    table: TableSpec,
    walls: Option<WallsSpec>,
}

impl GlowKey {
    pub(super) fn new(recipe: &Recipe, arrangement: &Arrangement) -> Self {
        let (table, walls) = (recipe.scene.table.clone(), recipe.scene.walls.clone());
        Self { places: arrangement.places().to_vec(), table, walls }
    }
}

/// What the light around is made from.
#[derive(Debug, Clone, PartialEq)]
struct LitKey {
    glows: Same<Vec<Glow>>,
    lights: LightsKey,
}

/// Light inside one pearl is made from.
#[derive(Debug, Clone, PartialEq)]
struct InsideKey {
    response: Same<Response>,
    lit: Same<Lit>,
    ball: usize,
}

impl Default for PreviewStage {
    fn default() -> Self {
        Self {
            optics: OpticsStage::new(FilmSampling::QUICK),
            glows: Kept::default(),
            lit: Kept::default(),
            dyes: Kept::default(),
            inside: Kept::default(),
            sized: [Sized::default(), Sized::default()],
            scene: Kept::default(),
        }
    }
}

impl PreviewStage {
    /// The codes; `None` where `work` ends before.
    pub(crate) fn preview(
        &mut self,
        before: &Before<'_>,
        asked: &Asked,
        work: &Work<'_>,
    ) -> Result<Option<Vec<u8>>, RenderError> {
        let optics = self.optics.optics(&before.recipe.pearls, before.lights, work)?;
        let Some(optics) = optics else { return Ok(None) };
        let response = |optics: &Optics| match optics {
            Optics::Transport { response } => Some(Arc::clone(response)),
            Optics::Illuminant { .. } => None,
        };
        match optics.iter().map(response).collect::<Option<Vec<_>>>() {
            Some(responses) => self.painted(before, (&optics, &responses), asked, work),
            None => self.sampled(before, &optics, asked, work),
        }
    }

    /// By tables.
    fn painted(
        &mut self,
        before: &Before<'_>,
        (optics, responses): (&[Optics], &[Arc<Response>]),
        asked: &Asked,
        work: &Work<'_>,
    ) -> Result<Option<Vec<u8>>, RenderError> {
        let Some(lit) = self.lit(before, optics, work)? else { return Ok(None) };
        let seen = Seen { before, responses, lit: &lit, asked };
        let Some(inside) = self.inside(&seen) else { return Ok(None) };
        let sized = &mut self.sized[usize::from(asked.size_px > SMALL_PX)];
        let Some(glimpses) = sized.glimpses(&seen) else { return Ok(None) };
        let Some(canvas) = sized.canvas(&seen, &glimpses) else { return Ok(None) };
        let Some(backdrop) = sized.backdrop(&seen) else { return Ok(None) };
        let Some(veils) = sized.veils(&seen, &glimpses, &inside) else { return Ok(None) };
        let dyes = |key: &Same<Response>| Ok::<_, Infallible>(Some(Dyes::new(&key.0)));
        let Ok(dyes) = self.dyes.all(seen.balls().map(|ball| seen.response(ball)).collect(), dyes);
        let Some(dyes) = dyes else { return Ok(None) };
        let painted = |ball: usize| {
            let skin = &before.skins[before.arrangement.places()[ball].pearl];
            let grain = skin.texture.as_ref().map(|_| skin.grain);
            Painted { dyes: &dyes[ball], veil: &veils[ball], grain }
        };
        let pearls: Vec<Painted<'_>> = seen.balls().map(painted).collect();
        let mut development = asked.development;
        development.exposure *= before.recipe.scene.camera.exposure;
        Ok(Some(paint((&canvas, &backdrop), &pearls, &development)))
    }

    /// By one sample a pixel of a smaller picture, enlarged.
    fn sampled(
        &mut self,
        before: &Before<'_>,
        optics: &[Optics],
        asked: &Asked,
        work: &Work<'_>,
    ) -> Result<Option<Vec<u8>>, RenderError> {
        let (recipe, arrangement) = (before.recipe, before.arrangement);
        let unlit = unlit(before, optics);
        let key = SceneKey::new(recipe, arrangement, before.lights.0.clone(), SAMPLES_SIDE);
        let make = |_: &SceneKey| work.piece(|progress| Ok::<_, RenderError>(unlit.lit(progress)));
        let Some(scene) = self.scene.one(key, make)? else { return Ok(None) };
        let pearl = |(model, place): (&Arc<Model>, &Place)| Pearl {
            model: Arc::clone(model),
            skin: before.skins[place.pearl].clone(),
        };
        let pearls: Vec<Pearl> = scene.models.iter().zip(arrangement.places()).map(pearl).collect();
        let is_small = asked.size_px <= SMALL_PX;
        let size_px = if is_small { asked.size_px } else { asked.size_px.div_ceil(COARSER) };
        let reflections = Arc::new(Reflections::none(pearls.len()));
        let surroundings = Arc::clone(&scene.surroundings);
        let camera = arrangement.camera();
        let counts = (size_px, SAMPLES_SIDE);
        let exposure = recipe.scene.camera.exposure;
        let sampler =
            Sampler::new(pearls, surroundings, camera, counts, reflections).exposed(exposure);
        let seen = |progress: &Progress| Ok::<_, RenderError>(sampler.rows(0..size_px, progress));
        let Some(pixels) = work.piece(seen)? else { return Ok(None) };
        let Development { exposure: factor, space, gamut } = asked.development;
        let factor = (exposure * factor) as f32;
        let light: Vec<f32> = light_of(&pixels).into_iter().map(|part| part * factor).collect();
        let codes = eight_bit(&develop(&light, space, gamut).codes);
        Ok(Some(enlarged(&codes, size_px, asked.size_px)))
    }

    /// Takes over what the pearls of a view send out, where that is not what is known already.
    pub(super) fn learn(&mut self, key: GlowKey, glows: &[Glow]) {
        let make = |_: &GlowKey| Ok::<_, Infallible>(Some(glows.to_vec()));
        let Ok(known) = self.glows.one(key.clone(), make);
        let are_near = known.is_some_and(|known| {
            known.len() == glows.len() && known.iter().zip(glows).all(|(a, b)| a.is_near(b, NEAR))
        });
        if !are_near {
            self.glows = Kept::default();
            let Ok(_) = self.glows.one(key, make);
        }
    }

    /// The light around, with what the pearls last sent out while places, table and walls are the same.
    fn lit(
        &mut self,
        before: &Before<'_>,
        optics: &[Optics],
        work: &Work<'_>,
    ) -> Result<Option<Arc<Lit>>, RenderError> {
        let unlit = unlit(before, optics);
        let key = GlowKey::new(before.recipe, before.arrangement);
        let glows = |_: &GlowKey| {
            work.piece(|progress| {
                let lit = unlit.lit(progress);
                Ok::<_, RenderError>(lit.map(|scene| scene.surroundings.glows()))
            })
        };
        let Some(glows) = self.glows.one(key, glows)? else { return Ok(None) };
        let key = LitKey { glows: Same(Arc::clone(&glows)), lights: before.lights.0.clone() };
        let lit = |_: &LitKey| {
            work.piece(|_| Ok::<_, RenderError>(Some(unlit.roughly_lit(glows.to_vec()))))
        };
        self.lit.one(key, lit)
    }
}

impl PreviewStage {
    /// Light inside each pearl.
    fn inside(&mut self, seen: &Seen<'_>) -> Option<Vec<Arc<Subsurface>>> {
        let key = |ball| {
            let lit = Same(Arc::clone(seen.lit));
            InsideKey { response: seen.response(ball), lit, ball }
        };
        let make = |key: &InsideKey| {
            Ok::<_, Infallible>(Some(Subsurface::of(&key.response.0, &key.lit.0, key.ball)))
        };
        let Ok(made) = self.inside.all(seen.balls().map(key).collect(), make);
        made
    }
}

/// A light that differs by less than this share of white is the same.
const NEAR: f64 = 0.003;
/// Samples along the side of a pixel.
const SAMPLES_SIDE: usize = 1;
/// A large picture without tables has so many times fewer pixels a side.
const COARSER: usize = 2;

fn unlit<'a>(before: &'a Before<'a>, optics: &'a [Optics]) -> Unlit<'a> {
    Unlit {
        pearls: &before.recipe.pearls,
        optics,
        arrangement: before.arrangement,
        solids: before.solids,
        lights: before.lights.1,
        scene: &before.recipe.scene,
        samples_side: SAMPLES_SIDE,
    }
}

/// Codes RGBA of a smaller picture's RGB, each pixel several times.
fn enlarged(codes: &[u8], size_px: usize, to_px: usize) -> Vec<u8> {
    let from = |i: usize| (i * size_px / to_px).min(size_px - 1);
    let pixel = |i: usize| {
        let at = 3 * (from(i / to_px) * size_px + from(i % to_px));
        [codes[at], codes[at + 1], codes[at + 2], u8::MAX]
    };
    (0..to_px * to_px).flat_map(pixel).collect()
}
