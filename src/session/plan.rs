//! From an `export` to a file: its path, its format, what goes into it.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Span, nearest},
    export::{FORMATS, Format, Item, Subject},
    kernel::{Curve, Surface},
    value::{Dim, Function, Value, to_json},
};

/// The path in normal form, if it stays below the output folder.
pub(super) fn safe_path(path: &str) -> Result<String, String> {
    let is_absolute = path.starts_with(['/', '\\']) || path.contains(':');
    if is_absolute {
        return Err(format!("`{path}` is not a path below the output folder"));
    }
    if let Some(c) = path.chars().find(|c| c.is_control()) {
        return Err(format!("a path cannot hold the character {:?}", c));
    }
    let mut parts: Vec<&str> = Vec::new();
    for part in path.split(['/', '\\']) {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop().ok_or_else(|| format!("`{path}` leaves the output folder"))?;
            }
            part => parts.push(part),
        }
    }
    if parts.is_empty() { Err(format!("`{path}` names no file")) } else { Ok(parts.join("/")) }
}

pub(super) fn unknown_format(path: &str, span: Span) -> Diagnostic {
    let file = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let endings: Vec<String> =
        FORMATS.iter().map(|format| format!("`.{}`", format.ending)).collect();
    let (message, near) = match file.rsplit_once('.') {
        Some((_, ending)) => (
            format!("no format has the ending `.{ending}`"),
            nearest(ending, FORMATS.iter().map(|format| format.ending)),
        ),
        None => (format!("`{path}` has no ending, which would choose the format"), None),
    };
    let diagnostic = Diagnostic::error(Code::UnknownFormat, span, message)
        .hint(format!("formats are {}", endings.join(", ")));
    match near {
        Some(near) => diagnostic.label(format!("did you mean `.{near}`?")),
        None => diagnostic,
    }
}

/// What a format has no place for, and where it could go instead.
pub(super) struct Misfit {
    pub(super) found: String,
    pub(super) hint: &'static str,
}

impl Misfit {
    fn of(value: &Value) -> Self {
        let hint = match value {
            Value::Table(_) => "tables go into `.csv` and `.json`",
            Value::Point(_) | Value::Curve(_) => {
                "curves and points go into `.obj`, and everything into `.json`"
            }
            Value::Function(_) => "export what the function yields",
            _ => {
                "geometry goes into `.obj` and `.stl`, tables into `.csv`, and everything into `.json`"
            }
        };
        Self { found: value.phrase(), hint }
    }
}

/// Turns a value into items of a file, lists element by element; else what was found.
pub(super) fn gather(
    name: &str,
    value: &Value,
    format: &Format,
    items: &mut Vec<Item>,
) -> Result<(), Misfit> {
    let subject = match value {
        // Exact data holds everything but functions, which are no data.
        _ if format.takes_data => match function_in(value) {
            None if has_parametric(value) => {
                return Err(Misfit {
                    found: "a parametric curve or surface, which is a function".to_owned(),
                    hint: "`to_nurbs(g, tolerance)` makes a NURBS of it",
                });
            }
            None => Subject::Data(to_json(value)),
            Some(function) => {
                let found = format!("the function `{}`", function.signature());
                return Err(Misfit { found, ..Misfit::of(&Value::Function(function.clone())) });
            }
        },
        Value::List(elements) => {
            for (i, element) in elements.iter().enumerate() {
                gather(&format!("{name}[{i}]"), element, format, items)?;
            }
            return Ok(());
        }
        Value::Point(point) => Subject::Point(*point),
        Value::Curve(curve) => Subject::Curve(curve.clone()),
        Value::Surface(surface) => Subject::Surface(surface.clone()),
        Value::Mesh(mesh) => Subject::Mesh(Arc::clone(mesh)),
        Value::Table(table) => Subject::Table(Arc::clone(table)),
        other => return Err(Misfit::of(other)),
    };
    if !(format.takes)(&subject) {
        return Err(Misfit::of(value));
    }
    if matches!(subject, Subject::Table(_)) && !items.is_empty() {
        let found = "a second table".to_owned();
        return Err(Misfit { found, ..Misfit::of(value) });
    }
    items.push(Item { name: unused(name, items), subject });
    Ok(())
}

/// The name, numbered where another item has it already.
fn unused(name: &str, items: &[Item]) -> String {
    let is_free = |name: &str| items.iter().all(|item| item.name != name);
    if is_free(name) {
        return name.to_owned();
    }
    let numbered = (2..=items.len() + 2).map(|i| format!("{name}-{i}"));
    numbered.clone().find(|name| is_free(name)).unwrap_or_else(|| name.to_owned())
}

/// Whether a curve or surface in a value is a function.
fn has_parametric(value: &Value) -> bool {
    match value {
        Value::Curve(Curve::Parametric(_)) | Value::Surface(Surface::Parametric(_)) => true,
        Value::List(items) => items.iter().any(has_parametric),
        Value::Record(record) => record.iter().any(|(_, value)| has_parametric(value)),
        _ => false,
    }
}

/// A function in a value.
fn function_in(value: &Value) -> Option<&Function> {
    match value {
        Value::Function(function) => Some(function),
        Value::List(items) => items.iter().find_map(function_in),
        Value::Record(record) => record.iter().find_map(|(_, value)| function_in(value)),
        _ => None,
    }
}

/// Reads the options of an export: its tolerance.
pub(super) fn options(
    options: &[(crate::diag::Spanned<String>, crate::diag::Spanned<Value>)],
    format: &Format,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<f64> {
    let mut tolerance = None;
    for (label, value) in options {
        if !format.options.contains(&label.value.as_str()) {
            let message = format!("`.{}` has no option `{}`", format.ending, label.value);
            let diagnostic =
                Diagnostic::error(Code::BadCall, label.span, message).label("unknown option");
            diagnostics.push(
                match (nearest(&label.value, format.options.iter().copied()), format.options) {
                    (Some(near), _) => diagnostic.label(format!("did you mean `{near}`?")),
                    (None, []) => diagnostic.hint("it takes no options"),
                    (None, known) => {
                        diagnostic.hint(format!("its options are {}", known.join(", ")))
                    }
                },
            );
            continue;
        }
        match &value.value {
            Value::Number(number)
                if 0.0 < number.value && (number.dim.is_none() || number.dim == Dim::LENGTH) =>
            {
                tolerance = Some(number.value);
            }
            other => {
                let message = format!(
                    "`{}` must be a positive length, found {}",
                    label.value,
                    other.phrase()
                );
                diagnostics.push(Diagnostic::error(Code::WrongKind, value.span, message));
            }
        }
    }
    tolerance
}

#[cfg(test)]
mod tests {
    use super::safe_path;

    #[test]
    fn paths_stay_below_the_output_folder() {
        assert_eq!(safe_path("a/../b/./c.obj").as_deref(), Ok("b/c.obj"));
        for path in [
            "../a.obj",
            "a/../../b.obj",
            "/etc/a.obj",
            "c:\\a.obj",
            "\\\\host\\a.obj",
            "",
            ".",
            "a/..",
        ] {
            assert!(safe_path(path).is_err(), "{path}");
        }
    }
}
