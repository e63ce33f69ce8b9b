//! `sum`: the sum of a list.

use super::{RunningSum, total};
use crate::{
    diag::Result,
    value::{Ctx, IntoValue, List, Value, op},
};

op! {
    /// Sum of numbers, or of points, from the first to the last; of an empty list 0.
    sum in List -> Value {
        /// The list; a range of whole numbers counts as one.
        list: List,
    }
    example "sum([1, 2, 3.5])" => "6.5";
    example "sum(1..100)" => "5050";
    example "sum([0, 30deg, 60deg])" => "90deg";
    example "sum([(1, 0), (0, 2)])" => "(1, 2, 0)";
    refuses "sum([30deg, 1])" => "E0303: an angle and a number without a unit do not mix";
    refuses "sum([1mm, 2deg])" => "E0303: a length and an angle do not mix";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    Ok(match total(&args.list, ctx.span)? {
        RunningSum::Number(sum) => sum.into_value(),
        RunningSum::Point(sum) => sum.into_value(),
    })
}
