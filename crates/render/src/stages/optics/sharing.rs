//! The films of a recipe, worked out in parts by several jobs.

use std::sync::atomic::AtomicBool;

use nacreous_image::FilmDraft;

use super::{FilmKey, OpticsStage, surface_key};
use crate::{
    RenderError,
    pearl::{coat::thickness_of, columns::columns_of},
    spec::pearl::PearlSpec,
};

impl OpticsStage {
    /// Whether the film of any pearl is not known yet.
    pub(crate) fn lacks_films(&self, pearls: &[PearlSpec]) -> bool {
        films(pearls).iter().any(|key| !self.films.has(key))
    }

    /// One of `parts` parts of the work on all films, whether they are known here or not.
    pub(crate) fn film_part(
        &self,
        pearls: &[PearlSpec],
        part: usize,
        parts: usize,
    ) -> Result<Vec<f64>, RenderError> {
        let never = AtomicBool::new(false);
        let mut numbers = Vec::new();
        for key in films(pearls) {
            let draft = self.draft_of(&key)?;
            for group in (part..draft.groups()).step_by(parts) {
                numbers.extend(draft.group(group, &never)?.unwrap_or_default());
            }
        }
        Ok(numbers)
    }

    /// Makes the films that are not known yet of what [`OpticsStage::film_part`] gave of each part.
    pub(crate) fn join_films(
        &mut self,
        pearls: &[PearlSpec],
        parts: &[&[f64]],
    ) -> Result<(), RenderError> {
        let mut left = parts.to_vec();
        let mut made = Vec::new();
        for key in films(pearls) {
            let draft = self.draft_of(&key)?;
            let groups = taken(&draft, &mut left).ok_or_else(RenderError::parts)?;
            if !self.films.has(&key) {
                let draft = draft.completed(&groups).ok_or_else(RenderError::parts)?;
                let films = thickness_of(key.count).map(|share| draft.film_of(share));
                made.push((key, films.collect::<Result<Vec<_>, _>>()?));
            }
        }
        if left.iter().any(|rest| !rest.is_empty()) {
            return Err(RenderError::parts());
        }
        for (key, films) in made {
            self.films.put(key, films);
        }
        Ok(())
    }

    fn draft_of(&self, key: &FilmKey) -> Result<FilmDraft, RenderError> {
        let columns = columns_of(&key.nacre, &key.film, key.outer_um)?;
        Ok(FilmDraft::new(columns, key.parts, self.sampling))
    }
}

/// The films of all pearls, each once.
fn films(pearls: &[PearlSpec]) -> Vec<FilmKey> {
    let mut films: Vec<FilmKey> = Vec::new();
    for pearl in pearls {
        if let PearlSpec::Transport(spec) = pearl {
            let key = surface_key(pearl, spec).film;
            if !films.contains(&key) {
                films.push(key);
            }
        }
    }
    films
}

/// The groups of a film, each from the front of its part; `None` where a part is short.
fn taken<'a>(draft: &FilmDraft, left: &mut [&'a [f64]]) -> Option<Vec<&'a [f64]>> {
    let parts = left.len();
    let group = |group: usize| {
        let part = left.get_mut(group.checked_rem(parts)?)?;
        let (own, rest) = part.split_at_checked(draft.numbers(group))?;
        *part = rest;
        Some(own)
    };
    (0..draft.groups()).map(group).collect()
}
