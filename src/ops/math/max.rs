//! `max`: the largest number.

use super::{common_dim, empty};
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, Number, Numbers, op},
};

op! {
    /// The largest of some numbers, given as a list or as the arguments themselves.
    max in Math -> Number {
        /// The numbers; one or more.
        numbers: Spanned<Numbers>,
    }
    example "max(3, 1, 2)" => "3";
    example "max([3, 1, 2])" => "3";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let Numbers(numbers) = args.numbers.value;
    let dim = common_dim(&numbers, ctx.span)?;
    let best = numbers
        .into_iter()
        .reduce(|best, candidate| if best.value < candidate.value { candidate } else { best });
    match best {
        Some(best) => Ok(Number { dim, ..best }),
        None => empty(args.numbers.span, "max"),
    }
}
