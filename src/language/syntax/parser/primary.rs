//! Expressions without operators: literals, names, everything in brackets, functions and choices.

use super::body::definitions;
use super::explain;
use super::expression::take_expression;
use super::input::{
    Input, Parsed, complain, expected, here, label, list, peek, peek_second, require, since, take,
    take_new_name,
};
use super::literal::{number, text};
use super::problem::ExpectedTokens;
use crate::diag::{Code, Diagnostic, Span};
use crate::syntax::ast::{
    Block, Comprehension, Element, Expr, ExprKind, Field, Generator, Name, Pattern,
};
use crate::syntax::token::Token;

/// An expression without operators.
pub(super) fn primary<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Expr<'s>> {
    let start = here(input);
    let kind = match peek(input) {
        Token::Number => number(input),
        Token::Name => name_or_function(input)?,
        Token::OpenParen | Token::LineParen => parentheses(input)?,
        Token::OpenBracket | Token::LineBracket => brackets(input)?,
        Token::OpenBrace => braces(input)?,
        Token::Text | Token::TextHead => return text(input),
        Token::True => word(input, ExprKind::Bool(true)),
        Token::False => word(input, ExprKind::Bool(false)),
        Token::None => word(input, ExprKind::None),
        Token::If => choice(input)?,
        Token::Placeholder => placeholder(input)?,
        token if token.names_built_in() && peek_second(input) == Token::OpenParen => {
            ExprKind::Name(label(input)?.text)
        }
        Token::Bad => {
            while take(input, Token::Bad) {}
            ExprKind::Error
        }
        token if token.is_keyword() && peek_second(input) == Token::Arrow => {
            let parameter = take_new_name(input)?;
            function(input, vec![parameter])?
        }
        _ => return Err(expected(input, ExpectedTokens::EXPRESSION)),
    };
    Ok(Expr { kind, span: since(input, start) })
}

fn word<'s>(input: &mut Input<'_, '_, 's>, kind: ExprKind<'s>) -> ExprKind<'s> {
    input.skip();
    kind
}

/// `name` or `name => body`
fn name_or_function<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<ExprKind<'s>> {
    let name = label(input)?;
    if peek(input) == Token::Arrow {
        return function(input, vec![name]);
    }
    Ok(ExprKind::Name(name.text))
}

/// `=> body`
fn function<'t, 's: 't>(
    input: &mut Input<'t, '_, 's>,
    parameters: Vec<Name<'s>>,
) -> Parsed<ExprKind<'s>> {
    require(input, Token::Arrow)?;
    Ok(ExprKind::Lambda(parameters, Box::new(take_expression(input)?)))
}

/// `_` that is not a whole argument.
fn placeholder<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<ExprKind<'s>> {
    if peek_second(input) == Token::Arrow {
        let parameter = take_new_name(input)?;
        return function(input, vec![parameter]);
    }
    let start = here(input);
    input.skip();
    let diagnostic = Diagnostic::error(
        Code::Syntax,
        since(input, start),
        "`_` stands for a whole argument of a call and for nothing else",
    );
    complain(input, diagnostic.hint("for more than that write a function: `x => f(2*x)`"));
    Ok(ExprKind::Error)
}

/// `if c then a else b`
fn choice<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<ExprKind<'s>> {
    input.skip();
    let condition = take_expression(input)?;
    require(input, Token::Then)?;
    let first = take_expression(input)?;
    require(input, Token::Else)?;
    let second = take_expression(input)?;
    Ok(ExprKind::If(Box::new([condition, first, second])))
}

/// `(a)`, a point, or the parameters of a function.
fn parentheses<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<ExprKind<'s>> {
    let start = here(input);
    input.skip();
    if is_parameter_list(input) {
        let parameters = list(input, Token::CloseParen, take_new_name)?;
        return function(input, parameters);
    }
    let mut items = list(input, Token::CloseParen, take_expression)?;
    if peek(input) == Token::Arrow {
        let parameters = items.iter().filter_map(|item| parameter(input, item)).collect();
        return function(input, parameters);
    }
    let span = since(input, start);
    match items.len() {
        1 => Ok(items.pop().map_or(ExprKind::Error, |only| ExprKind::Group(Box::new(only)))),
        2 | 3 => Ok(ExprKind::Point(items)),
        n => {
            // Two parts without a comma between them are told of, and may have been one.
            let is_told = |found: &Diagnostic| found.primary.span.start >= span.start;
            if !input.state().diagnostics.last().is_some_and(is_told) {
                complain(input, explain::point_length(n, span));
            }
            Ok(ExprKind::Error)
        }
    }
}

