//! Findings as exceptions, with all that the terminal would show.

use pyo3::{exceptions::PyRuntimeError, prelude::*, sync::PyOnceLock, types::PyType};
use virote::{
    diag::{Diagnostic, Sources},
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

/// The exception for an error of the geometry.
pub(crate) fn geom_error(py: Python<'_>, err: GeomError) -> PyErr {
    match Err::<(), _>(err).at(virote::diag::Span::default()) {
        Err(found) => geo_error(py, &found, &Sources::default()),
        Ok(()) => PyRuntimeError::new_err("an error that is none"),
    }
}
