//! Expressions: operators by their binding powers, in one loop (Pratt, "Top down operator
//! precedence", 1973), then calls, indices and fields.

use chumsky::prelude::custom;

use super::explain;
use super::input::{
    Input, Parsed, Rule, complain, expected, here, label, list, peek, peek_second, since, take,
};
use super::primary::primary;
use super::problem::{ExpectedTokens, Problem};
use crate::diag::{Code, Diagnostic};
use crate::syntax::ast::{Arg, BinaryOp, Expr, ExprKind, UnaryOp};
use crate::syntax::token::Token;

/// Powers of the non-associative operators, and of those that stand before their operand.
const COMPARISON: u8 = 10;
const RANGE: u8 = 12;
const NOT: u8 = 8;
const NEGATE: u8 = 18;

/// An operator between two operands.
#[derive(Clone, Copy)]
enum Infix {
    Pipe,
    Binary(BinaryOp),
}

/// Binding powers to the left and to the right, loosest first.
fn infix(token: Token) -> Option<(u8, u8, Infix)> {
    let binary = |left, right, op| Some((left, right, Infix::Binary(op)));
    match token {
        Token::Pipe => Some((2, 3, Infix::Pipe)),
        Token::Or => binary(4, 5, BinaryOp::Or),
        Token::And => binary(6, 7, BinaryOp::And),
        Token::Equal => binary(COMPARISON, 11, BinaryOp::Equal),
        Token::NotEqual => binary(COMPARISON, 11, BinaryOp::NotEqual),
        Token::Less => binary(COMPARISON, 11, BinaryOp::Less),
        Token::LessEqual => binary(COMPARISON, 11, BinaryOp::LessEqual),
        Token::Greater => binary(COMPARISON, 11, BinaryOp::Greater),
        Token::GreaterEqual => binary(COMPARISON, 11, BinaryOp::GreaterEqual),
        Token::Near => binary(COMPARISON, 11, BinaryOp::Near),
        Token::Range => binary(RANGE, 13, BinaryOp::Range),
        Token::RangeBelow => binary(RANGE, 13, BinaryOp::RangeBelow),
        Token::Plus => binary(14, 15, BinaryOp::Add),
        Token::Minus => binary(14, 15, BinaryOp::Subtract),
        Token::Star => binary(16, 17, BinaryOp::Multiply),
        Token::Slash => binary(16, 17, BinaryOp::Divide),
        Token::Percent => binary(16, 17, BinaryOp::Remainder),
        Token::Caret => binary(21, 20, BinaryOp::Power),
        _ => None,
    }
}

/// An expression.
pub(super) fn expression<'t, 's: 't>() -> impl Rule<'t, 's, Expr<'s>> {
    custom(take_expression)
}

/// The rule of [`expression`].
pub(super) fn take_expression<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Expr<'s>> {
    climb(input, 0)
}

/// An expression of operators that bind to the left with power `least` or more.
fn climb<'t, 's: 't>(input: &mut Input<'t, '_, 's>, least: u8) -> Parsed<Expr<'s>> {
    let start = here(input);
    let mut left = match peek(input) {
        Token::Minus | Token::LineMinus => prefix(input, UnaryOp::Negate, NEGATE)?,
        Token::Not => prefix(input, UnaryOp::Not, NOT)?,
        _ => operand(input)?,
    };
    let mut chained = None;
    while let Some((power, right_power, operator)) = infix(peek(input)) {
        if power < least {
            break;
        }
        let operator_at = here(input);
        input.skip();
        let right = climb(input, right_power)?;
        if let Some((first, _)) = chained.filter(|&(_, before)| before == power) {
            let diagnostic = explain::chain(input, [start, first, operator_at]);
            complain(input, diagnostic);
        }
        let is_chainless = power == COMPARISON || power == RANGE;
        chained = is_chainless.then_some((operator_at, power));
        left = combine(input, operator, left, right)?;
    }
    Ok(left)
}

fn prefix<'t, 's: 't>(input: &mut Input<'t, '_, 's>, op: UnaryOp, power: u8) -> Parsed<Expr<'s>> {
    let start = here(input);
    input.skip();
    let operand = climb(input, power)?;
    Ok(Expr { kind: ExprKind::Unary(op, Box::new(operand)), span: since(input, start) })
}

