//! Two pieces of work at once where there are threads: by rayon with the feature `parallel`, one after the
//! other without it.

#[cfg(feature = "parallel")]
pub(crate) use rayon::join;

/// Does one piece of work, then the other.
#[cfg(not(feature = "parallel"))]
pub(crate) fn join(first: impl FnOnce(), second: impl FnOnce()) {
    first();
    second();
}
