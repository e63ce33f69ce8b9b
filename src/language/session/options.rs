//! The options of an export, from values of the script to what a format is asked.

use crate::{
    diag::{Code, Diagnostic, Spanned, nearest},
    export::{ExportOption, Format, OptionValue, Options},
    value::{Dimension, Value},
};

/// Reads the options after `with`; what does not fit goes to `diagnostics`.
pub(super) fn options(
    given: &[(Spanned<String>, Spanned<Value>)],
    format: &Format,
    diagnostics: &mut Vec<Diagnostic>,
) -> Options {
    let mut options = Options::default();
    for (idx, (label, value)) in given.iter().enumerate() {
        let Some(option) = format.options.iter().find(|option| option.name == label.value) else {
            diagnostics.push(unknown(label, format));
            continue;
        };
        if given[..idx].iter().any(|(earlier, _)| earlier.value == label.value) {
            let message = format!("`{}` is given twice", label.value);
            diagnostics.push(Diagnostic::error(Code::BadCall, label.span, message));
        } else if !(option.set)(&mut options, option_value(&value.value)) {
            diagnostics.push(wrong(option, value));
        }
    }
    options
}

fn option_value(value: &Value) -> OptionValue<'_> {
    match value {
        Value::Bool(value) => OptionValue::Bool(*value),
        Value::Text(text) => OptionValue::Text(text),
        Value::Point(point) => OptionValue::Point(*point),
        Value::Number(number) if number.dim.is_bare() => OptionValue::Number(number.value),
        Value::Number(number) if number.dim == Dimension::LENGTH => {
            OptionValue::Length(number.value)
        }
        Value::Number(number) if number.dim.is_angle() => OptionValue::Angle(number.value),
        _ => OptionValue::Other,
    }
}

fn unknown(label: &Spanned<String>, format: &Format) -> Diagnostic {
    let message = format!("`.{}` has no option `{}`", format.ending, label.value);
    let diagnostic = Diagnostic::error(Code::BadCall, label.span, message).label("unknown option");
    let known: Vec<&str> = format.options.iter().map(|option| option.name).collect();
    match (nearest(&label.value, known.iter().copied()), known.is_empty()) {
        (Some(near), _) => diagnostic.meant(near),
        (None, true) => diagnostic.hint("it takes no options"),
        (None, false) => diagnostic.hint(format!("its options are {}", known.join(", "))),
    }
}

/// What is wrong with a value that is none for the option.
fn wrong(option: &ExportOption, value: &Spanned<Value>) -> Diagnostic {
    let (name, words) = (option.name, (option.words)());
    let Value::Text(word) = &value.value else {
        return not_wanted(option, value);
    };
    if words.is_empty() {
        return not_wanted(option, value);
    }
    let message = format!("there is no {name} `{word}`");
    let list: Vec<String> = words.iter().map(|word| format!("`\"{word}\"`")).collect();
    let diagnostic = Diagnostic::error(Code::BadChoice, value.span, message)
        .hint(format!("{name}s are {}", list.join(", ")));
    match nearest(word, words) {
        Some(near) => diagnostic.meant(&format!("\"{near}\"")),
        None => diagnostic,
    }
}

fn not_wanted(option: &ExportOption, value: &Spanned<Value>) -> Diagnostic {
    let ExportOption { name, wants, .. } = option;
    let message = format!("`{name}` must be {wants}, found {}", value.value.phrase());
    Diagnostic::error(Code::WrongKind, value.span, message)
}
