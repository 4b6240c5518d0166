//! Long work that Python can interrupt.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use pyo3::{exceptions::PyRuntimeError, prelude::*};

use crate::threads::pool;

/// How often a waiting Python looks for the end, for Ctrl-C, and reports progress.
const LOOK_UP: Duration = Duration::from_millis(5);

/// Runs `work` on another thread while this one lets Python live.
///
/// What `look_up` raises now and then, and Ctrl-C, ends in `stop`, which asks the work to end soon.
pub fn watched<T: Send>(
    py: Python<'_>,
    look_up: impl Fn() -> PyResult<()>,
    stop: impl Fn(),
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    // On a thread of the pool, which keeps its memory for the next call.
    pool().in_place_scope(|scope| {
        let (done, mut end) = channel();
        scope.spawn(move |_| {
            // A panic ends here: without a result the channel just closes. Nobody listens any more once
            // Python was interrupted.
            drop(catch_unwind(AssertUnwindSafe(work)).map(|found| done.send(found)));
        });
        loop {
            let listening = &mut end;
            let waited = py.detach(move || listening.recv_timeout(LOOK_UP));
            match waited {
                Ok(result) => return Ok(result),
                Err(RecvTimeoutError::Disconnected) => return Err(broken_off()),
                Err(RecvTimeoutError::Timeout) => {}
            }
            if let Err(error) = py.check_signals().and_then(|()| look_up()) {
                stop();
                return Err(error);
            }
        }
    })
}

/// What should not happen: work that ended without a result though nobody asked it to stop.
pub fn broken_off() -> PyErr {
    PyRuntimeError::new_err("the computation broke off; please report this")
}
