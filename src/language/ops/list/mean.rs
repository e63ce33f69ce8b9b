//! `mean`: the mean of a list.

use super::{RunningSum, total};
use crate::{
    diag::{Result, Spanned},
    ops::math::empty,
    value::{At, Ctx, IntoValue, List, Number, Real, Value, op},
};

op! {
    /// Arithmetic mean of numbers, or of points.
    mean in List -> Value {
        /// The list; one element or more.
        list: Spanned<List>,
    }
    example "mean([1, 2, 6])" => "3";
    example "mean([(0, 0), (2, 4)])" => "(1, 2, 0)";
    example "mean([0, 30deg])" => "15deg";
    refuses "mean([])" => "E0502: an empty list has no `mean`";
    refuses "mean([1, (0, 0)])" => "E0301: numbers and points cannot be added";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let items = &args.list.value;
    if items.is_empty() {
        return empty(args.list.span, "mean");
    }
    let n_items = Real::Plain(items.len() as f64);
    Ok(match total(items, ctx.span)? {
        RunningSum::Number(sum) => {
            let value = sum.value.over(&n_items).at(ctx.span)?;
            Number { value, dim: sum.dim }.into_value()
        }
        RunningSum::Point(sum) => sum.over(&n_items).at(ctx.span)?.into_value(),
    })
}
