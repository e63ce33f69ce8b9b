//! The program as it is evaluated: names are slots, literals are values, spans are global.
//!
//! `lower` makes it from the tree of a script; the machine runs it. Nothing in it borrows from
//! the source, so functions of the script can outlive their text.

use std::sync::{Arc, OnceLock};

pub(crate) use crate::syntax::ast::{BinaryOp, Kind, UnaryOp};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::Tolerance,
    value::Value,
};

/// An expression with its place.
#[derive(Debug)]
pub(crate) struct Expr {
    pub(crate) kind: ExprKind,
    pub(crate) span: Span,
}

/// What an expression is.
#[derive(Debug)]
pub(crate) enum ExprKind {
    /// Was reported; whatever contains it is never evaluated.
    Poison,
    /// A literal or a built-in.
    Constant(Value),
    /// A parameter or variable of the running function.
    Local(usize),
    /// A value that the running function took from around it.
    Captured(usize),
    /// A function defined together with the running one.
    Sibling(usize),
    /// A definition of the file.
    Global(usize),
    Point(Box<[Expr; 3]>),
    List(Vec<Element>),
    Record(Vec<(Arc<str>, Expr)>),
    Text(Vec<StringPart>),
    Comprehension(Box<Comprehension>),
    Block(Box<Block>),
    Unary(UnaryOp, Box<Expr>),
    Binary(BinaryOp, Box<[Expr; 2]>),
    /// `a ~= b within c`
    Within(Box<[Expr; 3]>),
    Call(Box<CallExpr>),
    Index(Box<[Expr; 2]>),
    Field(Box<Expr>, Arc<str>, Span),
    Lambda(Arc<Group>, usize, Vec<CaptureSource>),
    If(Box<[Expr; 3]>),
    /// A list that must have so many elements, because a pattern takes it apart.
    Exactly(Box<Expr>, usize),
    /// The record of what an imported file defines, with these parameters.
    Import(usize, Vec<Arg>),
    /// The same where a call names the file.
    Script(Arc<ScriptFile>, Vec<Arg>),
    /// A value that must be of a promised kind; the span is the keyword's.
    Promise(Box<Expr>, Kind, Span),
}

impl Expr {
    /// Whether it is a text as it is written, with or without values in it.
    pub(crate) fn is_text(&self) -> bool {
        matches!(self.kind, ExprKind::Text(_) | ExprKind::Constant(Value::Text(_)))
    }
}

/// A file that a call names. It is looked for after the names of the text around the call are resolved.
#[derive(Debug)]
pub(crate) struct ScriptFile {
    /// As it is written.
    pub(crate) path: Arc<str>,
    /// Where it is written.
    pub(crate) place: Span,
    /// Its place in the library, or why it has none.
    pub(crate) found: OnceLock<Result<usize>>,
}

/// An element of a list.
#[derive(Debug)]
pub(crate) enum Element {
    Item(Expr),
    Spread(Expr),
    /// The first element, a spread of a value of the frame, where nothing but the elements behind it is evaluated in
    /// the frame from there on: the list may grow out of it.
    Grown {
        slot: usize,
        span: Span,
    },
}

/// A part of an interpolated string.
#[derive(Debug)]
pub(crate) enum StringPart {
    Text(Arc<str>),
    Expr(Expr, Option<TextFormat>),
}

/// How a number stands in a text.
#[derive(Debug)]
pub(crate) struct TextFormat {
    pub(crate) digits: Option<usize>,
    pub(crate) unit: Option<Arc<str>>,
    pub(crate) span: Span,
}

/// A call as written.
#[derive(Debug)]
pub(crate) struct CallExpr {
    pub(crate) callee: Expr,
    pub(crate) args: Vec<Arg>,
    /// Whether an argument is `_`, which makes a function of the call.
    pub(crate) is_partial: bool,
}

/// An argument; without a value it is the placeholder.
#[derive(Debug)]
pub(crate) struct Arg {
    pub(crate) label: Option<(Arc<str>, Span)>,
    pub(crate) value: Option<Expr>,
    /// The value of the frame that it is, where nothing but the arguments before it names that: the call gets it, and the
    /// frame has it no more.
    pub(crate) taken: Option<usize>,
    pub(crate) span: Span,
}

