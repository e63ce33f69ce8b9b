//! Numbers and strings: from their spelling to their value.

use super::expression::take_expression;
use super::input::{Input, Parsed, complain, expected, here, peek, since};
use super::problem::ExpectedTokens;
use crate::diag::{self, Code, Diagnostic, Fix, Span, nearest};
use crate::syntax::ast::{Expr, ExprKind, StringPart, TextFormat, Unit};
use crate::syntax::token::Token;

/// `12.5mm`
pub(super) fn number<'s>(input: &mut Input<'_, '_, 's>) -> ExprKind<'s> {
    let at = here(input);
    input.skip();
    let script = input.state();
    let (text, span) = (script.text(at), script.span(at));
    let is_called = script.token(at + 1) == Token::OpenParen
        && script.gap(at + 1).end == script.span(at + 1).start;
    match read_number(text, span, is_called) {
        Ok((value, unit)) => ExprKind::Number(value, unit),
        Err(diagnostic) => {
            script.complain(*diagnostic);
            ExprKind::Error
        }
    }
}

/// Value and unit of a number's text, behind which brackets may stand as behind what is called.
fn read_number(text: &str, span: Span, is_called: bool) -> diag::Result<(f64, Option<Unit>)> {
    let digits = digits_len(text.as_bytes());
    let (digits, suffix) = text.split_at(digits);
    let bad = |message: String| Diagnostic::error(Code::BadNumber, span, message);
    let separated = digits.contains('_').then(|| digits.replace('_', ""));
    if separated.is_some()
        && (digits.contains("__") || digits.contains("_.") || digits.ends_with('_'))
    {
        let hint = "a `_` stands between two digits: `1_000`";
        return bad(format!("`{text}` is no number")).hint(hint).fail();
    }
    let value: f64 = separated.as_deref().unwrap_or(digits).parse().unwrap_or(f64::INFINITY);
    if !value.is_finite() {
        let hint = "the largest number is 1.8e308";
        return bad("this number is too large".to_owned()).hint(hint).fail();
    }
    if suffix.is_empty() {
        return Ok((value, None));
    }
    if suffix.eq_ignore_ascii_case("e") {
        let hint = "an exponent is written `1e-3`";
        return bad(format!("the exponent of `{text}` has no digits")).hint(hint).fail();
    }
    match Unit::from_name(suffix) {
        Some(unit) => Ok((value, Some(unit))),
        None => unknown_unit(digits, suffix, span, is_called).fail(),
    }
}

/// The bytes of a number without its unit.
fn digits_len(bytes: &[u8]) -> usize {
    let digits = |from: usize| {
        bytes[from..].iter().take_while(|b| b.is_ascii_digit() || **b == b'_').count()
    };
    let mut len = digits(0);
    let has_digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    if bytes.get(len) == Some(&b'.') {
        len += 1 + digits(len + 1);
    }
    if matches!(bytes.get(len), Some(b'e' | b'E')) {
        let signed = len + 1 + usize::from(matches!(bytes.get(len + 1), Some(b'+' | b'-')));
        if has_digit(signed) {
            len = signed + bytes[signed..].iter().take_while(|b| b.is_ascii_digit()).count();
        }
    }
    len
}

fn unknown_unit(digits: &str, suffix: &str, span: Span, is_called: bool) -> Diagnostic {
    let diagnostic =
        Diagnostic::error(Code::UnknownUnit, span, format!("`{suffix}` is not a unit"))
            .label("unknown unit");
    if let Some(unit) = power_of_unit(suffix) {
        return diagnostic
            .hint(format!("did you mean `{digits}{unit}`?"))
            .fix(Fix::replace(span, format!("{digits}{unit}")));
    }
    if let Some(value) = of_another_base(digits, suffix) {
        return diagnostic
            .hint(format!("numbers are written to the base of ten: `{value}`"))
            .fix(Fix::replace(span, value.to_string()));
    }
    // Of equally near units the millimetre.
    let known = || ["mm"].into_iter().chain(Unit::ALL.iter().map(|&(name, _)| name));
    let is_product = is_called || matches!(suffix, "pi" | "tau" | "π");
    let unit = || by_habit(suffix).or_else(|| nearest(suffix, known()));
    match (!is_product).then(unit).flatten() {
        Some(unit) => diagnostic
            .hint(format!("did you mean `{digits}{unit}`?"))
            .fix(Fix::replace(span, format!("{digits}{unit}"))),
        None if is_product => {
            let constant = if suffix == "π" { "pi" } else { suffix };
            diagnostic
                .hint(format!("a product is written `{digits} * {constant}`"))
                .fix(Fix::replace(span, format!("{digits} * {constant}")))
        }
        None => diagnostic
            .hint(format!(
                "lengths take `um mm cm m km in ft`, angles `deg rad turn`; a product is written `{digits} * {suffix}`"
            ))
            .fix(Fix::replace(span, format!("{digits} * {suffix}"))),
    }
}

