//! A pass over the tokens that pairs the brackets, and takes what has no pair out of the script.
//!
//! A statement keyword at the beginning of a line is a wall: no parenthesis, square bracket or
//! record reaches beyond it. Statements may stand in blocks and tests, so that these only end at
//! their brace; if that is missing, at the first statement that is not indented further than the
//! line on which the brace was opened.

use crate::diag::{Code, Diagnostic, Fix};
use crate::limits::Limits;
use crate::syntax::lexed::Lexed;
use crate::syntax::token::Token;

/// Replaces unpaired brackets, with what they spoil, by [`Token::Bad`], and tells of them.
///
/// Linear; each of at most `limits.diagnostics` unclosed blocks costs another pass over the rest.
pub(super) fn check(lexed: &mut Lexed<'_>, limits: &Limits) -> Vec<Diagnostic> {
    let mut pairing = BracketPairing {
        lexed,
        open: Vec::new(),
        is_crossed: false,
        line: ReadLine::default(),
        spoilt: Vec::new(),
        found: Vec::new(),
        limits,
    };
    let mut start = Some(0);
    while let Some(from) = start {
        start = pairing.run(from);
    }
    let BracketPairing { spoilt, found, .. } = pairing;
    for (start, end) in spoilt {
        lexed.give_up(start, end);
    }
    found
}

/// An open bracket.
struct OpenBracket {
    /// The index of its token.
    at: usize,
    holds: BracketContent,
    /// Open brackets by [`index`], this one included: of the first three kinds those in the same
    /// string.
    counts: [usize; 4],
    /// The indentation of its line.
    indent: usize,
    /// The first statement in it that may well stand after it, judging by its indentation.
    wall: Option<usize>,
}

/// What may stand in a bracket.
#[derive(Clone, Copy, PartialEq, Eq)]
enum BracketContent {
    Expressions,
    Statements,
}

struct BracketPairing<'a, 's> {
    lexed: &'a mut Lexed<'s>,
    open: Vec<OpenBracket>,
    /// Whether two brackets of the current statement cross: then its other brackets are silent.
    is_crossed: bool,
    line: ReadLine,
    /// The tokens to give up: from one to before another, none inside of the next.
    spoilt: Vec<(usize, usize)>,
    found: Vec<Diagnostic>,
    limits: &'a Limits,
}

impl BracketPairing<'_, '_> {
    /// Pairs the brackets from token `start` on; answers where to start again.
    fn run(&mut self, start: usize) -> Option<usize> {
        self.line = ReadLine::default();
        for at in start..self.lexed.tokens.len() {
            let token = self.lexed.tokens[at];
            if token.opens() {
                self.open(at);
            } else if token.closes() {
                self.close(at);
            } else if token.begins_statement() && (self.is_crossed || !self.open.is_empty()) {
                self.statement(at);
            }
        }
        self.finish()
    }

    fn open(&mut self, at: usize) {
        let holds = self.holds(at);
        let indent = match holds {
            BracketContent::Expressions => 0,
            BracketContent::Statements => self.line.indent(self.lexed, at),
        };
        let mut counts = self.open.last().map_or([0; 4], |open| open.counts);
        let opening = self.lexed.tokens[at];
        if opening == Token::TextHead {
            counts[..3].fill(0);
        }
        counts[index(opening)] += 1;
        self.open.push(OpenBracket { at, holds, counts, indent, wall: None });
    }

    fn holds(&self, at: usize) -> BracketContent {
        if self.lexed.tokens[at] != Token::OpenBrace {
            return BracketContent::Expressions;
        }
        let (first, second) = (self.lexed.token(at + 1), self.lexed.token(at + 2));
        let is_label = first.is_word()
            && matches!(second, Token::Colon | Token::Comma | Token::Equals | Token::CloseBrace);
        if is_label { BracketContent::Expressions } else { BracketContent::Statements }
    }

