//! Long work without the interpreter's lock, which Ctrl-C ends.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// How often Python looks for signals.
const INTERVAL: Duration = Duration::from_millis(50);

/// Does `work` on a thread of its own while other Python threads run. It is told by its flag that it is no longer wanted.
///
/// # Errors
/// What a signal raises, such as `KeyboardInterrupt`, once the work has ended.
pub fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Arc<AtomicBool>) -> T + Send) -> PyResult<T> {
    let stop = Arc::new(AtomicBool::new(false));
    let (sender, receiver) = channel();
    let receiver = Mutex::new(receiver);
    thread::scope(|scope| {
        let flag = &stop;
        let worker = scope.spawn(move || sender.send(work(flag)));
        let wait = || receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(INTERVAL);
        let mut raised = None;
        loop {
            match py.detach(wait) {
                Ok(done) => return raised.map_or(Ok(done), Err),
                Err(RecvTimeoutError::Disconnected) => {
                    // A panic that nobody has taken would go on from the end of the scope.
                    let _ = worker.join();
                    return Err(PyRuntimeError::new_err("the work panicked"));
                }
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(error) = py.check_signals() {
                        stop.store(true, Ordering::Relaxed);
                        raised = Some(error);
                    }
                }
            }
        }
    })
}
