//! `integrate`: the integral of a function over a range.

use super::{SearchRange, no_derivatives, plain_number, told, value_at};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{
        IntegralError, find_integral,
        glam::DVec3,
        tolerance::{EXACT_RELATIVE, INTEGRAL_RELATIVE},
    },
    value::{Callback, Ctx, Dimension, IntoValue, Number, Range, Value, op},
};

op! {
    /// Integral of a function over a range: of numbers a number, of points a point.
    ///
    /// It is known to thirteen digits of the integral of the function's size, or within `tolerance`. The
    /// ends of the range are never asked for, so that a function may grow without bound there; an integral
    /// that has no finite value, or does not settle, is refused with the place. Piessens et al., *QUADPACK*,
    /// §2.2.1.
    integrate in Math -> Value {
        /// A function of one number that yields a number or a point.
        f: Spanned<Callback>,
        /// The range.
        range: Spanned<Range>,
        /// How far the integral may be off, in units of its own; thirteen digits unless given.
        tolerance: Option<Spanned<Number>>,
    }
    example "integrate(x => x^2, 0..3) ~= 9" => "true";
    example "integrate(t => sqrt(1 - t^2), -1..1) ~= pi/2" => "true";
    example "integrate(t => (t, 1), 0..2) ~= (2, 2)" => "true";
    example "integrate(x => 2cm, 0cm..30mm) == 3cm * 2cm" => "true";
    refuses "integrate(x => 1/x, 0..1)" => "E0504: the integral does not settle near 0";
    refuses "integrate(x => x, 1..0)" => "E0606: an interval needs its start below its end, got 1..0";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let range = SearchRange::new(args.range)?;
    let (mut dim, mut is_point) = (None, None);
    let ask = |at: f64| -> Result<[f64; 3]> {
        let value = value_at(ctx, &args.f, &range, at)?;
        if let Value::JetPoint(_) = value {
            return no_derivatives(args.f.span);
        }
        let components = match &value {
            Value::Point(point) if is_point != Some(false) => point.to_array(),
            _ if is_point == Some(true) => {
                let message = format!(
                    "the function yields points, and {} at {}",
                    value.phrase(),
                    range.told(at)
                );
                return Diagnostic::error(Code::WrongKind, args.f.span, message).fail();
            }
            _ => {
                let number = plain_number(&value, args.f.span)?;
                let before: Dimension = *dim.get_or_insert(number.dim);
                if before.common(number.dim).is_none() {
                    let message = format!(
                        "the function yields {} at {} and {before} before",
                        number.dim,
                        range.told(at)
                    );
                    return Diagnostic::error(Code::UnitMismatch, args.f.span, message).fail();
                }
                [number.value, 0.0, 0.0]
            }
        };
        is_point = Some(matches!(value, Value::Point(_)));
        Ok(components)
    };
    let [relative, absolute] = match &args.tolerance {
        Some(tolerance) => [EXACT_RELATIVE, tolerance.value.value],
        None => [INTEGRAL_RELATIVE, 0.0],
    };
    let found = find_integral(ask, range.ends, relative, absolute);
    let [x, y, z] = found.map(|found| found.value).map_err(|err| match err {
        IntegralError::Function(found) => found,
        IntegralError::Unsettled { at, error } => {
            let message = format!("the integral does not settle near {}", range.told(at));
            let left = if error.is_finite() { format!("it may be off by {} still", told(error, None)) } else { "its value is beyond all numbers".to_owned() };
            Box::new(Diagnostic::error(Code::NoAnswer, args.f.span, message).label(left).hint(
                "it may have no finite value; else divide the range there, or give a larger `tolerance`",
            ))
        }
    })?;
    if is_point == Some(true) {
        return Ok(DVec3::new(x, y, z).into_value());
    }
    let dim = dim.unwrap_or_default();
    let Some(dim) = dim.times(range.dim) else {
        let message = "the dimension of the integral has powers that are too high";
        return Diagnostic::error(Code::UnitMismatch, args.f.span, message).fail();
    };
    Ok(Number { value: x, dim }.into_value())
}