    /// A statement keyword: nothing but blocks and tests reaches beyond it.
    fn statement(&mut self, at: usize) {
        if !self.lexed.begins_statement(at) || !self.lexed.begins_line(at) {
            return;
        }
        let n_left = self.open.iter().rposition(|open| open.holds == BracketContent::Statements);
        self.give_up(
            n_left.map_or(0, |last| last + 1),
            at,
            "a new statement begins here while it is still open",
        );
        self.is_crossed = false;
        let indent = self.line.indent(self.lexed, at);
        if let Some(block) = self.open.last_mut().filter(|block| indent <= block.indent) {
            block.wall.get_or_insert(at);
        }
    }

    fn close(&mut self, at: usize) {
        let closing = self.lexed.tokens[at];
        let Some(top) = self.open.last() else { return self.stray(at) };
        let opening = self.lexed.tokens[top.at];
        if closing == counterpart(opening) {
            self.open.pop();
            return;
        }
        let own = |open: &OpenBracket| counterpart(self.lexed.tokens[open.at]) == closing;
        if is_weak(index(opening)) && is_weak(index(closing)) {
            self.crossed(at);
        } else if top.counts[index(closing)] == 0 {
            self.stray(at);
        } else if let Some(parent) = self.open.iter().rposition(own) {
            self.give_up(parent + 1, at, "this closes what is around it");
            self.open.pop();
        }
    }

    fn stray(&mut self, at: usize) {
        if !self.is_crossed {
            let message = format!("{} closes nothing", self.lexed.tokens[at].shown());
            let diagnostic = Diagnostic::error(Code::StrayBracket, self.lexed.span(at), message);
            let fix = Fix::remove(self.lexed.span(at), self.lexed.text(at));
            self.report(diagnostic.label("no bracket is open here").fix(fix));
        }
        self.spoil(at, at + 1);
    }

    /// `(a]`: reported, and taken for `(a)`. A bracket is missing before it, or it is another one than was meant: what
    /// fits those behind.
    fn crossed(&mut self, at: usize) {
        let Some(open) = self.open.pop() else { return };
        let (opening, closing) = (self.lexed.tokens[open.at].anywhere(), self.lexed.tokens[at]);
        if !self.is_crossed {
            let message = format!("{} does not close {}", closing.shown(), opening.shown());
            let found = Diagnostic::error(Code::StrayBracket, self.lexed.span(at), message);
            let meant = counterpart(opening);
            let found = if self.fits(None, at) {
                let fix = Fix::insert(self.lexed.span(at).at_start(), meant.text());
                found.label(format!("expected {} before this", meant.shown())).fix(fix)
            } else if !self.fits(None, at + 1) && self.fits(Some(opening), at + 1) {
                found.label("no bracket of its kind is open here")
            } else {
                found.meant(meant.text())
            };
            self.report(found.also(self.lexed.span(open.at), "opened here"));
        }
        self.is_crossed = true;
        self.lexed.tokens[at] = counterpart(opening);
    }

    /// Whether the brackets from token `start` to the end of the statement close those that are open, `innermost` too,
    /// and each other.
    fn fits(&self, innermost: Option<Token>, start: usize) -> bool {
        let open = self.open.iter().map(|open| self.lexed.tokens[open.at].anywhere());
        let mut open: Vec<Token> = open.chain(innermost).collect();
        for at in start..self.lexed.tokens.len() {
            let token = self.lexed.tokens[at];
            if token.opens() {
                open.push(token.anywhere());
            } else if token.closes() {
                if open.pop().is_none_or(|opening| counterpart(opening) != token) {
                    return false;
                }
            } else if self.lexed.begins_statement(at) && self.lexed.begins_line(at) {
                break;
            }
        }
        !open.iter().any(|opening| is_weak(index(*opening)))
    }

    /// Takes the brackets from number `first` on out of the script, up to token `end`, and tells
    /// of the innermost.
    fn give_up(&mut self, first: usize, end: usize, why: &str) {
        let (Some(outermost), Some(innermost)) = (self.open.get(first), self.open.last()) else {
            return;
        };
        let (start, innermost) = (outermost.at, innermost.at);
        if !self.is_crossed {
            self.unclosed(first, innermost, end, why);
        }
        self.spoil(start, end);
        self.open.truncate(first);
    }

