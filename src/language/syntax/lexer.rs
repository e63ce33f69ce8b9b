//! Text to tokens: logos finds them, this file adds what needs memory: the parts of interpolated
//! strings, nested comments, the beginnings of lines, and habits from other languages.

mod foreign;
mod scan;
mod unseen;

use logos::{Lexer, Logos};

use scan::{PieceEnd, piece};

use super::block_comment::is_closed;
use super::lexed::{Comment, Lexed};
use super::token::Token;
use crate::diag::{Code, Diagnostic, Fix, Span};

/// The tokens of `source`, which is shorter than 4 GiB; keeps at most `most` diagnostics.
pub(super) fn lex(source: &str, most: usize) -> Lexed<'_> {
    let mut scanner = Scanner {
        source,
        lexer: Token::lexer(source),
        out: Lexed { source, ..Lexed::default() },
        open: Vec::new(),
        end: 0,
        most,
        grown: None,
    };
    scanner.out.tokens.reserve(source.len() / 3);
    scanner.out.spans.reserve(source.len() / 3);
    while let Some(token) = scanner.lexer.next() {
        scanner.take(token.unwrap_or(Token::Bad));
    }
    scanner.finish()
}

/// An interpolated string that is still open.
struct Interpolation {
    /// The index of its head.
    head: usize,
    /// Braces open inside the current expression.
    braces: usize,
    /// Other brackets open there.
    brackets: usize,
}

impl Interpolation {
    /// Whether a colon here begins a format.
    fn is_outside_brackets(&self) -> bool {
        self.braces == 0 && self.brackets == 0
    }
}

struct Scanner<'s> {
    source: &'s str,
    lexer: Lexer<'s, Token>,
    out: Lexed<'s>,
    open: Vec<Interpolation>,
    /// Where the token before ends.
    end: usize,
    most: usize,
    /// The finding about stray text that has grown since its message was made.
    grown: Option<usize>,
}

impl<'s> Scanner<'s> {
    fn take(&mut self, token: Token) {
        if matches!(token, Token::LineComment | Token::BlockComment) {
            return self.comment(token);
        }
        let start = self.lexer.span().start;
        if !self.open.is_empty() && self.source[self.end..start].contains('\n') {
            self.give_up_string(self.end);
        }
        match token {
            Token::Text => self.piece(Token::Text, Token::TextHead),
            Token::OpenBrace => {
                if let Some(inner) = self.open.last_mut() {
                    inner.braces += 1;
                }
                self.push(token);
            }
            Token::CloseBrace => self.close_brace(),
            Token::OpenParen | Token::OpenBracket => {
                if let Some(inner) = self.open.last_mut() {
                    inner.brackets += 1;
                }
                self.line_start(token);
            }
            Token::CloseParen | Token::CloseBracket => {
                if let Some(inner) = self.open.last_mut() {
                    inner.brackets = inner.brackets.saturating_sub(1);
                }
                self.push(token);
            }
            Token::Minus => self.line_start(token),
            Token::Colon if self.open.last().is_some_and(Interpolation::is_outside_brackets) => {
                self.format();
            }
            Token::Dot | Token::Number => self.point_or_number(token),
            Token::Foreign => self.foreign(),
            Token::ForeignText => self.foreign_text(),
            Token::Hash => self.hash(),
            Token::Bad => self.stray(),
            _ => self.push(token),
        }
        self.end = self.lexer.span().end;
    }