/// Whether words and commas follow, then `) =>`.
fn is_parameter_list(input: &mut Input<'_, '_, '_>) -> bool {
    let start = here(input);
    let script = input.state();
    let is_item =
        |token: Token| token.is_word() || matches!(token, Token::Comma | Token::Placeholder);
    let n_items = script.tokens[start..].iter().take_while(|token| is_item(**token)).count();
    script.token(start + n_items) == Token::CloseParen
        && script.token(start + n_items + 1) == Token::Arrow
}

/// A parameter that was read as an expression.
fn parameter<'s>(input: &mut Input<'_, '_, 's>, item: &Expr<'s>) -> Option<Name<'s>> {
    match item.kind {
        ExprKind::Name(text) => return Some(Name { text, span: item.span }),
        ExprKind::Error => {}
        _ => {
            let message = "a parameter of a function must be a plain name";
            let diagnostic = Diagnostic::error(Code::BadParameter, item.span, message);
            complain(input, diagnostic.label("not a name"));
        }
    }
    None
}

/// A list or a comprehension.
fn brackets<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<ExprKind<'s>> {
    input.skip();
    if peek(input) == Token::For {
        return comprehension(input);
    }
    Ok(ExprKind::List(list(input, Token::CloseBracket, element)?))
}

fn element<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Element<'s>> {
    if take(input, Token::Spread) {
        return Ok(Element::Spread(take_expression(input)?));
    }
    Ok(Element::Item(take_expression(input)?))
}

/// `for x in xs if c, y in ys: e]`
fn comprehension<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<ExprKind<'s>> {
    input.skip();
    let mut generators = vec![generator(input)?];
    while take(input, Token::Comma) && peek(input) != Token::Colon {
        generators.push(generator(input)?);
    }
    require(input, Token::Colon)?;
    let body = take_expression(input)?;
    take(input, Token::Comma);
    require(input, Token::CloseBracket)?;
    Ok(ExprKind::Comprehension(Box::new(Comprehension { generators, body })))
}

/// `x in xs [if c]`
fn generator<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Generator<'s>> {
    let pattern = pattern(input)?;
    require(input, Token::In)?;
    let source = take_expression(input)?;
    let condition = if take(input, Token::If) { Some(take_expression(input)?) } else { None };
    Ok(Generator { pattern, source, condition })
}

/// `a`, `[a, b]` or `{a, b}`
pub(super) fn pattern<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Pattern<'s>> {
    let start = here(input);
    match peek(input).anywhere() {
        Token::OpenBracket => {
            input.skip();
            let names = list(input, Token::CloseBracket, take_new_name)?;
            Ok(Pattern::List(names, since(input, start)))
        }
        Token::OpenBrace => {
            input.skip();
            let names = list(input, Token::CloseBrace, take_new_name)?;
            Ok(Pattern::Record(names, since(input, start)))
        }
        _ => Ok(Pattern::Name(take_new_name(input)?)),
    }
}

/// A record or a block.
fn braces<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<ExprKind<'s>> {
    input.skip();
    let is_record = match (peek(input), peek_second(input)) {
        (Token::CloseBrace, _) => true,
        (Token::Text, Token::Colon) => true,
        (Token::True | Token::False | Token::None, Token::CloseBrace) => false,
        (first, second) => {
            first.is_word()
                && matches!(second, Token::Colon | Token::Comma | Token::CloseBrace | Token::Equals)
        }
    };
    if is_record {
        return Ok(ExprKind::Record(list(input, Token::CloseBrace, field)?));
    }
    let statements = definitions(input)?;
    if peek(input) == Token::CloseBrace {
        return Err(expected(input, ExpectedTokens::VALUE));
    }
    let value = take_expression(input)?;
    while take(input, Token::Semicolon) {}
    require(input, Token::CloseBrace)?;
    Ok(ExprKind::Block(Box::new(Block { statements, value })))
}

/// `label: value`, or `name` alone.
fn field<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Field<'s>> {
    let is_short = matches!(peek_second(input), Token::Comma | Token::CloseBrace);
    if peek(input) == Token::Text {
        let diagnostic = explain::quoted_label(input);
        complain(input, diagnostic);
        let start = here(input);
        input.skip();
        let span = since(input, start);
        let text = inside_quotes(input, span);
        require(input, Token::Colon)?;
        return Ok(Field { name: Name { text, span }, value: Some(take_expression(input)?) });
    }
    let name = if is_short { take_new_name(input)? } else { label(input)? };
    match peek(input) {
        Token::Colon => input.skip(),
        Token::Equals => {
            let at = here(input);
            let diagnostic = explain::equals_in_record(input.state(), name, at);
            complain(input, diagnostic);
            input.skip();
        }
        _ => return Ok(Field { name, value: None }),
    }
    Ok(Field { name, value: Some(take_expression(input)?) })
}

fn inside_quotes<'s>(input: &mut Input<'_, '_, 's>, span: Span) -> &'s str {
    input.state().source[span.range()].trim_matches('"')
}
