//! What people write where a statement should begin, and what they write behind one.

use super::FailurePlace;
use crate::diag::{Code, Diagnostic, Fix, Span};
use crate::syntax::ast::Unit;
use crate::syntax::parser::parsed_script::ParsedScript;
use crate::syntax::token::Token;

/// Words that begin statements in other languages, and what takes their place.
const HABITS: &[(&str, &str)] = &[
    ("function", "fn"),
    ("def", "fn"),
    ("func", "fn"),
    ("fun", "fn"),
    ("module", "fn"),
    ("const", "let"),
    ("var", "let"),
    ("val", "let"),
    ("set", "let"),
    ("define", "let"),
    ("assert", "check"),
    ("require", "check"),
    ("echo", "print"),
    ("println", "print"),
    ("show", "print"),
    ("include", "import"),
    ("use", "import"),
    ("from", "import"),
    ("save", "export"),
    ("write", "export"),
    ("parameter", "param"),
    ("input", "param"),
    ("vector", "point"),
    ("units", "unit"),
];

/// Words that stand between two operands in other languages, and what stands there here.
const OPERATORS: &[(&str, &str)] = &[
    ("mod", "%"),
    ("rem", "%"),
    ("is", "=="),
    ("eq", "=="),
    ("ne", "!="),
    ("lt", "<"),
    ("le", "<="),
    ("gt", ">"),
    ("ge", ">="),
    ("pow", "^"),
    ("times", "*"),
];

/// Words that people write where the range of a `param` follows.
const RANGE_WORDS: &[&str] = &["between", "among", "inside"];

/// No statement begins with the token that was found.
pub(super) fn beginning(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let found = place.found();
    match found {
        Token::Name => name(place),
        Token::For => place
            .wrong("there are no loops")
            .label("a `for` stands inside a list")
            .hint("write `let xs = [for i in 0..3: ...]`"),
        Token::If => place
            .wrong("a choice is no statement")
            .label("an `if` is an expression")
            .hint("write `let x = if c then a else b`"),
        Token::LineMinus | Token::LineParen | Token::LineBracket if place.at > 0 => {
            let message = format!("expected a statement, found {}", place.shown());
            let diagnostic = place.wrong(message).label("this begins a line");
            place.line_hint().into_iter().fold(diagnostic, Diagnostic::hint)
        }
        _ if found.begins_expression() => lone_expression(place),
        _ => place.wrong(format!("expected a statement, found {}", place.shown())),
    }
}

fn name(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let text = place.text();
    let diagnostic = place.wrong(format!("`{text}` does not begin a statement"));
    let guess = |keyword: &str| format!("did you mean `{keyword}`?");
    let before = place.script.span(place.at);
    let before = Span::new(before.start, before.start);
    if matches!(place.next(), Token::Equals) {
        return diagnostic
            .label(guess(&format!("let {text} = ...")))
            .fix(Fix::insert(before, "let "));
    }
    if let Some((_, keyword)) = HABITS.iter().find(|(habit, _)| *habit == text) {
        return diagnostic.meant(keyword);
    }
    match text {
        "while" => return diagnostic.hint("there are no loops; write `[for i in 0..3: ...]`"),
        "return" => return diagnostic.hint("the value of a block stands last, without a word"),
        "expect" => return diagnostic.label("did you mean `expect error \"E0203\" ...`?"),
        _ => {}
    }
    let follows = place.next();
    let is_statement = follows.begins_expression() && follows != Token::OpenParen;
    let keywords = Token::STATEMENTS.iter().map(|keyword| keyword.text());
    match place.slip(keywords) {
        Some(keyword) if is_statement => diagnostic.meant(keyword),
        _ if follows == Token::OpenParen && defines_function(place) => {
            diagnostic
                .label(guess(&format!("fn {text}(...) = ...")))
                .fix(Fix::insert(before, "fn "))
        }
        _ if matches!(follows, Token::OpenParen | Token::Dot | Token::OpenBracket) => {
            lone_expression(place)
        }
        _ => diagnostic.hint(
            "statements begin with `let`, `param`, `fn`, `point`, `curve`, `surface`, `region`, `face`, `solid`, `mesh`, `table`, `check`, `print`, `export`, `import` or `test`",
        ),
    }
}

