//! Second stage: the light around the pearls, what they make of it, and what of that comes back.

use std::sync::Arc;

use nacreous_image::{
    Glow, IlluminantPearl, Irradiance, Lit, Model, Progress, Surroundings, Table, Transport, Walls,
    parallel,
};

use super::optics::{Optics, microfacets_of};
use crate::{
    arrangement::{Arrangement, Place, Solids},
    lights::Lights,
    spec::{
        pearl::PearlSpec,
        scene::{SceneSpec, TableKind, TableSpec, WallsSpec},
    },
};

/// How often light goes from the pearls to the table and to each other. Once is enough for all but the
/// point where a white pearl touches a white table, which stays 20 % dark.
pub const BOUNCES: usize = 1;

/// What light falls on, and how much of it is looked at.
pub(crate) struct Unlit<'a> {
    pub(crate) pearls: &'a [PearlSpec],
    pub(crate) optics: &'a [Optics],
    pub(crate) arrangement: &'a Arrangement,
    pub(crate) solids: &'a Solids,
    pub(crate) lights: &'a Lights,
    pub(crate) scene: &'a SceneSpec,
    pub(crate) samples_side: usize,
}

/// Pearls and surroundings in all the light that there is.
#[derive(Debug)]
pub(crate) struct LitScene {
    /// What the pearl in each place does with light.
    pub(crate) models: Vec<Arc<Model>>,
    pub(crate) surroundings: Arc<Lit>,
}

impl Unlit<'_> {
    /// Lets the light in: surroundings, pearls, what they send out, and again. `None` once `progress` says
    /// to stop.
    pub(crate) fn lit(&self, progress: &Progress) -> Option<LitScene> {
        let surroundings = self.surroundings();
        // A lone pearl under lamps alone throws one sharp shadow, which costs less than a chart.
        let softly = self.arrangement.places().len() > 1 || !surroundings.windows.is_empty();
        let mut lit = surroundings.settled(softly);
        let mut models = self.models(&lit, progress)?;
        for _ in 0..BOUNCES {
            let glows = glows(&models, &lit, progress);
            let softly = softly || models.iter().any(Model::gives_light);
            lit = lit.with_glows(glows, softly);
            models = self.models(&lit, progress)?;
        }
        let models = models.into_iter().map(Arc::new).collect();
        (!progress.is_stopped()).then(|| LitScene { models, surroundings: Arc::new(lit) })
    }

    /// The light around for a preview, where pearls send out `glows`, each in its place.
    pub(crate) fn roughly_lit(&self, glows: Vec<Glow>) -> Lit {
        self.surroundings().roughly_settled(glows)
    }

    fn surroundings(&self) -> Surroundings {
        let lamps = self.lights.lamps_for(self.pearls.iter().map(microfacets_of));
        let (table, walls) = (table(&self.scene.table), self.scene.walls.as_ref().map(walls));
        let (sky, balls) = (self.lights.sky.clone(), self.arrangement.balls());
        let solid = |place: &Place| self.solids[place.pearl].clone();
        let solids = self.arrangement.places().iter().map(solid).collect();
        Surroundings::new(table, walls, sky, lamps, balls)
            .with_windows(self.lights.windows.clone())
            .with_solids(solids)
    }

    /// What each place's pearl does with the light that there is; `None` once `progress` says to stop, which
    /// for hundreds of pearls need not wait for all of them.
    fn models(&self, lit: &Lit, progress: &Progress) -> Option<Vec<Model>> {
        let places = self.arrangement.places();
        let model = |ball: usize| {
            let model = || self.model(&self.optics[places[ball].pearl], lit, ball);
            (!progress.is_stopped()).then(model)
        };
        parallel::map(places.len(), model).into_iter().collect()
    }

    fn model(&self, optics: &Optics, lit: &Lit, ball: usize) -> Model {
        match optics {
            Optics::Illuminant { rings, look } => Model::Illuminant(Box::new(IlluminantPearl {
                rings: Arc::clone(rings),
                mixing: look.mixing,
                body_colour: look.body_colour,
                irradiance: Irradiance::new(lit, ball),
                facets: look.facets,
                mirror_weight: look.mirror_weight,
                falloff_mm: look.falloff_mm,
            })),
            Optics::Transport { response } => {
                Model::Transport(Box::new(Transport::new(response, lit, ball, self.samples_side)))
            }
        }
    }
}

/// What each pearl sends out; a lone pearl of 1996 lights nothing.
fn glows(models: &[Model], lit: &Lit, progress: &Progress) -> Vec<Glow> {
    let alone = models.len() == 1;
    let glow = |ball: usize| {
        let gives = (models[ball].gives_light() || !alone) && !progress.is_stopped();
        if gives { models[ball].glow(lit, ball) } else { Glow::BLACK }
    };
    parallel::map(models.len(), glow)
}

fn table(spec: &TableSpec) -> Option<Table> {
    let (colour, second_colour) = (spec.colour.0, spec.second_colour.0);
    Some(match spec.kind {
        TableKind::None => return None,
        TableKind::Plain => Table::Plain(colour),
        TableKind::Checker => Table::Checker { colour, second_colour, check_mm: spec.check_mm },
        TableKind::Cloth => Table::Cloth { colour, second_colour, weave_mm: spec.weave_mm },
    })
}

fn walls(spec: &WallsSpec) -> Walls {
    let (half_width_mm, height_mm) = (spec.half_width_mm, spec.height_mm);
    Walls { half_width_mm, height_mm, colour: spec.colour.0 }
}
