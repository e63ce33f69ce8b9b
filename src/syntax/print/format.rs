//! The formatter: canonical text that keeps comments, blank lines, and how numbers are written.
//!
//! Comments between statements stay where they are. A statement with a comment inside of it stays
//! as it was written.

use super::layout::Layout;
use super::{WIDTH, statement, test_head};
use crate::diag::{Diagnostic, Span};
use crate::limits::Limits;
use crate::syntax::ast::{Statement, StatementKind};
use crate::syntax::lexed::Comment;
use crate::syntax::lexer::lex;
use crate::syntax::parser::parse;

/// `source` in canonical form; the same text again when it has that form already.
///
/// # Errors
/// What is wrong with the text, if it cannot be parsed.
pub fn format(source: &str, limits: &Limits) -> Result<String, Vec<Diagnostic>> {
    let (tree, diagnostics) = parse(source, limits);
    if !diagnostics.is_empty() {
        return Err(diagnostics);
    }
    let comments = lex(source, 0).comments;
    let mut formatter =
        Formatter { source, comments: &comments, out: String::new(), depth: 0, end: 0 };
    formatter.statements(&tree.statements, source.len());
    Ok(formatter.out)
}

struct Formatter<'a> {
    source: &'a str,
    /// Those that are not written yet.
    comments: &'a [Comment],
    out: String,
    /// Tests around.
    depth: usize,
    /// Where in the source the last thing written ends.
    end: usize,
}

impl Formatter<'_> {
    /// The statements and comments up to byte `end`.
    fn statements(&mut self, statements: &[Statement<'_>], end: usize) {
        for statement in statements {
            self.comments_before(statement.span.start as usize);
            self.line_before(statement.span.start as usize);
            self.statement(statement);
        }
        self.comments_before(end);
        if !self.out.is_empty() && !self.out.ends_with('\n') {
            self.out.push('\n');
        }
    }

    fn statement(&mut self, statement: &Statement<'_>) {
        let span = statement.span;
        let has_comment = |from: u32, to: u32, comments: &[Comment]| {
            comments.iter().take_while(|c| c.span.start < to).any(|c| c.span.start >= from)
        };
        match &statement.kind {
            StatementKind::Test { name, body }
                if !has_comment(span.start, name.span.end, self.comments) =>
            {
                self.out.push_str(&test_head(self.source, name));
                self.depth += 1;
                self.end = name.span.end as usize;
                self.out.push('\n');
                self.statements(body, span.end as usize - 1);
                self.depth -= 1;
                self.indent();
                self.out.push('}');
            }
            _ if has_comment(span.start, span.end, self.comments) => {
                self.out.push_str(&self.source[span.range()]);
                let n_inside = self.comments.iter().take_while(|c| c.span.start < span.end).count();
                self.comments = &self.comments[n_inside..];
            }
            _ => self.fresh(statement),
        }
        self.end = span.end as usize;
    }

    /// A statement without comments, laid out anew.
    fn fresh(&mut self, one: &Statement<'_>) {
        let mut layout = Layout::new(Some(self.source));
        for _ in 0..self.depth {
            layout.indent();
        }
        statement(&mut layout, one);
        self.out.push_str(layout.render(WIDTH).trim_start());
    }

    /// The comments up to byte `end`: behind the last statement, or on lines of their own.
    fn comments_before(&mut self, end: usize) {
        while let Some((comment, rest)) = self.comments.split_first() {
            if comment.span.start as usize >= end {
                return;
            }
            self.comments = rest;
            let gap = &self.source[self.end..comment.span.start as usize];
            if self.end > 0 && !gap.contains('\n') && !self.out.ends_with('\n') {
                self.out.push_str("  ");
            } else {
                self.line_before(comment.span.start as usize);
            }
            let Span { start, end } = comment.span;
            self.out.push_str(self.source[start as usize..end as usize].trim_end());
            self.end = end as usize;
        }
    }

    /// A new line for what begins at byte `start`, after a blank one if one was there.
    fn line_before(&mut self, start: usize) {
        let gap = &self.source[self.end..start];
        let is_first = self.out.is_empty() || self.out.ends_with("{\n");
        if !self.out.is_empty() && !self.out.ends_with('\n') {
            self.out.push('\n');
        }
        if !is_first && gap.matches('\n').count() > 1 {
            self.out.push('\n');
        }
        self.indent();
    }

    fn indent(&mut self) {
        self.out.extend(std::iter::repeat_n("  ", self.depth));
    }
}
