//! What the operators say when two sides do not go together: both are named.

use super::operand::{OperandPlaces, OperatorRefusal};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    eval::ir::BinaryOp,
    kernel::tolerance::LIMIT_WITHOUT_UNIT,
    value::{BARE_AND_ANGLE, Dimension, Function, Number, Value},
};

/// Why two numbers have no result, in words; `verb` is what was tried, as in "cannot be added".
pub(super) fn refused(
    refusal: OperatorRefusal,
    verb: &str,
    [a, b]: [Number; 2],
    places: OperandPlaces,
) -> Box<Diagnostic> {
    let error = |code: Code, message: String| Diagnostic::error(code, places.whole, message);
    Box::new(match refusal {
        OperatorRefusal::Mismatch => {
            return mismatch(verb, &Value::Number(a), &Value::Number(b), places);
        }
        OperatorRefusal::PowerOfUnitTooHigh => {
            error(Code::UnitMismatch, "the power of the unit is too high".to_owned())
        }
        OperatorRefusal::ExponentWithUnit => {
            let message = format!("an exponent has no unit, found {}", b.dim);
            Diagnostic::error(Code::UnitMismatch, places.right, message)
        }
        OperatorRefusal::NoSuchPowerOfUnit => {
            error(Code::UnitMismatch, format!("{} cannot be raised to the power {b}", a.dim))
                .hint("divide by `1mm`, `1m` or `1rad` first to take the unit away")
        }
        OperatorRefusal::ZeroDivisor => error(Code::DivisionByZero, "division by zero".to_owned())
            .also(places.right, "this is 0"),
        OperatorRefusal::NegativePowerOfZero => {
            error(Code::DivisionByZero, "zero has no negative power".to_owned())
                .also(places.left, "this is 0")
        }
        OperatorRefusal::FractionalPowerOfNegative => {
            error(Code::Domain, format!("a negative number ({a}) has no power of {b}"))
        }
    })
}

pub(super) fn overflow<T>(span: Span) -> Result<T> {
    Diagnostic::error(Code::Domain, span, "the result is beyond the largest number, 1.8e308")
        .label("too large")
        .fail()
}

/// What to do where units do not go together.
pub(super) const OF_OTHER_UNIT: &str =
    "divide by a unit, such as `1mm` or `1deg`, to make a plain number of a quantity";

/// Two values whose units do not go together.
pub(super) fn mismatch(verb: &str, a: &Value, b: &Value, places: OperandPlaces) -> Box<Diagnostic> {
    let message = format!("{} and {} cannot be {verb}", noun(a), noun(b));
    Box::new(
        Diagnostic::error(Code::UnitMismatch, places.whole, message)
            .also(places.left, format!("this is {}", noun(a)))
            .also(places.right, format!("this is {}", noun(b)))
            .hint(match (a, b) {
                (Value::Number(a), Value::Number(b)) if a.dim.common(b.dim).is_some() => {
                    BARE_AND_ANGLE
                }
                _ => OF_OTHER_UNIT,
            }),
    )
}

/// What a limit cannot be that of a distance between, of such values. Plain numbers are in the document's units, coordinates
/// are lengths; beside an angle a limit says its unit, unless it is for rounding alone.
pub(in crate::eval) fn of_other_unit(limit: Number, side: &Value) -> Option<Value> {
    let is_bare = limit.dim.is_bare();
    let is_other = match side {
        Value::Number(number) if number.dim.is_angle() && is_bare => {
            LIMIT_WITHOUT_UNIT < limit.value
        }
        Value::Number(number) => !is_bare && !number.dim.is_bare() && limit.dim != number.dim,
        Value::Point(_) => !is_bare && limit.dim != Dimension::LENGTH,
        Value::List(items) => return items.iter().find_map(|item| of_other_unit(limit, item)),
        Value::Record(record) => {
            return record.iter().find_map(|(_, value)| of_other_unit(limit, value));
        }
        _ => false,
    };
    is_other.then(|| side.clone())
}

/// A limit whose unit is not that of what it limits.
pub(in crate::eval) fn limit_of_other_unit<T>(
    limit: Number,
    side: &Value,
    place: Span,
) -> Result<T> {
    let takes = match side {
        Value::Point(_) => Dimension::LENGTH.to_string(),
        other => noun(other),
    };
    let found = noun(&Value::Number(limit));
    let message = format!("`within` takes {takes} here, found {found}");
    let hint = match limit.dim.is_bare() {
        true => "say its unit: `within 1deg`; a thousandth or less, for rounding, needs none",
        false => "a plain number counts in the units of both sides",
    };
    Diagnostic::error(Code::UnitMismatch, place, message).hint(hint).fail()
}

/// A value by its dimension, else by its kind.
fn noun(value: &Value) -> String {
    match value {
        Value::Number(number) => number.dim.to_string(),
        other => other.phrase(),
    }
}

/// Two values of kinds that an operator does not take.
pub(super) fn inapplicable<T>(
    op: BinaryOp,
    a: &Value,
    b: &Value,
    places: OperandPlaces,
) -> Result<T> {
    use BinaryOp as Op;
    let message = format!("`{}` cannot work on {} and {}", op.symbol(), a.phrase(), b.phrase());
    let diagnostic = Diagnostic::error(Code::WrongKind, places.whole, message)
        .also(places.left, format!("this is {}", a.phrase()))
        .also(places.right, format!("this is {}", b.phrase()));
    match (a, op, b) {
        (Value::List(_), Op::Add, Value::List(_)) => {
            diagnostic.hint("join lists by `[...a, ...b]`")
        }
        (Value::Function(Function::Partial(_)), ..)
        | (.., Value::Function(Function::Partial(_))) => diagnostic.hint(
            "`_` makes a function of the one call that it stands in: write `x => max(x, 3) + 1`",
        ),
        (Value::Text(_), Op::Add, _) | (_, Op::Add, Value::Text(_)) => {
            diagnostic.hint("join texts by interpolation: \"{a}{b}\"")
        }
        (Value::List(_), _, Value::Number(_)) | (Value::Number(_), _, Value::List(_)) => {
            diagnostic.hint("for each element: `[for x in xs: ...]`")
        }
        (Value::Point(_), Op::Add | Op::Subtract, Value::Number(_))
        | (Value::Number(_), Op::Add | Op::Subtract, Value::Point(_)) => {
            diagnostic.hint("points are added to points: `p + (1, 0, 0)`; numbers multiply them")
        }
        (Value::Point(_), Op::Multiply, Value::Point(_)) => {
            diagnostic.hint("`dot(a, b)` and `cross(a, b)` multiply vectors")
        }
        (Value::Curve(_) | Value::Surface(_) | Value::Mesh(_), _, Value::Point(_)) => {
            diagnostic.hint("move geometry by `translate(g, v)`")
        }
        _ => diagnostic,
    }
    .fail()
}
