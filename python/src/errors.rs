//! Findings as exceptions, with all that the terminal would show.

use std::io;

use pyo3::{
    exceptions::{PyOSError, PyRuntimeError},
    prelude::*,
    sync::PyOnceLock,
    types::PyType,
};
use virote::{
    diag::{Diagnostic, Sources},
    export::io_reason,
    kernel::GeomError,
    render,
    value::At,
};

/// A class of a module of the package.
pub(crate) fn class<'py>(
    py: Python<'py>,
    known: &'static PyOnceLock<Py<PyType>>,
    module: &str,
    name: &str,
) -> PyResult<&'py Bound<'py, PyType>> {
    known.import(py, module, name)
}

/// The exception for a finding.
pub(crate) fn geo_error(py: Python<'_>, found: &Diagnostic, sources: &Sources) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let json = render::json(found, sources).to_string();
    let picture = render::picture(found, sources, false);
    let made = class(py, &CLASS, "virote._findings", "GeoError")
        .and_then(|class| class.call_method1("_of", (json, picture)));
    match made {
        Ok(error) => PyErr::from_value(error),
        Err(_) => PyRuntimeError::new_err(found.message.clone()),
    }
}

/// The exception for a file that cannot be written, which is an error of the system as well.
pub(crate) fn write_error(
    py: Python<'_>,
    found: &Diagnostic,
    sources: &Sources,
    number: Option<i32>,
) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let json = render::json(found, sources).to_string();
    let picture = render::picture(found, sources, false);
    let made = class(py, &CLASS, "virote._findings", "WriteError")
        .and_then(|class| class.call_method1("_of_system", (json, picture, number)));
    match made {
        Ok(error) => PyErr::from_value(error),
        Err(_) => PyOSError::new_err(found.message.clone()),
    }
}

/// The exception for an error of the system, with its number where it has one.
pub(crate) fn os_error(err: &io::Error, what: &str) -> PyErr {
    let message = format!("{what}: {}", io_reason(err));
    match err.raw_os_error() {
        Some(number) => PyOSError::new_err((number, message)),
        None => PyOSError::new_err(message),
    }
}

/// The exception for an error of the geometry.
pub(crate) fn geom_error(py: Python<'_>, err: GeomError) -> PyErr {
    match Err::<(), _>(err).at(virote::diag::Span::default()) {
        Err(found) => geo_error(py, &found, &Sources::default()),
        Ok(()) => PyRuntimeError::new_err("an error that is none"),
    }
}
