//! `cosspace`: numbers denser at the ends.

use super::check_length;
use crate::{
    diag::Result,
    ops::math::common_dim,
    value::{Ctx, Number, op},
};

op! {
    /// `n` numbers from `a` to `b`, both included, denser towards the ends as the cosine of equal angles: the usual stations of an aerofoil.
    cosspace in List -> Vec<Number> {
        /// The first number.
        a: Number,
        /// The last number.
        b: Number,
        /// How many; one gives the first alone.
        n: usize,
    }
    example "cosspace(0, 1, 3)" => "[0, 0.5, 1]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Number>> {
    let Args { a, b, n } = args;
    let dim = common_dim(&[a, b], ctx.span)?;
    check_length(n as f64, ctx)?;
    let number = |i: usize| {
        // Both ends exactly.
        let value = match i {
            0 => a.value,
            _ if i + 1 == n => b.value,
            _ => {
                let t = i as f64 / (n - 1) as f64;
                // As a sine about the middle, so that both halves mirror each other exactly.
                let t = 0.5 * (1.0 + libm::sin(std::f64::consts::PI * (t - 0.5)));
                a.value * (1.0 - t) + b.value * t
            }
        };
        Number { value, dim }
    };
    Ok((0..n).map(number).collect())
}
