//! The value of what a block, a function or a test defines, where it depends on nothing that is given to a function: from
//! the definitions that it needs, as a small script of its own.

use std::{collections::BTreeSet, fmt::Write as _, ops::Range};

use super::{DefinedName, Document, NameRole, Values};
use crate::{
    limits::Limits,
    session::Session,
    syntax::Highlight,
    value::{Dimension, NoFiles, Number, Value},
};

/// Steps that such a script may take: a hover waits for it.
const MOST_STEPS: u64 = 100_000;
/// Definitions that it may need.
const MOST_DEFINITIONS: usize = 100;

impl Document {
    /// The value of an expression of this text, as far as it can quickly be known. `values` are of the last run.
    pub(super) fn local_value(
        &self,
        session: &Session,
        values: &Values,
        expr: &Range<usize>,
    ) -> Option<Value> {
        if !values.are_of(self) {
            return None;
        }
        let (unit, tolerance) = values.report().document;
        let mut slice = DefinitionSlice {
            document: self,
            values,
            script: format!("unit {}\ntolerance {}\n", unit.name(), tolerance.distance),
            taken: BTreeSet::new(),
        };
        slice.need(expr, expr)?;
        let mut wanted = "it".to_owned();
        while self.text.contains(&wanted) {
            wanted.push('_');
        }
        let script = format!("{}let {wanted} = {}", slice.script, self.text.get(expr.clone())?);
        let limits = Limits { steps: MOST_STEPS, ..*session.limits() };
        let report = Session::new(limits).run("", script.as_bytes(), &NoFiles, &[]);
        report.definitions.into_iter().find(|one| one.name == wanted)?.value
    }
}

/// The definitions that an expression needs, in the order in which they do.
struct DefinitionSlice<'d> {
    document: &'d Document,
    values: &'d Values,
    script: String,
    /// Where the names of those stand that are in it.
    taken: BTreeSet<usize>,
}

impl DefinitionSlice<'_> {
    /// Takes in what the names in `expr` mean, unless they are defined inside of `own`; none where something depends on
    /// what is given to a function.
    fn need(&mut self, expr: &Range<usize>, own: &Range<usize>) -> Option<()> {
        let document = self.document;
        let first = document.pieces.partition_point(|(_, place)| place.start < expr.start);
        for idx in first..document.pieces.len() {
            let (paint, place) = &document.pieces[idx];
            if expr.end <= place.start {
                break;
            }
            let before = idx.checked_sub(1).map_or("", |before| document.piece(before));
            let is_label = document.piece(idx + 1) == "=" && matches!(before, "(" | ",");
            let is_key = document.piece(idx + 1) == ":" && matches!(before, "{" | ",");
            if *paint != Highlight::Name || before == "." || is_label || is_key {
                continue;
            }
            let Some(name) = document.definition_of(place) else { continue };
            let is_own = document.outline.defined_at(&name.place) == Some(name);
            if !is_own {
                return None;
            }
            if own.start <= name.place.start && name.place.end <= own.end {
                continue;
            }
            self.take(name)?;
        }
        Some(())
    }

    /// Takes in a definition, after those that it needs.
    fn take(&mut self, name: &DefinedName) -> Option<()> {
        if !self.taken.insert(name.place.start) {
            return Some(());
        }
        if MOST_DEFINITIONS < self.taken.len() || name.is_part {
            return None;
        }
        let known = self.values.value(&name.name).filter(|_| name.is_of_file);
        if let Some(text) = known.and_then(|value| self.spelled(value)) {
            return writeln!(self.script, "let {} = {text}", name.name).ok();
        }
        let text = match name.role {
            NameRole::Function => {
                self.need(&name.whole, &name.whole)?;
                self.document.text.get(name.whole.clone())?.to_owned()
            }
            NameRole::Definition(_) => {
                let value = name.value.clone()?;
                self.need(&value, &value)?;
                format!("let {} = {}", name.name, self.document.text.get(value)?)
            }
            _ => return None,
        };
        writeln!(self.script, "{text}").ok()
    }

    /// A value as a script says it, to the last bit; none of what is too large for that.
    fn spelled(&self, value: &Value) -> Option<String> {
        let unit = self.values.report().document.0.name();
        Some(match value {
            Value::Number(number) => match number {
                Number { value, dim } if *dim == Dimension::LENGTH => format!("({value}{unit})"),
                Number { value, dim } if *dim == Dimension::ANGLE => format!("({value}rad)"),
                Number { value, .. } if Number::bare(*value) == *number => format!("({value})"),
                _ => return None,
            },
            Value::Bool(truth) => truth.to_string(),
            Value::Point(at) => format!("({}, {}, {})", at.x, at.y, at.z),
            Value::Text(text) if !text.contains(['\\', '"', '{', '\n']) => format!("\"{text}\""),
            _ => return None,
        })
    }
}
