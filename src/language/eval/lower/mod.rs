//! From the tree of a script to the program that runs: every name is resolved here, all at once,
//! before anything is evaluated.

mod block;
mod expr;
pub(in crate::eval) mod foreign_names;
mod graph;
mod growing;
mod import;
mod name_walk;
mod scope;
mod script;
mod statement;
mod test;
mod uses;

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use scope::Scopes;
pub(super) use script::ScriptCall;
use uses::Uses;

use super::{
    ir::{CaptureSource, Definition, DefinitionRole, Expr, ExprKind, Program},
    name_uses::NotedNames,
    outcome::Defined,
};
use crate::{
    diag::{Code, Diagnostic, Fix, Severity, Span, nearest},
    kernel::Tolerance,
    syntax::ast::{self, Statement, Tree, Unit},
    value::{Function, Registry, Value},
};

/// The program of a script, and what is wrong with its names.
pub(crate) struct Lowered {
    pub(crate) program: Program,
    pub(crate) diagnostics: Vec<Diagnostic>,
    pub(super) noted: NotedNames,
    /// The scripts that its calls name, not looked for yet.
    pub(super) scripts: Vec<ScriptCall>,
}

/// What is known of a text besides its tree.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Origin<'a> {
    /// The text.
    pub(crate) text: &'a str,
    /// Its first byte in all sources.
    pub(crate) base: u32,
    /// Where it does not parse, as places in all sources, in order. A statement with such a place has had
    /// its message: it is neither judged nor evaluated.
    pub(crate) faults: &'a [Span],
    /// What the paths of its imports stand for, with the first byte of each, in the order of the
    /// text; empty where a file could not be had.
    pub(crate) imports: &'a [(u32, Option<Imported>)],
    /// Definitions beside the text, with their values.
    pub(crate) known: &'a [Defined],
}

/// What is known of an imported file.
#[derive(Clone, Debug)]
pub(crate) struct Imported {
    /// Its place in the library.
    pub(crate) file: usize,
    /// Its path.
    pub(crate) path: String,
    /// The names that it defines with their places, private ones included.
    pub(crate) names: Vec<(Arc<str>, Span)>,
}

impl Imported {
    /// The names of the file as parts of the name or path at this place.
    pub(super) fn parts_of(&self, whole: Span) -> impl Iterator<Item = (Span, Arc<str>, Span)> {
        self.names.iter().map(move |(name, place)| (whole, Arc::clone(name), *place))
    }
}

/// The places of syntax errors among findings, in order.
pub(crate) fn faults(found: &[Diagnostic]) -> Vec<Span> {
    let errors = found.iter().filter(|found| found.severity == Severity::Error);
    let mut faults: Vec<Span> = errors.map(|found| found.primary.span).collect();
    faults.sort_unstable();
    faults
}

/// Lowers the tree of a text, in this unit unless it states another.
pub(crate) fn lower<'s>(
    tree: &Tree<'s>,
    origin: Origin<'s>,
    registry: &Registry,
    unit: Unit,
) -> Lowered {
    let mut lowerer = Lowerer {
        registry,
        origin,
        is_faulty: false,
        unit,
        tolerance: Tolerance::DEFAULT,
        globals: BTreeMap::new(),
        tested: None,
        first: 0,
        scopes: Scopes::default(),
        uses: Uses::default(),
        imports: BTreeSet::new(),
        n_unknown: 0,
        is_poisoned: false,
        noted: NotedNames::default(),
        scripts: Vec::new(),
        diagnostics: Vec::new(),
    };
    lowerer.header(&tree.statements);
    let mut program = lowerer.program(&tree.statements);
    program.tests = lowerer.tests(&tree.statements, program.definitions.len());
    let Lowerer { diagnostics, noted, scripts, .. } = lowerer;
    Lowered { program, diagnostics, noted, scripts }
}

/// Unknown names for which the nearest known one is looked for: more than anybody reads, and few
/// enough that a file full of them takes no time.
const MOST_SUGGESTIONS: usize = 100;

