//! A script as a row of atoms: tokens, whole strings, and comments, with all that decides how
//! they are set.

use crate::diag::Span;
use crate::syntax::lexed::{Comment, Lexed};
use crate::syntax::token::Token;

/// A token, a whole string, or a comment.
#[derive(Debug)]
pub(super) struct Atom<'s> {
    /// Its text; empty for a comma that is dropped.
    pub(super) text: &'s str,
    /// Its place in the source.
    pub(super) span: Span,
    /// Its kind, without regard to its line; a string is its head.
    pub(super) token: Token,
    /// Where it begins.
    pub(super) start: Start,
    /// Whether no space stands before it.
    pub(super) is_glued: bool,
    /// Of a bracket: the other one.
    pub(super) partner: usize,
    /// Of an opening bracket: what it holds.
    pub(super) holds: GroupContent,
    /// Whether a statement begins with it, or the value of a block.
    pub(super) is_head: bool,
    /// A line that is too long may be broken before it.
    pub(super) rank: Option<Rank>,
    /// It may stand under its like of the line before.
    pub(super) point: Option<Point>,
}

/// Where an atom begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Start {
    /// On the line of the atom before.
    Same,
    /// On a new line.
    Line,
    /// On a new line after a blank one.
    Blank,
}

/// What brackets hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GroupContent {
    /// Something without a comma at its end.
    One,
    /// Items, with a comma at the end of each that ends a line.
    Items,
    /// The value of a block, with spaces around.
    Value,
    /// Statements, each on a line of its own.
    Statements,
}

/// Where a line that is too long is broken, the best place first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    /// After a comma; no atom is marked with it.
    Item,
    /// Before the value of a definition.
    Bind,
    /// Before `|>`.
    Pipe,
    /// Before `else`.
    Else,
    /// Before the body of a comprehension.
    Body,
    /// Before `or`.
    Or,
    /// Before `and`.
    And,
    /// Before `==`, `~=` and their like.
    Compare,
    /// After `+`, `-`.
    Sum,
    /// After `*`, `/`, `%`.
    Product,
    /// Before `then`.
    Then,
    /// After `=>`.
    Arrow,
    /// Before the value of a definition that has brackets of its own to break.
    LastBind,
    /// Before `in`, `step`, `to`.
    Clause,
}

/// What may stand in columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Point {
    /// The name of a definition.
    Name,
    /// Its `=`.
    Equals,
    /// The `in` of a parameter.
    In,
    /// The `step` of a parameter.
    Step,
    /// The `to` of an export.
    To,
    /// The `with` of a definition or an export.
    With,
    /// The text of a parameter or a check.
    Label,
    /// A comment at the end of a line.
    Comment,
}

impl Point {
    /// From left to right.
    pub(super) const ALL: [Self; 8] = [
        Self::Name,
        Self::Equals,
        Self::In,
        Self::Step,
        Self::To,
        Self::With,
        Self::Label,
        Self::Comment,
    ];

    /// Whether it stands in the margin, as far from the rest as its author wants.
    pub(super) fn is_marginal(self) -> bool {
        matches!(self, Self::Label | Self::Comment)
    }
}

impl Atom<'_> {
    /// Whether it is a comment.
    pub(super) fn is_comment(&self) -> bool {
        matches!(self.token, Token::LineComment | Token::BlockComment)
    }

    /// Whether it is an opening bracket.
    pub(super) fn opens(&self) -> bool {
        matches!(self.token, Token::OpenParen | Token::OpenBracket | Token::OpenBrace)
    }

    /// Whether it is a closing bracket.
    pub(super) fn closes(&self) -> bool {
        matches!(self.token, Token::CloseParen | Token::CloseBracket | Token::CloseBrace)
    }

    /// Whether it begins a line.
    pub(super) fn begins_line(&self) -> bool {
        self.start != Start::Same
    }

    /// Makes it begin a line.
    pub(super) fn begin_line(&mut self) {
        if self.start == Start::Same {
            self.start = Start::Line;
        }
    }

    /// Its columns; of a comment over several lines those of the last.
    pub(super) fn width(&self) -> usize {
        self.text.rsplit('\n').next().map_or(0, |line| line.chars().count())
    }
}

/// The atoms of a script without mistakes. Semicolons and commas before closing brackets are left out.
pub(super) fn atoms<'s>(lexed: &Lexed<'s>) -> Vec<Atom<'s>> {
    let mut row = AtomRow { source: lexed.source, atoms: Vec::with_capacity(lexed.tokens.len()) };
    let mut comments = lexed.comments.iter().peekable();
    // The outermost string, and how many are open.
    let (mut head, mut n_open) = (0, 0_usize);
    for (at, &token) in lexed.tokens.iter().enumerate() {
        while let Some(comment) = comments.next_if(|comment| comment.before <= at) {
            if n_open == 0 {
                row.comment(comment);
            }
        }
        match token {
            Token::TextHead => {
                if n_open == 0 {
                    head = at;
                }
                n_open += 1;
            }
            Token::TextTail => {
                n_open -= 1;
                if n_open == 0 {
                    row.push(lexed.span(head).to(lexed.span(at)), Token::TextHead);
                }
            }
            _ if n_open > 0 => {}
            Token::End | Token::Semicolon => {}
            Token::Comma if lexed.token(at + 1).closes() => {}
            _ => row.push(lexed.span(at), token.anywhere()),
        }
    }
    pair(&mut row.atoms);
    row.atoms
}

struct AtomRow<'s> {
    source: &'s str,
    atoms: Vec<Atom<'s>>,
}

impl AtomRow<'_> {
    fn comment(&mut self, comment: &Comment) {
        let is_block = self.source[comment.span.range()].starts_with("/*");
        self.push(comment.span, if is_block { Token::BlockComment } else { Token::LineComment });
    }

    fn push(&mut self, span: Span, token: Token) {
        let before = self.atoms.last().map_or(0, |atom| atom.span.end as usize);
        let n_lines = self.source[before..span.start as usize].matches('\n').count();
        let start = match (self.atoms.last(), n_lines) {
            (None, _) | (Some(_), 1) => Start::Line,
            (Some(_), 0) => Start::Same,
            (Some(last), _) if last.opens() || token.closes() => Start::Line,
            (Some(_), _) => Start::Blank,
        };
        self.atoms.push(Atom {
            text: self.source[span.range()].trim_end(),
            span,
            token,
            start,
            is_glued: false,
            partner: 0,
            holds: GroupContent::One,
            is_head: false,
            rank: None,
            point: None,
        });
    }
}

/// Tells each bracket its partner.
fn pair(atoms: &mut [Atom<'_>]) {
    let mut open = Vec::new();
    for at in 0..atoms.len() {
        if atoms[at].opens() {
            open.push(at);
        } else if atoms[at].closes()
            && let Some(partner) = open.pop()
        {
            atoms[at].partner = partner;
            atoms[partner].partner = at;
        }
    }
}

/// The next atom at or after `at` that is no comment; the length without any.
pub(super) fn code_at(atoms: &[Atom<'_>], at: usize) -> usize {
    (at..atoms.len()).find(|&at| !atoms[at].is_comment()).unwrap_or(atoms.len())
}

/// The last atom before `at` that is no comment.
pub(super) fn code_before(atoms: &[Atom<'_>], at: usize) -> Option<usize> {
    (0..at).rev().find(|&at| !atoms[at].is_comment())
}
