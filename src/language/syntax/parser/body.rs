//! Series of statements: each broken one is left behind for itself, and hides no other.

use chumsky::prelude::custom;

use super::explain;
use super::input::{Input, Parsed, Rule, complain, here, peek, since, skip_to, take};
use super::statement::statement;
use crate::syntax::ast::{Statement, StatementKind};
use crate::syntax::token::Token;

/// Where a statement stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StatementContext {
    /// At the top level.
    Script,
    /// In the braces of a `test`.
    Test,
    /// In the braces of an expression.
    Block,
}

/// All statements of a script.
pub(super) fn script<'t, 's: 't>() -> impl Rule<'t, 's, Vec<Statement<'s>>> {
    custom(|input: &mut Input<'t, '_, 's>| {
        let mut statements = Vec::new();
        loop {
            statements.extend(statements_of(input, StatementContext::Script));
            match peek(input) {
                Token::End => return Ok(statements),
                _ => input.skip(),
            }
        }
    })
}

/// The definitions at the beginning of a block.
pub(super) fn definitions<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Vec<Statement<'s>>> {
    let mut statements = Vec::new();
    loop {
        while take(input, Token::Semicolon) {}
        let at = here(input);
        if !input.state().begins_statement(at) {
            return Ok(statements);
        }
        let is_definition = peek(input).begins_definition();
        if !is_definition {
            let diagnostic = explain::misplaced(input.state(), at, StatementContext::Block);
            complain(input, diagnostic);
        }
        let statement = recovering(input, StatementContext::Block);
        if is_definition {
            statements.push(statement);
        }
    }
}

/// Statements up to the end of the script, or to the brace that closes the body.
pub(super) fn statements_of<'t, 's: 't>(
    input: &mut Input<'t, '_, 's>,
    body: StatementContext,
) -> Vec<Statement<'s>> {
    let mut statements = Vec::new();
    loop {
        match peek(input) {
            Token::Semicolon => input.skip(),
            Token::End | Token::CloseBrace => return statements,
            _ => statements.push(recovering(input, body)),
        }
    }
}

/// A statement; if it is broken, an error node up to the next one, and a finding.
fn recovering<'t, 's: 't>(input: &mut Input<'t, '_, 's>, body: StatementContext) -> Statement<'s> {
    let start = here(input);
    let checkpoint = input.save();
    let docs = documentation(input, start);
    match statement(input, body) {
        Ok(kind) => {
            let span = since(input, start);
            // What is left over belongs to the statement, which is then as broken as that.
            let span = if finish(input, body, start) { since(input, start) } else { span };
            Statement { docs, kind, span }
        }
        Err(problem) => {
            let diagnostic = explain::problem(input.state(), problem, start);
            if let Some(diagnostic) = diagnostic {
                complain(input, diagnostic);
            }
            let end = input.state().end_of_broken(start).max(start + 1);
            input.rewind(checkpoint);
            skip_to(input, end);
            Statement { docs, kind: StatementKind::Error, span: since(input, start) }
        }
    }
}

/// The `///` lines right before token `start`.
fn documentation(input: &mut Input<'_, '_, '_>, start: usize) -> Option<String> {
    let script = input.state();
    let comments = &script.comments;
    let first = comments.partition_point(|comment| comment.before < start);
    let lines: Vec<&str> = comments[first..]
        .iter()
        .take_while(|comment| comment.before == start)
        .filter(|comment| comment.is_doc)
        .map(|comment| {
            let line = &script.source[comment.span.range()][3..];
            line.strip_prefix(' ').unwrap_or(line).trim_end()
        })
        .collect();
    (!lines.is_empty()).then(|| lines.join("\n"))
}

/// Leaves a whole statement behind: what still follows it is reported and skipped. Whether
/// anything did.
fn finish(input: &mut Input<'_, '_, '_>, body: StatementContext, start: usize) -> bool {
    let at = here(input);
    let next = peek(input);
    let script = input.state();
    let begins_line = script.begins_line(at);
    let is_over = match body {
        StatementContext::Script => next == Token::End,
        StatementContext::Test => next == Token::CloseBrace,
        // What follows is the value of the block, or is reported as such.
        StatementContext::Block => true,
    };
    let is_next = script.begins_statement(at)
        || (begins_line && (next.begins_statement() || next == Token::Name))
        || (body == StatementContext::Test && script.is_word(at, "expect"));
    if is_over || is_next || next == Token::Semicolon {
        return false;
    }
    let end = script.end_of_broken(at);
    if let Some(diagnostic) = explain::trailing(script, start, at) {
        complain(input, diagnostic);
    }
    skip_to(input, end);
    true
}
