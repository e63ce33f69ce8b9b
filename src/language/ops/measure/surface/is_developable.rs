//! `is_developable` of a surface.

use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Whether a surface can be unrolled into a plane without being stretched: K = 0 everywhere.
    ///
    /// A curvature counts as none below 1e-9 over the size of the surface, or of the other curvature. Of a
    /// NURBS up to degree 8 that is looked at in enough places to hold for all of it; of a `parametric`
    /// surface at 49 × 49 places.
    ///
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, §1.4.
    is_developable in Measure -> bool {
        /// The surface.
        s: Spanned<Surface>,
    }
    example "is_developable(cone((0, 0), 3, 1, 4))" => "true";
    example "is_developable(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)))" => "false";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    args.s.value.is_developable(ctx.tolerance).at(args.s.span)
}
