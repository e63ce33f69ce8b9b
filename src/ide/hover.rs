//! What a name is and is worth, as Markdown.

use std::ops::Range;

use super::{
    DefinedName, Document, NameRole, Values, completion_spot::CompletionSpot, names::Meaning,
};
use crate::{
    docs, eval,
    session::Session,
    syntax::{self, ast::Unit},
    value::{Value, field_names, rounded},
};

/// Lines of the language's own text that a keyword shows.
const MOST_LINES: usize = 30;

impl Document {
    /// What stands at a byte, as Markdown, and its place. `values` are of the last run, if there was one.
    #[must_use]
    pub fn hover(
        &self,
        session: &Session,
        values: Option<&Values>,
        at: usize,
    ) -> Option<(String, Range<usize>)> {
        let registry = session.registry();
        let (meaning, place) = self.meaning(registry, at)?;
        let text = match meaning {
            Meaning::Name(name) => self.of_name(session, name, &place, values),
            Meaning::BuiltIn(name) => docs::markdown(registry, name)?,
            Meaning::Label { call: "with", label } => self.of_option(session, label, &place)?,
            Meaning::Key(label, value) => {
                let found = values
                    .and_then(|values| Some((values, self.local_value(session, values, &value)?)));
                let told = found.map(|(values, value)| values.description(&value));
                fenced(&format!("{label}: {}", told.or_else(|| self.kind_of(session, &value))?))
            }
            Meaning::Code(code) => {
                format!("**{}**: {}\n\n{}", code.id(), code.title(), code.explanation())
            }
            Meaning::Label { call, label } => {
                let (_, ops) = registry.get(call)?;
                let param =
                    ops.iter().flat_map(|op| op.params).find(|param| param.name == label)?;
                format!("{}\n\n{}", fenced(&param.signature()), docs::paragraph(param.docs))
            }
            Meaning::Field { of, field } => {
                let value = of.and_then(|of| self.field(values?, of, field));
                let values = values?;
                fenced(&format!(".{field} = {}", values.description(&value?)))
            }
            Meaning::Keyword(word) => {
                let entry = docs::language::markdown(word)?;
                entry.lines().take(MOST_LINES).collect::<Vec<_>>().join("\n")
            }
            Meaning::Number(text) => conversions(text)?,
        };
        Some((text, place))
    }

    /// The geometry that a name at a byte stands for, which a hover can show a picture of.
    #[must_use]
    pub fn shown_geometry<'v>(
        &self,
        session: &Session,
        values: &'v Values,
        at: usize,
    ) -> Option<&'v Value> {
        let (Meaning::Name(name), place) = self.meaning(session.registry(), at)? else {
            return None;
        };
        self.value_of(name, &place, values)
    }

    /// The value of a field of what a name of the script stands for.
    fn field(&self, values: &Values, of: &str, field: &str) -> Option<Value> {
        let value = values.value(of)?;
        if !field_names(value).contains(&field) {
            return None;
        }
        let tolerance = values.report().document.1;
        crate::value::field(value, field, tolerance).ok().flatten()
    }

    /// The value of a definition, also of one that is reached through an import.
    pub(super) fn value_of<'v>(
        &self,
        name: &DefinedName,
        place: &Range<usize>,
        values: &'v Values,
    ) -> Option<&'v Value> {
        if !name.is_of_file {
            return None;
        }
        let is_own = self.outline.defined_at(&name.place).is_some_and(|own| own == name);
        if is_own {
            return values.value(&name.name);
        }
        // `part.name`, or a name that an import lists.
        let idx = self.piece_at(place.start)?;
        let before = idx.checked_sub(1).map_or("", |before| self.piece(before));
        if before != "." {
            return values.value(&name.name);
        }
        match values.value(self.piece(idx.checked_sub(2)?))? {
            Value::Record(record) => record.get(&name.name),
            _ => None,
        }
    }

    fn of_name(
        &self,
        session: &Session,
        name: &DefinedName,
        place: &Range<usize>,
        values: Option<&Values>,
    ) -> String {
        let value = values.and_then(|values| Some((values, self.value_of(name, place, values)?)));
        let mut out = fenced(&signature_with(name, value.map(|(_, value)| value)));
        match value {
            Some((_, Value::Function(_))) if name.role == NameRole::Function => {}
            Some((_, Value::Function(function))) => {
                out.push_str(&format!("\n\nfunction `{}`", function.signature()));
            }
            Some((values, value)) => {
                out.push_str(&format!("\n\n{}", values.description(value)));
                if !values.are_of(self) {
                    out.push_str(" *(before the last edit)*");
                }
            }
            None => {
                let told = self.of_local(session, name, values);
                out.extend(told.map(|told| format!("\n\n{told}")));
            }
        }
        if let Some(label) = &name.label {
            out.push_str(&format!("\n\n*{}*", label.replace('*', "\\*")));
        }
        if let Some(docs) = &name.docs {
            out.push_str(&format!("\n\n{}", docs::paragraph(docs)));
        }
        out
    }

    /// The value of a definition without one in the last run, or else its kind.
    fn of_local(
        &self,
        session: &Session,
        name: &DefinedName,
        values: Option<&Values>,
    ) -> Option<String> {
        let is_own = self.outline.defined_at(&name.place) == Some(name);
        let place = name.value.as_ref().filter(|_| is_own)?;
        if !matches!(name.role, NameRole::Definition(_)) {
            return None;
        }
        let found = values.and_then(|values| {
            let value = self.local_value(session, values, place).filter(|_| !name.is_of_file)?;
            Some(match &value {
                Value::Function(function) => format!("function `{}`", function.signature()),
                value => values.description(value),
            })
        });
        found.or_else(|| self.kind_of(session, place))
    }

    /// What an expression is, by its form.
    fn kind_of(&self, session: &Session, expr: &Range<usize>) -> Option<String> {
        let registry = session.registry();
        let spot =
            CompletionSpot { document: self, session, registry, values: None, at: expr.start };
        Some(spot.owner(self.text.get(expr.clone())?)?.words())
    }

    /// What an option behind `with` takes.
    fn of_option(&self, session: &Session, label: &str, place: &Range<usize>) -> Option<String> {
        let registry = session.registry();
        let spot =
            CompletionSpot { document: self, session, registry, values: None, at: place.start };
        let call = syntax::open_call(&self.text, place.start)?;
        match call.statement {
            Some("import") => {
                let params = spot.params_of_file(&call);
                let param = params.into_iter().find(|param| param.name == label)?;
                let docs = param.docs.as_deref().map(docs::paragraph).unwrap_or_default();
                Some(format!("{}\n\n{docs}", fenced(&signature(param))))
            }
            Some("export") => {
                let option = spot.export_options().into_iter().find(|one| one.name == label)?;
                Some(format!("{}\n\ntakes {}", fenced(&format!("{label} =")), option.wants))
            }
            _ => {
                let (_, wants) = eval::LOOK_OPTIONS.into_iter().find(|(name, _)| *name == label)?;
                Some(format!("{}\n\ntakes {wants}", fenced(&format!("{label} ="))))
            }
        }
    }
}