    fn finish(mut self) -> Lexed<'s> {
        self.name_grown();
        if !self.open.is_empty() {
            self.give_up_string(self.end);
        }
        let end = offset(self.source.len());
        self.out.tokens.push(Token::End);
        self.out.spans.push(Span::new(end, end));
        self.out
    }

    fn span(&self) -> Span {
        let range = self.lexer.span();
        Span::new(offset(range.start), offset(range.end))
    }

    fn push(&mut self, token: Token) {
        self.out.spans.push(self.span());
        self.out.tokens.push(token);
    }

    fn complain(&mut self, diagnostic: Diagnostic) {
        if self.out.diagnostics.len() < self.most {
            self.out.diagnostics.push(diagnostic);
        }
    }

    fn comment(&mut self, token: Token) {
        let text = self.lexer.slice();
        if token == Token::BlockComment && !is_closed(text) {
            let start = self.span().start;
            let diagnostic = Diagnostic::error(
                Code::UnclosedComment,
                Span::new(start, start + 2),
                "this comment is never closed",
            );
            self.complain(
                diagnostic
                    .label("`*/` is missing")
                    .hint("comments nest: every `/*` needs its own `*/`")
                    .fix(Fix::insert(Span::new(self.span().end, self.span().end), " */")),
            );
        }
        let is_doc =
            token == Token::LineComment && text.starts_with("///") && !text.starts_with("////");
        let mut span = self.span();
        span.end -= u32::from(text.ends_with('\r'));
        self.out.comments.push(Comment { span, before: self.out.tokens.len(), is_doc });
    }

    /// A bracket or a minus: another kind when it begins a line.
    fn line_start(&mut self, token: Token) {
        let gap = &self.source[self.end..self.lexer.span().start];
        let begins_line = self.out.tokens.is_empty() || gap.contains('\n');
        self.push(match token {
            Token::OpenParen if begins_line => Token::LineParen,
            Token::OpenBracket if begins_line => Token::LineBracket,
            Token::Minus if begins_line => Token::LineMinus,
            _ => token,
        });
    }

    fn close_brace(&mut self) {
        match self.open.last_mut() {
            Some(inner) if inner.braces == 0 => self.piece(Token::TextTail, Token::TextMiddle),
            Some(inner) => {
                inner.braces -= 1;
                self.push(Token::CloseBrace);
            }
            None => self.push(Token::CloseBrace),
        }
    }

    /// What stands behind a colon, up to the brace that ends the expression.
    fn format(&mut self) {
        let rest = self.lexer.remainder();
        self.lexer.bump(rest.find(['}', '{', '"', '\n']).unwrap_or(rest.len()));
        self.push(Token::TextFormat);
    }

    /// The piece of a string that begins here: `last` when a quote ends it, `more` when a brace does.
    fn piece(&mut self, last: Token, more: Token) {
        let (len, end) = piece(self.lexer.remainder());
        self.lexer.bump(len);
        match end {
            PieceEnd::Quote => {
                if last == Token::TextTail {
                    self.open.pop();
                }
                self.push(last);
            }
            PieceEnd::Brace => {
                if more == Token::TextHead {
                    self.open.push(Interpolation {
                        head: self.out.tokens.len(),
                        braces: 0,
                        brackets: 0,
                    });
                }
                self.push(more);
            }
            PieceEnd::Line => {
                self.push(last);
                self.open.push(Interpolation {
                    head: self.out.tokens.len() - 1,
                    braces: 0,
                    brackets: 0,
                });
                self.give_up_string(self.lexer.span().end);
            }
        }
    }

    /// Reports the outermost open string, which ends with its line at `end`.
    fn give_up_string(&mut self, end: usize) {
        let Some(outermost) = self.open.first() else { return };
        let head = outermost.head;
        let has_brace = self.out.tokens[head] == Token::TextHead;
        let line = self.source[..end].trim_end();
        let span = Span::new(self.out.spans[head].start, offset(line.len()));
        let diagnostic =
            Diagnostic::error(Code::UnclosedString, span, "this string is never closed")
                .label("a `\"` is missing before the end of the line");
        let is_behind_number =
            self.source[..span.start as usize].ends_with(|c: char| c.is_ascii_digit());
        self.complain(if has_brace {
            diagnostic.hint(
                "`{` begins an interpolation that ends with `}`; write `\\{` for the brace itself",
            )
        } else if is_behind_number {
            diagnostic.hint("an inch is written `in`, glued to the number: `3in`")
        } else {
            diagnostic.fix(Fix::insert(Span::new(span.end, span.end), "\""))
        });
        self.out.tokens.truncate(head);
        self.out.spans.truncate(head);
        self.out.tokens.push(Token::Bad);
        self.out.spans.push(span);
        for comment in self.out.comments.iter_mut().rev().take_while(|c| c.before > head + 1) {
            comment.before = head + 1;
        }
        self.open.clear();
    }

    /// `1.` and `.5` are reported and mean what they seem to.
    fn point_or_number(&mut self, token: Token) {
        if !self.is_half_number(token) {
            return self.push(token);
        }
        let whole = self.out.spans.pop().unwrap_or_default().to(self.span());
        let text = &self.source[whole.range()];
        let meant = if token == Token::Dot { format!("{text}0") } else { format!("0{text}") };
        let message = format!("`{text}` lacks digits on one side of its point");
        let diagnostic = Diagnostic::error(Code::BadNumber, whole, message);
        self.complain(diagnostic.meant(&meant));
        self.out.tokens.pop();
        self.out.tokens.push(Token::Number);
        self.out.spans.push(whole);
    }

    /// Whether `token` and the one before it are `1.` or `.5`.
    fn is_half_number(&self, token: Token) -> bool {
        let (Some(last), Some(before)) = (self.out.tokens.last(), self.out.spans.last()) else {
            return false;
        };
        let is_glued = before.end as usize == self.lexer.span().start;
        match (last, token) {
            (Token::Number, Token::Dot) => {
                is_glued && self.source[before.range()].bytes().all(|b| b.is_ascii_digit())
            }
            (Token::Dot, Token::Number) => {
                let at = self.out.spans.len() - 1;
                let stands_alone = at == 0
                    || self.out.spans[at - 1].end < before.start
                    || !self.out.tokens[at - 1].ends_expression();
                is_glued && stands_alone
            }
            _ => false,
        }
    }

    fn foreign_text(&mut self) {
        let (span, text) = (self.span(), self.lexer.slice());
        let inner = text.trim_matches(['\'', '"', '“', '”', '„', '‟', '‘', '’']);
        let diagnostic =
            Diagnostic::error(Code::StrayText, span, "a string stands in straight double quotes");
        self.complain(diagnostic.meant(&format!("\"{inner}\"")));
        self.push(Token::Bad);
    }

    /// A comment of another language, or a colour without quotes.
    fn hash(&mut self) {
        let rest = self.lexer.remainder();
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_hexdigit()).len();
        let is_colour = matches!(digits, 3 | 4 | 6 | 8);
        let line = rest.find('\n').unwrap_or(rest.len());
        self.lexer.bump(if is_colour { digits } else { line });
        let span = Span::new(self.span().start, self.span().start + 1);
        let diagnostic = Diagnostic::error(Code::StrayText, span, "`#` means nothing here")
            .label("not part of the language");
        if is_colour {
            let meant = format!("\"{}\"", self.lexer.slice());
            let fix = Fix::replace(self.span(), meant.clone());
            self.complain(diagnostic.hint(format!("a colour is a string: `{meant}`")).fix(fix));
            self.push(Token::Bad);
        } else {
            let fix = Fix::replace(span, "//");
            self.complain(diagnostic.hint("a comment begins with `//`").fix(fix));
        }
    }

    /// Text that is nothing; neighbours are reported as one.
    fn stray(&mut self) {
        let span = self.span();
        self.name_grown();
        let glued = self.out.spans.last().is_some_and(|last| last.end == span.start);
        match self.out.diagnostics.last_mut() {
            Some(last)
                if glued && last.code == Code::StrayText && last.primary.span.end == span.start =>
            {
                last.primary.span = last.primary.span.to(span);
                if let Some(token) = self.out.spans.last_mut() {
                    *token = last.primary.span;
                }
                self.grown = Some(self.out.diagnostics.len() - 1);
                return;
            }
            _ => {}
        }
        let diagnostic = Diagnostic::error(Code::StrayText, span, meaningless(self.lexer.slice()));
        let diagnostic = diagnostic.label("not part of the language");
        self.complain(match self.lexer.slice() {
            "?" => diagnostic.hint("a choice is written `if c then a else b`"),
            "\\" => diagnostic.hint("lines need no continuation mark").fix(Fix::remove(span, "\\")),
            "'" => diagnostic.hint("strings take double quotes"),
            _ => diagnostic,
        });
        self.push(Token::Bad);
    }

    /// Makes the message of stray text that has grown.
    fn name_grown(&mut self) {
        if let Some(found) = self.grown.take().and_then(|at| self.out.diagnostics.get_mut(at)) {
            found.message = meaningless(&self.source[found.primary.span.range()]);
        }
    }
}

/// Letters of stray text that its message repeats.
const MOST_REPEATED: usize = 60;

fn meaningless(text: &str) -> String {
    if let Some(code) = unseen::code(text) {
        return format!("the invisible character {code} means nothing here");
    }
    match text.char_indices().nth(MOST_REPEATED) {
        Some((end, _)) => format!("`{}…` means nothing here", &text[..end]),
        None => format!("`{text}` means nothing here"),
    }
}

/// `source` is shorter than 4 GiB, which `parse` makes sure of.
fn offset(at: usize) -> u32 {
    u32::try_from(at).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests;
