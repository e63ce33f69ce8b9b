//! `abs`: the magnitude of a number.

use crate::{
    diag::Result,
    value::{At, Ctx, Number, OnNumbers, Real, op},
};

op! {
    /// Magnitude of a number, without its sign.
    abs in Math -> Number<Real> {
        /// A number of any dimension.
        x: Number<Real>,
    }
    example "abs(-3)" => "3";
    example "abs(-30deg)" => "30deg";
    encloses crate::kernel::Enclosure::abs;
    on_numbers OnNumbers::One(Some, f64::abs);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    Ok(Number { value: args.x.value.abs().at(ctx.span)?, ..args.x })
}