    /// Gives up the tokens `start..end`, which are behind or around those given up before.
    fn spoil(&mut self, start: usize, end: usize) {
        while self.spoilt.last().is_some_and(|last| last.0 >= start) {
            self.spoilt.pop();
        }
        self.spoilt.push((start, end));
    }

    /// Tells of the bracket at token `open`, the innermost before token `end`, of those from number
    /// `first` on.
    fn unclosed(&mut self, first: usize, open: usize, end: usize, why: &str) {
        let message = format!("{} is never closed", self.lexed.tokens[open].anywhere().shown());
        let place = self.lexed.span(open);
        let diagnostic =
            Diagnostic::error(Code::UnclosedBracket, place, message).label("opened here");
        let unclosed = self.open[first..].iter().rev().filter(|open| open.at < end);
        let closing: Vec<Token> =
            unclosed.map(|open| counterpart(self.lexed.tokens[open.at])).collect();
        let diagnostic = if closing.contains(&Token::TextTail) {
            diagnostic
        } else {
            let text: String = closing.iter().map(|token| token.text()).collect();
            diagnostic.fix(Fix::insert(self.lexed.gap(end), text))
        };
        let is_end = self.lexed.token(end) == Token::End;
        let end = self.lexed.span(end);
        self.report(if is_end { diagnostic } else { diagnostic.also(end, why) });
    }

    /// The end of the script: what is open now is never closed.
    fn finish(&mut self) -> Option<usize> {
        let outermost = self.open.first()?;
        let start = outermost.at;
        let end = outermost.wall.unwrap_or(self.lexed.tokens.len() - 1);
        let innermost = self.open.iter().rev().find(|open| open.at < end).map_or(start, |o| o.at);
        if !self.is_crossed {
            self.unclosed(0, innermost, end, "this statement seems to stand outside of it");
        }
        self.spoil(start, end);
        self.open.clear();
        self.is_crossed = false;
        let goes_on = self.found.len() < self.limits.diagnostics;
        if !goes_on {
            let end_of_script = self.lexed.tokens.len() - 1;
            self.spoil(end, end_of_script);
        }
        goes_on.then_some(end)
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        if self.found.len() < super::most_diagnostics(self.limits) {
            self.found.push(diagnostic);
        }
    }
}

/// The number of a kind of brackets.
fn index(token: Token) -> usize {
    match token.anywhere() {
        Token::OpenParen | Token::CloseParen => 0,
        Token::OpenBracket | Token::CloseBracket => 1,
        Token::OpenBrace | Token::CloseBrace => 2,
        _ => 3,
    }
}

/// Whether brackets of a kind are taken for one another rather than closed from outside.
fn is_weak(index: usize) -> bool {
    index < 2
}

/// What closes `opening`.
fn counterpart(opening: Token) -> Token {
    match opening.anywhere() {
        Token::OpenParen => Token::CloseParen,
        Token::OpenBracket => Token::CloseBracket,
        Token::OpenBrace => Token::CloseBrace,
        _ => Token::TextTail,
    }
}

/// The line that is being read.
#[derive(Default)]
struct ReadLine {
    /// The bytes before are read.
    read: usize,
    indent: usize,
}

impl ReadLine {
    /// The white space, in bytes, before the first thing on the line of token `at`.
    ///
    /// Asked in the order of the tokens, so that no long line is searched twice.
    fn indent(&mut self, lexed: &Lexed<'_>, at: usize) -> usize {
        let end = lexed.span(at).start as usize;
        if let Some(line_break) = lexed.source[self.read..end].rfind('\n') {
            let line = &lexed.source[self.read + line_break + 1..];
            self.indent = line.len() - line.trim_start().len();
        }
        self.read = end;
        self.indent
    }
}
