//! What people write where the grammar wants something else.

use super::statement::unit;
use super::{ExpectedTokens, FailurePlace};
use crate::diag::{Code, Diagnostic, Fix};
use crate::syntax::ast::Unit;
use crate::syntax::token::Token;

/// A complaint that knows what was meant, if there is one.
pub(super) fn explain(
    place: &FailurePlace<'_, '_, '_>,
    expected: ExpectedTokens,
) -> Option<Diagnostic> {
    let has = |token: Token| expected.has_token(token);
    if place.found() == Token::Name
        && place.before() == Token::Number
        && Unit::from_name(place.text()).is_some()
    {
        return Some(unit(place));
    }
    if expected.has(ExpectedTokens::EXPRESSION) {
        expression(place)
    } else if expected.has(ExpectedTokens::NAME) {
        name(place)
    } else if expected.has(ExpectedTokens::TEXT) {
        text(place)
    } else if expected.has(ExpectedTokens::VALUE) {
        Some(value(place))
    } else if has(Token::Equals) {
        equals(place)
    } else if has(Token::Then) || has(Token::Else) {
        Some(choice(place, expected))
    } else if has(Token::In) || has(Token::Colon) {
        comprehension(place, expected)
    } else if has(Token::To) {
        to(place)
    } else if has(Token::OpenParen) {
        parameters(place)
    } else if has(Token::CloseBrace) && !has(Token::Comma) {
        Some(end_of_block(place))
    } else {
        list(place, expected)
    }
}

fn expression(place: &FailurePlace<'_, '_, '_>) -> Option<Diagnostic> {
    let plain = || place.expected("an expression");
    let found = place.found();
    Some(match found {
        Token::Range | Token::RangeBelow => {
            plain().hint("a range has two ends: from the start it is `xs[0..3]`")
        }
        Token::CloseBracket if matches!(place.before(), Token::Range | Token::RangeBelow) => {
            plain().hint("a range has two ends: to the end of a list it is `xs[1..-1]`")
        }
        Token::Spread => place
            .wrong("`...` spreads a list inside of `[ ]` and nowhere else")
            .hint("where a list is wanted, pass the list itself"),
        Token::Equals if is_setting(place.before()) => takes_no_equals(place),
        Token::Equals if place.at == place.start + 1 && place.before().begins_definition() => {
            let keyword = place.script.text(place.start);
            place
                .expected("a name")
                .hint(format!("a definition has a name: `{keyword} name = ...`"))
        }
        Token::TextMiddle | Token::TextTail if is_text_start(place.before()) => {
            let span = place.script.span(place.at - 1).at_end();
            let span = crate::diag::Span::new(span.end - 1, place.script.span(place.at).start + 1);
            Diagnostic::error(Code::Syntax, span, "an interpolation is empty")
                .label("expected an expression between the braces")
                .hint("write `\\{` for the brace itself")
        }
        Token::For => {
            place.wrong("a comprehension stands in `[ ]`").hint("write `[for i in 0..3: ...]`")
        }
        Token::Star if place.before() == Token::Star => plain().hint("a power is written `a^b`"),
        Token::Plus if place.before() == Token::Plus => plain().hint(
            "there is no assignment: give the new value a name of its own, `let next = i + 1`",
        ),
        Token::Equals if is_comparison_part(place.before()) => {
            plain().hint("comparisons are `== != < <= > >= ~=`")
        }
        _ if found.begins_statement() && !place.script.begins_line(place.at) => keyword(place),
        _ => return None,
    })
}

fn is_comparison_part(token: Token) -> bool {
    matches!(token, Token::Less | Token::Greater | Token::Equals | Token::Equal)
}

/// A statement's keyword in the middle of a line.
fn keyword(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let text = place.text();
    let diagnostic = place
        .expected("an expression")
        .label(format!("`{text}` is a keyword; it begins a statement and cannot name a value"));
    match place.found() {
        Token::Import => diagnostic.hint(read_in_expression(place)),
        _ => diagnostic,
    }
}

/// How a file is read within an expression: a script with what stands behind `with`, anything else as data.
fn read_in_expression(place: &FailurePlace<'_, '_, '_>) -> String {
    let script = place.script;
    let path = match place.next() {
        Token::Text => script.text(place.at + 1),
        _ => "\"part.geo\"",
    };
    if !path.ends_with(".geo\"") {
        return format!("data are read by `load({path})`, a script by `script(\"part.geo\")`");
    }
    let mut given = String::new();
    if script.token(place.at + 2) == Token::With && script.token(place.at + 3) == Token::OpenParen {
        let first = place.at + 4;
        let mut depth = 1_usize;
        let mut end = first;
        while depth > 0 && script.token(end) != Token::End {
            match script.token(end) {
                Token::OpenParen => depth += 1,
                Token::CloseParen => depth -= 1,
                _ => {}
            }
            end += 1;
        }
        if depth == 0 && first + 1 < end {
            given = format!(", {}", script.source_of(first, end - 1));
        }
    }
    format!("`import` is a statement; in an expression write `script({path}{given})`")
}

