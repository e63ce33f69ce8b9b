//! Searches: roots, least and greatest values, integrals and trajectories of functions of the script.

mod best;
mod bounds;
mod gradient;
mod integrate;
mod maximize;
mod minimize;
mod ode;
mod solve;
mod switching;
mod system;
mod unknowns;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Interval, tolerance::PARAMETER_RELATIVE},
    value::{
        At, BARE_AND_ANGLE, CARRIES_DERIVATIVES, Callback, CommonDimension, Ctx, Dimension,
        FromValue, IntoValue, Mismatch, Number, Op, Range, Type, Value, rounded,
    },
};

pub(super) static OPS: &[&Op] =
    &[&gradient::OP, &integrate::OP, &maximize::OP, &minimize::OP, &ode::OP, &solve::OP];

/// What an argument may be is for its search to tell; here it only says what it is for.
macro_rules! said {
    ($(#[$docs:meta])* $name:ident: $ty:expr) => {
        $(#[$docs])*
        struct $name(Value);

        impl FromValue for $name {
            const TYPE: Type = $ty;

            fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
                Ok(Self(value.clone()))
            }
        }
    };
}

said! {
    /// What bounds unknowns.
    Within: Type::OneOf(&[Type::Range, Type::List(&Type::Range, 1), Type::Record])
}

said! {
    /// What an integral is over.
    Over: Type::OneOf(&[
        Type::Range,
        Type::List(&Type::Range, 2),
        Type::Curve,
        Type::Region,
        Type::Face,
        Type::Surface,
        Type::List(&Type::OneOf(&[Type::Curve, Type::Region, Type::Face, Type::Surface]), 1),
    ])
}

/// An interval with the dimension of what runs through it.
struct SearchRange {
    ends: [f64; 2],
    dim: Dimension,
}

impl SearchRange {
    /// The interval of a range.
    ///
    /// # Errors
    /// A range that is backwards or a single place, whose ends do not go together, or which leaves its end out: what
    /// is found may be that end.
    fn new(range: Spanned<Range>) -> Result<Self> {
        if !range.value.closed {
            let message = format!(
                "a search looks at both ends of its range, and {} leaves one out",
                range.value
            );
            let closed = Range { closed: true, ..range.value };
            return Diagnostic::error(Code::Domain, range.span, message)
                .hint(format!("write `{closed}`, or end it before"))
                .fail();
        }
        let (Range { start, end, .. }, dim) = (range.value, Self::dimension(&range)?);
        let interval = Interval::new(start.value, end.value);
        interval.at(range.span)?;
        Ok(Self { ends: [start.value, end.value], dim })
    }

    /// What both ends of a range measure.
    ///
    /// # Errors
    /// Ends that do not go together.
    fn dimension(range: &Spanned<Range>) -> Result<Dimension> {
        let Range { start, end, .. } = range.value;
        start.dim.common(end.dim).ok_or_else(|| {
            let message = format!("the range begins with {} and ends with {}", start.dim, end.dim);
            Box::new(Diagnostic::error(Code::UnitMismatch, range.span, message))
        })
    }

    /// A place as a value.
    fn place(&self, at: f64) -> Number {
        Number { value: at, dim: self.dim }
    }

    /// The same range, whose places are found by numbers of this dimension: of a bare range by open numbers they
    /// are open, too, since nobody has said what the found place measures.
    fn found_by(&self, dim: Option<Dimension>) -> Self {
        let dim = dim.map_or(self.dim, |found| found_dimension(self.dim, found));
        Self { ends: self.ends, dim }
    }

    /// A place as messages tell it, with six digits; zero where it is nearer to that than rounding.
    fn place_text(&self, at: f64) -> String {
        let [start, end] = self.ends;
        let is_zero = start <= 0.0 && 0.0 <= end && at.abs() < PARAMETER_RELATIVE * (end - start);
        let at = if is_zero { 0.0 } else { at };
        six_digits(at, Some(self.dim))
    }
}

/// What an unknown measures that numbers of the dimension `by` have told: nobody has said it, if it is bare and
/// they are open.
fn found_dimension(own: Dimension, by: Dimension) -> Dimension {
    let is_open = own.is_none() && by.length_power().is_none();
    if is_open { Dimension::OPEN } else { own }
}

/// What a function yields at a place of a range.
fn value_at(
    ctx: &mut Ctx<'_>,
    function: &Spanned<Callback>,
    range: &SearchRange,
    at: f64,
) -> Result<Value> {
    ctx.call(&function.value, &[range.place(at).into_value()]).map_err(|mut found| {
        found.others.retain(|other| other.span != ctx.span);
        if found.others.len() < MOST_LABELS {
            found = Box::new(
                found.also(ctx.span, format!("asked at {} from here", range.place_text(at))),
            );
        }
        match range.ends.iter().position(|end| end.to_bits() == at.to_bits()) {
            Some(end) if unknowns::is_without_value(&found) => {
                let place = range.place_text(at);
                Box::new(found.hint(match end {
                    0 => format!("the function has no value at {place}, where the range begins: let `within` begin where it has one"),
                    _ => format!("the function has no value at {place}, where the range ends: let `within` end where it has one"),
                }))
            }
            _ => found,
        }
    })
}

/// Labels of a mistake in a function, to which the search that asked is added.
const MOST_LABELS: usize = 3;

/// The number that a function yields, without derivatives, of the dimension that it yielded before.
fn number_at(
    ctx: &mut Ctx<'_>,
    function: &Spanned<Callback>,
    range: &SearchRange,
    (at, dim): (f64, &mut CommonDimension),
) -> Result<f64> {
    let value = value_at(ctx, function, range, at)?;
    let number = unknowns::number(&value, function.span)?.looked_at();
    take(dim, number, function.span, || range.place_text(at))?;
    Ok(number.value)
}

/// Takes a number that a function yields at a place into the dimension of its values.
///
/// # Errors
/// A number that does not go with those before.
fn take(
    dim: &mut CommonDimension,
    number: Number,
    span: Span,
    place: impl FnOnce() -> String,
) -> Result<()> {
    dim.take(number).map_err(|[before, own]| {
        let message = format!("the function yields {own} at {} and {before} before", place());
        let found = Diagnostic::error(Code::UnitMismatch, span, message);
        let is_bare = own.is_bare() || before.is_bare();
        Box::new(if is_bare { found.hint(BARE_AND_ANGLE) } else { found })
    })
}

/// A number without derivatives.
fn plain_number(value: &Value, span: Span) -> Result<Number> {
    match value {
        Value::Number(number) => Ok(*number),
        Value::Jet(_) | Value::JetPoint(_) => no_derivatives(span),
        other => {
            let message =
                format!("the function must yield a number, but it yields {}", other.phrase());
            Diagnostic::error(Code::WrongKind, span, message)
                .hint("for example `x => x^2 - 2`")
                .fail()
        }
    }
}

/// Fails: a search is no smooth function of what its function took from around it, as far as it knows.
fn no_derivatives<T>(span: Span) -> Result<T> {
    let message = "no derivative passes through a search, and derivatives are wanted";
    Diagnostic::error(Code::NoDerivative, span, message).hint(CARRIES_DERIVATIVES).fail()
}

/// A number as messages tell it, with six digits.
fn six_digits(value: f64, dim: Option<Dimension>) -> String {
    let six = rounded(value);
    match dim {
        Some(dim) if dim.is_angle() => Number::angle(six.parse().unwrap_or(value)).to_string(),
        _ => six,
    }
}
