//! Values as exact data.

use crate::{
    export::Subject,
    kernel::{Curve, Surface},
    value::{Function, Value, to_json},
};

/// What of a value is no data.
pub(super) enum NoData<'v> {
    /// A function of the script.
    Function(&'v Function),
    /// A curve or surface that is a function.
    Parametric,
}

/// A value as exact data, which holds everything but functions.
pub(super) fn data(value: &Value) -> Result<Subject, NoData<'_>> {
    if let Some(function) = function_in(value) {
        return Err(NoData::Function(function));
    }
    if has_parametric(value) {
        return Err(NoData::Parametric);
    }
    Ok(Subject::Data(to_json(value)))
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
