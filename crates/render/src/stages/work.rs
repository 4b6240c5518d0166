//! How much of a job is worked out in one call.

use std::cell::Cell;

use nacreous_image::Progress;

/// The pieces that may still be begun in one call, and the wish that it stop. A piece is what is kept as one
/// thing: the film of one pearl, its grain, the light around all of them.
pub(crate) struct Work<'a> {
    progress: &'a Progress,
    left: Cell<usize>,
}

impl<'a> Work<'a> {
    /// Everything that is missing.
    pub(crate) fn whole(progress: &'a Progress) -> Self {
        Self { progress, left: Cell::new(usize::MAX) }
    }

    /// One piece of it.
    pub(crate) fn one_piece(progress: &'a Progress) -> Self {
        Self { progress, left: Cell::new(1) }
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
