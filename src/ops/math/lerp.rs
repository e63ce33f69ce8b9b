//! `lerp`: linear interpolation.

use super::{Quantity, common_dim, finite, outside};
use crate::{
    diag::Result,
    value::{Ctx, Number, Value, op},
};

op! {
    /// The value at fraction `t` of the way from `a` to `b`, of numbers or points; exact at 0 and 1, and beyond them it goes on.
    lerp in Math -> Value {
        /// The value at 0.
        a: Quantity,
        /// The value at 1.
        b: Quantity,
        /// The fraction.
        t: f64,
    }
    example "lerp(2, 4, 0.25)" => "2.5";
    example "lerp((0, 0), (2, 4), 0.5)" => "(1, 2, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let Args { a, b, t } = args;
    match (a, b) {
        (Quantity::Number(a), Quantity::Number(b)) => {
            let dim = common_dim(&[a, b], ctx.span)?;
            let value = finite(a.value * (1.0 - t) + b.value * t, ctx.span)?;
            Ok(Value::Number(Number { value, dim }))
        }
        (Quantity::Point(a), Quantity::Point(b)) => Ok(Value::Point(a * (1.0 - t) + b * t)),
        _ => outside(ctx.span, "both values must be numbers, or both points".to_owned()),
    }
}
