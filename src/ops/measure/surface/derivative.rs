//! `derivative` of a surface.

use glam::DVec3;

use super::inside;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Partial derivative vector of a surface, of order `du` by u and `dv` by v.
    ///
    /// Piegl & Tiller, *The NURBS Book*, A3.6 and A4.4.
    derivative in Measure -> DVec3 {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
        /// The order by u.
        du: usize = 1,
        /// The order by v.
        dv: usize = 0,
    }
    example "derivative(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)), 0.5, 1)" => "(1, 0, 1)";
    example "derivative(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1)), 0, 0, du = 1, dv = 1)" => "(0, 0, 1)";
    refuses "derivative(plane_patch((0, 0), (1, 0), (0, 1)), 2, 0)" => "E0606: parameter 2 is outside the domain 0..1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    let (order, most) = (args.du.saturating_add(args.dv), ctx.limits.degree);
    if most < order {
        let message = format!("derivatives go up to order {most}, found {order}");
        return Diagnostic::error(Code::TooLarge, ctx.span, message).fail();
    }
    Ok(args.s.derivatives_at(u, v, order).at(ctx.span)?.get(args.du, args.dv))
}
