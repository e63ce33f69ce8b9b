//! What is shown between the lines: values, kinds, names of parameters, margins of claims.

use std::ops::Range;

use super::{ActKind, Document, NameRole, Values};
use crate::{
    kernel::sorting::sort_by_key,
    session::TestVerdict,
    syntax::ast::Kind,
    value::{Registry, Value},
};

/// Which hints are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HintOptions {
    /// Values of definitions.
    pub values: bool,
    /// Kinds of what `let` defines.
    pub kinds: bool,
    /// Names of parameters before arguments.
    pub parameters: bool,
    /// Margins of claims.
    pub margins: bool,
}

impl Default for HintOptions {
    fn default() -> Self {
        Self { values: true, kinds: true, parameters: true, margins: true }
    }
}

/// What a hint tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HintKind {
    /// A value, behind its definition.
    Value,
    /// A kind, behind a name.
    Kind,
    /// A parameter, before an argument.
    Parameter,
    /// How well a claim holds.
    Margin,
}

/// Text that is shown and does not stand there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// Before which byte.
    pub at: usize,
    /// The text.
    pub text: String,
    /// What it tells.
    pub kind: HintKind,
}

/// What a line above a statement offers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LensKind {
    /// Runs a test.
    Test {
        /// Its name.
        name: String,
        /// How it came out, if it was run.
        verdict: Option<TestVerdict>,
    },
    /// A claim came out so.
    Check {
        /// Whether it holds.
        holds: bool,
        /// The figures.
        figures: String,
    },
    /// Shows this definition.
    View(String),
}

/// A line above a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeLens {
    /// The statement.
    pub range: Range<usize>,
    /// What it offers.
    pub kind: LensKind,
}

impl Document {
    /// The hints within a range of the text, in order. `values` must be of this text.
    #[must_use]
    pub fn hints(
        &self,
        registry: &Registry,
        values: Option<&Values>,
        within: &Range<usize>,
        shown: HintOptions,
    ) -> Vec<Hint> {
        let mut found = Vec::new();
        let is_within =
            |range: &Range<usize>| range.start < within.end && within.start <= range.end;
        if let Some(values) = values {
            let names = self.outline.of_file().filter(|name| is_within(&name.whole));
            for name in
                names.filter(|name| matches!(name.role, NameRole::Definition(_) | NameRole::Param))
            {
                let (Some(value), Some(place)) = (values.value(&name.name), &name.value) else {
                    continue;
                };
                let kind = NameRole::Definition(Kind::Let);
                match values.brief(value) {
                    Some(text) if shown.values && !name.is_literal => {
                        found.push(Hint {
                            at: place.end,
                            text: format!(" = {text}"),
                            kind: HintKind::Value,
                        });
                    }
                    None if shown.kinds
                        && name.role == kind
                        && !matches!(value, Value::Function(_)) =>
                    {
                        let text = format!(": {}", kind_of(value));
                        found.push(Hint { at: name.place.end, text, kind: HintKind::Kind });
                    }
                    _ => {}
                }
            }
            let checks = self
                .outline
                .acts
                .iter()
                .filter(|act| act.kind == ActKind::Check && is_within(&act.whole));
            for act in checks.filter(|_| shown.margins) {
                if let Some(checked) = values.checked(&act.subject) {
                    let text = format!(" {}", checked.verdict.figures());
                    found.push(Hint { at: act.whole.end, text, kind: HintKind::Margin });
                }
            }
        }
        if shown.parameters {
            self.parameter_hints(registry, &is_within, &mut found);
        }
        sort_by_key(&mut found, |hint| hint.at);
        found
    }

    /// The names of parameters before arguments that are written as values.
    fn parameter_hints(
        &self,
        registry: &Registry,
        is_within: &dyn Fn(&Range<usize>) -> bool,
        found: &mut Vec<Hint>,
    ) {
        for call in self.outline.calls.iter().filter(|call| is_within(&call.name)) {
            let text = self.text.get(call.name.clone()).unwrap_or_default();
            let names: Vec<String> = match self.definition_of(&call.name) {
                Some(name) => name.parameters.iter().map(|(name, _)| name.clone()).collect(),
                None => match registry.get(text).map(|(_, ops)| &ops[..]) {
                    // Of several that share a name nobody knows which is meant; a list without its
                    // brackets has no names.
                    Some([op]) if !op.params.first().is_some_and(|param| param.spreads) => {
                        op.params.iter().map(|param| param.name.to_owned()).collect()
                    }
                    _ => Vec::new(),
                },
            };
            if names.len() < 2 {
                continue;
            }
            let names = names.iter().skip(usize::from(call.is_piped));
            let by_position = call.arguments.iter().filter(|(_, is_labelled, _)| !is_labelled);
            for ((place, _, is_literal), name) in by_position.zip(names) {
                // One letter tells nobody anything.
                if *is_literal && 1 < name.chars().count() {
                    found.push(Hint {
                        at: place.start,
                        text: format!("{name}: "),
                        kind: HintKind::Parameter,
                    });
                }
            }
        }
    }

    /// The lines above statements: of tests, of claims where `values` are of this text, of geometry. Claims of a test
    /// have theirs when it was run.
    #[must_use]
    pub fn lenses(&self, values: Option<&Values>) -> Vec<CodeLens> {
        let mut found = Vec::new();
        for act in &self.outline.acts {
            let range = act.whole.clone();
            match act.kind {
                ActKind::Test => {
                    let name = self.text.get(act.subject.clone()).unwrap_or_default();
                    let tested = values.and_then(|values| values.tested(&act.subject));
                    let kind = LensKind::Test {
                        name: name.trim_matches('"').to_owned(),
                        verdict: tested.map(|test| test.verdict),
                    };
                    found.push(CodeLens { range, kind });
                }
                ActKind::Check => {
                    let Some(checked) = values.and_then(|values| values.checked(&act.subject))
                    else {
                        continue;
                    };
                    let verdict = &checked.verdict;
                    let kind = LensKind::Check { holds: verdict.holds, figures: verdict.figures() };
                    found.push(CodeLens { range, kind });
                }
                _ => {}
            }
        }
        let geometry = self
            .outline
            .of_file()
            .filter(|name| matches!(name.role, NameRole::Definition(kind) if kind.is_geometry()));
        found.extend(geometry.map(|name| CodeLens {
            range: name.whole.clone(),
            kind: LensKind::View(name.name.clone()),
        }));
        sort_by_key(&mut found, |lens| lens.range.start);
        found
    }
}

/// What a value without a short form is.
fn kind_of(value: &Value) -> String {
    match value {
        Value::List(_) => value.phrase().trim_start_matches("a ").to_owned(),
        Value::Curve(_) | Value::Surface(_) => value.phrase().trim_start_matches("a ").to_owned(),
        _ => value.kind().to_owned(),
    }
}
