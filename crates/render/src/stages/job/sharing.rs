//! Work before the pixels, shared out among jobs of the same recipe in workers without memory in common.
//!
//! Films by groups of columns, what pearls mirror by knots of a net; to the bit what one job works out alone.

use std::sync::Arc;

use nacreous_image::{Progress, Reflections};

use super::{Job, ReflectionsKey};
use crate::{
    RenderError,
    stages::{around::LitScene, work::Work},
};

/// What can be shared out, in the order in which it is needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shared {
    /// The spectra of all films.
    Films,
    /// What the pearls mirror to the camera.
    Reflections,
}

impl Job {
    /// What this job lacks first. Others may lack more, or less, by what they made before: the first that any of them lacks
    /// is what all work on.
    ///
    /// # Errors
    /// As [`Job::view`].
    pub fn lacks(&mut self) -> Result<Option<Shared>, RenderError> {
        if self.optics.lacks_films(&self.recipe.pearls) {
            return Ok(Some(Shared::Films));
        }
        let Some((_, key)) = self.lit()? else { return Ok(None) };
        Ok((!self.reflections.has(&key)).then_some(Shared::Reflections))
    }

    /// Part `part` of `parts`, for the [`Job::join`] of all; of reflections once no job lacks films.
    ///
    /// # Errors
    /// As [`Job::view`].
    pub fn part(
        &mut self,
        shared: Shared,
        (part, parts): (usize, usize),
    ) -> Result<Vec<f64>, RenderError> {
        match shared {
            Shared::Films => self.optics.film_part(&self.recipe.pearls, part, parts),
            Shared::Reflections => {
                let Some((scene, key)) = self.lit()? else { return Ok(Vec::new()) };
                let view = (&key.camera, key.size_px);
                let (models, surroundings) = (&scene.models, &scene.surroundings);
                Ok(Reflections::part(models, surroundings, view, (part, parts)))
            }
        }
    }

    /// Takes over what all parts gave, in their order and this job's own too, unless it is known already.
    ///
    /// # Errors
    /// As [`Job::view`], and [`RenderError`] for parts of other work.
    pub fn join(&mut self, shared: Shared, parts: &[&[f64]]) -> Result<(), RenderError> {
        match shared {
            Shared::Films => self.optics.join_films(&self.recipe.pearls, parts),
            Shared::Reflections => {
                let Some((scene, key)) = self.lit()? else { return Ok(()) };
                let (surroundings, view) = (&scene.surroundings, (&key.camera, key.size_px));
                let joined = Reflections::joined(&scene.models, surroundings, view, parts);
                let joined = joined.ok_or_else(RenderError::parts)?;
                if !self.reflections.has(&key) {
                    self.reflections.put(key, joined);
                }
                Ok(())
            }
        }
    }

    /// The lit scene, and what its reflections are made from.
    fn lit(&mut self) -> Result<Option<(Arc<LitScene>, ReflectionsKey)>, RenderError> {
        let progress = Progress::default();
        let Some((scene_key, scene)) = self.lit_scene(&Work::whole(&progress))? else {
            return Ok(None);
        };
        let (camera, size_px) = (self.arrangement.camera(), self.recipe.size);
        Ok(Some((scene, ReflectionsKey { scene: scene_key, camera, size_px })))
    }
}
