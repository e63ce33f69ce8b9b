//! `is_planar` of a surface.

use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Whether a surface lies in one plane, within the tolerance.
    ///
    /// One that is collapsed to a straight line does too. Told from the control points; of a `parametric` surface from points of it.
    is_planar in Measure -> bool {
        /// The surface.
        s: Spanned<Surface>,
    }
    example "is_planar(bilinear((0, 0), (0, 1), (1, 0), (2, 3)))" => "true";
    example "is_planar(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)))" => "false";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    args.s.value.is_planar(ctx.tolerance).at(args.s.span)
}
