//! What became of a file: its definitions, what its effects came to, what was found.

use super::claim::Verdict;
use crate::{
    diag::{Diagnostic, Span, Spanned},
    kernel::Tolerance,
    syntax::ast::{Kind, Unit},
    value::Value,
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
    /// Whether `all` leaves it out.
    pub is_hidden: bool,
}

/// A printed line.
#[derive(Clone, Debug)]
pub struct Printed {
    /// The expression as it was written.
    pub source: String,
    /// Its value.
    pub value: Value,
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

/// A file to be written.
#[derive(Clone, Debug)]
pub struct Exported {
    /// The path as the script gives it.
    pub path: Spanned<String>,
    /// What goes into it, under names for groups.
    pub subjects: Vec<(String, Spanned<Value>)>,
    /// The definitions that its subjects name.
    pub names: Vec<String>,
    /// Options after `with`.
    pub options: Vec<(Spanned<String>, Spanned<Value>)>,
}

/// What an effect came to.
#[derive(Clone, Debug)]
pub enum Output {
    /// `print`
    Printed(Printed),
    /// `check`
    Checked(Checked),
    /// `export`
    Exported(Exported),
}

/// The result of evaluating a file.
#[derive(Debug)]
pub struct Outcome {
    /// Every definition.
    pub definitions: Vec<Defined>,
    /// Every effect that could act, in the order of the source.
    pub outputs: Vec<Output>,
    /// What went wrong, in the order of the source.
    pub diagnostics: Vec<Diagnostic>,
    /// Settings that no parameter takes, each a sentence.
    pub unknown_settings: Vec<String>,
    /// The unit of length.
    pub unit: Unit,
    /// The tolerance.
    pub tolerance: Tolerance,
}

/// Puts findings into the order of the source, whatever thread they come from, each once: a
/// mistake in a function is told for the first call that meets it.
pub(crate) fn in_order(diagnostics: &mut Vec<Diagnostic>) {
    diagnostics.sort_by(|a, b| {
        (a.primary.span, a.code, &a.message).cmp(&(b.primary.span, b.code, &b.message))
    });
    diagnostics.dedup_by(|b, a| {
        (a.primary.span, a.code, &a.message) == (b.primary.span, b.code, &b.message)
    });
}
