//! `cbrt`: the cube root.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{At, Ctx, Dimension, Number, OnNumbers, Real, op},
};

op! {
    /// Cube root; of a volume it is a length.
    cbrt in Math -> Number<Real> {
        /// A number.
        x: Spanned<Number<Real>>,
    }
    example "cbrt(-27)" => "-3";
    encloses crate::kernel::Enclosure::cbrt;
    on_numbers OnNumbers::One(Dimension::cube_root, libm::cbrt);
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number<Real>> {
    let Some(dim) = args.x.value.dim.cube_root() else {
        return outside(args.x.span, format!("{} has no cube root", args.x.value.dim));
    };
    Ok(Number { value: args.x.value.value.cbrt().at(args.x.span)?, dim })
}
