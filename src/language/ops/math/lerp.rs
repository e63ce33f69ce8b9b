//! `lerp`: linear interpolation.

use super::{NumberOrPoint, Ratio, common_dim, finite, outside};
use crate::{
    diag::Result,
    value::{Ctx, Dimension, IntoValue, Number, OnNumbers, Real, Value, op},
};

op! {
    /// The value at fraction `t` of the way from `a` to `b`, of numbers or points; exact at 0 and 1, and beyond them it goes on.
    lerp in Math -> Value {
        /// The value at 0.
        a: NumberOrPoint,
        /// The value at 1.
        b: NumberOrPoint,
        /// The fraction.
        t: Ratio,
    }
    example "lerp(2, 4, 0.25)" => "2.5";
    example "lerp((0, 0), (2, 4), 0.5)" => "(1, 2, 0)";
    example "lerp(0, 90deg, 0.5)" => "45deg";
    refuses "lerp(1, 90deg, 0.5)" => "E0303: a number without a unit and an angle do not mix";
    refuses "lerp(1, (0, 0), 0.5)" => "E0502: both values must be numbers, or both points";
    on_numbers OnNumbers::Three(sum_of_ends, between);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let Args { a, b, t: Ratio(Number { value: t, dim: dim_of_t }) } = args;
    let rest = Real::Plain(1.0).minus(&t);
    match (a, b) {
        (NumberOrPoint::Number(a), NumberOrPoint::Number(b)) => {
            let dim = common_dim([a.looked_at(), b.looked_at()].into_iter(), ctx.span)?;
            let value = finite(a.value.times(&rest).plus(&b.value.times(&t)), ctx.span)?;
            // A bare number changes no power.
            let dim = dim.times(dim_of_t).unwrap_or(dim);
            Ok(Number { value, dim }.into_value())
        }
        (NumberOrPoint::Point(a), NumberOrPoint::Point(b)) => {
            Ok(a.times(&rest).plus(&b.times(&t)).into_value())
        }
        _ => outside(ctx.span, "both values must be numbers, or both points".to_owned()),
    }
}

fn sum_of_ends([a, b, t]: [Dimension; 3]) -> Option<Dimension> {
    if t.is_bare() { a.sum(b)?.times(t) } else { None }
}

fn between([a, b, t]: [f64; 3]) -> f64 {
    a * (1.0 - t) + b * t
}
