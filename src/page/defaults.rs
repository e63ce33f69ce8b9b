//! Values of parameters written into a script: the text of their defaults, and nothing else.

use std::ops::Range;

use crate::{
    eval::{Schema, SchemaParameter},
    limits::Limits,
    session::Session,
    syntax::{
        self,
        ast::{ExprKind, StatementKind, Unit},
    },
    value::{Dimension, Files, NoFiles, Value, shortest_in},
};

/// The script with other defaults.
///
/// # Errors
/// A sentence where a value is none for its parameter.
pub(crate) fn rewritten(
    text: &str,
    given: &[(String, String)],
    session: &Session,
    files: &dyn Files,
) -> Result<String, String> {
    let schema = |text: &str| session.parameters("script", text.as_bytes(), files);
    let old = schema(text).map_err(|_| "the script has errors; mend them first")?;
    let mut new = text.to_owned();
    for (name, value) in given {
        let parameter = parameter(&old, name)?;
        let place = default_place(&new, name, session.limits())
            .ok_or_else(|| format!("the script has no parameter `{name}`"))?;
        let value = as_written(value, parameter, old.unit.name());
        if !is_literal(&value, old.unit.name(), session) {
            return Err(format!("`{value}` is not a value that a script could write"));
        }
        let value = in_unit_of(&new[place.clone()], value, old.unit.name(), session.limits());
        let mut next = new.clone();
        next.replace_range(place.clone(), &value);
        // The value is one expression: what stood around it stands there still.
        let expected = place.start..place.start + value.len();
        if default_place(&next, name, session.limits()) != Some(expected) {
            return Err(format!("`{value}` is not a value that a script could write"));
        }
        new = next;
    }
    let found = schema(&new).map_err(|report| {
        let first = report.diagnostics.first();
        first.map_or_else(|| "the value is refused".to_owned(), |found| found.message.clone())
    })?;
    for (name, value) in given {
        let (before, after) = (parameter(&old, name)?, parameter(&found, name)?);
        if before.kind != after.kind {
            return Err(format!("`{value}` would make `{name}` a {}", after.kind));
        }
    }
    Ok(new)
}

fn parameter<'s>(schema: &'s Schema, name: &str) -> Result<&'s SchemaParameter, String> {
    let found = schema.parameters.iter().find(|parameter| parameter.name == name);
    found.ok_or_else(|| format!("the script has no parameter `{name}`"))
}

/// A value as a script writes it: strings in quotes, lengths with a unit.
fn as_written(value: &str, parameter: &SchemaParameter, unit: &str) -> String {
    match &parameter.default {
        Value::Text(_) => Value::text(value).to_string(),
        Value::Number(number)
            if number.dim == Dimension::LENGTH && value.trim().parse::<f64>().is_ok() =>
        {
            format!("{}{unit}", value.trim())
        }
        _ => value.trim().to_owned(),
    }
}

/// Whether a value says the same wherever it stands: no name of the script is in it.
fn is_literal(value: &str, unit: &str, session: &Session) -> bool {
    let alone = format!("unit {unit}\nparam value = {value}\n");
    session.parameters("value", alone.as_bytes(), &NoFiles).is_ok()
}

/// A number with the document's unit, in the unit that stands in its place, unless that takes more digits.
fn in_unit_of(old: &str, value: String, unit: &str, limits: &Limits) -> String {
    let (Some((_, own)), Some((number, given))) = (measure(old, limits), measure(&value, limits))
    else {
        return value;
    };
    if given != unit || own == given {
        return value;
    }
    let Some(shortest) = shortest_in(number, own, unit) else { return value };
    let text = format!("{shortest}{own}");
    if text.len() <= value.len() + MORE_DIGITS { text } else { value }
}

/// How many characters longer a number may become in the unit of the script's author: `1mm` is `0.1cm`.
const MORE_DIGITS: usize = 2;

/// A number that is written with a unit of length.
fn measure(text: &str, limits: &Limits) -> Option<(f64, &'static str)> {
    let source = format!("param value = {text}");
    let (tree, found) = syntax::parse(&source, limits);
    let [statement] = &tree.statements[..] else { return None };
    let StatementKind::Param(param) = &statement.kind else { return None };
    let ExprKind::Number(number, Some(unit)) = param.default.kind else { return None };
    let (name, _) = Unit::ALL.iter().find(|(_, known)| *known == unit)?;
    found.is_empty().then_some((number, *name))
}

/// Where the default of a parameter stands in a text without mistakes.
fn default_place(text: &str, name: &str, limits: &Limits) -> Option<Range<usize>> {
    let (tree, found) = syntax::parse(text, limits);
    if !found.is_empty() {
        return None;
    }
    tree.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Param(param) if param.name.text == name => Some(param.default.span.range()),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::{Session, rewritten};
    use crate::value::NoFiles;

    fn written(text: &str, given: &[(&str, &str)]) -> Result<String, String> {
        let given: Vec<(String, String)> =
            given.iter().map(|&(name, value)| (name.to_owned(), value.to_owned())).collect();
        rewritten(text, &given, &Session::default(), &NoFiles)
    }

    #[test]
    fn only_the_default_changes() {
        let text = "// größe 10mm\nparam  neck=10mm   in 5mm..20mm // here\nparam s = \"a\"\nprint neck, s\n";
        let new = written(text, &[("neck", "12.5"), ("s", "say \"no\"")]);
        let expected = text.replace("neck=10mm", "neck=12.5mm").replace("\"a\"", r#""say \"no\"""#);
        assert_eq!(new, Ok(expected));
    }

    #[test]
    fn what_a_person_wrote_stands_as_it_is_written_and_lengths_in_the_units_of_the_script() {
        let text = "unit mm\nparam a = 2cm\nparam b = 5in\nparam c = pi / 4\nparam d = 3mm\n";
        for (name, value, expected) in [
            ("a", "30mm", "a = 3cm"),
            ("a", "12.5", "a = 1.25cm"),
            ("a", "1in", "a = 1in"),
            ("b", "25.4mm", "b = 1in"),
            ("b", "10mm", "b = 10mm"),
            ("c", "pi/3", "c = pi/3"),
            ("d", "2mm + 1mm", "d = 2mm + 1mm"),
        ] {
            let new = written(text, &[(name, value)]);
            assert!(new.as_ref().is_ok_and(|new| new.contains(expected)), "{value}: {new:?}");
        }
    }

    #[test]
    fn what_is_no_value_of_the_parameter_changes_nothing() {
        let text = "param neck = 10mm in 5mm..20mm\nparam n = 3\n";
        for (name, value) in [
            ("neck", "30mm"),
            ("neck", "30deg"),
            ("n", "2mm"),
            ("n", "1\nexport all to \"x.stl\""),
            ("n", "1 // and more"),
            ("n", "1 in 0..9"),
            ("n", ""),
            ("other", "1"),
            ("neck", "n * 1mm"),
            ("n", "n"),
        ] {
            assert!(written(text, &[(name, value)]).is_err(), "{name} = {value}");
        }
    }
}
