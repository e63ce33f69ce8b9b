//! The options of an export, from values of the script to what a format is asked.

use crate::{
    diag::{Code, Diagnostic, Spanned, nearest},
    export::{Format, Options, View},
    value::{Dimension, Value},
};

/// Digits after the point that an f64 can have any use for.
const MOST_DECIMALS: f64 = 17.0;

/// Reads the options after `with`; what does not fit goes to `diagnostics`.
pub(super) fn options(
    given: &[(Spanned<String>, Spanned<Value>)],
    format: &Format,
    diagnostics: &mut Vec<Diagnostic>,
) -> Options {
    let mut options = Options::default();
    for (idx, (label, value)) in given.iter().enumerate() {
        if !format.options.contains(&label.value.as_str()) {
            diagnostics.push(unknown(label, format));
        } else if given[..idx].iter().any(|(earlier, _)| earlier.value == label.value) {
            let message = format!("`{}` is given twice", label.value);
            diagnostics.push(Diagnostic::error(Code::BadCall, label.span, message));
        } else if let Err(found) = read(label, value, &mut options) {
            diagnostics.push(*found);
        }
    }
    options
}

fn unknown(label: &Spanned<String>, format: &Format) -> Diagnostic {
    let message = format!("`.{}` has no option `{}`", format.ending, label.value);
    let diagnostic = Diagnostic::error(Code::BadCall, label.span, message).label("unknown option");
    match (nearest(&label.value, format.options.iter().copied()), format.options) {
        (Some(near), _) => diagnostic.label(format!("did you mean `{near}`?")),
        (None, []) => diagnostic.hint("it takes no options"),
        (None, known) => diagnostic.hint(format!("its options are {}", known.join(", "))),
    }
}

fn read(
    label: &Spanned<String>,
    value: &Spanned<Value>,
    options: &mut Options,
) -> Result<(), Box<Diagnostic>> {
    let wrong = |wanted: &str| {
        let message = format!("`{}` must be {wanted}, found {}", label.value, value.value.phrase());
        Box::new(Diagnostic::error(Code::WrongKind, value.span, message))
    };
    match (label.value.as_str(), &value.value) {
        ("tolerance", Value::Number(number))
            if 0.0 < number.value && (number.dim.is_none() || number.dim == Dimension::LENGTH) =>
        {
            options.tolerance = Some(number.value);
        }
        ("tolerance", _) => return Err(wrong("a positive length")),
        ("angle", Value::Number(number))
            if 0.0 < number.value && number.dim == Dimension::ANGLE =>
        {
            options.angle = Some(number.value);
        }
        ("angle", _) => return Err(wrong("a positive angle, such as `15deg`")),
        ("binary", Value::Bool(binary)) => options.binary = Some(*binary),
        ("free_form", Value::Bool(free_form)) => options.free_form = *free_form,
        ("binary" | "free_form", _) => return Err(wrong("true or false")),
        ("decimals", Value::Number(number))
            if number.dim.is_none()
                && (0.0..=MOST_DECIMALS).contains(&number.value)
                && number.value.fract().abs() <= 0.0 =>
        {
            options.decimals = Some(number.value as usize);
        }
        ("decimals", _) => return Err(wrong("a whole number from 0 to 17")),
        ("view", Value::Text(name)) => {
            options.view = View::from_name(name).ok_or_else(|| no_view(name, value))?;
        }
        ("view", _) => return Err(wrong("the name of a view, such as `\"front\"`")),
        _ => {}
    }
    Ok(())
}

fn no_view(name: &str, value: &Spanned<Value>) -> Box<Diagnostic> {
    let names = View::ALL.iter().map(|&(name, _)| name);
    let message = format!("there is no view `{name}`");
    let diagnostic = Diagnostic::error(Code::BadChoice, value.span, message);
    let list: Vec<String> = names.clone().map(|name| format!("`\"{name}\"`")).collect();
    let diagnostic = diagnostic.hint(format!("views are {}", list.join(", ")));
    Box::new(match nearest(name, names) {
        Some(near) => diagnostic.label(format!("did you mean `\"{near}\"`?")),
        None => diagnostic,
    })
}