/// `[for ...: body]`
#[derive(Debug)]
pub(crate) struct Comprehension {
    pub(crate) generators: Vec<Generator>,
    pub(crate) body: Expr,
}

/// `x in source if condition`
#[derive(Debug)]
pub(crate) struct Generator {
    pub(crate) slot: usize,
    pub(crate) source: Expr,
    /// Variables that take an element apart: slots and how each is got from it.
    pub(crate) parts: Vec<(usize, Expr)>,
    pub(crate) condition: Option<Expr>,
}

/// Definitions in the order of their dependencies, then a value.
#[derive(Debug)]
pub(crate) struct Block {
    pub(crate) definitions: Vec<(usize, Expr)>,
    pub(crate) value: Expr,
}

/// Functions that are defined together and may call one another, with what they take from
/// around them.
#[derive(Debug)]
pub(crate) struct Group {
    pub(crate) lambdas: Vec<Lambda>,
}

/// A function of the script.
#[derive(Debug)]
pub(crate) struct Lambda {
    /// `None` for `x => ...`.
    pub(crate) name: Option<Arc<str>>,
    pub(crate) parameters: Vec<Parameter>,
    pub(crate) body: Expr,
    /// Slots of a frame: parameters first, then variables.
    pub(crate) n_slots: usize,
}

/// A parameter with its default.
#[derive(Debug)]
pub(crate) struct Parameter {
    pub(crate) name: Arc<str>,
    pub(crate) default: Option<Expr>,
}

/// Where a captured value comes from, in the frame that makes the function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CaptureSource {
    Local(usize),
    Captured(usize),
    Sibling(usize),
}

/// A definition of the file.
#[derive(Debug)]
pub(crate) struct Definition {
    /// How outputs call it.
    pub(crate) name: Arc<str>,
    /// The name itself, or the keyword where there is none.
    pub(crate) name_span: Span,
    pub(crate) role: DefinitionRole,
    pub(crate) value: Expr,
    /// Slots that its expression needs.
    pub(crate) n_slots: usize,
    /// Definitions that it uses, in ascending order, each once.
    pub(crate) dependencies: Vec<Dependency>,
    /// Whether a mistake in it was reported already.
    pub(crate) is_poisoned: bool,
    /// Presentation: evaluated options after `with`.
    pub(crate) with: Vec<Arg>,
}

/// What sort of definition it is.
#[derive(Debug)]
pub(crate) enum DefinitionRole {
    /// An input of the file.
    Param(Box<ParamRules>),
    /// A function, which may use itself.
    Function,
    /// What an import brings; no other file sees it from here.
    Import,
    /// `let` and the kinds.
    Value(Kind),
    /// The right side of a pattern; has no name of its own.
    Hidden,
    /// One beside the text: its value, with the identity of its result where results are remembered.
    Known(Option<u64>),
}

/// What a `param` allows.
#[derive(Debug)]
pub(crate) struct ParamRules {
    pub(crate) kind: Option<ParamKind>,
    /// Where that is written.
    pub(crate) kind_span: Option<Span>,
    pub(crate) allowed: Option<Expr>,
    pub(crate) step: Option<Expr>,
    /// A text for people.
    pub(crate) label: Option<Expr>,
    /// The `///` lines before it.
    pub(crate) docs: Option<String>,
}

/// The stated kind of a `param`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ParamKind {
    Number,
    Integer,
    Length,
    Angle,
    Bool,
    Text,
}

impl ParamKind {
    /// Every kind with its word.
    pub(crate) const ALL: &'static [(&'static str, Self)] = &[
        ("number", Self::Number),
        ("integer", Self::Integer),
        ("length", Self::Length),
        ("angle", Self::Angle),
        ("bool", Self::Bool),
        ("string", Self::Text),
    ];

    /// Its word.
    pub(crate) fn word(self) -> &'static str {
        Self::ALL.iter().find(|&&(_, kind)| kind == self).map_or("", |&(word, _)| word)
    }
}

