//! `linspace`: numbers at equal distances.

use super::spaced;
use crate::{
    diag::Result,
    value::{Ctx, Number, Real, op},
};

op! {
    /// `n` numbers at equal distances from `a` to `b`, both included.
    linspace in List -> Vec<Number<Real>> {
        /// The first number.
        a: Number<Real>,
        /// The last number.
        b: Number<Real>,
        /// How many; one gives the first alone.
        n: usize,
    }
    example "linspace(0, 1, 5)" => "[0, 0.25, 0.5, 0.75, 1]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Number<Real>>> {
    spaced(args.a, args.b, args.n, ctx, |t| t)
}
