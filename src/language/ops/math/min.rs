//! `min`: the smallest number.

use super::{common_dim, empty};
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, Dimension, Number, Numbers, OnNumbers, Real, op},
};

op! {
    /// The smallest of some numbers, given as a list or as the arguments themselves.
    min in Math -> Number<Real> {
        /// The numbers; one or more.
        numbers: Spanned<Numbers>,
    }
    example "min(3, 1, 2)" => "1";
    example "min([3, 1, 2])" => "1";
    refuses "min([])" => "E0502: an empty list has no `min`";
    refuses "min(1, 30deg)" => "E0303: a number without a unit and an angle do not mix";
    refuses "min(1mm, 1deg)" => "E0303: a length and an angle do not mix";
    on_numbers OnNumbers::Fold(Dimension::sum, lesser);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    let Numbers(numbers) = args.numbers.value;
    let dim = common_dim(numbers.iter().map(Number::looked_at), ctx.span)?;
    let mut values = numbers.into_iter().map(|number| number.value);
    let Some(first) = values.next() else { return empty(args.numbers.span, "min") };
    let value = values.try_fold(first, Real::min).at(args.numbers.span)?;
    Ok(Number { value, dim })
}

/// The smaller of two numbers; of equal ones the first.
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}
