//! How much of a job is worked out in one call.

use std::cell::Cell;

use nacreous_image::{FilmDraft, Progress};

/// The pieces that may still be begun in one call, and the wish that it stop. A piece is what is kept as one
/// thing, the grain of one pearl or the light around all of them, or a part of a film.
pub(crate) struct Work<'a> {
    progress: &'a Progress,
    left: Cell<usize>,
    /// Angles in a part of a film.
    pub(crate) film_angles: usize,
}

/// In one piece; there are 129 for each of four groups of columns. In WebAssembly such a piece of
/// `akoya-rg` takes some 12 ms (docs/benchmarks.md) **(ours)**.
const FILM_ANGLES: usize = 33;

impl<'a> Work<'a> {
    /// Everything that is missing.
    pub(crate) fn whole(progress: &'a Progress) -> Self {
        Self { progress, left: Cell::new(usize::MAX), film_angles: FilmDraft::ALL_ANGLES }
    }

    /// One piece of it.
    pub(crate) fn one_piece(progress: &'a Progress) -> Self {
        Self { progress, left: Cell::new(1), film_angles: FILM_ANGLES }
    }

    /// What `make` gives where a piece is left; else `None`, as where it was asked to stop.
    pub(crate) fn piece<T, E>(
        &self,
        make: impl FnOnce(&Progress) -> Result<Option<T>, E>,
    ) -> Result<Option<T>, E> {
        let Some(left) = self.left.get().checked_sub(1) else { return Ok(None) };
        self.left.set(left);
        make(self.progress)
    }
}
