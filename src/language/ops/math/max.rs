//! `max`: the largest number.

use super::{common_dim, empty};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, Dimension, Number, Numbers, OnNumbers, Real, op},
};

op! {
    /// The largest of some numbers, given as a list or as the arguments themselves.
    max in Math -> Number<Real> {
        /// The numbers; one or more.
        numbers: Spanned<Numbers>,
    }
    example "max(3, 1, 2)" => "3";
    example "max([3, 1, 2])" => "3";
    refuses "max([])" => "E0502: an empty list has no `max`";
    refuses "max(1, 30deg)" => "E0303: a number without a unit and an angle do not mix";
    refuses "max(1mm, 1deg)" => "E0303: a length and an angle do not mix";
    on_numbers OnNumbers::Fold(Dimension::sum, greater);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    let Numbers(numbers) = args.numbers.value;
    let dim = common_dim(numbers.iter().map(Number::looked_at), ctx.span)?;
    let mut values = numbers.into_iter().map(|number| number.value);
    let Some(first) = values.next() else { return empty(args.numbers.span, "max") };
    let value = values.try_fold(first, Real::max).at(args.numbers.span)?;
    Ok(Number { value, dim })
}

/// The larger of two numbers; of equal ones the first.
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}
