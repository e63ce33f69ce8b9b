//! `mean`: the mean of a list.

use super::total;
use crate::{
    diag::{Result, Spanned},
    ops::math::empty,
    value::{Ctx, List, Number, Value, op},
};

op! {
    /// Arithmetic mean of numbers, or of points.
    mean in List -> Value {
        /// The list; one element or more.
        list: Spanned<List>,
    }
    example "mean([1, 2, 6])" => "3";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let items = &args.list.value;
    if items.is_empty() {
        return empty(args.list.span, "mean");
    }
    let n_items = items.len() as f64;
    Ok(match total(items, ctx.span)? {
        Value::Number(sum) => Value::Number(Number { value: sum.value / n_items, ..sum }),
        Value::Point(sum) => Value::Point(sum / n_items),
        other => other,
    })
}
