//! Statements: each a row of keywords and parts.

use chumsky::prelude::{Parser, custom};

use super::body::{StatementContext, statements_of};
use super::explain;
use super::expression::{argument, expression, take_expression};
use super::input::{
    Input, Parsed, Rule, at, complain, expected, here, label, list, mark, new_name, peek,
    peek_second, take, when, word,
};
use super::literal::{check_document_unit, text};
use super::primary::pattern;
use super::problem::{ExpectedTokens, Problem};
use crate::diag::{Code, Diagnostic};
use crate::syntax::ast::{
    Arg, Definition, Export, Expr, Function, Import, Kind, Name, Param, Parameter, Pattern,
    StatementKind,
};
use crate::syntax::token::Token;

/// One statement: its keyword picks the rule.
pub(super) fn statement<'t, 's: 't>(
    input: &mut Input<'t, '_, 's>,
    body: StatementContext,
) -> Parsed<StatementKind<'s>> {
    let start = here(input);
    let keyword = peek(input);
    if body == StatementContext::Test && is_misplaced_in_test(keyword) {
        let diagnostic = explain::misplaced(input.state(), start, body);
        complain(input, diagnostic);
    }
    match keyword {
        Token::Geo => input.parse(edition()),
        Token::Unit => input.parse(document_unit()),
        Token::Tolerance => input.parse(tolerance()),
        Token::Param => input.parse(param()),
        Token::Let => input.parse(let_definition()),
        Token::Fn => input.parse(function()),
        Token::Check => input.parse(check()),
        Token::Print => input.parse(print()),
        Token::Export => input.parse(export()),
        Token::Import => input.parse(import()),
        Token::Test => input.parse(test()),
        Token::Name if is_expectation(input) => {
            if body != StatementContext::Test {
                let diagnostic = explain::misplaced(input.state(), start, body);
                complain(input, diagnostic);
            }
            input.parse(expect_error())
        }
        Token::Name if let Some(kind) = word_kind(input) => definition(input, kind),
        token => match kind(token) {
            Some(kind) => definition(input, kind),
            None => Err(expected(input, ExpectedTokens::STATEMENT)),
        },
    }
}

/// Whether `expect error` comes next, which are no keywords.
fn is_expectation(input: &mut Input<'_, '_, '_>) -> bool {
    let at = here(input);
    let script = input.state();
    script.is_word(at, "expect") && script.is_word(at + 1, "error")
}

/// The kind that a word promises where a statement begins; elsewhere it is a name like others.
fn word_kind(input: &mut Input<'_, '_, '_>) -> Option<Kind> {
    let at = here(input);
    let script = input.state();
    let words = [
        ("region", Kind::Region),
        ("regions", Kind::Regions),
        ("face", Kind::Face),
        ("faces", Kind::Faces),
        ("solid", Kind::Solid),
        ("solids", Kind::Solids),
    ];
    words.into_iter().find(|(word, _)| script.is_word(at, word)).map(|(_, kind)| kind)
}

fn is_misplaced_in_test(keyword: Token) -> bool {
    matches!(keyword, Token::Geo | Token::Unit | Token::Tolerance | Token::Param | Token::Test)
}

/// `geo 1`
fn edition<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Geo).ignore_then(expression()).map(StatementKind::Edition)
}

/// `tolerance 1e-6`
fn tolerance<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Tolerance).ignore_then(expression()).map(StatementKind::Tolerance)
}

/// `unit mm`; `in` is a unit too.
fn document_unit<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    let unit = custom(|input: &mut Input<'t, '_, 's>| {
        let name = if peek(input) == Token::In { label(input)? } else { input.parse(word())? };
        if let Some(diagnostic) = check_document_unit(name.text, name.span) {
            complain(input, diagnostic);
        }
        Ok(name)
    });
    mark(Token::Unit).ignore_then(unit).map(StatementKind::Unit)
}

/// `param NAME [: KIND] = EXPR [in ALLOWED] [step S] ["label"]`
fn param<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    let step = custom(|input: &mut Input<'t, '_, 's>| {
        let start = here(input);
        if !input.state().is_word(start, "step") {
            return Ok(None);
        }
        input.skip();
        take_expression(input).map(Some)
    });
    mark(Token::Param)
        .ignore_then(new_name())
        .then(when(Token::Colon, word()))
        .then_ignore(mark(Token::Equals))
        .then(expression())
        .then(when(Token::In, expression()))
        .then(step)
        .then(at(STRING, custom(text)))
        .map(|(((((name, kind), default), allowed), step), label)| {
            StatementKind::Param(Box::new(Param { name, kind, default, allowed, step, label }))
        })
}

/// The tokens that a string begins with.
const STRING: &[Token] = &[Token::Text, Token::TextHead];

/// `let PATTERN = EXPR`
fn let_definition<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Let)
        .ignore_then(custom(pattern))
        .then_ignore(mark(Token::Equals))
        .then(expression())
        .then(options())
        .map(|((pattern, value), with)| define(Kind::Let, pattern, value, with))
}

