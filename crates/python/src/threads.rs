//! The threads that work: a pool of this process's own.
//!
//! A fork copies the memory of a process but none of its threads, so work handed to the parent's pool would
//! wait for ever. A child therefore makes a pool of its own, and the parent's stays as it is.

use std::sync::OnceLock;

use pyo3::{Python, marker::Ungil};
use rayon::ThreadPool;

/// The pool of one process, and that of a process forked from it.
struct Threads {
    process: u32,
    pool: ThreadPool,
    of_child: OnceLock<Box<Threads>>,
}

static THREADS: OnceLock<Threads> = OnceLock::new();

/// The pool of the process that asks, as many threads as rayon would take (`RAYON_NUM_THREADS`).
pub fn pool() -> &'static ThreadPool {
    let process = std::process::id();
    let mut threads = THREADS.get_or_init(|| Threads::of(process));
    while threads.process != process {
        threads = threads.of_child.get_or_init(|| Box::new(Threads::of(process)));
    }
    &threads.pool
}

impl Threads {
    fn of(process: u32) -> Self {
        // Where the system gives no more threads rayon's own pool would end the program likewise.
        let pool = rayon::ThreadPoolBuilder::new().build().expect("the system gives threads");
        Self { process, pool, of_child: OnceLock::new() }
    }
}

/// Does short work on the pool while other threads of Python run.
pub fn detached<T: Ungil + Send>(py: Python<'_>, work: impl FnOnce() -> T + Ungil + Send) -> T {
    py.detach(|| pool().install(work))
}
