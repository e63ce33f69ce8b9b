//! Shaded pictures: of what a script exports or defines, and of a value alone.

use pyo3::{exceptions::PyValueError, prelude::*};
use virote::{
    export::{Format, PICTURES, View},
    limits::work::{self, MemoryGauge, StopToken, Watch},
    session::{PictureContent, Report, Session},
    value::{NoFiles, Value},
};

use crate::interrupt::interruptible;

/// What a value alone is called while it is drawn.
const ALONE: &str = "value";

/// What a picture is to show.
pub(crate) struct Wanted<'a> {
    /// Width and height in pixels.
    pub(crate) size: [usize; 2],
    /// From where, by name; without one what fits.
    pub(crate) view: Option<&'a str>,
    /// The definitions, or with no name those that the script exports.
    pub(crate) only: &'a [String],
}

/// A picture in PNG of definitions of a report.
pub(crate) fn draw(
    py: Python<'_>,
    session: &Session,
    stop: &StopToken,
    report: &Report,
    Wanted { size, view, only }: Wanted<'_>,
) -> PyResult<Vec<u8>> {
    let mut content = PictureContent { only, ..PictureContent::new(size) };
    if let Some(name) = view {
        let view = View::from_name(name);
        let names: Vec<&str> = View::ALL.iter().map(|&(name, _)| name).collect();
        let wrong = || format!("there is no view `{name}`; views are {}", names.join(", "));
        content.options.viewpoint.view = Some(view.ok_or_else(|| PyValueError::new_err(wrong()))?);
    }
    let most = session.limits().picture_pixels;
    if size.contains(&0) || most < size[0].saturating_mul(size[1]) {
        return Err(PyValueError::new_err(format!("a picture has from 1 to {most} pixels")));
    }
    let format = Format::among(PICTURES, "a.png");
    let format = format.ok_or_else(|| PyValueError::new_err("there is no PNG"))?;
    let watch = Watch {
        gauge: MemoryGauge::default(),
        memory_bytes: usize::MAX,
        stop: stop.clone(),
        steps: u64::MAX,
    };
    let drawn = interruptible(py, stop, || {
        let drawing = || {
            let job = session.picture(report, &content, format)?;
            let mut bytes = Vec::new();
            (format.write)(&job, &mut bytes).map_err(|err| err.reason())?;
            Ok(bytes)
        };
        work::under(watch, drawing).0
    })?;
    drawn.map_err(|message: String| PyValueError::new_err(message))
}

/// A picture in PNG of a value; nothing where it is nothing that can be drawn.
pub(crate) fn of_value(
    py: Python<'_>,
    value: &Value,
    size: [usize; 2],
    view: Option<&str>,
) -> PyResult<Option<Vec<u8>>> {
    let is_geometry = matches!(
        value,
        Value::Curve(_)
            | Value::Surface(_)
            | Value::Region(_)
            | Value::Face(_)
            | Value::Solid(_)
            | Value::Mesh(_)
    );
    if !is_geometry {
        return Ok(None);
    }
    let (session, stop) = (Session::default(), StopToken::default());
    // The report of a script that defines it and nothing else.
    let text = format!("let {ALONE} = 0");
    let mut report = session.run(ALONE, text.as_bytes(), &NoFiles, &[]);
    for defined in &mut report.definitions {
        defined.value = Some(value.clone());
        defined.identity = None;
    }
    let only = &[ALONE.to_owned()];
    draw(py, &session, &stop, &report, Wanted { size, view, only }).map(Some)
}
