//! Numbers.

mod abs;
mod acos;
mod asin;
mod atan;
mod atan2;
mod cbrt;
mod ceil;
mod clamp;
mod cos;
mod cosh;
mod exp;
mod floor;
mod hypot;
mod lerp;
mod ln;
mod log10;
mod max;
mod min;
mod random;
mod round;
mod sign;
mod sin;
mod sinh;
mod sqrt;
mod tan;
mod tanh;

use crate::{
    diag::{Code, Diagnostic, Fix, Result, Span},
    value::{
        BARE_AND_ANGLE, CommonDimension, Ctx, Dimension, FromValue, Mismatch, Number, Op, Real,
        Type, Value, Vector,
    },
};

pub(super) static OPS: &[&Op] = &[
    &abs::OP,
    &acos::OP,
    &asin::OP,
    &atan::OP,
    &atan2::OP,
    &cbrt::OP,
    &ceil::OP,
    &clamp::OP,
    &cos::OP,
    &cosh::OP,
    &exp::OP,
    &floor::OP,
    &hypot::OP,
    &lerp::OP,
    &ln::OP,
    &log10::OP,
    &max::OP,
    &min::OP,
    &random::OP,
    &round::OP,
    &sign::OP,
    &sin::OP,
    &sinh::OP,
    &sqrt::OP,
    &tan::OP,
    &tanh::OP,
];

/// Fails: there is no value for these arguments.
pub(super) fn outside<T>(span: Span, message: String) -> Result<T> {
    Diagnostic::error(Code::Domain, span, message).fail()
}

/// The value, unless it is beyond all numbers.
pub(super) fn finite(value: Real, span: Span) -> Result<Real> {
    if value.is_finite() {
        Ok(value)
    } else {
        outside(span, "the result is beyond the largest number, 1.8e308".to_owned())
    }
}

/// Fails: a list without elements has no `what`.
pub(super) fn empty<T>(span: Span, what: &str) -> Result<T> {
    outside(span, format!("an empty list has no `{what}`"))
}

/// The dimension of numbers one of which is the answer, or on the way to it; a bare number fits any but an angle, beside
/// which only 0 says what it is.
pub(super) fn common_dim(numbers: impl Iterator<Item = Number>, span: Span) -> Result<Dimension> {
    let mut common = CommonDimension::default();
    for number in numbers {
        common.take(number).map_err(|[a, b]| {
            // The bare one first, as where two are added.
            mismatch(if b.is_bare() { [b, a] } else { [a, b] }, span)
        })?;
    }
    Ok(common.dimension())
}

pub(super) fn mismatch([a, b]: [Dimension; 2], span: Span) -> Box<Diagnostic> {
    let found = Diagnostic::error(Code::UnitMismatch, span, format!("{a} and {b} do not mix"));
    Box::new(if a.is_bare() || b.is_bare() { found.hint(BARE_AND_ANGLE) } else { found })
}

/// The dimension of what is rounded to whole numbers, of which there are none of an angle: degrees are not radians.
fn rounded_dim(dim: Dimension) -> Option<Dimension> {
    (dim.angle_power() == 0).then_some(dim)
}

/// # Errors
/// Angles.
fn check_whole(x: Number, name: &str, span: Span) -> Result<()> {
    if x.dim.angle_power() == 0 {
        return Ok(());
    }
    let message = "an angle has no digits of its own: degrees are no radians";
    Diagnostic::error(Code::UnitMismatch, span, message)
        .hint(format!("in degrees: `{name}(x / 1deg) * 1deg`"))
        .fail()
}

/// The dimension of a function of bare numbers, which is one.
fn ratio(dim: Dimension) -> Option<Dimension> {
    dim.is_bare().then_some(Dimension::NONE)
}

/// The dimension of an angle that a bare number tells.
fn angle_of(dim: Dimension) -> Option<Dimension> {
    dim.is_bare().then_some(Dimension::ANGLE)
}

/// An angle, or a bare number of radians.
struct Radians(Real);

impl FromValue for Radians {
    const TYPE: Type = Type::OneOf(&[Type::Angle, Type::Ratio]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Number(number) if number.dim.is_bare() || number.dim.is_angle() => {
                Ok(Self(Real::Plain(number.value)))
            }
            Value::Jet(number) if number.dim.is_bare() || number.dim.is_angle() => {
                Ok(Self(number.value.clone()))
            }
            Value::Number(_) | Value::Jet(_) => {
                Err(Mismatch::kind(Self::TYPE, value).code(Code::UnitMismatch))
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// A number without a unit, or one of which nobody has said what it measures.
struct Ratio(Number<Real>);

impl FromValue for Ratio {
    const TYPE: Type = Type::Ratio;

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        Real::from_value(value, span)?;
        Number::from_value(value, span).map(Self)
    }
}

/// Warns where an angle is written as a whole number without a unit that as radians hardly anybody
/// writes, and as degrees everybody: 30, 45, 60 and so on, in steps of 15.
fn warn_of_degrees(ctx: &mut Ctx<'_>, angle: Span) {
    let source = ctx.sources.and_then(|sources| sources.at(angle));
    let Some(text) = source.and_then(|source| source.text.get(source.local(angle))) else { return };
    // However it is spelled, so that what is remembered of a number goes for all its spellings.
    let is_filling = |c: char| c.is_whitespace() || matches!(c, '(' | ')' | '-' | '_');
    let number: Option<f64> = text.replace(is_filling, "").parse().ok();
    if !number.is_some_and(|number| 30.0 <= number && number % 15.0 == 0.0) {
        return;
    }
    let message = format!("`{text}` without a unit counts as radians");
    ctx.warn(
        Diagnostic::warning(Code::DegreesMeant, angle, message)
            .hint(format!("write `{text}deg` for degrees; `{text}rad` says that radians are meant"))
            .fix(Fix::replace(angle, format!("{text}deg")))
            .fix(Fix::replace(angle, format!("{text}rad"))),
    );
}

/// A number or a point.
enum NumberOrPoint {
    Number(Number<Real>),
    Point(Vector),
}

impl FromValue for NumberOrPoint {
    const TYPE: Type = Type::OneOf(&[Type::Number, Type::Point]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Number(_) | Value::Jet(_) => {
                FromValue::from_value(value, span).map(Self::Number)
            }
            Value::Point(_) | Value::JetPoint(_) => {
                FromValue::from_value(value, span).map(Self::Point)
            }
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}