fn combine<'t, 's: 't>(
    input: &mut Input<'t, '_, 's>,
    operator: Infix,
    left: Expr<'s>,
    right: Expr<'s>,
) -> Parsed<Expr<'s>> {
    let span = left.span.to(right.span);
    let kind = match operator {
        Infix::Pipe => {
            if !is_callee(&right) {
                let message = "`|>` passes a value into a call";
                complain(
                    input,
                    Diagnostic::error(Code::Syntax, right.span, message)
                        .label("this is no call")
                        .hint("`a |> f(b)` is `f(a, b)`; put the pipe into parentheses to go on with its result"),
                );
            }
            ExprKind::Pipe(Box::new([left, right]))
        }
        Infix::Binary(BinaryOp::Near) if take(input, Token::Within) => {
            let tolerance = climb(input, COMPARISON + 1)?;
            let span = span.to(tolerance.span);
            let kind = ExprKind::Within(Box::new([left, right, tolerance]));
            return Ok(Expr { kind, span });
        }
        Infix::Binary(op) => ExprKind::Binary(op, Box::new([left, right])),
    };
    Ok(Expr { kind, span })
}

/// Whether a value can be piped into it.
fn is_callee(right: &Expr<'_>) -> bool {
    matches!(
        right.kind,
        ExprKind::Call(..)
            | ExprKind::Name(_)
            | ExprKind::Field(..)
            | ExprKind::Index(_)
            | ExprKind::Group(_)
            | ExprKind::Error
    )
}

/// A primary expression with its calls, indices and fields.
fn operand<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Expr<'s>> {
    let start = here(input);
    let mut left = primary(input)?;
    loop {
        let kind = match peek(input) {
            Token::OpenParen if is_literal(&left) => return Ok(left),
            Token::OpenParen => {
                input.skip();
                let arguments = list(input, Token::CloseParen, argument)?;
                ExprKind::Call(Box::new(left), arguments)
            }
            Token::OpenBracket => {
                input.skip();
                let index = take_expression(input)?;
                close_index(input, &left)?;
                ExprKind::Index(Box::new([left, index]))
            }
            Token::Dot => {
                input.skip();
                let name = label(input)?;
                ExprKind::Field(Box::new(left), name)
            }
            _ => return Ok(left),
        };
        left = Expr { kind, span: since(input, start) };
    }
}

/// Whether it can certainly not be called, so that a parenthesis after it means something else.
fn is_literal(left: &Expr<'_>) -> bool {
    matches!(
        left.kind,
        ExprKind::Number(..)
            | ExprKind::Text(_)
            | ExprKind::Interpolation(_)
            | ExprKind::Bool(_)
            | ExprKind::None
            | ExprKind::Point(_)
            | ExprKind::List(_)
            | ExprKind::Record(_)
            | ExprKind::Comprehension(_)
    )
}

/// The `]` of an index; between two lists of a list a missing comma looks like one.
fn close_index<'t, 's: 't>(input: &mut Input<'t, '_, 's>, left: &Expr<'s>) -> Parsed<()> {
    if take(input, Token::CloseBracket) {
        return Ok(());
    }
    if peek(input) == Token::Comma && is_literal(left) {
        let diagnostic = Diagnostic::error(Code::Syntax, left.span.at_end(), "a `,` is missing")
            .label("expected `,` after this");
        return Err(Problem::Told(Box::new(diagnostic)));
    }
    Err(expected(input, ExpectedTokens::token(Token::CloseBracket)))
}

/// An argument of a call: `value`, `label = value` or `_`.
pub(super) fn argument<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Arg<'s>> {
    let name = match (peek(input), peek_second(input)) {
        (token, Token::Equals) if token.is_word() => {
            let name = label(input)?;
            input.skip();
            Some(name)
        }
        (token, Token::Colon) if token.is_word() => {
            let at = here(input);
            let diagnostic = explain::colon_in_call(input.state(), at);
            complain(input, diagnostic);
            let name = label(input)?;
            input.skip();
            Some(name)
        }
        _ => None,
    };
    let second = peek_second(input);
    if peek(input) == Token::Placeholder && matches!(second, Token::Comma | Token::CloseParen) {
        let start = here(input);
        input.skip();
        let value = Expr { kind: ExprKind::Placeholder, span: since(input, start) };
        return Ok(Arg { name, value });
    }
    Ok(Arg { name, value: take_expression(input)? })
}