/// `0x1f`, `0b101` or `0o17`, as far as it is whole in a number.
fn of_another_base(digits: &str, suffix: &str) -> Option<u64> {
    let (mark, rest) = suffix.split_at_checked(1)?;
    let base = match mark {
        "x" | "X" => 16,
        "o" | "O" => 8,
        "b" | "B" => 2,
        _ => return None,
    };
    let value = u64::from_str_radix(rest, base).ok()?;
    (digits == "0" && value <= MOST_WHOLE).then_some(value)
}

/// Up to here every whole number is one of the language's numbers.
const MOST_WHOLE: u64 = 1 << f64::MANTISSA_DIGITS;

/// An area or a volume as it is written: `mm^2` for `mm2`.
fn power_of_unit(suffix: &str) -> Option<String> {
    let powers = [(['2', '²'], 2), (['3', '³'], 3)];
    powers.iter().find_map(|(digits, power)| {
        let unit = suffix.strip_suffix(digits)?;
        Unit::from_name(unit)?.millimetres()?;
        Some(format!("{unit}^{power}"))
    })
}

/// The unit that people write out or write otherwise.
fn by_habit(suffix: &str) -> Option<&'static str> {
    Some(match suffix.to_lowercase().as_str() {
        // The sign for micro and the Greek letter.
        "µm" | "μm" | "micron" | "microns" => "um",
        "millimeter" | "millimeters" | "millimetre" | "millimetres" => "mm",
        "centimeter" | "centimeters" | "centimetre" | "centimetres" => "cm",
        "meter" | "meters" | "metre" | "metres" => "m",
        "kilometer" | "kilometers" | "kilometre" | "kilometres" => "km",
        "inch" | "inches" => "in",
        "foot" | "feet" => "ft",
        "°" | "degrees" | "degree" | "d" => "deg",
        "radian" | "radians" | "r" => "rad",
        "turns" | "rev" => "turn",
        _ => return None,
    })
}

/// `unit` after the statement's keyword, which is a unit of length.
pub(super) fn check_document_unit(name: &str, span: Span) -> Option<Diagnostic> {
    let lengths = || Unit::ALL.iter().filter(|(_, unit)| unit.millimetres().is_some());
    let error = |message: String| Diagnostic::error(Code::UnknownUnit, span, message);
    match Unit::from_name(name) {
        Some(unit) if unit.millimetres().is_some() => None,
        Some(_) => Some(
            error(format!("`{name}` is a unit of angle; the document needs one of length"))
                .hint("lengths take `um mm cm m km in ft`"),
        ),
        None => {
            let diagnostic = error(format!("`{name}` is not a unit")).label("unknown unit");
            let habit = by_habit(name)
                .filter(|habit| lengths().any(|(known, _)| known == habit))
                .or_else(|| nearest(name, lengths().map(|&(known, _)| known)));
            Some(match habit {
                Some(known) => diagnostic
                    .hint(format!("did you mean `{known}`?"))
                    .fix(Fix::replace(span, known)),
                None => diagnostic.hint("lengths take `um mm cm m km in ft`"),
            })
        }
    }
}

/// A string, with or without interpolation; both are one token each, or a series of them.
pub(super) fn text<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Expr<'s>> {
    let start = here(input);
    let kind = match peek(input) {
        Token::Text => ExprKind::Text(piece(input)),
        Token::TextHead => ExprKind::Interpolation(pieces(input)?),
        Token::Bad => {
            input.skip();
            ExprKind::Error
        }
        _ => return Err(expected(input, ExpectedTokens::TEXT)),
    };
    Ok(Expr { kind, span: since(input, start) })
}

