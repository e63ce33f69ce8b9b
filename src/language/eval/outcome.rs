//! What became of a file: its definitions, what its effects came to, what was found.

use std::fmt;

use super::{claim::Verdict, memory::Work};
use crate::{
    diag::{Code, Diagnostic, Span, Spanned, shown},
    kernel::{Tolerance, sorting::sort_by},
    syntax::ast::{Kind, Unit},
    value::{Appearance, Value, table_text},
};

/// A definition with its value.
#[derive(Clone, Debug)]
pub struct Defined {
    /// Its name; `curve@LINE` where it has none.
    pub name: String,
    /// The promise of its keyword; `None` for `param` and `fn`.
    pub kind: Option<Kind>,
    /// Where its name stands.
    pub span: Span,
    /// Its value; `None` where evaluation failed.
    pub value: Option<Value>,
    /// How it came by its value.
    pub work: Work,
    /// In an incremental session the identity of its value: where it is the same in two runs, so is the
    /// value.
    pub identity: Option<u64>,
    /// How it is presented.
    pub look: Appearance,
}

/// A printed line.
#[derive(Clone, Debug)]
pub struct Printed {
    /// The expression as it was written.
    pub source: String,
    /// Where it stands.
    pub span: Span,
    /// Its value.
    pub value: Value,
    /// The document's unit of length, which its numbers are told in.
    pub unit: Unit,
    /// Whether the expression is a text itself, which says what it says without its source.
    pub is_text: bool,
}

/// What stands in the output, without the line break at the end: the text of a string that is written as
/// one, the rows of a table, or `source = value`.
impl fmt::Display for Printed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.value {
            Value::Text(text) if self.is_text => f.write_str(&shown(text)),
            Value::Table(table) => {
                let rows = if table.n_rows() == 1 { "row" } else { "rows" };
                let text = table_text(table);
                write!(
                    f,
                    "{} = table of {} {rows}\n{}",
                    self.heading(),
                    table.n_rows(),
                    text.trim_end()
                )
            }
            _ => write!(f, "{} = {}", self.source, self.value_text()),
        }
    }
}

/// Characters of an expression that stand over the rows of a table; of a longer one its beginning.
const HEADING: usize = 60;

impl Printed {
    /// The expression over the rows of a table.
    fn heading(&self) -> String {
        match self.source.char_indices().nth(HEADING) {
            Some((end, _)) => format!("{}…", self.source[..end].trim_end()),
            None => self.source.clone(),
        }
    }

    /// The value alone, its numbers with their units.
    #[must_use]
    pub fn value_text(&self) -> String {
        self.value.in_unit(self.unit.name()).to_string()
    }
}

/// A judged claim.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The claim as it was written.
    pub source: String,
    /// Where it stands.
    pub span: Span,
    /// The script's own text for the report.
    pub message: Option<String>,
    /// How it came out.
    pub verdict: Verdict,
}

/// A mistake that a test expects, and what happened.
#[derive(Clone, Debug)]
pub struct ExpectedMistake {
    /// The expression as it was written.
    pub source: String,
    /// Where it stands.
    pub span: Span,
    /// The code that it must fail with.
    pub code: Code,
    /// What it came to: its value, or how it failed.
    pub found: std::result::Result<String, Box<Diagnostic>>,
}

impl ExpectedMistake {
    /// Whether the expected error came.
    #[must_use]
    pub fn holds(&self) -> bool {
        matches!(&self.found, Err(found) if found.code == self.code)
    }
}

/// One thing that goes into a file.
#[derive(Clone, Debug)]
pub struct ExportSubject {
    /// What the file calls it.
    pub name: String,
    /// Its value.
    pub value: Spanned<Value>,
    /// How the definition is presented that it is, or is a part of.
    pub look: Appearance,
    /// The identity of its value, where it is a definition that has one.
    pub identity: Option<u64>,
}

/// A file to be written.
#[derive(Clone, Debug)]
pub struct Exported {
    /// The path as the script gives it.
    pub path: Spanned<String>,
    /// What goes into it.
    pub subjects: Vec<ExportSubject>,
    /// Whether it is the report of the script that goes into it.
    pub is_report: bool,
    /// The definitions that its subjects name.
    pub names: Vec<String>,
    /// Options after `with`.
    pub options: Vec<(Spanned<String>, Spanned<Value>)>,
}

/// What an effect came to.
#[derive(Clone, Debug)]
pub enum EffectOutput {
    /// `print`
    Printed(Printed),
    /// `check`
    Checked(Checked),
    /// `export`
    Exported(Exported),
    /// `expect error`
    Expected(ExpectedMistake),
}

/// What became of a test.
#[derive(Clone, Debug)]
pub struct TestOutcome {
    /// Its name.
    pub name: String,
    /// Where its name stands.
    pub span: Span,
    /// Every effect that could act, in the order of the source.
    pub outputs: Vec<EffectOutput>,
    /// What went wrong when it ran.
    pub diagnostics: Vec<Diagnostic>,
    /// Whether it has a mistake that kept it from running.
    pub is_poisoned: bool,
    /// Whether all of it could be evaluated.
    pub is_whole: bool,
}

/// The result of evaluating a file.
#[derive(Debug)]
pub struct Outcome {
    /// Every definition.
    pub definitions: Vec<Defined>,
    /// Every effect that could act, in the order of the source.
    pub outputs: Vec<EffectOutput>,
    /// The tests that were run, in the order of the source.
    pub tests: Vec<TestOutcome>,
    /// What went wrong outside of them, in the order of the source.
    pub diagnostics: Vec<Diagnostic>,
    /// Settings that no parameter takes, each a sentence.
    pub unknown_settings: Vec<String>,
    /// Whether nothing of the file itself lacks a value; of what it imports a part is enough.
    pub is_whole: bool,
    /// The unit of length.
    pub unit: Unit,
    /// The tolerance.
    pub tolerance: Tolerance,
}

/// Puts findings into the order of the source, whatever thread they come from, each once: a
/// mistake in a function is told for the first call that meets it.
pub(crate) fn in_order(diagnostics: &mut Vec<Diagnostic>) {
    let labels = |found: &Diagnostic| -> Vec<(Span, String)> {
        found.others.iter().map(|label| (label.span, label.text.clone())).collect()
    };
    // Of one mistake that is told with different labels the shortest list stays.
    sort_by(diagnostics, |a, b| {
        let own = (a.primary.span, a.code, &a.message, a.others.len());
        own.cmp(&(b.primary.span, b.code, &b.message, b.others.len()))
            .then_with(|| labels(a).cmp(&labels(b)))
    });
    diagnostics.dedup_by(|b, a| {
        (a.primary.span, a.code, &a.message) == (b.primary.span, b.code, &b.message)
    });
}
