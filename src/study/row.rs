//! What became of a variant as a row: parameters, results, checks, what went wrong, how long it took.

use serde_json::{Map, Value as Json, json};

use super::{plan::Variant, plan_column::PRIME, vary::number_and_power};
use crate::{
    diag::{Code, Diagnostic, Severity, nearest},
    eval::{Checked, Schema, SchemaParameter},
    session::{Event, Report},
    syntax::ast::Unit,
    value::{Number, Value, in_unit_of},
};

/// Cells by the titles of their columns, in the order of the columns.
pub type Row = Map<String, Json>;

/// Titles of columns that every study has.
pub(super) const ID: &str = "id";
/// The code of the first error.
pub(super) const CODE: &str = "code";
/// Its message.
pub(super) const MESSAGE: &str = "message";
/// The time of evaluation.
pub(super) const MILLISECONDS: &str = "milliseconds";
/// The names of pictures, where there are any.
pub(super) const PICTURE: &str = "picture";

/// Makes rows of reports.
#[derive(Debug)]
pub struct RowMaker {
    parameters: Vec<SchemaParameter>,
    unit: Unit,
    /// Definitions that are results; none for all that have a number, a text or a truth value.
    wants: Vec<String>,
}

/// Characters of a claim in the title of its column.
const MOST_CLAIM: usize = 80;

/// Finds wanted names that the script does not define among `defined`.
///
/// # Errors
/// The first, and the name that was meant.
pub fn check_wants(wants: &[String], defined: &[&str]) -> Result<(), String> {
    let Some(name) = wants.iter().find(|name| !defined.contains(&name.as_str())) else {
        return Ok(());
    };
    Err(match nearest(name, defined.iter().copied()) {
        Some(near) => format!("the script defines no `{name}`; did you mean `{near}`?"),
        None => format!("the script defines no `{name}`"),
    })
}

impl RowMaker {
    /// For the script of a schema.
    #[must_use]
    pub fn new(schema: Schema, wants: Vec<String>) -> Self {
        Self { parameters: schema.parameters, unit: schema.unit, wants }
    }

    /// The row of a variant; `stopped` tells why it was, where it was stopped: whatever else was found, it is not
    /// done, and that is its error.
    ///
    /// # Errors
    /// A wanted definition that is nothing that a cell holds.
    pub fn row(
        &self,
        variant: &Variant,
        report: &Report,
        milliseconds: f64,
        stopped: Option<&str>,
    ) -> Result<Row, String> {
        let mut row = Row::new();
        row.insert(ID.to_owned(), variant.id.clone());
        for parameter in &self.parameters {
            let (title, value) = self.parameter(parameter, variant, report);
            row.insert(title, value);
        }
        self.add_results(report, &mut row)?;
        let checks = report.events.iter().filter_map(|event| match event {
            Event::Checked(checked) => Some(checked),
            _ => None,
        });
        for checked in checks {
            add_check(checked, report, &mut row);
        }
        let mut errors =
            report.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        let error = match stopped {
            Some(why) => Some((Code::Stopped, why.to_owned())),
            None => errors.next().map(|error| (error.code, error_message(error, report))),
        };
        let (code, message) = error.map(|(code, message)| (code.id(), message)).unzip();
        row.insert(CODE.to_owned(), json!(code));
        row.insert(MESSAGE.to_owned(), json!(message));
        row.insert(MILLISECONDS.to_owned(), json!((1e3 * milliseconds).round() / 1e3));
        Ok(row)
    }

    /// The title and the value of a parameter.
    fn parameter(
        &self,
        parameter: &SchemaParameter,
        variant: &Variant,
        report: &Report,
    ) -> (String, Json) {
        let name = &parameter.name;
        let defined = report.definitions.iter().find(|defined| defined.name == *name);
        let given = variant.settings.iter().rfind(|setting| setting.name == *name);
        let value = defined.and_then(|defined| defined.value.as_ref());
        let default = Value::None;
        // A value that was refused is told as it was given.
        let value = value.unwrap_or(match given {
            None => &parameter.default,
            Some(_) => &default,
        });
        let (unit, cell) = self.cell(value).unwrap_or_default();
        let cell = match (value, given) {
            (Value::None, Some(given)) => self.refused(&given.text, parameter),
            _ => cell,
        };
        let unit = self.unit_of(parameter).or(unit);
        // Whatever happens to be whole, a column is of the kind of its parameter.
        let whole = cell.as_f64().map(Number::bare).and_then(Number::as_integer);
        let cell = whole.filter(|_| parameter.kind == "integer").map_or(cell, Json::from);
        (titled(name, unit.as_deref()), cell)
    }

    /// The unit of the column of a parameter that measures something for certain, whatever a variant gives it.
    fn unit_of(&self, parameter: &SchemaParameter) -> Option<String> {
        let dim = parameter.dimension()?;
        if dim.is_angle() { Some(DEGREES.to_owned()) } else { dim.unit(self.unit.name()) }
    }