fn pieces<'t, 's: 't>(input: &mut Input<'t, '_, 's>) -> Parsed<Vec<StringPart<'s>>> {
    let mut pieces = Vec::new();
    loop {
        let is_last = peek(input) == Token::TextTail;
        let text = piece(input);
        if !text.is_empty() {
            pieces.push(StringPart::Text(text));
        }
        if is_last {
            return Ok(pieces);
        }
        let expr = take_expression(input)?;
        let format = (peek(input) == Token::TextFormat).then(|| format(input)).flatten();
        pieces.push(StringPart::Expr(expr, format));
        if !matches!(peek(input), Token::TextMiddle | Token::TextTail) {
            return Err(expected(input, ExpectedTokens::token(Token::CloseBrace)));
        }
    }
}

/// A format: digits behind a point, a unit, or both.
fn format<'s>(input: &mut Input<'_, '_, 's>) -> Option<TextFormat<'s>> {
    let at = here(input);
    let span = input.state().span(at);
    input.skip();
    let text = input.state().source[span.range()].trim_start_matches(':').trim();
    let (digits, unit) = match text.strip_prefix('.') {
        Some(rest) => {
            let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
            (Some(rest[..end].parse::<usize>()), rest[end..].trim())
        }
        None => (None, text),
    };
    let is_unit = unit.starts_with(|c: char| c.is_alphabetic() || matches!(c, '1' | '°'));
    match digits.transpose() {
        Ok(digits) if digits.is_some() && unit.is_empty() || is_unit => {
            Some(TextFormat { digits, unit: (!unit.is_empty()).then_some(unit), span })
        }
        _ => {
            let message = match text {
                "" => "a format is missing behind the colon".to_owned(),
                _ => format!("`{text}` is no format"),
            };
            complain(input, Diagnostic::error(Code::Syntax, span, message).label("not understood").hint(
                "a format is `.3` for digits behind the point, a unit such as `mm`, or both, as in `{x:.1mm}`",
            ));
            None
        }
    }
}

/// The text of one token of a string.
fn piece(input: &mut Input<'_, '_, '_>) -> String {
    let at = here(input);
    input.skip();
    let script = input.state();
    let inner = Span::new(script.span(at).start + 1, script.span(at).end - 1);
    let text = &script.source[inner.range()];
    if !text.contains('\\') {
        return text.to_owned();
    }
    unescape(text, inner.start, |diagnostic| complain(input, diagnostic))
}

/// `text` with its escapes resolved; what is no escape is told and left out.
fn unescape(text: &str, start: u32, mut tell: impl FnMut(Diagnostic)) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('\\') {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        let (len, resolved) = escape(rest);
        match resolved {
            Some(c) => out.push(c),
            None => {
                let from = start + u32::try_from(text.len() - rest.len()).unwrap_or(0);
                let span = Span::new(from, from + u32::try_from(len).unwrap_or(0));
                tell(bad_escape(&rest[..len], span));
            }
        }
        rest = &rest[len..];
    }
    out.push_str(rest);
    out
}

/// The length of the escape that `rest` begins with, and its character.
fn escape(rest: &str) -> (usize, Option<char>) {
    let Some(mark) = rest[1..].chars().next() else { return (1, None) };
    let resolved = match mark {
        'n' => '\n',
        't' => '\t',
        '"' | '\\' | '{' | '}' => mark,
        'u' => {
            let Some(end) = rest.strip_prefix("\\u{").and_then(|_| rest.find('}')) else {
                return (2, None);
            };
            let code = u32::from_str_radix(&rest[3..end], 16).ok();
            return (end + 1, code.and_then(char::from_u32));
        }
        _ => return (1 + mark.len_utf8(), None),
    };
    (2, Some(resolved))
}

fn bad_escape(text: &str, span: Span) -> Diagnostic {
    let diagnostic = Diagnostic::error(Code::BadEscape, span, format!("`{text}` is not an escape"));
    if text.starts_with("\\u") {
        return diagnostic.hint("a character is written by its code: `\\u{3b1}` is α");
    }
    diagnostic
        .hint("write `\\\\` for the backslash itself; escapes are `\\n \\t \\\" \\\\ \\{ \\u{...}`")
}