/// The words for kinds of parameters.
pub fn param_kinds() -> impl Iterator<Item = &'static str> {
    ParamKind::ALL.iter().map(|&(word, _)| word)
}

/// A definition that something uses.
#[derive(Clone, Debug)]
pub(crate) struct Dependency {
    pub(crate) definition: usize,
    /// The fields of an import, where nothing else of it is used: the others may have failed.
    pub(crate) fields: Option<Box<[Arc<str>]>>,
}

/// A statement that acts on values.
#[derive(Debug)]
pub(crate) struct Effect {
    /// From its keyword to its end.
    pub(crate) span: Span,
    pub(crate) kind: EffectKind,
    pub(crate) n_slots: usize,
    pub(crate) dependencies: Vec<Dependency>,
    pub(crate) is_poisoned: bool,
}

/// What a statement does.
#[derive(Debug)]
pub(crate) enum EffectKind {
    Check {
        claim: Expr,
        message: Option<Expr>,
    },
    Print(Vec<PrintedExpr>),
    /// `named` are the definitions that the subjects name.
    Export {
        subjects: ExportedSubjects,
        named: Vec<usize>,
        path: Expr,
        options: Vec<Arg>,
    },
    /// In tests only; a mistake that was found without evaluation is the answer already.
    Expect {
        code: Code,
        subject: Expr,
        found: Option<Box<Diagnostic>>,
    },
}

/// An expression of a print, which is printed where what it depends on by itself has a value.
#[derive(Debug)]
pub(crate) struct PrintedExpr {
    pub(crate) expr: Expr,
    pub(crate) dependencies: Vec<Dependency>,
    pub(crate) is_poisoned: bool,
}

/// The word of an export that means all geometry of the script, where the script calls nothing else so.
pub(crate) const ALL: &str = "all";

/// The word of an export that means the report of the script, where the script calls nothing else so.
pub(crate) const REPORT: &str = "report";

/// What an export writes.
#[derive(Debug)]
pub(crate) enum ExportedSubjects {
    /// `all`: every definition that promises geometry.
    All,
    /// `report`: what the script says and claims.
    Report,
    These(Vec<Expr>),
}

impl ExportedSubjects {
    /// Whether it concerns all of the file.
    pub(crate) fn is_of_whole_file(&self) -> bool {
        !matches!(self, Self::These(_))
    }
}

/// A whole file, ready to run; or a test of it.
#[derive(Debug)]
pub(crate) struct Program {
    /// The number of its first definition: those before it belong to the file around a test.
    pub(crate) first: usize,
    pub(crate) definitions: Vec<Definition>,
    pub(crate) effects: Vec<Effect>,
    /// Definitions, functions that use one another together, each after those that it uses.
    pub(crate) components: Vec<Vec<usize>>,
    pub(crate) tests: Vec<Test>,
    /// The unit of length.
    pub(crate) unit: crate::syntax::ast::Unit,
    pub(crate) tolerance: Tolerance,
}

/// A test: definitions and effects that see the definitions of the file around it.
#[derive(Debug)]
pub(crate) struct Test {
    pub(crate) name: Arc<str>,
    /// Where its name stands.
    pub(crate) span: Span,
    pub(crate) program: Program,
    /// Whether a mistake in it was reported already; then nothing of it is evaluated.
    pub(crate) is_poisoned: bool,
}

impl Program {
    /// The definition with this number, unless it belongs to the file around.
    pub(crate) fn definition(&self, idx: usize) -> Option<&Definition> {
        self.definitions.get(idx.checked_sub(self.first)?)
    }

    /// The names of the parameters.
    pub(crate) fn parameters(&self) -> impl Iterator<Item = &str> {
        let is_param =
            |definition: &&Definition| matches!(definition.role, DefinitionRole::Param(_));
        self.definitions.iter().filter(is_param).map(|definition| &*definition.name)
    }
}

impl Definition {
    /// Whether it gives a name to something of its own file.
    pub(crate) fn is_named(&self) -> bool {
        !matches!(self.role, DefinitionRole::Hidden | DefinitionRole::Import)
            && !self.name.is_empty()
    }
}
