//! `derivative` of a curve.

use super::varying;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::Side,
    value::{Ctx, Real, RealCurve, Vector, op},
};

op! {
    /// Derivative vector of a curve by its parameter, of any order; order 0 is the point.
    ///
    /// At a knot it is that of the piece to the right, unless the side says otherwise; at the end that
    /// of the piece to the left. Piegl & Tiller, *The NURBS Book*, A3.2 and A4.2.
    derivative in Measure -> Vector {
        /// The curve.
        c: RealCurve,
        /// The parameter, inside the curve's domain.
        t: Spanned<Real>,
        /// The order.
        order: Spanned<usize> = Spanned::unplaced(1),
        /// The piece that is asked at a knot: after it or before it.
        side: Side = Side::Right,
    }
    example "derivative(bezier((0, 0), (1, 2), (2, 0)), 0)" => "(2, 4, 0)";
    example "derivative(bezier((0, 0), (1, 2), (2, 0)), 0.5, order = 2)" => "(0, -8, 0)";
    example "derivative(polyline((0, 0), (1, 0), (1, 1)), 1, side = \"left\")" => "(1, 0, 0)";
    refuses "derivative(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "derivative(bezier((0, 0), (1, 2), (2, 0)), 0, order = -1)" => "E0301: `derivative`: `order` must be a whole number of zero or more, found the number -1";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vector> {
    let most = ctx.limits.degree;
    if most < args.order.value {
        let message = format!("derivatives go up to order {most}, found {}", args.order.value);
        return Diagnostic::error(Code::TooLarge, args.order.span, message).fail();
    }
    let order = args.order.value;
    let plain = |t| Ok(args.c.derivatives_beside(t, args.side, order)?[order]);
    let formula = |d: &[Vector]| Ok(d[order].clone());
    varying::vector(&args.c, &args.t, args.side, plain, (order, formula))
}