/// `KIND NAME = EXPR` or `KIND EXPR`
fn definition<'t, 's: 't>(input: &mut Input<'t, '_, 's>, kind: Kind) -> Parsed<StatementKind<'s>> {
    input.skip();
    let is_named = peek(input).is_word() && peek_second(input) == Token::Equals;
    let pattern = if is_named {
        let name = input.parse(new_name())?;
        input.skip();
        Pattern::Name(name)
    } else {
        Pattern::Anonymous
    };
    let value = take_expression(input)?;
    let with = input.parse(options())?;
    Ok(define(kind, pattern, value, with))
}

fn define<'s>(
    kind: Kind,
    pattern: Pattern<'s>,
    value: Expr<'s>,
    with: Vec<Arg<'s>>,
) -> StatementKind<'s> {
    StatementKind::Definition(Definition { kind, pattern, value, with })
}

/// The kind that a keyword promises.
fn kind(keyword: Token) -> Option<Kind> {
    match keyword {
        Token::Point => Some(Kind::Point),
        Token::Curve => Some(Kind::Curve),
        Token::Surface => Some(Kind::Surface),
        Token::Mesh => Some(Kind::Mesh),
        Token::Table => Some(Kind::Table),
        Token::Points => Some(Kind::Points),
        Token::Curves => Some(Kind::Curves),
        Token::Surfaces => Some(Kind::Surfaces),
        Token::Meshes => Some(Kind::Meshes),
        Token::Tables => Some(Kind::Tables),
        _ => None,
    }
}

/// `fn NAME(a, b = DEFAULT) = EXPR`
fn function<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    let parameter = |input: &mut Input<'t, '_, 's>| {
        let name = input.parse(new_name())?;
        let default = input.parse(when(Token::Equals, expression()))?;
        Ok(Parameter { name, default })
    };
    mark(Token::Fn)
        .ignore_then(new_name())
        .then(parenthesized(parameter))
        .then_ignore(mark(Token::Equals))
        .then(expression())
        .map(|((name, parameters), body)| {
            StatementKind::Function(Box::new(Function { name, parameters, body }))
        })
}

/// `(item, item)`
fn parenthesized<'t, 's: 't, T>(
    item: impl Fn(&mut Input<'t, '_, 's>) -> Parsed<T>,
) -> impl Rule<'t, 's, Vec<T>> {
    mark(Token::OpenParen).ignore_then(custom(move |input: &mut Input<'t, '_, 's>| {
        list(input, Token::CloseParen, &item)
    }))
}

/// `with (name = value)`, if it comes next; else nothing.
fn options<'t, 's: 't>() -> impl Rule<'t, 's, Vec<Arg<'s>>> {
    let option = |input: &mut Input<'t, '_, 's>| {
        let option = argument(input)?;
        if option.name.is_none() {
            let message = "an option is written `name = value`";
            complain(input, Diagnostic::error(Code::Syntax, option.value.span, message));
        }
        Ok(option)
    };
    when(Token::With, parenthesized(option)).map(Option::unwrap_or_default)
}

/// `check EXPR ["message"]`
fn check<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Check)
        .ignore_then(expression())
        .then(at(STRING, custom(text)))
        .map(|(claim, message)| StatementKind::Check { claim, message })
}

/// `print EXPR, ...`
fn print<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Print).ignore_then(custom(expressions)).map(StatementKind::Print)
}

/// Expressions with commas between them, one or more.
fn expressions<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Vec<Expr<'s>>> {
    let mut items = vec![take_expression(input)?];
    while take(input, Token::Comma) {
        let at = here(input);
        let is_trailing =
            matches!(peek(input), Token::End | Token::To | Token::CloseBrace | Token::Semicolon);
        if is_trailing || input.state().begins_statement(at) {
            break;
        }
        items.push(take_expression(input)?);
    }
    Ok(items)
}

/// `export EXPR, ... to "PATH" [with (...)]` or `export all to ...`
fn export<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Export)
        .ignore_then(custom(expressions))
        .then_ignore(mark(Token::To))
        .then(custom(text))
        .then(options())
        .map(|((subjects, path), options)| {
            StatementKind::Export(Box::new(Export { subjects, path, options }))
        })
}

/// `import "PATH" [as NAME] [with (...)]` or `import "PATH" (a, b)`
fn import<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Import)
        .ignore_then(custom(text))
        .then(when(Token::As, new_name()))
        .then(at(&[Token::OpenParen], parenthesized(imported_name)))
        .then(options())
        .map(|(((path, alias), names), with)| {
            StatementKind::Import(Box::new(Import { path, alias, names, with }))
        })
}

fn imported_name<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Name<'s>> {
    input.parse(new_name())
}

/// `test "name" { ... }`
fn test<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    let body = custom(|input: &mut Input<'t, '_, 's>| {
        Ok::<_, Problem>(statements_of(input, StatementContext::Test))
    });
    mark(Token::Test)
        .ignore_then(custom(text))
        .then_ignore(mark(Token::OpenBrace))
        .then(body)
        .then_ignore(mark(Token::CloseBrace))
        .map(|(name, body)| StatementKind::Test { name, body })
}

/// `expect error "E0203" EXPR`, which the caller has seen to begin so.
fn expect_error<'t, 's: 't>() -> impl Rule<'t, 's, StatementKind<'s>> {
    mark(Token::Name)
        .ignore_then(mark(Token::Name))
        .ignore_then(custom(text))
        .then(expression())
        .map(|(code, subject)| StatementKind::ExpectError { code, subject })
}
