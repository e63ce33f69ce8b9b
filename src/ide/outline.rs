//! What a text defines, calls and claims: gathered from its tree in one walk.

use std::ops::Range;

use super::outline_walk::OutlineWalk;
use crate::{diag::Diagnostic, kernel::sorting::sort_by_key, session::Session, syntax::ast::Kind};

/// What a name is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NameRole {
    /// `param`
    Param,
    /// `fn`
    Function,
    /// A file, or a name of one.
    Import,
    /// `let`, or a kind.
    Definition(Kind),
    /// A parameter of a function.
    Parameter,
    /// A variable of a comprehension.
    Variable,
}

/// A name where it is defined.
#[derive(Clone, Debug, PartialEq)]
pub struct DefinedName {
    /// Its text.
    pub name: String,
    /// Its place.
    pub place: Range<usize>,
    /// What it is.
    pub role: NameRole,
    /// The statement, function or comprehension that defines it.
    pub whole: Range<usize>,
    /// Where it is known; all of the text for definitions of the file.
    pub scope: Range<usize>,
    /// The expression that it stands for, where it has one of its own.
    pub value: Option<Range<usize>>,
    /// Whether that is a number, a string or a truth value as it is written.
    pub is_literal: bool,
    /// The `///` lines before it.
    pub docs: Option<String>,
    /// The parameters of a function with the texts of their defaults.
    pub parameters: Vec<(String, Option<String>)>,
    /// The kind that a `param` states.
    pub kind: Option<String>,
    /// What a `param` allows, as it is written: `in 1mm..9mm step 1mm`.
    pub allowed: Option<String>,
    /// The text for people behind a `param`.
    pub label: Option<String>,
    /// Whether the file defines it, and no block or test in it.
    pub is_of_file: bool,
    /// Whether it stands for a field or element of what is taken apart.
    pub is_part: bool,
}

/// A call.
#[derive(Clone, Debug, PartialEq)]
pub struct CallSite {
    /// The called name.
    pub name: Range<usize>,
    /// Its arguments: place, whether it has a label, whether it is a literal.
    pub arguments: Vec<(Range<usize>, bool, bool)>,
    /// Whether something is piped into it.
    pub is_piped: bool,
}

/// A statement that claims, tests, writes or imports.
#[derive(Clone, Debug, PartialEq)]
pub struct Act {
    /// Which keyword it has.
    pub kind: ActKind,
    /// All of it.
    pub whole: Range<usize>,
    /// The claim, the test's name, the path.
    pub subject: Range<usize>,
}

/// What a statement without a name does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActKind {
    /// `check`
    Check,
    /// `test`
    Test,
    /// `export`
    Export,
    /// `import`
    Import,
    /// `print`
    Print,
}

/// What a text defines, calls and claims.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    /// Every defined name, in the order in which they stand.
    pub names: Vec<DefinedName>,
    /// Every call of a name.
    pub calls: Vec<CallSite>,
    /// Every statement without a name.
    pub acts: Vec<Act>,
    /// The places of statements and expressions.
    pub nodes: Vec<Range<usize>>,
    /// Strings: place, value, and the label whose value they are.
    pub texts: Vec<(Range<usize>, String, Option<String>)>,
    /// Fields of records that are given by their name alone.
    pub short_fields: Vec<Range<usize>>,
    /// What is wrong with the text alone.
    pub faults: Vec<Diagnostic>,
}

impl Outline {
    /// The outline of a text.
    #[must_use]
    pub fn of(session: &Session, text: &str) -> Self {
        session.tree(text, |tree, faults| {
            let mut outline = OutlineWalk::of(text, tree);
            sort_by_key(&mut outline.names, |name| name.place.start);
            Self { faults, ..outline }
        })
    }

    /// The name that is defined at exactly this place.
    #[must_use]
    pub fn defined_at(&self, place: &Range<usize>) -> Option<&DefinedName> {
        let first = self.names.partition_point(|name| name.place.start < place.start);
        self.names[first..]
            .iter()
            .take_while(|name| name.place.start == place.start)
            .find(|name| name.place == *place)
    }

    /// The definitions of the file, in the order in which they stand.
    pub fn of_file(&self) -> impl Iterator<Item = &DefinedName> {
        self.names.iter().filter(|name| name.is_of_file)
    }
}
