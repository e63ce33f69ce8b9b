//! What the rules of the grammar read from, and the few tools that they share.
//!
//! The input of chumsky is the slice of token kinds, so that a place is the index of a token; the
//! state beside it knows source and spans. The grammar decides by looking ahead and never goes
//! back: `when` and `list` take the place of the backtracking `or_not` and `separated_by`.

use chumsky::extra::{Full, SimpleState};
use chumsky::input::InputRef;
use chumsky::prelude::{Parser, any, custom};

use super::explain;
use super::parsed_script::ParsedScript;
use super::problem::{ExpectedTokens, Problem, Tokens};
use crate::diag::{Code, Diagnostic, Span};
use crate::syntax::ast::Name;
use crate::syntax::token::Token;

/// Its error and the state of the grammar's input.
pub(super) type ParserExtra<'t, 's> = Full<Problem, SimpleState<ParsedScript<'t, 's>>, ()>;
/// The input while a rule reads it.
pub(super) type Input<'t, 'p, 's> = InputRef<'t, 'p, Tokens<'t>, ParserExtra<'t, 's>>;
/// What a rule answers.
pub(super) type Parsed<T> = Result<T, Problem>;

/// A rule of the grammar.
pub(super) trait Rule<'t, 's: 't, T>:
    Parser<'t, Tokens<'t>, T, ParserExtra<'t, 's>>
{
}
impl<'t, 's: 't, T, P: Parser<'t, Tokens<'t>, T, ParserExtra<'t, 's>>> Rule<'t, 's, T> for P {}

/// The index of the next token.
pub(super) fn here(input: &Input<'_, '_, '_>) -> usize {
    *input.cursor().inner()
}

/// The kind of the next token.
pub(super) fn peek(input: &mut Input<'_, '_, '_>) -> Token {
    input.peek().unwrap_or(Token::End)
}

/// The kind of the token after the next.
pub(super) fn peek_second(input: &mut Input<'_, '_, '_>) -> Token {
    let at = here(input);
    input.state().token(at + 1)
}

/// The place of all tokens from number `start` up to here.
pub(super) fn since(input: &mut Input<'_, '_, '_>, start: usize) -> Span {
    let end = here(input);
    input.state().place(start, end)
}

/// Takes the next token if it is a `token`.
pub(super) fn take(input: &mut Input<'_, '_, '_>, token: Token) -> bool {
    let found = peek(input) == token;
    if found {
        input.skip();
    }
    found
}

/// Takes a `token`, which must come next.
pub(super) fn require(input: &mut Input<'_, '_, '_>, token: Token) -> Parsed<()> {
    if take(input, token) { Ok(()) } else { Err(expected(input, ExpectedTokens::token(token))) }
}

/// The failure of a rule that wants `expected` next.
pub(super) fn expected(input: &Input<'_, '_, '_>, expected: ExpectedTokens) -> Problem {
    Problem::Expected { at: here(input), expected }
}

/// Records a finding and goes on.
pub(super) fn complain(input: &mut Input<'_, '_, '_>, diagnostic: Diagnostic) {
    input.state().complain(diagnostic);
}

/// A token of kind `token`, in whatever part of a line.
pub(super) fn mark<'t, 's: 't>(token: Token) -> impl Rule<'t, 's, ()> {
    custom(move |input: &mut Input<'t, '_, 's>| {
        if peek(input).anywhere() == token {
            input.skip();
            return Ok(());
        }
        Err(expected(input, ExpectedTokens::token(token)))
    })
}

/// What follows `token`, if that comes next.
pub(super) fn when<'t, 's: 't, T>(
    token: Token,
    rule: impl Rule<'t, 's, T>,
) -> impl Rule<'t, 's, Option<T>> {
    custom(
        move |input: &mut Input<'t, '_, 's>| {
            if take(input, token) { input.parse(&rule).map(Some) } else { Ok(None) }
        },
    )
}

/// `rule`, if the next token is a `token`, which stays for it.
pub(super) fn at<'t, 's: 't, T>(
    tokens: &'static [Token],
    rule: impl Rule<'t, 's, T>,
) -> impl Rule<'t, 's, Option<T>> {
    custom(
        move |input: &mut Input<'t, '_, 's>| {
            if tokens.contains(&peek(input)) { input.parse(&rule).map(Some) } else { Ok(None) }
        },
    )
}

