//! `virote params`: what a script can be given.

use std::path::Path;

use serde_json::{Value as Json, json};

use super::{
    exit_status::ExitStatus,
    inspect::look,
    run_args::OutputArgs,
    standard_streams::{say, say_exactly},
};
use crate::{
    disk::{Script, ScriptFiles},
    eval::{Schema, SchemaParameter},
    session::Session,
    value::{Number, Value, to_json},
};

/// `virote params FILE [--json]`
pub(super) fn run(path: &Path, is_json: bool, talk: &OutputArgs) -> ExitStatus {
    let ask = |session: &Session, script: &Script, files: &ScriptFiles| {
        session.parameters(&script.name, &script.bytes, files)
    };
    look(path, talk, ask, |script, voice, schema| {
        if is_json {
            say_exactly(&format!("{:#}\n", schema_json(&script.name, schema)));
        } else if schema.parameters.is_empty() {
            voice.remark(&format!("`{}` has no parameters", script.name));
        } else {
            say(&table(schema));
        }
    })
}

/// A line for each parameter, its documentation below.
fn table(schema: &Schema) -> String {
    let head = ["name", "kind", "default", "allowed", "step", "label"].map(str::to_owned);
    let unit = schema.unit.name();
    let mut rows = vec![head];
    rows.extend(schema.parameters.iter().map(|parameter| row(parameter, unit)));
    let mut widths = [0; 6];
    for row in &rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = cell.chars().count().max(*width);
        }
    }
    let docs = schema.parameters.iter().map(|parameter| parameter.docs.as_deref());
    let mut text = String::new();
    for (row, docs) in rows.iter().zip(std::iter::once(None).chain(docs)) {
        // A column that no parameter fills is left out.
        let cells = row
            .iter()
            .zip(widths)
            .enumerate()
            .filter(|&(column, _)| rows.iter().skip(1).any(|row| !row[column].is_empty()));
        let line: String = cells.map(|(_, (cell, width))| format!("{cell:<width$}  ")).collect();
        text.push_str(line.trim_end());
        text.push('\n');
        for line in docs.into_iter().flat_map(str::lines) {
            text.push_str(format!("  {line}").trim_end());
            text.push('\n');
        }
    }
    text
}

fn row(parameter: &SchemaParameter, unit: &str) -> [String; 6] {
    let step = parameter.step.map(Value::Number);
    [
        parameter.name.clone(),
        parameter.kind.to_owned(),
        parameter.written(&parameter.default, unit),
        parameter.allowed.as_ref().map(|value| parameter.written(value, unit)).unwrap_or_default(),
        step.map(|step| parameter.written(&step, unit)).unwrap_or_default(),
        parameter.label.clone().unwrap_or_default(),
    ]
}

/// The parameters of a script as JSON.
#[must_use]
pub fn schema_json(file: &str, schema: &Schema) -> Json {
    let unit = schema.unit.name();
    let parameters: Vec<Json> =
        schema.parameters.iter().map(|parameter| parameter_json(parameter, unit)).collect();
    json!({ "file": file, "unit": unit, "parameters": parameters })
}

/// Every member is always there; what a parameter lacks is null.
fn parameter_json(parameter: &SchemaParameter, unit: &str) -> Json {
    let unit = parameter.unit_text(unit);
    let range = match &parameter.allowed {
        Some(Value::Range(range)) => json!({
            "start": number_json(range.start),
            "end": number_json(range.end),
            "closed": range.closed,
        }),
        _ => Json::Null,
    };
    let choices = match &parameter.allowed {
        Some(Value::List(choices)) => choices.iter().map(value_json).collect(),
        _ => Json::Null,
    };
    json!({
        "name": parameter.name,
        "kind": parameter.kind,
        "unit": unit,
        "default": value_json(&parameter.default),
        "range": range,
        "step": parameter.step.map(number_json),
        "choices": choices,
        "label": parameter.label,
        "docs": parameter.docs,
    })
}

fn value_json(value: &Value) -> Json {
    match value {
        Value::Number(number) => number_json(*number),
        other => to_json(other),
    }
}

/// A number in the document's unit; an angle in degrees, in the fewest digits that read back.
fn number_json(number: Number) -> Json {
    let text = number.to_string();
    let degrees = text.strip_suffix("deg").and_then(|text| text.parse::<f64>().ok());
    let value = degrees.unwrap_or(number.value);
    // Whole numbers stand without a point, as the script writes them.
    match Number::bare(value).as_integer() {
        Some(whole) => json!(whole),
        None => json!(value),
    }
}
