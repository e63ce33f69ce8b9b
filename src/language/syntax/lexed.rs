//! A text as tokens, and the questions that can be asked about them by their numbers.

use super::token::Token;
use crate::diag::{Diagnostic, Span};

/// The tokens of a text, and what stands between them.
#[derive(Debug, Default)]
pub(super) struct Lexed<'s> {
    /// The text.
    pub(super) source: &'s str,
    /// The kinds; the last one is [`Token::End`].
    pub(super) tokens: Vec<Token>,
    /// Their places.
    pub(super) spans: Vec<Span>,
    /// The comments in order.
    pub(super) comments: Vec<Comment>,
    /// What could not be read.
    pub(super) diagnostics: Vec<Diagnostic>,
}

impl<'s> Lexed<'s> {
    /// The kind of token `at`; beyond the end [`Token::End`].
    pub(super) fn token(&self, at: usize) -> Token {
        self.tokens.get(at).copied().unwrap_or(Token::End)
    }

    /// The place of token `at`; beyond the end the end.
    pub(super) fn span(&self, at: usize) -> Span {
        self.spans[at.min(self.spans.len() - 1)]
    }

    /// The text of token `at`.
    pub(super) fn text(&self, at: usize) -> &'s str {
        &self.source[self.span(at).range()]
    }

    /// The text of the tokens `start..end`.
    pub(super) fn source_of(&self, start: usize, end: usize) -> &'s str {
        &self.source[self.place(start, end).range()]
    }

    /// The place of the tokens `start..end`.
    pub(super) fn place(&self, start: usize, end: usize) -> Span {
        if end > start { self.span(start).to(self.span(end - 1)) } else { self.gap(start) }
    }

    /// The empty place after the token before `at`.
    pub(super) fn gap(&self, at: usize) -> Span {
        match at.checked_sub(1) {
            Some(before) => self.span(before).at_end(),
            None => Span::default(),
        }
    }

    /// Whether token `at` is the first one of its line.
    pub(super) fn begins_line(&self, at: usize) -> bool {
        let before = self.gap(at).end as usize;
        at == 0 || self.source[before..self.span(at).start as usize].contains('\n')
    }

    /// Those of some tokens that stand in no brackets among these, up to a bracket that closes what opened before them.
    pub(super) fn outside_brackets(
        &self,
        tokens: std::ops::Range<usize>,
    ) -> impl Iterator<Item = usize> {
        let depths = tokens.scan(0_usize, |depth, at| {
            let token = self.token(at);
            if token.closes() {
                *depth = depth.checked_sub(1)?;
                return Some((at, false));
            }
            let is_outside = *depth == 0 && !token.opens();
            *depth += usize::from(token.opens());
            Some((at, is_outside))
        });
        depths.filter(|(_, is_outside)| *is_outside).map(|(at, _)| at)
    }

    /// Whether token `at` is the contextual word `word`.
    pub(super) fn is_word(&self, at: usize, word: &str) -> bool {
        self.token(at) == Token::Name && self.text(at) == word
    }

    /// Whether a statement begins with token `at`: its keyword is no label, no field, and no name.
    pub(super) fn begins_statement(&self, at: usize) -> bool {
        self.token(at).begins_statement()
            && !matches!(
                self.token(at + 1),
                Token::Equals
                    | Token::Colon
                    | Token::Comma
                    | Token::Arrow
                    | Token::CloseParen
                    | Token::CloseBracket
                    | Token::CloseBrace
            )
            && (at == 0 || self.token(at - 1) != Token::Dot)
            && !(self.token(at).names_built_in() && self.token(at + 1) == Token::OpenParen)
    }

    /// Where the broken statement that began with token `start` ends: before the next thing that
    /// looks like a statement, or before the brace that closes its body. Brackets are in pairs.
    pub(super) fn end_of_broken(&self, start: usize) -> usize {
        let mut depth = 0_usize;
        let mut at = start;
        loop {
            match self.token(at) {
                Token::End => return at,
                token if token.opens() => depth += 1,
                token if token.closes() => match depth.checked_sub(1) {
                    Some(less) => depth = less,
                    None => return at,
                },
                _ if depth > 0 || at == start => {}
                _ if self.is_wall(at) => return at,
                _ => {}
            }
            at += 1;
        }
    }

    /// Whether a statement begins with token `at` of a broken one: not where an operand is missing.
    fn is_wall(&self, at: usize) -> bool {
        let follows = matches!(self.token(at - 1), Token::Semicolon)
            || self.token(at - 1).ends_expression()
            || self.begins_line(at);
        follows && self.begins_statement(at) || self.looks_like_statement(at)
    }

    /// A line that begins with `name =` or `name name`: a statement without its keyword.
    fn looks_like_statement(&self, at: usize) -> bool {
        self.token(at) == Token::Name
            && matches!(self.token(at + 1), Token::Name | Token::Equals)
            && self.begins_line(at)
    }

    /// Makes the tokens `start..end` such as are already reported.
    pub(super) fn give_up(&mut self, start: usize, end: usize) {
        self.tokens[start..end].fill(Token::Bad);
    }
}

/// A comment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Comment {
    /// Its place, without the line break.
    pub(super) span: Span,
    /// The index of the token that follows.
    pub(super) before: usize,
    /// Whether it is documentation: `///`.
    pub(super) is_doc: bool,
}