/// Whether `f(a, b)` is followed by `=`.
fn defines_function(place: &FailurePlace<'_, '_, '_>) -> bool {
    /// Tokens of a list of parameters that are looked at.
    const MOST: usize = 64;
    let tokens = || (place.at + 1..).take(MOST).map(|at| (at, place.script.token(at)));
    let end = tokens().find(|(_, token)| matches!(token, Token::CloseParen | Token::End));
    end.is_some_and(|(at, token)| {
        token == Token::CloseParen && place.script.token(at + 1) == Token::Equals
    })
}

fn lone_expression(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    place
        .wrong("an expression alone is no statement")
        .label("expected a keyword before this")
        .hint("to name the value write `let name = ...`, to see it `print ...`")
}

/// Something stands behind a whole statement, which began with token `start`; `None` when it is
/// already reported.
pub(crate) fn trailing(
    script: &ParsedScript<'_, '_>,
    start: usize,
    at: usize,
) -> Option<Diagnostic> {
    let place = FailurePlace { script, start, at };
    let (keyword, before) = (script.token(start), place.before());
    Some(match place.found() {
        Token::Bad => return None,
        Token::Equals => place.wrong("`=` does not compare").meant("=="),
        Token::Name if before == Token::Number && is_unit(place.text()) => unit(&place),
        Token::Name | Token::Text | Token::Number
            if keyword.begins_definition() && at == start + 2 =>
        {
            missing_equals(&place)
        }
        Token::Name if keyword == Token::Check && place.is_last() => place
            .wrong(format!("expected an operator or the next statement, found `{}`", place.text()))
            .label(format!("did you mean the words of the report, `, \"{}\"`?", place.text())),
        Token::Name if keyword == Token::Param && RANGE_WORDS.contains(&place.text()) => {
            place.guess("the next statement", "in")
        }
        Token::Name if slip_of_part(&place).is_some() => {
            let meant = slip_of_part(&place).unwrap_or_default();
            place.guess("the next statement", meant)
        }
        Token::Name if before == Token::Name && script.token(at + 1) == Token::In => place
            .wrong(format!("`{}` is called with a list and a function", script.text(at - 1)))
            .hint(format!("write `{}(xs, x => x < 3)`", script.text(at - 1))),
        Token::OpenParen => call_of_literal(&place),
        Token::LineMinus | Token::LineParen | Token::LineBracket => beginning(&place),
        Token::Within => place.wrong("`within` belongs to `~=`").hint("write `a ~= b within 1e-9`"),
        Token::In if keyword != Token::Param => place
            .wrong("only a `param` states its range")
            .hint(format!("drop the range, or write `param` instead of {}", keyword.shown()))
            .fix(Fix::replace(script.span(start), "param")),
        Token::With => place
            .wrong(format!("a {} takes no `with`", keyword.shown()))
            .hint("`with` belongs to definitions, `export` and `import`"),
        Token::To => place.wrong("only `export` writes files").label("unexpected `to`"),
        Token::Comma => several(&place),
        Token::Then | Token::Else => place
            .wrong(format!("{} without an `if`", place.shown()))
            .hint("write `if c then a else b`"),
        Token::If => place
            .wrong("an `if` stands before what it chooses from")
            .hint("write `if c then a else b`"),
        Token::Arrow => place
            .wrong("the parameters of a function are plain names")
            .hint("write `x => x^2`, `(u, v) => u*v` or `fn f(x) = x^2`"),
        _ if place.is_missing() && script.begins_line(at) => beginning(&place),
        _ => side_by_side(&place),
    })
}

