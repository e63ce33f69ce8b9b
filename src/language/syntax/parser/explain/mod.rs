//! Words for what went wrong: a failure of the grammar becomes something a person can act on.
//!
//! A complaint stands where the thing is missing, that is at the end of the token before, unless
//! what was found instead is on the same line. `missing` knows what people write where something
//! else was expected, `statement` what they write where statements begin and end.

mod missing;
mod remarks;
mod statement;

pub(super) use remarks::{
    chain, colon_in_call, equals_in_record, misplaced, missing_comma, point_length, quoted_label,
};
pub(super) use statement::trailing;

use super::parsed_script::ParsedScript;
use super::problem::{ExpectedTokens, Problem};
use crate::diag::{Code, Diagnostic, nearest};
use crate::syntax::token::Token;

/// The diagnostic of `problem` in the statement that begins with token `start`; `None` when its
/// cause is already reported.
pub(super) fn problem(
    script: &ParsedScript<'_, '_>,
    problem: Problem,
    start: usize,
) -> Option<Diagnostic> {
    let (at, expected) = match problem {
        Problem::Told(diagnostic) => return Some(*diagnostic),
        Problem::Expected { at, expected } => (at, expected),
    };
    let place = FailurePlace { script, start, at };
    let is_statement = expected.has(ExpectedTokens::STATEMENT);
    if place.found() == Token::Bad || is_statement && place.next() == Token::Bad {
        return None;
    }
    let found = match is_statement {
        true => statement::beginning(&place),
        false => missing::explain(&place, expected)
            .unwrap_or_else(|| place.expected(&expected.alternatives())),
    };
    Some(Diagnostic { is_at_end: place.found() == Token::End, ..found })
}

/// Where a rule failed.
struct FailurePlace<'a, 't, 's> {
    script: &'a ParsedScript<'t, 's>,
    /// The first token of the statement.
    start: usize,
    /// The token that was found.
    at: usize,
}

impl<'s> FailurePlace<'_, '_, 's> {
    fn found(&self) -> Token {
        self.script.token(self.at)
    }

    fn next(&self) -> Token {
        self.script.token(self.at + 1)
    }

    /// The token before, in the statement.
    fn before(&self) -> Token {
        if self.at > self.start { self.script.token(self.at - 1) } else { Token::End }
    }

    /// Whether nothing stands between what was found and the token before.
    fn is_glued(&self) -> bool {
        self.script.gap(self.at).end == self.script.span(self.at).start
    }

    /// Whether nothing stands between what was found and the token behind.
    fn is_next_glued(&self) -> bool {
        FailurePlace { at: self.at + 1, ..*self }.is_glued()
    }

    /// Whether what was found is the last of its line.
    fn is_last(&self) -> bool {
        self.next() == Token::End || self.script.begins_line(self.at + 1)
    }

    /// Whether the innermost bracket that is open here is a brace in a string.
    fn is_in_string(&self) -> bool {
        let mut depth = 0_usize;
        for at in (self.start..self.at).rev() {
            let token = self.script.token(at);
            let is_head = matches!(token, Token::TextHead | Token::TextMiddle);
            if depth == 0 && (is_head || token.opens()) {
                return is_head;
            }
            match token {
                Token::TextTail => depth += 1,
                Token::TextHead => depth = depth.saturating_sub(1),
                _ if token.closes() => depth += 1,
                _ if token.opens() => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        false
    }

    fn text(&self) -> &'s str {
        self.script.text(self.at)
    }

    /// What was found, in words.
    fn shown(&self) -> String {
        match self.found() {
            Token::Name | Token::Number => format!("`{}`", self.text()),
            token => token.shown(),
        }
    }

    /// Whether what was found belongs to another line, so that something is missing before.
    fn is_missing(&self) -> bool {
        let found = self.found();
        self.at > self.start
            && (found == Token::End || found.closes() || self.script.begins_line(self.at))
    }

    /// The usual complaint.
    fn expected(&self, want: &str) -> Diagnostic {
        let message = format!("expected {want}, found {}", self.shown());
        if self.is_missing() {
            let diagnostic = Diagnostic::error(Code::Syntax, self.script.gap(self.at), message);
            let diagnostic = diagnostic.label(format!("expected {want} after this"));
            return match self.line_hint() {
                Some(hint) => diagnostic.hint(hint),
                None => diagnostic,
            };
        }
        Diagnostic::error(Code::Syntax, self.script.span(self.at), message)
            .label(format!("expected {want}"))
    }

    /// The usual complaint with a guess at what is meant.
    fn guess(&self, want: &str, meant: &str) -> Diagnostic {
        let message = format!("expected {want}, found {}", self.shown());
        Diagnostic::error(Code::Syntax, self.script.span(self.at), message).meant(meant)
    }

    /// A complaint about what was found.
    fn wrong(&self, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(Code::Syntax, self.script.span(self.at), message)
    }

    /// Why what begins this line does not continue the one before.
    fn line_hint(&self) -> Option<&'static str> {
        remarks::line_hint(self.found())
    }

    /// The word of `among` that the name found may be a slip for.
    fn slip<'w>(&self, among: impl IntoIterator<Item = &'w str>) -> Option<&'w str> {
        if self.found() == Token::Name { nearest(self.text(), among) } else { None }
    }
}
