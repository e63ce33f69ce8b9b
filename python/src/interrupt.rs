//! Long work: without Python's lock, on a thread with stack enough, and ended by Ctrl-C.

use std::{
    sync::mpsc::{self, RecvTimeoutError},
    thread,
    time::Duration,
};

use pyo3::{exceptions::PyRuntimeError, prelude::*};
use virote::limits::{Limits, stack, work::StopToken};

/// How often it is asked whether Ctrl-C was pressed.
const TICK: Duration = Duration::from_millis(30);

/// Does the work while other threads of Python run; where a signal wants to end it, sets the switch, and
/// raises what the signal raises.
pub(crate) fn interruptible<R: Send>(
    py: Python<'_>,
    stop: &StopToken,
    work: impl FnOnce() -> R + Send,
) -> PyResult<R> {
    py.detach(|| {
        thread::scope(|scope| {
            let (sender, results) = mpsc::channel();
            let bytes = Limits::DEFAULT.stack_bytes;
            let serve = move || sender.send(stack::known(bytes, work));
            let started = thread::Builder::new().stack_size(bytes).spawn_scoped(scope, serve);
            started.map_err(|err| PyRuntimeError::new_err(format!("no thread: {err}")))?;
            let mut raised = None;
            let result = loop {
                match results.recv_timeout(TICK) {
                    Ok(result) => break Some(result),
                    Err(RecvTimeoutError::Disconnected) => break None,
                    Err(RecvTimeoutError::Timeout) if raised.is_none() => {
                        if let Err(signal) = Python::attach(|py| py.check_signals()) {
                            raised = Some(signal);
                            stop.stop();
                        }
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                }
            };
            stop.reset();
            match (raised, result) {
                (Some(signal), _) => Err(signal),
                (None, Some(result)) => Ok(result),
                (None, None) => Err(PyRuntimeError::new_err("the evaluation failed")),
            }
        })
    })
}
