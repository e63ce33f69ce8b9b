//! `is_minimal` of a surface.

use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Whether a surface is minimal, like a soap film: its mean curvature is zero everywhere.
    ///
    /// A curvature counts as none below 1e-9 over the size of the surface, or of the largest curvature. Of a
    /// NURBS up to degree 8 that is looked at in enough places to hold for all of it; of a `parametric`
    /// surface at 49 × 49 places.
    ///
    /// do Carmo, *Differential Geometry of Curves and Surfaces*, §3-5.
    is_minimal in Measure -> bool {
        /// The surface.
        s: Spanned<Surface>,
    }
    example "is_minimal(parametric((u, v) => (cosh(v)*cos(u), cosh(v)*sin(u), v), 0..tau, -1..1))" => "true";
    example "is_minimal(cylinder((0, 0), 1, 1))" => "false";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    args.s.value.is_minimal(ctx.tolerance).at(args.s.span)
}
