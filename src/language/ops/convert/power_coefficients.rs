//! `power_coefficients`: a polynomial curve in the power basis.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// Coefficients of a curve of one polynomial segment, the lowest power of its parameter first.
    ///
    /// The inverse of `polynomial`. Of a curve of several segments take one by `to_bezier`.
    /// Piegl & Tiller, *The NURBS Book*, §1.2.
    power_coefficients in Curve -> Vec<DVec3> {
        /// The curve, without weights and of one segment.
        c: Spanned<Arc<NurbsCurve>>,
    }
    example "power_coefficients(bezier((0, 0), (1, 2), (2, 0)))" => "[(0, 0, 0), (2, 4, 0), (0, -4, 0)]";
    example "power_coefficients(polynomial([(1, 0), (2, 1), (0, 3)], domain = 2..4))" => "[(1, 0, 0), (2, 1, 0), (0, 3, 0)]";
    refuses "power_coefficients(polyline((0, 0), (1, 2), (3, 1)))" => "E0611: a polynomial in t has one segment, but the curve has 2";
    refuses "power_coefficients(circle((0, 0), 1))" => "E0611: a polynomial in t has no weights, but those of the curve differ";
    refuses "power_coefficients(conic((0, 0), (1, 2), (2, 0), 1/2))" => "E0611: a polynomial in t has no weights, but those of the curve differ";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<DVec3>> {
    ctx.made_by(&|| args.c.value.factors_of_powers());
    args.c.value.power_coefficients().at(args.c.span)
}
