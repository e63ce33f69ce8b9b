//! `cosspace`: numbers denser at the ends.

use super::spaced;
use crate::{
    diag::Result,
    value::{Ctx, Number, Real, op},
};

op! {
    /// `n` numbers from `a` to `b`, both included, denser towards the ends as the cosine of equal angles: the usual stations of an aerofoil.
    cosspace in List -> Vec<Number<Real>> {
        /// The first number.
        a: Number<Real>,
        /// The last number.
        b: Number<Real>,
        /// How many; one gives the first alone.
        n: usize,
    }
    example "cosspace(0, 1, 3)" => "[0, 0.5, 1]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Number<Real>>> {
    // As a sine about the middle, so that both halves mirror each other exactly.
    spaced(args.a, args.b, args.n, ctx, |t| {
        0.5 * (1.0 + libm::sin(std::f64::consts::PI * (t - 0.5)))
    })
}
