//! `cbrt`: the cube root.

use super::outside;
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, Number, op},
};

op! {
    /// Cube root; of a volume it is a length.
    cbrt in Math -> Number {
        /// A number.
        x: Spanned<Number>,
    }
    example "cbrt(-27)" => "-3";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Number> {
    let Some(dim) = args.x.value.dim.cube_root() else {
        return outside(args.x.span, format!("{} has no cube root", args.x.value.dim));
    };
    Ok(Number { value: libm::cbrt(args.x.value.value), dim })
}
