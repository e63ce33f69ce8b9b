//! A pass over the tokens that refuses what nests too deeply, before anything recurses over it.
//!
//! Two measures: *nesting* is how deep the parser recurses (brackets, and operators that take
//! everything to their right); *height* is how deep the tree can become, which later passes
//! recurse over (a chain such as `1 + 1 + ...` is a tree as deep as it is long).

use crate::diag::{Code, Diagnostic};
use crate::limits::{Ceiling, Limits};
use crate::syntax::lexed::Lexed;
use crate::syntax::token::Token;

/// Gives up statements that are too deep, and tells so. Brackets come in pairs already.
pub(super) fn check(lexed: &mut Lexed<'_>, limits: &Limits) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut outer: Vec<Level> = Vec::new();
    let mut level = Level::default();
    let mut statement = 0;
    let mut at = 0;
    while at < lexed.tokens.len() {
        let token = lexed.tokens[at];
        if token.begins_statement() && lexed.begins_statement(at) {
            level.next_item();
            if outer.is_empty() {
                (level, statement) = (Level::default(), at);
            }
        }
        if token.opens() {
            let is_postfix = at > 0 && lexed.tokens[at - 1].ends_expression();
            level.links += usize::from(is_postfix);
            let inner = Level { enclosing: level.nesting() + 1, ..Level::default() };
            outer.push(std::mem::replace(&mut level, inner));
        } else if token.closes() {
            let height = level.height() + 1;
            level = outer.pop().unwrap_or_default();
            level.tallest = level.tallest.max(height);
        } else {
            let before = at.checked_sub(1).map_or(Token::End, |before| lexed.tokens[before]);
            level.take(token, before);
        }
        if let Some((message, ceiling)) = level.excess(limits) {
            found.push(too_deep(lexed, at, message).crossing(ceiling));
            at = give_up(lexed, statement);
            (outer, level) = (Vec::new(), Level::default());
        } else {
            at += 1;
        }
    }
    found
}

/// What is known inside one pair of brackets.
#[derive(Clone, Copy, Default)]
struct Level {
    /// Nesting of the brackets around.
    enclosing: usize,
    /// Right-nesting operators by when they end: `^` and prefix `-` at an operator that binds less,
    /// `not` at `and` and the like, `if` and `=>` at the end of the item.
    tight: usize,
    nots: usize,
    loose: usize,
    /// Operators, calls, indices and fields of the current item.
    links: usize,
    /// Height of the tallest bracket in the current item.
    tallest: usize,
    /// Height of the tallest item before.
    finished: usize,
}

impl Level {
    fn nesting(&self) -> usize {
        self.enclosing + self.tight + self.nots + self.loose
    }

    fn height(&self) -> usize {
        self.finished.max(self.links + self.tallest)
    }

    /// A comma: the next item of a list begins.
    fn next_item(&mut self) {
        let Self { enclosing, .. } = *self;
        *self = Self { enclosing, finished: self.height(), ..Self::default() };
    }

    fn take(&mut self, token: Token, before: Token) {
        match token {
            Token::Comma | Token::Semicolon | Token::TextMiddle => self.next_item(),
            Token::Caret => self.tight += 1,
            Token::Minus if before.ends_expression() => self.tight = 0,
            Token::Minus | Token::LineMinus => self.tight += 1,
            Token::Not => self.nots += 1,
            Token::If | Token::Arrow => self.loose += 1,
            Token::And | Token::Or | Token::Pipe | Token::Then | Token::Else => {
                (self.tight, self.nots) = (0, 0);
            }
            Token::Dot => {}
            _ if token.is_infix() => self.tight = 0,
            _ => return,
        }
        self.links += 1;
    }

    /// What is wrong, if anything, and the ceiling that was crossed.
    fn excess(&self, limits: &Limits) -> Option<(String, &'static str)> {
        if self.nesting() > limits.nesting {
            return Some((format!("nested more than {} deep", limits.nesting), Ceiling::NESTING));
        }
        let is_long = self.links + self.tallest > limits.chain;
        let message = || format!("more than {} operators in one expression", limits.chain);
        is_long.then(|| (message(), Ceiling::CHAIN))
    }
}

/// Takes the statement that began at token `start` out of the script; answers where the next begins.
fn give_up(lexed: &mut Lexed<'_>, start: usize) -> usize {
    let end = lexed.end_of_broken(start);
    let is_statement = lexed.begins_statement(start);
    lexed.give_up((start + usize::from(is_statement)).min(end), end);
    end
}

fn too_deep(lexed: &Lexed<'_>, at: usize, message: String) -> Diagnostic {
    Diagnostic::error(Code::TooDeep, lexed.span(at), message)
        .label("here the limit is passed")
        .hint("give inner parts names of their own with `let`")
}
