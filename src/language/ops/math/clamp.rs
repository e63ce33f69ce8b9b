//! `clamp`: a number kept within limits.

use super::{common_dim, max::greater, min::lesser, outside};
use crate::{
    diag::Result,
    value::{At, Ctx, Dimension, Number, OnNumbers, Real, op},
};

op! {
    /// The number nearest to `x` between two limits.
    clamp in Math -> Number<Real> {
        /// The number.
        x: Number<Real>,
        /// The lower limit.
        low: Number<Real>,
        /// The upper limit.
        high: Number<Real>,
    }
    example "clamp(12, 0, 10)" => "10";
    refuses "clamp(3, 5, 1)" => "E0502: the lower limit 5 is above the upper limit 1";
    on_numbers OnNumbers::Three(common_of_three, clamped);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    let [x, low, high] = [args.x, args.low, args.high];
    let dim = common_dim([&x, &low, &high].into_iter().map(Number::looked_at), ctx.span)?;
    if high.value.value() < low.value.value() {
        let (low, high) = (low.looked_at(), high.looked_at());
        return outside(ctx.span, format!("the lower limit {low} is above the upper limit {high}"));
    }
    let value = x.value.max(low.value).and_then(|value| value.min(high.value)).at(ctx.span)?;
    Ok(Number { value, dim })
}

fn common_of_three([a, b, c]: [Dimension; 3]) -> Option<Dimension> {
    a.sum(b)?.sum(c)
}

/// No number where the lower limit is above the upper one.
fn clamped([x, low, high]: [f64; 3]) -> f64 {
    if high < low { f64::NAN } else { lesser(greater(x, low), high) }
}
