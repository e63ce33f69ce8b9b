//! The parameters of a script as the page's controls want them.

use serde_json::{Value as Json, json};

use crate::{
    eval::{Schema, SchemaParameter, Setting},
    session::Report,
    value::{Dimension, Number, Value},
};

/// Every parameter with its value in this run.
pub(super) fn json(schema: Option<&Schema>, report: Option<&Report>, settings: &[Setting]) -> Json {
    let Some(schema) = schema else { return json!([]) };
    let unit = schema.unit.name();
    let parameter = |parameter: &SchemaParameter| {
        let set = settings.iter().rfind(|setting| setting.name == parameter.name);
        let in_run = report.and_then(|report| {
            let defined = report.definitions.iter().find(|its| its.name == parameter.name);
            defined?.value.clone()
        });
        one(parameter, unit, set, in_run)
    };
    schema.parameters.iter().map(parameter).collect()
}

fn one(
    parameter: &SchemaParameter,
    unit: &'static str,
    set: Option<&Setting>,
    in_run: Option<Value>,
) -> Json {
    let value = in_run.as_ref().unwrap_or(&parameter.default);
    let text = match (&in_run, set) {
        // Of a value that was refused there is only what was asked for.
        (None, Some(setting)) => setting.text.clone(),
        _ => written(value, unit),
    };
    let (mut least, mut most, mut choices) = (None, None, None);
    match &parameter.allowed {
        Some(Value::Range(range)) => {
            least = Some(number(range.start));
            most = Some(number(range.end));
        }
        Some(Value::List(list)) => {
            choices = Some(list.values().map(|choice| written(&choice, unit)).collect::<Vec<_>>());
        }
        _ => {}
    }
    let step = parameter.step.map(number).or((parameter.kind == "integer").then_some(1.0));
    json!({
        "name": parameter.name,
        "label": parameter.label,
        "docs": parameter.docs,
        "kind": if choices.is_some() { "choice" } else { kind(parameter) },
        "value": text,
        "default": written(&parameter.default, unit),
        "number": if let Value::Number(its) = value { Some(number(*its)) } else { None },
        "least": least,
        "most": most,
        "step": step,
        "unit": parameter.unit_text(unit),
        "choices": choices,
        "isSet": set.is_some(),
    })
}

fn dimension(value: &Value) -> Option<Dimension> {
    if let Value::Number(number) = value { Some(number.dim) } else { None }
}

fn kind(parameter: &SchemaParameter) -> &'static str {
    match (&parameter.default, dimension(&parameter.default)) {
        (_, Some(Dimension::LENGTH)) => "length",
        (_, Some(Dimension::ANGLE)) => "angle",
        (Value::Number(_), _) => "number",
        (Value::Bool(_), _) => "bool",
        (Value::Text(_), _) => "text",
        _ => "other",
    }
}

/// What a parameter allows, as a script writes it.
pub(super) fn allowed_text(parameter: &SchemaParameter, unit: &str) -> Option<String> {
    parameter.allowed.as_ref().map(|allowed| parameter.written(allowed, unit))
}

/// A value as it stands behind `--set NAME=`: numbers with their unit, strings as they are.
pub(super) fn written(value: &Value, unit: &'static str) -> String {
    match value {
        Value::Text(text) => text.to_string(),
        other => other.in_unit(unit).to_string(),
    }
}

/// A number in the document's unit; an angle in degrees, as it is written.
fn number(number: Number) -> f64 {
    let text = number.to_string();
    let degrees = text.strip_suffix("deg").and_then(|text| text.parse().ok());
    degrees.unwrap_or(number.value)
}
