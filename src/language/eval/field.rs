//! Fields of values, and what is told of one that is not there.

use super::{
    autodiff::{no_derivative, through},
    lower::foreign_names::advice as foreign_advice,
    machine::Machine,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::Tolerance,
    value::{At, Value, field, field_names},
};

/// Fields that depend on the shape of a curve or surface alone, not on its knots and control points.
const OF_SHAPE: [&str; 12] = [
    "domain", "domain_u", "domain_v", "degree", "degree_u", "degree_v", "start", "end", "closed",
    "closed_u", "closed_v", "rational",
];

/// Fields that a message lists.
const MOST_FIELDS_TOLD: usize = 40;

/// Fields with which a misspelt one is compared.
const MOST_NAMES: usize = 200;

impl Machine<'_> {
    /// The field of a value; `subject` is what it stands behind, `place` its name.
    pub(super) fn field_of(
        &self,
        value: &Value,
        subject: Span,
        name: &str,
        place: Span,
    ) -> Result<Value> {
        let tolerance = self.env.tolerance;
        if value.is_jet() && field_names(value).contains(&name) {
            return varying_field(value, name, place, tolerance);
        }
        if let Some(found) = field(value, name, tolerance).at(place)? {
            return Ok(found);
        }
        let names = field_names(value);
        let message = format!("{} has no field `{name}`", value.phrase());
        let first = match value {
            Value::List(items) => items.first(),
            _ => None,
        };
        let mut diagnostic = Diagnostic::error(Code::NoField, place, message)
            .also(subject, format!("this is {}", value.phrase()));
        if let Some(near) = crate::diag::nearest(name, names.iter().copied().take(MOST_NAMES)) {
            diagnostic = diagnostic.meant(near);
        }
        if let Some(first) = first
            && field_names(first).contains(&name)
        {
            let list = self.env.repeated(subject).unwrap_or_else(|| "xs".to_owned());
            diagnostic = diagnostic.hint(format!(
                "its elements have: `{list}[0].{name}`, or of all `[for x in {list}: x.{name}]`"
            ));
        } else if let (Value::List(items), "x" | "y" | "z") = (value, name)
            && let 2..=3 = items.len()
            && items.values().all(|item| matches!(item, Value::Number(_)))
        {
            let list = self.env.repeated(subject).unwrap_or_else(|| "xs".to_owned());
            diagnostic = diagnostic
                .hint(format!("a list has elements; a point of it is `({list}[0], {list}[1])`"));
        } else if let Some(call) = self.env.instead_of_field(subject, value, name) {
            diagnostic = diagnostic.hint(call);
        } else if matches!(value, Value::List(_))
            && let Some(advice) = foreign_advice(name)
        {
            diagnostic = diagnostic.hint(advice);
        }
        let told = names.iter().take(MOST_FIELDS_TOLD).map(|name| shown_field(name));
        let list: Vec<String> = told.collect();
        if !list.is_empty() {
            let rest = if list.len() < names.len() { " ..." } else { "" };
            diagnostic = diagnostic.hint(format!("its fields are {}{rest}", list.join(" ")));
        }
        diagnostic.fail()
    }
}

/// The field of a value that carries derivatives, with its own.
fn varying_field(value: &Value, name: &str, place: Span, tolerance: Tolerance) -> Result<Value> {
    let told = format!("`.{name}`");
    match value {
        Value::JetRegion(_) | Value::JetSolid(_) => return no_derivative(&told, place),
        Value::JetCurve(_) | Value::JetSurface(_) => {}
        _ => return Ok(field(value, name, tolerance).at(place)?.unwrap_or(Value::None)),
    }
    let read = |args: &[Value]| match args {
        [of, ..] => Ok(field(of, name, tolerance).at(place)?.unwrap_or(Value::None)),
        [] => Ok(Value::None),
    };
    let is_of_shape = OF_SHAPE.contains(&name);
    through((&told, is_of_shape), place, std::slice::from_ref(value), read)
}

/// How a script reaches a field: `.x`, or `["half breadth"]` where the name is no word.
fn shown_field(name: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let starts_well = name.starts_with(|c: char| is_word(c) && !c.is_numeric());
    if starts_well && name.chars().all(is_word) {
        format!("`.{name}`")
    } else {
        format!("`[{name:?}]`")
    }
}