/// `pi r`, `lambda x: x`, `f"text"`: an expression behind another.
fn side_by_side(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let diagnostic = place
        .wrong(format!("expected an operator or the next statement, found {}", place.shown()))
        .label("this continues nothing");
    let (before, found) = (place.before(), place.found());
    let last = place.script.text(place.at.saturating_sub(1));
    let is_text = |token: Token| matches!(token, Token::Text | Token::TextHead);
    let operator = OPERATORS.iter().find(|(word, _)| found == Token::Name && *word == place.text());
    if let Some((_, operator)) = operator.filter(|_| place.next().begins_expression()) {
        return place.guess("an operator or the next statement", operator);
    }
    match found {
        Token::Name if matches!(last, "lambda" | "function" | "func") => {
            diagnostic.hint(format!("a function without a name is written `{0} => {0}^2`", place.text()))
        }
        _ if is_text(found) && before == Token::Name && place.is_glued() => {
            diagnostic.hint("a string has no prefix; a value stands in it as `\"{x}\"`")
        }
        _ if is_text(found) || matches!(before, Token::Text | Token::TextTail) => {
            diagnostic.hint("what is printed or exported is separated by commas: `print a, b`; texts join as `\"{a}{b}\"`")
        }
        Token::Name | Token::Number | Token::OpenBrace if before.ends_expression() => {
            diagnostic
                .hint("a product is written `a * b`, a call `f(x)`, a list `[a, b]`")
                .fix(Fix::insert(place.script.gap(place.at), " * "))
        }
        _ => diagnostic,
    }
}

/// The word that may follow in such a statement and that the name found may be a slip for.
fn slip_of_part<'w>(place: &FailurePlace<'_, '_, '_>) -> Option<&'w str> {
    match place.script.token(place.start) {
        Token::Param => place.slip(["in", "step"]),
        Token::Check => place.slip(["within", "and", "or"]),
        Token::Import => place.slip(["as", "with"]),
        _ => place.slip(["with", "and", "or"]),
    }
}

fn is_unit(text: &str) -> bool {
    Unit::from_name(text).is_some()
}

/// `10 mm`
pub(super) fn unit(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let (number, unit) = (place.script.text(place.at - 1), place.text());
    let span = place.script.place(place.at - 1, place.at + 1);
    Diagnostic::error(Code::Syntax, span, "a unit is glued to its number")
        .meant(&format!("{number}{unit}"))
}

/// `curve c bezier(...)`
fn missing_equals(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let name = place.script.text(place.at - 1);
    let message = format!("expected `=`, found {}", place.shown());
    Diagnostic::error(Code::Syntax, place.script.gap(place.at), message)
        .label(format!("did you mean `{} {name} = ...`?", place.script.text(place.start)))
        .fix(Fix::insert(place.script.gap(place.at), " ="))
}

/// `2(x + 1)`, `(1, 2)(3, 4)`
fn call_of_literal(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let message = "a value like this cannot be called";
    let diagnostic = Diagnostic::error(Code::Syntax, place.script.gap(place.at), message);
    match place.before() {
        Token::Number => diagnostic
            .label(format!("did you mean `{}*(...)`?", place.script.text(place.at - 1)))
            .fix(Fix::insert(place.script.gap(place.at), " * ")),
        _ => diagnostic.label("is an operator or a `,` missing after this?"),
    }
}

/// `let a = 1, 2`
fn several(place: &FailurePlace<'_, '_, '_>) -> Diagnostic {
    let diagnostic = place.wrong("expected an operator or the next statement, found `,`");
    let is_decimal = place.before() == Token::Number && place.next() == Token::Number;
    if is_decimal && place.is_glued() && place.is_next_glued() {
        let [whole, fraction] = [place.at - 1, place.at + 1].map(|at| place.script.text(at));
        let fix = Fix::replace(place.script.span(place.at), ".");
        return diagnostic
            .hint(format!("the decimal sign is a point: `{whole}.{fraction}`"))
            .fix(fix);
    }
    if place.script.token(place.start).begins_definition() {
        return diagnostic.hint("several values form a list `[a, b]` or a point `(a, b)`");
    }
    diagnostic
}