/// A definition on one line: `curve keel`, `fn twice(x, by = 2)`.
pub(super) fn signature(name: &DefinedName) -> String {
    signature_with(name, None)
}

/// The same; a parameter names the kind of its value where it states none.
fn signature_with(name: &DefinedName, value: Option<&Value>) -> String {
    let text = &name.name;
    match name.role {
        NameRole::Param => {
            let kind = name.kind.as_deref().or_else(|| eval::param_kind(value?));
            let kind = kind.map(|kind| format!(": {kind}")).unwrap_or_default();
            let allowed = name.allowed.iter().map(|allowed| format!(" {allowed}"));
            format!("param {text}{kind}{}", allowed.collect::<String>())
        }
        NameRole::Import => format!("import {text}"),
        NameRole::Parameter => format!("(parameter) {text}"),
        NameRole::Variable => format!("(variable) {text}"),
        NameRole::Definition(kind) => format!("{} {text}", kind.word()),
        NameRole::Function => {
            let parameters: Vec<String> = name.parameters.iter().map(parameter).collect();
            format!("fn {text}({})", parameters.join(", "))
        }
    }
}

/// A parameter with its default.
pub(super) fn parameter((name, default): &(String, Option<String>)) -> String {
    match default {
        Some(default) => format!("{name} = {default}"),
        None => name.clone(),
    }
}

/// Code of the language.
pub(super) fn fenced(code: &str) -> String {
    format!("```geo\n{code}\n```")
}

/// A number with a unit in the other units of its kind.
fn conversions(text: &str) -> Option<String> {
    let digits = text.trim_end_matches(|c: char| c.is_alphabetic());
    let unit = Unit::from_name(&text[digits.len()..])?;
    let value: f64 = digits.replace('_', "").parse().ok()?;
    let told = |(name, size): (&str, f64)| format!("{} {name}", rounded(size));
    let all: Vec<String> = match unit.millimetres() {
        Some(size) => {
            let lengths = Unit::ALL.iter().filter(|(_, other)| *other != unit);
            lengths
                .filter_map(|(name, other)| Some(told((name, value * size / other.millimetres()?))))
                .collect()
        }
        None => {
            let turns = match unit {
                Unit::Deg => value / 360.0,
                Unit::Turn => value,
                _ => value / std::f64::consts::TAU,
            };
            let all = [
                ("deg", 360.0, Unit::Deg),
                ("rad", std::f64::consts::TAU, Unit::Rad),
                ("turn", 1.0, Unit::Turn),
            ];
            all.into_iter()
                .filter(|(.., other)| *other != unit)
                .map(|(name, size, _)| told((name, turns * size)))
                .collect()
        }
    };
    Some(format!("{}\n\n= {}", fenced(text), all.join(" = ")))
}
