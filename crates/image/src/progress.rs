use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// How far a render is, seen from another thread, and the wish that it stop.
#[derive(Debug, Default)]
pub struct Progress {
    rows_done: AtomicUsize,
    stop: AtomicBool,
}

impl Progress {
    /// Rows finished so far.
    pub fn rows_done(&self) -> usize {
        self.rows_done.load(Ordering::Relaxed)
    }

    /// Counts a row as finished.
    pub(crate) fn row_done(&self) {
        self.rows_done.fetch_add(1, Ordering::Relaxed);
    }

    /// What turns true with the wish to stop.
    pub fn stop_flag(&self) -> &AtomicBool {
        &self.stop
    }

    /// Whether there is that wish.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Asks the render to stop at the end of the row.
    pub fn stop(&self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}