fn name(place: &FailurePlace<'_, '_, '_>) -> Option<Diagnostic> {
    Some(match place.found() {
        Token::Number if place.before() == Token::Dot => {
            place.expected("a name").hint(format!("an element of a list is `xs[{}]`", place.text()))
        }
        Token::Text => place.expected("a name").hint("names stand without quotes"),
        Token::Equals if is_setting(place.before()) => takes_no_equals(place),
        Token::Number => place.expected("a name").hint("a name begins with a letter"),
        Token::In => return None,
        token if token.is_keyword() && !place.is_missing() => {
            place.wrong(format!("`{}` is a keyword; choose another name", place.text()))
        }
        _ => return None,
    })
}

/// `1..10 step 2`
pub(super) const NO_STEP: &str =
    "a range goes by ones; `range(0, 10, 2)` lists numbers that are 2 apart";

/// `unit = mm`
fn takes_no_equals(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let keyword = place.script.text(place.at - 1);
    let diagnostic = place.wrong(format!("`{keyword}` takes no `=`")).label("drop this");
    let span = diagnostic.primary.span;
    diagnostic.fix(Fix::remove(span, "="))
}

fn is_text_start(token: Token) -> bool {
    matches!(token, Token::TextHead | Token::TextMiddle)
}

fn is_setting(token: Token) -> bool {
    matches!(token, Token::Geo | Token::Unit | Token::Tolerance)
}

/// A path or a title without quotes: all that is glued together is meant.
fn text(place: &FailurePlace<'_, '_, '_>) -> Option<Diagnostic> {
    if place.is_missing() || !place.found().is_word() && place.found() != Token::Number {
        return None;
    }
    let script = place.script;
    let is_glued = |at: &usize| script.gap(*at).end == script.span(*at).start;
    let is_part = |at: &usize| {
        let token = script.token(*at);
        token.is_word()
            || matches!(
                token,
                Token::Dot | Token::Slash | Token::Minus | Token::Number | Token::Range
            )
    };
    let end = (place.at + 1..script.tokens.len())
        .find(|at| !is_glued(at) || !is_part(at))
        .unwrap_or(place.at + 1);
    let span = script.place(place.at, end);
    let text = &script.source[span.range()];
    let message = format!("expected a string, found `{text}`");
    let diagnostic = Diagnostic::error(Code::Syntax, span, message);
    if script.token(place.start) == Token::Import && !text.contains(['.', '/']) {
        return Some(diagnostic.label("a name, and no file").hint(
            "`import` reads another script, `import \"part.geo\"`; what is built in, such as `sqrt` and `pi`, needs no import",
        ));
    }
    Some(diagnostic.meant(&format!("\"{text}\"")))
}

fn value(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    Diagnostic::error(Code::Syntax, place.script.gap(place.at), "the block has no value")
        .label("expected an expression after this")
        .hint("a block holds definitions, then its value; before a value in brackets or with a sign, `;` ends them: `{ let a = 1; -a }`")
}

fn equals(place: &FailurePlace<'_, '_, '_>) -> Option<Diagnostic> {
    let keyword = place.script.token(place.start);
    Some(match place.found() {
        Token::Minus if place.next().is_word() && place.is_glued() => hyphen(place),
        Token::Equal => place.guess("`=`", "="),
        Token::Arrow if keyword == Token::Fn => place.guess("`=`", "="),
        Token::OpenBrace if keyword == Token::Fn => {
            place.expected("`=`").hint("a function is written `fn f(x) = ...`")
        }
        Token::OpenParen if keyword == Token::Let => {
            place.expected("`=`").hint("a function is defined by `fn f(x) = ...`")
        }
        Token::Colon => place
            .expected("`=`")
            .hint("only a `param` states its kind so; `point`, `curve`, `surface`, `mesh` and `table` take the place of `let`"),
        Token::In if keyword == Token::Param => {
            place.expected("`=`").hint("the default comes first: `param n = 3 in 1..5`")
        }
        _ if keyword == Token::Param => place.expected("`=`").hint(format!(
            "a parameter has a default, for whoever runs the script to replace: `param {} = 10mm`",
            place.script.text(place.start + 1)
        )),
        found if keyword == Token::Let => {
            let told = place.expected("`=`").hint("a definition has a value: `let a = 10mm`");
            if !found.begins_expression() || place.is_missing() {
                return Some(told);
            }
            told.fix(Fix::insert(place.script.gap(place.at), " ="))
        }
        _ => return None,
    })
}

/// `let my-name = 3`
fn hyphen(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let script = place.script;
    let is_part = |at: &usize| {
        let token = script.token(*at);
        token.is_word() || matches!(token, Token::Minus | Token::Number)
    };
    let end = (place.at..script.tokens.len()).find(|at| !is_part(at)).unwrap_or(place.at);
    let span = script.place(place.at - 1, end);
    let meant = script.source[span.range()].replace('-', "_");
    Diagnostic::error(Code::Syntax, span, "a name holds letters, digits and `_`").meant(&meant)
}