    /// A value that the parameter refused, in the unit of its column; none where it measures something else.
    fn refused(&self, text: &str, parameter: &SchemaParameter) -> Json {
        let (number, unit) = number_and_power(text);
        let number = match (number, unit, parameter.dimension()) {
            (Some(number), "", _) => Some(number),
            (Some(number), unit, _) if self.unit_of(parameter).as_deref() == Some(unit) => {
                Some(number)
            }
            (Some(number), unit, Some(dim)) => {
                let own = in_unit_of(number, unit, self.unit.name());
                own.filter(|own| own.dim == dim).map(|own| match dim.is_angle() {
                    true => in_degrees(own),
                    false => own.value,
                })
            }
            _ => None,
        };
        match parameter.kind {
            "string" | "bool" => json!(text),
            _ => number.map_or(Json::Null, number_cell),
        }
    }

    /// The named numbers, texts and truth values.
    fn add_results(&self, report: &Report, row: &mut Row) -> Result<(), String> {
        let is_parameter =
            |name: &str| self.parameters.iter().any(|parameter| parameter.name == name);
        for defined in &report.definitions {
            let name = &defined.name;
            let is_asked = self.wants.contains(name);
            if is_parameter(name) || !self.wants.is_empty() && !is_asked {
                continue;
            }
            let Some(value) = &defined.value else { continue };
            match self.cell(value) {
                Some((unit, cell)) => {
                    row.insert(titled(name, unit.as_deref()), cell);
                }
                None if is_asked && !matches!(value, Value::None) => {
                    let found = value.phrase();
                    let such_as = match value {
                        Value::List(_) | Value::Table(_) => {
                            format!(", such as `let n = len({name})`")
                        }
                        Value::Point(_) => format!(", such as `let height = {name}.z`"),
                        Value::Curve(_) => format!(", such as `let long = length({name})`"),
                        Value::Surface(_) | Value::Region(_) | Value::Face(_) => {
                            format!(", such as `let skin = area({name})`")
                        }
                        Value::Solid(_) | Value::Mesh(_) => {
                            format!(", such as `let content = volume({name})`")
                        }
                        _ => String::new(),
                    };
                    return Err(format!(
                        "`{name}` is {found}, and a result is a number, a text or a truth value; give a name to a number of it{such_as}"
                    ));
                }
                None => {}
            }
        }
        Ok(())
    }

    /// The unit and the cell of a value, if it is one that a cell holds.
    fn cell(&self, value: &Value) -> Option<(Option<String>, Json)> {
        Some(match value {
            Value::Bool(truth) => (None, json!(truth)),
            Value::Text(text) => (None, json!(**text)),
            Value::Number(number) if number.dim.is_angle() => {
                (Some(DEGREES.to_owned()), number_cell(in_degrees(*number)))
            }
            Value::Number(number) => (number.dim.unit(self.unit.name()), number_cell(number.value)),
            _ => return None,
        })
    }
}

/// A number as a cell; zero has no sign, as wherever numbers are told.
fn number_cell(number: f64) -> Json {
    json!(number + 0.0)
}

/// The unit of angles in results, as everywhere that they are printed.
const DEGREES: &str = "deg";

/// An angle in the fewest digits of degrees that read back to it.
fn in_degrees(angle: Number) -> f64 {
    let text = angle.to_string();
    let degrees = text.strip_suffix(DEGREES).and_then(|text| text.parse().ok());
    degrees.unwrap_or_else(|| angle.value.to_degrees())
}

/// `neck [mm]`; what is called like a column of every study, with a prime.
fn titled(name: &str, unit: Option<&str>) -> String {
    let prime = match [ID, CODE, MESSAGE, MILLISECONDS, PICTURE].contains(&name) {
        true => PRIME.to_string(),
        false => String::new(),
    };
    let unit = unit.map_or(String::new(), |unit| format!(" [{unit}]"));
    format!("{name}{prime}{unit}")
}

/// Whether a check holds, and its margin, which is negative where it does not.
fn add_check(checked: &Checked, report: &Report, row: &mut Row) {
    let line = report
        .sources
        .at(checked.span)
        .map_or(0, |source| source.line_column(checked.span.start).0);
    let claim: Vec<&str> = checked.source.split_whitespace().collect();
    let claim = claim.join(" ");
    let claim = match claim.char_indices().nth(MOST_CLAIM) {
        Some((end, _)) => format!("{}…", &claim[..end]),
        None => claim,
    };
    let (verdict, unit) = (&checked.verdict, checked.verdict.unit());
    let margin = verdict.margin().map(|margin| match unit {
        DEGREES => in_degrees(Number::angle(margin)),
        _ => margin,
    });
    let unit = Some(unit).filter(|unit| !unit.is_empty());
    let mut title = format!("{line}: {claim}");
    while row.contains_key(&format!("check {title}")) {
        title.push('\'');
    }
    row.insert(format!("check {title}"), json!(verdict.holds));
    row.insert(titled(&format!("margin {title}"), unit), margin.map_or(Json::Null, number_cell));
}

/// The message of an error with its line.
fn error_message(error: &Diagnostic, report: &Report) -> String {
    let source = report.sources.at(error.primary.span);
    match source {
        Some(source) => {
            let (line, _) = source.line_column(error.primary.span.start);
            format!("{} ({}:{line})", error.message, source.name)
        }
        None => error.message.clone(),
    }
}