/// Items with commas between them, up to and with `close`; a trailing comma is allowed.
///
/// A comma that is missing between two items is reported once, and the list goes on.
pub(super) fn list<'t, 's: 't, T>(
    input: &mut Input<'t, '_, 's>,
    close: Token,
    item: impl Fn(&mut Input<'t, '_, 's>) -> Parsed<T>,
) -> Parsed<Vec<T>> {
    let mut items = Vec::new();
    let mut reported = false;
    while !take(input, close) {
        items.push(item(input)?);
        let next = peek(input);
        if next == Token::Comma {
            input.skip();
        } else if next != close {
            let missing = next.begins_expression() || next == Token::Spread;
            if !missing || is_unit_after_number(input) {
                return Err(expected(input, ExpectedTokens::token(Token::Comma).or(close)));
            }
            if !reported {
                missing_comma(input);
            }
            reported = true;
        }
    }
    Ok(items)
}

/// Whether the next name is a unit that should be glued to the number before it.
fn is_unit_after_number(input: &mut Input<'_, '_, '_>) -> bool {
    let at = here(input);
    let script = input.state();
    at > 0
        && script.token(at - 1) == Token::Number
        && crate::syntax::ast::Unit::from_name(script.text(at)).is_some()
}

fn missing_comma(input: &mut Input<'_, '_, '_>) {
    let at = here(input);
    let diagnostic = explain::missing_comma(input.state(), at);
    complain(input, diagnostic);
}

/// A name that is used, not defined.
pub(super) fn word<'t, 's: 't>() -> impl Rule<'t, 's, Name<'s>> {
    custom(|input: &mut Input<'t, '_, 's>| take_word(input, ExpectedTokens::NAME, Token::Name))
}

/// A label: a name or a keyword.
pub(super) fn label<'s>(input: &mut Input<'_, '_, 's>) -> Parsed<Name<'s>> {
    match peek(input) {
        token if token.is_word() => take_word(input, ExpectedTokens::NAME, token),
        _ => Err(expected(input, ExpectedTokens::NAME)),
    }
}

fn take_word<'s>(
    input: &mut Input<'_, '_, 's>,
    wanted: ExpectedTokens,
    token: Token,
) -> Parsed<Name<'s>> {
    let at = here(input);
    if !take(input, token) {
        return Err(expected(input, wanted));
    }
    let script = input.state();
    Ok(Name { text: script.text(at), span: script.span(at) })
}

/// A name that is given to something; a keyword is reported and taken for it.
pub(super) fn new_name<'t, 's: 't>() -> impl Rule<'t, 's, Name<'s>> {
    custom(take_new_name)
}

/// The rule of [`new_name`].
pub(super) fn take_new_name<'s>(input: &mut Input<'_, '_, 's>) -> Parsed<Name<'s>> {
    let at = here(input);
    let token = peek(input);
    if token.is_keyword() {
        let script = input.state();
        let follows = matches!(
            script.token(at + 1),
            Token::Equals
                | Token::Comma
                | Token::Colon
                | Token::In
                | Token::Arrow
                | Token::OpenParen
                | Token::CloseParen
                | Token::CloseBracket
                | Token::CloseBrace
        );
        // `for in xs`: the name is missing.
        let is_missing = token == Token::In && script.token(at + 1) != Token::In;
        if is_missing || !follows || script.begins_line(at) {
            return Err(expected(input, ExpectedTokens::NAME));
        }
        let text = script.text(at);
        let message = format!("`{text}` is a keyword; choose another name");
        let diagnostic = Diagnostic::error(Code::Syntax, script.span(at), message);
        complain(input, diagnostic);
        return take_word(input, ExpectedTokens::NAME, token);
    }
    if token == Token::Placeholder {
        let span = input.state().span(at);
        let message = "`_` names nothing; choose a name";
        complain(input, Diagnostic::error(Code::BadParameter, span, message));
        return take_word(input, ExpectedTokens::NAME, token);
    }
    take_word(input, ExpectedTokens::NAME, Token::Name)
}

/// Everything up to token number `end`.
pub(super) fn skip_to(input: &mut Input<'_, '_, '_>, end: usize) {
    while here(input) < end && input.check(any()).is_ok() {}
}