fn choice(place: &FailurePlace<'_, '_, '_>, expected: ExpectedTokens) -> Diagnostic {
    let want = expected.alternatives();
    let word = want.trim_matches('`');
    if place.found() == Token::Equals && word == "then" {
        return place.wrong("`=` does not compare").meant("==");
    }
    if place.slip([word]).is_some() {
        return place.guess(&want, word);
    }
    let diagnostic = place.expected(&want);
    let gap = place.script.gap(place.at);
    let goes_on = place.found().begins_expression() && !place.is_missing();
    match word {
        "else" if goes_on => diagnostic.fix(Fix::insert(gap, " else")),
        // What else it may be only its author knows.
        "else" => diagnostic.fix(Fix::insert(gap, " else none")),
        "then" if place.found().begins_expression() => diagnostic.fix(Fix::insert(gap, " then")),
        _ => diagnostic,
    }
    .hint(match word {
        "else" => "an `if` always has an `else`: `if c then a else b`",
        _ => "a choice is written `if c then a else b`",
    })
}

fn comprehension(place: &FailurePlace<'_, '_, '_>, expected: ExpectedTokens) -> Option<Diagnostic> {
    Some(match place.found() {
        Token::Equals | Token::Colon if expected.has_token(Token::In) => place.guess("`in`", "in"),
        Token::Arrow | Token::Then | Token::Equals => place.guess("`:`", ":"),
        Token::For => place
            .expected("`:`")
            .hint("several variables are separated by commas: `[for i in xs, j in ys: ...]`"),
        Token::CloseBracket => place
            .expected(&expected.alternatives())
            .hint("what each element is comes last: `[for i in 0..3: i^2]`"),
        Token::Comma if expected.has_token(Token::In) => place
            .expected("`in`")
            .hint("to take an element apart write `[for [a, b] in pairs: ...]`"),
        Token::Name if place.text() == "step" => place.expected("`:`").hint(NO_STEP),
        _ => place
            .expected(&expected.alternatives())
            .hint("a comprehension is written `[for x in xs: x^2]`, with a condition `[for x in xs if x < 3: x^2]`"),
    })
}

fn to(place: &FailurePlace<'_, '_, '_>) -> Option<Diagnostic> {
    match place.found() {
        Token::Name if matches!(place.text(), "into" | "onto" | "in" | "too" | "tp" | "ot") => {
            Some(place.guess("`to`", "to"))
        }
        Token::As | Token::In | Token::Arrow => Some(place.guess("`to`", "to")),
        Token::Text => Some(
            Diagnostic::error(
                Code::Syntax,
                place.script.gap(place.at),
                "expected `to`, found a string",
            )
            .label("expected `to` after this")
            .fix(Fix::insert(place.script.gap(place.at), " to")),
        ),
        _ => Some(place.expected("`to`").hint("write `export s to \"hull.obj\"`")),
    }
}

fn parameters(place: &FailurePlace<'_, '_, '_>) -> Option<Diagnostic> {
    let keyword = place.script.token(place.start);
    if keyword == Token::Fn && place.found() == Token::Equals {
        return Some(place.expected("`(`").hint("write `fn f(x) = ...` or `let f = x => ...`"));
    }
    None
}

/// More after the value of a block.
fn end_of_block(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let diagnostic = place.expected("`}`");
    if place.script.text(place.at - 1) == "return" {
        let span = place.script.span(place.at - 1);
        return Diagnostic::error(Code::Syntax, span, "there is no `return`")
            .label("drop this")
            .hint("the value of a block stands last, after its definitions");
    }
    match place.found() {
        Token::Comma | Token::Colon if place.is_in_string() => diagnostic.hint(
            "in a string `{x}` holds the value of an expression; a brace itself is written `\\{`",
        ),
        token if token.begins_statement() => {
            diagnostic.hint("the value of a block stands last, after its definitions")
        }
        Token::Comma | Token::Colon => {
            diagnostic.hint("a record is written `{label: value, other: value}`")
        }
        _ => diagnostic,
    }
}

fn list(place: &FailurePlace<'_, '_, '_>, expected: ExpectedTokens) -> Option<Diagnostic> {
    let plain = || place.expected(&expected.alternatives());
    Some(match place.found() {
        Token::Semicolon => place.guess(&expected.alternatives(), ","),
        Token::For => plain().hint("a comprehension is written `[for x in xs: x^2]`"),
        Token::Equals if place.before() == Token::Name => {
            place.wrong("`=` does not compare").meant("==")
        }
        Token::Equals => {
            plain().hint("comparisons are `==`; an argument is written `name = value`")
        }
        Token::Colon if place.script.token(place.start) == Token::Fn => {
            plain().hint("the parameters of a function state no kind")
        }
        Token::Colon if !expected.has_token(Token::Comma) => {
            plain().hint("a part of a list is `xs[1..3]`, both ends included")
        }
        Token::Colon => {
            plain().hint("records stand in braces: `{a: 1}`; arguments are written `name = value`")
        }
        _ => return None,
    })
}