/// The state of lowering one file.
struct Lowerer<'a, 's> {
    registry: &'a Registry,
    origin: Origin<'s>,
    /// Whether the statement under way did not parse as it stands.
    is_faulty: bool,
    unit: Unit,
    tolerance: Tolerance,
    /// Definitions of the file: index and place of the name.
    globals: BTreeMap<&'s str, (usize, Span)>,
    /// Definitions of the test under way.
    tested: Option<BTreeMap<&'s str, (usize, Span)>>,
    /// The number of the first definition of the file or test under way.
    first: usize,
    scopes: Scopes<'s>,
    /// What the definition under way uses.
    uses: Uses,
    /// The definitions that are whole imports.
    imports: BTreeSet<usize>,
    /// Names without a meaning so far.
    n_unknown: usize,
    /// Whether a mistake was found in the definition under way.
    is_poisoned: bool,
    /// What names mean, as places.
    noted: NotedNames,
    /// The scripts that calls name.
    scripts: Vec<ScriptCall>,
    diagnostics: Vec<Diagnostic>,
}

impl<'s> Lowerer<'_, 's> {
    /// The place in all sources.
    fn at(&self, span: Span) -> Span {
        span.shifted(self.origin.base)
    }

    /// Records a mistake in the definition under way.
    fn report(&mut self, diagnostic: Diagnostic) {
        self.is_poisoned = true;
        if !self.is_faulty {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Begins a statement: whether it parsed decides what may be said about it.
    fn begin(&mut self, statement: Span) {
        let Span { start, end } = self.at(statement);
        let text = self.origin.text;
        let follows = |fault: Span| {
            let gap = (end - self.origin.base) as usize..(fault.start - self.origin.base) as usize;
            text.get(gap).is_some_and(|gap| gap.chars().all(|c| c == ' ' || c == '\t'))
        };
        let concerns = |fault: &Span| fault.start < end || follows(*fault);
        // The places are in order, so that the first one from here on tells.
        let first = self.origin.faults.partition_point(|fault| fault.start < start);
        self.is_faulty = self.origin.faults.get(first).is_some_and(concerns);
        self.is_poisoned = self.is_faulty;
    }

    /// Whether a statement that did not parse may define `name`: the text has `name =` somewhere,
    /// or `name` behind a keyword that defines.
    fn may_be_defined(&self, name: &str) -> bool {
        let text = self.origin.text;
        !self.origin.faults.is_empty()
            && text.match_indices(name).any(|(at, _)| {
                let (before, rest) = (text[..at].trim_end(), text[at + name.len()..].trim_start());
                rest.starts_with('=') && !rest.starts_with("==")
                    || before.len() < at && is_definition_word(before)
            })
    }

    fn poison(&mut self, span: Span) -> Expr {
        self.is_poisoned = true;
        Expr { kind: ExprKind::Poison, span }
    }

    /// The program of these statements, without its tests.
    fn program(&mut self, statements: &[Statement<'s>]) -> Program {
        let (mut definitions, effects) = self.statements(statements);
        let n_before = self.diagnostics.len();
        let components = graph::order(&mut definitions, self.first, &mut self.diagnostics);
        for found in &mut self.diagnostics[n_before..] {
            let own = definitions.iter().find(|own| own.name_span == found.primary.span);
            if let Some(own) = own.filter(|own| self.registry.get(&own.name).is_some()) {
                found.hints.push(format!(
                    "`{0}` is the script's own here, which hides the built-in; give it another name to use that one",
                    own.name
                ));
            }
        }
        Program {
            first: self.first,
            definitions,
            effects,
            components,
            tests: Vec::new(),
            unit: self.unit,
            tolerance: self.tolerance,
        }
    }

    /// The definitions beside the text, which have their values.
    fn known(&mut self) -> Vec<Definition> {
        if self.tested.is_some() {
            return Vec::new();
        }
        let (known, span) = (self.origin.known, Span::default());
        let with_values = known.iter().filter_map(|known| Some((known, known.value.clone()?)));
        let definition = |(idx, (known, value)): (usize, (&'s Defined, Value))| {
            self.globals.insert(known.name.as_str(), (idx, span));
            Definition {
                name: Arc::from(known.name.as_str()),
                name_span: span,
                role: DefinitionRole::Known(known.identity),
                value: Expr { kind: ExprKind::Constant(value), span },
                n_slots: 0,
                dependencies: Vec::new(),
                is_poisoned: false,
                with: Vec::new(),
            }
        };
        with_values.enumerate().map(definition).collect()
    }

    /// The number of the definition `name` of the file or the test under way, and its place.
    fn global(&self, name: &str) -> Option<(usize, Span)> {
        let tested = self.tested.as_ref().and_then(|tested| tested.get(name));
        tested.or_else(|| self.globals.get(name)).copied()
    }

    /// What a name means at this place.
    fn resolve(&mut self, name: &'s str, local_span: Span) -> Expr {
        let span = self.at(local_span);
        if let Some((source, defined)) = self.scopes.find(name) {
            self.noted.uses.push((span, defined));
            let kind = match source {
                CaptureSource::Local(slot) => ExprKind::Local(slot),
                CaptureSource::Captured(idx) => ExprKind::Captured(idx),
                CaptureSource::Sibling(idx) => ExprKind::Sibling(idx),
            };
            return Expr { kind, span };
        }
        if let Some((idx, defined)) = self.global(name) {
            self.noted.uses.push((span, defined));
            self.uses.add(idx);
            return Expr { kind: ExprKind::Global(idx), span };
        }
        if self.registry.names_script(name) {
            return self.script_as_value(name, span);
        }
        if let Some((known, ops)) = self.registry.get(name) {
            let function = Function::Builtin(known, ops.clone());
            return Expr { kind: ExprKind::Constant(Value::Function(function)), span };
        }
        if let Some(constant) = self.registry.constant(name) {
            return Expr { kind: ExprKind::Constant((constant.value)()), span };
        }
        self.unknown(name, span)
    }

    fn unknown(&mut self, name: &str, span: Span) -> Expr {
        self.n_unknown += 1;
        let (mut near, mut near_builtin) = (None, None);
        if self.n_unknown <= MOST_SUGGESTIONS {
            near = nearest(name, self.scopes.names());
            let globals = self.tested.iter().chain([&self.globals]).flat_map(BTreeMap::keys);
            near = near.or_else(|| nearest(name, globals.copied()));
            near_builtin = nearest(name, self.registry.names());
        }
        if self.may_be_defined(name) {
            return self.poison(span);
        }
        let defined = near.and_then(|near| self.global(near)).map(|(_, span)| span);
        // The script's own names are nearer than words of other programs, and these than what is built in.
        let advice = foreign_names::advice(name).filter(|_| near.is_none());
        match (near.or(near_builtin), advice) {
            (_, Some(advice)) => {
                let diagnostic = Diagnostic::error(
                    Code::UnknownName,
                    span,
                    format!("nothing is called `{name}`"),
                );
                let diagnostic = diagnostic.label("unknown name").hint(advice);
                let fix = foreign_names::word(name).map(|word| Fix::replace(span, word));
                self.report(match fix {
                    Some(fix) => diagnostic.fix(fix),
                    None => diagnostic,
                });
            }
            (Some(near), None) => {
                let mut diagnostic = Diagnostic::error(
                    Code::UnknownName,
                    span,
                    format!("nothing is called `{name}`"),
                )
                .meant(near);
                if let Some(defined) = defined {
                    diagnostic = diagnostic.also(defined, format!("`{near}` is defined here"));
                }
                self.report(diagnostic);
            }
            (None, None) if !self.origin.faults.is_empty() => {}
            (None, None) => {
                let diagnostic = Diagnostic::error(
                    Code::UnknownName,
                    span,
                    format!("nothing is called `{name}`"),
                )
                .label("unknown name")
                .hint(format!("define it with `let {name} = ...` anywhere in this file"));
                self.report(diagnostic);
            }
        }
        self.poison(span)
    }

    /// Where a name of this place is defined, if it is one of the script.
    fn around(&mut self, name: &str) -> Option<Span> {
        let local = self.scopes.find(name).map(|(_, span)| span);
        local.or_else(|| self.global(name).map(|(_, span)| span))
    }

    /// Gives a name inside an expression a slot.
    fn bind(&mut self, name: &ast::Name<'s>) -> usize {
        self.scopes.bind(name.text, self.at(name.span))
    }

    /// Gives a name of a scope that began at `mark` a slot; a second one of the same name is reported,
    /// as `what` that are called so.
    fn bind_once(&mut self, name: &ast::Name<'s>, mark: usize, what: &str) -> usize {
        if let Some(first) = self.scopes.own(name.text, mark) {
            let message = format!("two {what} are called `{}`", name.text);
            self.report(
                Diagnostic::error(Code::Duplicate, self.at(name.span), message)
                    .label("choose another name")
                    .also(first, "the first one"),
            );
        }
        self.bind(name)
    }
}

/// Whether a text ends with a keyword that a defined name follows.
fn is_definition_word(text: &str) -> bool {
    let last = text.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or_default();
    matches!(last, "fn" | "param") || ast::Kind::ALL.iter().any(|&(word, _)| word == last)
}
