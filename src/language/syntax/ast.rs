//! The tree of a script, as it was written: names and texts borrow from the source.
//!
//! Spans count from the start of the text. Where the parser had to recover, an `Error` node
//! stands, and a diagnostic tells why; such a tree is never evaluated.

pub use super::operator::{BinaryOp, UnaryOp};
use crate::diag::Span;

/// A whole script.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Tree<'s> {
    /// The statements in source order.
    pub statements: Vec<Statement<'s>>,
}

/// An identifier where it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Name<'s> {
    /// Its text.
    pub text: &'s str,
    /// Its place.
    pub span: Span,
}

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement<'s> {
    /// The `///` lines before it, without the slashes, joined by line breaks; `None` without any.
    pub docs: Option<String>,
    /// What it states.
    pub kind: StatementKind<'s>,
    /// From its keyword to its end.
    pub span: Span,
}

/// What a statement states.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind<'s> {
    /// Not understood; reported.
    Error,
    /// `geo 1`
    Edition(Expr<'s>),
    /// `unit mm`
    Unit(Name<'s>),
    /// `tolerance 1e-6`
    Tolerance(Expr<'s>),
    /// `param NAME ...`
    Param(Box<Param<'s>>),
    /// `let`, and the kinds: `curve c = ...`
    Definition(Definition<'s>),
    /// `fn NAME(...) = ...`
    Function(Box<Function<'s>>),
    /// `check EXPR ["message"]`
    Check {
        /// The claim.
        claim: Expr<'s>,
        /// A text for the report.
        message: Option<Expr<'s>>,
    },
    /// `print EXPR, ...`
    Print(Vec<Expr<'s>>),
    /// `export ... to ...`
    Export(Box<Export<'s>>),
    /// `import "PATH" ...`
    Import(Box<Import<'s>>),
    /// `test "name" { ... }`
    Test {
        /// The test's name.
        name: Expr<'s>,
        /// Its statements.
        body: Vec<Statement<'s>>,
    },
    /// `expect error "E0203" EXPR`, in tests only
    ExpectError {
        /// The code, a string.
        code: Expr<'s>,
        /// What must fail.
        subject: Expr<'s>,
    },
}

/// `param NAME [: KIND] = EXPR [in A..B | in [..]] [step S] ["label"]`
#[derive(Clone, Debug, PartialEq)]
pub struct Param<'s> {
    /// Its name.
    pub name: Name<'s>,
    /// Its stated kind.
    pub kind: Option<Name<'s>>,
    /// The default.
    pub default: Expr<'s>,
    /// Range or list of choices.
    pub allowed: Option<Expr<'s>>,
    /// Step inside the range.
    pub step: Option<Expr<'s>>,
    /// A text for people.
    pub label: Option<Expr<'s>>,
}

/// What a definition's keyword promises.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `let`: nothing
    Let,
    /// `point`
    Point,
    /// `curve`
    Curve,
    /// `surface`
    Surface,
    /// `region`
    Region,
    /// `face`
    Face,
    /// `solid`
    Solid,
    /// `mesh`
    Mesh,
    /// `table`
    Table,
    /// `points`
    Points,
    /// `curves`
    Curves,
    /// `surfaces`
    Surfaces,
    /// `regions`
    Regions,
    /// `faces`
    Faces,
    /// `solids`
    Solids,
    /// `meshes`
    Meshes,
    /// `tables`
    Tables,
}

impl Kind {
    /// Every kind with its keyword, in the order of the reference.
    pub const ALL: &'static [(&'static str, Self)] = &[
        ("let", Self::Let),
        ("point", Self::Point),
        ("curve", Self::Curve),
        ("surface", Self::Surface),
        ("region", Self::Region),
        ("face", Self::Face),
        ("solid", Self::Solid),
        ("mesh", Self::Mesh),
        ("table", Self::Table),
        ("points", Self::Points),
        ("curves", Self::Curves),
        ("surfaces", Self::Surfaces),
        ("regions", Self::Regions),
        ("faces", Self::Faces),
        ("solids", Self::Solids),
        ("meshes", Self::Meshes),
        ("tables", Self::Tables),
    ];

    /// Whether it promises points, curves, surfaces or meshes.
    #[must_use]
    pub fn is_geometry(self) -> bool {
        !matches!(self, Self::Let | Self::Table | Self::Tables)
    }

    /// The keyword.
    #[must_use]
    pub fn word(self) -> &'static str {
        Self::ALL.iter().find(|&&(_, kind)| kind == self).map_or("", |&(word, _)| word)
    }
}

/// `KIND [NAME] = EXPR [with (...)]`; without a name the `=` is missing too
#[derive(Clone, Debug, PartialEq)]
pub struct Definition<'s> {
    /// The keyword.
    pub kind: Kind,
    /// What is defined.
    pub pattern: Pattern<'s>,
    /// Its value.
    pub value: Expr<'s>,
    /// Presentation: the arguments after `with`.
    pub with: Vec<Arg<'s>>,
}

/// The left side of a definition.
#[derive(Clone, Debug, PartialEq)]
pub enum Pattern<'s> {
    /// `curve bezier(...)`: no name.
    Anonymous,
    /// `let a = ...`
    Name(Name<'s>),
    /// `let [a, b] = ...`
    List(Vec<Name<'s>>, Span),
    /// `let {a, b} = ...`
    Record(Vec<Name<'s>>, Span),
}

/// `fn NAME(a, b = DEFAULT) = EXPR`
#[derive(Clone, Debug, PartialEq)]
pub struct Function<'s> {
    /// Its name.
    pub name: Name<'s>,
    /// Its parameters.
    pub parameters: Vec<Parameter<'s>>,
    /// Its body.
    pub body: Expr<'s>,
}

/// A parameter of a function, with its default.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter<'s> {
    /// Its name.
    pub name: Name<'s>,
    /// Its value when left out.
    pub default: Option<Expr<'s>>,
}

/// `export EXPR, ... to "PATH" [with (...)]`
#[derive(Clone, Debug, PartialEq)]
pub struct Export<'s> {
    /// What is written: `None` is `all`.
    pub subjects: Vec<Expr<'s>>,
    /// The path, a string.
    pub path: Expr<'s>,
    /// The options after `with`.
    pub options: Vec<Arg<'s>>,
}

/// `import "PATH" [as NAME] [with (...)]` or `import "PATH" (a, b)`
#[derive(Clone, Debug, PartialEq)]
pub struct Import<'s> {
    /// The path, a string.
    pub path: Expr<'s>,
    /// The name that qualifies, when stated.
    pub alias: Option<Name<'s>>,
    /// The listed names.
    pub names: Option<Vec<Name<'s>>>,
    /// Parameters of the imported file.
    pub with: Vec<Arg<'s>>,
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr<'s> {
    /// What it is.
    pub kind: ExprKind<'s>,
    /// Where it stands, brackets of its own included.
    pub span: Span,
}

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind<'s> {
    /// Not understood; reported.
    Error,
    /// `12.5mm`; the number as written, before its unit is applied
    Number(f64, Option<Unit>),
    /// `"text"`, escapes resolved
    Text(String),
    /// `"a {x} b"`: texts and expressions in turn
    Interpolation(Vec<StringPart<'s>>),
    /// `true`, `false`
    Bool(bool),
    /// `none`
    None,
    /// `name`
    Name(&'s str),
    /// `_` as an argument
    Placeholder,
    /// `(a)`: kept, so that printing gives back what was written
    Group(Box<Expr<'s>>),
    /// `(x, y)`, `(x, y, z)`; other lengths are reported by the parser
    Point(Vec<Expr<'s>>),
    /// `[a, ...b]`
    List(Vec<Element<'s>>),
    /// `{a: 1, b}`; the short form `b` stands for `b: b`
    Record(Vec<Field<'s>>),
    /// `[for i in xs, j in ys if c: e]`
    Comprehension(Box<Comprehension<'s>>),
    /// `{ definitions  value }`
    Block(Box<Block<'s>>),
    /// `-x`, `not x`
    Unary(UnaryOp, Box<Expr<'s>>),
    /// `a + b`
    Binary(BinaryOp, Box<[Expr<'s>; 2]>),
    /// `a ~= b within c`: the third is the tolerance
    Within(Box<[Expr<'s>; 3]>),
    /// `a |> f(b)`: the call, with `a` as its first argument kept apart
    Pipe(Box<[Expr<'s>; 2]>),
    /// `f(a, label = b)`
    Call(Box<Expr<'s>>, Vec<Arg<'s>>),
    /// `xs[i]`
    Index(Box<[Expr<'s>; 2]>),
    /// `p.x`
    Field(Box<Expr<'s>>, Name<'s>),
    /// `x => e`, `(x, y) => e`
    Lambda(Vec<Name<'s>>, Box<Expr<'s>>),
    /// `if c then a else b`
    If(Box<[Expr<'s>; 3]>),
}

/// A part of an interpolated string.
#[derive(Clone, Debug, PartialEq)]
pub enum StringPart<'s> {
    /// Text, escapes resolved.
    Text(String),
    /// `{expr}`, or `{expr:.3mm}`.
    Expr(Expr<'s>, Option<TextFormat<'s>>),
}

/// How a number stands in a text: `:.3`, `:mm` or `:.3mm`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextFormat<'s> {
    /// Digits behind the point.
    pub digits: Option<usize>,
    /// The unit that it is told in.
    pub unit: Option<&'s str>,
    /// Where it stands, its colon included.
    pub span: Span,
}

/// An element of a list.
#[derive(Clone, Debug, PartialEq)]
pub enum Element<'s> {
    /// One element.
    Item(Expr<'s>),
    /// `...xs`: all elements of a list.
    Spread(Expr<'s>),
}

/// `label: value` of a record
#[derive(Clone, Debug, PartialEq)]
pub struct Field<'s> {
    /// The label.
    pub name: Name<'s>,
    /// The value; `None` for the short form.
    pub value: Option<Expr<'s>>,
}

/// An argument of a call or an option after `with`.
#[derive(Clone, Debug, PartialEq)]
pub struct Arg<'s> {
    /// `name =`, when given so.
    pub name: Option<Name<'s>>,
    /// The value.
    pub value: Expr<'s>,
}

/// `for x in xs, y in ys if c: e`
#[derive(Clone, Debug, PartialEq)]
pub struct Comprehension<'s> {
    /// The generators, outermost first.
    pub generators: Vec<Generator<'s>>,
    /// What each element is.
    pub body: Expr<'s>,
}

/// `x in xs [if c]`
#[derive(Clone, Debug, PartialEq)]
pub struct Generator<'s> {
    /// The variable, or several that take an element apart.
    pub pattern: Pattern<'s>,
    /// What it runs over.
    pub source: Expr<'s>,
    /// Which elements count; may use all variables so far.
    pub condition: Option<Expr<'s>>,
}

/// Definitions, then a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Block<'s> {
    /// `let`, `fn` and kinds only; others are reported by the parser.
    pub statements: Vec<Statement<'s>>,
    /// The value.
    pub value: Expr<'s>,
}

/// A unit of length or angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Micrometre.
    Um,
    /// Millimetre.
    Mm,
    /// Centimetre.
    Cm,
    /// Metre.
    M,
    /// Kilometre.
    Km,
    /// Inch, 25.4 mm.
    In,
    /// Foot, 304.8 mm.
    Ft,
    /// Degree.
    Deg,
    /// Radian.
    Rad,
    /// Full turn.
    Turn,
}

impl Unit {
    /// Every unit with its name, in the order of the reference.
    pub const ALL: &'static [(&'static str, Self)] = &[
        ("um", Self::Um),
        ("mm", Self::Mm),
        ("cm", Self::Cm),
        ("m", Self::M),
        ("km", Self::Km),
        ("in", Self::In),
        ("ft", Self::Ft),
        ("deg", Self::Deg),
        ("rad", Self::Rad),
        ("turn", Self::Turn),
    ];

    /// The unit called `name`.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|&(_, unit)| unit)
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|&&(_, unit)| unit == self).map_or("", |&(name, _)| name)
    }

    /// Its size in millimetres; `None` for angles.
    #[must_use]
    pub fn millimetres(self) -> Option<f64> {
        match self {
            Self::Um => Some(0.001),
            Self::Mm => Some(1.0),
            Self::Cm => Some(10.0),
            Self::M => Some(1_000.0),
            Self::Km => Some(1_000_000.0),
            Self::In => Some(25.4),
            Self::Ft => Some(304.8),
            Self::Deg | Self::Rad | Self::Turn => None,
        }
    }
}
