//! `derivative` of a surface.

use super::varying::{self, Varying};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    ops::face::RealSurfaceOrFace,
    value::{Ctx, Real, Vector, op},
};

op! {
    /// Partial derivative vector of a surface, of order `du` by u and `dv` by v.
    ///
    /// Piegl & Tiller, *The NURBS Book*, A3.6 and A4.4.
    derivative in Measure -> Vector {
        /// The surface, or a part of one.
        s: RealSurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<Real>,
        /// The second parameter.
        v: Spanned<Real>,
        /// The order by u.
        du: usize = 1,
        /// The order by v.
        dv: usize = 0,
    }
    example "derivative(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)), 0.5, 1)" => "(1, 0, 1)";
    example "derivative(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)), 0, 0, du = 1, dv = 1)" => "(0, 0, 1)";
    refuses "derivative(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let (du, dv, most) = (args.du, args.dv, ctx.limits.degree);
    let order = du.saturating_add(dv);
    if most < order {
        let message = format!("derivatives go up to order {most}, found {order}");
        return Diagnostic::error(Code::TooLarge, ctx.span, message).fail();
    }
    let plain = |u, v| Ok(args.s.derivatives_at(u, v, order)?.get(du, dv));
    let formula = |at: &Varying| at.derivative(du, dv);
    varying::vector(&args.s, [&args.u, &args.v], ctx.span, plain, (order, formula))
}
