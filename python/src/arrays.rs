//! NumPy, loaded by Python's own import when it is needed first: what keeps it from being loaded is raised.

use numpy::PyUntypedArray;
use pyo3::{prelude::*, sync::PyOnceLock};

static LOADED: PyOnceLock<()> = PyOnceLock::new();

/// Loads NumPy; whoever makes an array asks for it before.
///
/// # Errors
/// What its import raises: `ModuleNotFoundError` where there is none, `KeyboardInterrupt` at Ctrl-C.
pub(crate) fn load(py: Python<'_>) -> PyResult<()> {
    LOADED
        .get_or_try_init(py, || {
            py.import("numpy")?;
            py.check_signals()?;
            // Its interface, which the bindings look up once, without any way to fail.
            numpy::dtype::<f64>(py);
            Ok(())
        })
        .copied()
}

/// The array, if it is one; as long as nobody has loaded NumPy nothing is.
///
/// # Errors
/// Those of [`load`].
pub(crate) fn array<'a, 'py>(
    given: &'a Bound<'py, PyAny>,
) -> PyResult<Option<&'a Bound<'py, PyUntypedArray>>> {
    let py = given.py();
    if LOADED.get(py).is_none() {
        if !py.import("sys")?.getattr("modules")?.contains("numpy")? {
            return Ok(None);
        }
        load(py)?;
    }
    Ok(given.cast().ok())
}
