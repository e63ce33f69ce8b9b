//! `linspace`: numbers at equal distances.

use super::spaced;
use crate::{
    diag::Result,
    value::{Ctx, Number, op},
};

op! {
    /// `n` numbers at equal distances from `a` to `b`, both included.
    linspace in List -> Vec<Number> {
        /// The first number.
        a: Number,
        /// The last number.
        b: Number,
        /// How many; one gives the first alone.
        n: usize,
    }
    example "linspace(0, 1, 5)" => "[0, 0.25, 0.5, 0.75, 1]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Number>> {
    spaced(args.a, args.b, args.n, ctx, |t| t)
}
