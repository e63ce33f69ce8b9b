//! `refine` of a curve: more knots.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// The same curve with more knots; a knot that is to be there twice more is given twice.
    ///
    /// Exact: one control point more for each. A knot within rounding of one that is there already
    /// counts as that one. Piegl & Tiller, *The NURBS Book*, A5.4.
    refine in Edit -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The knots to insert, in any order, inside the curve's domain.
        knots: Spanned<Vec<f64>>,
    }
    example "refine(line((0, 0), (4, 8)), [0.5, 0.25]).points" => "[(0, 0, 0), (1, 2, 0), (2, 4, 0), (4, 8, 0)]";
    example "refine(line((0, 0), (4, 8)), []).degree" => "1";
    refuses "refine(bezier((0, 0), (1, 2), (2, 0)), [0.5, 2])" => "E0606: parameter 2 is outside the domain 0..1";
    derivative shape;
    picture "refine(bezier((0, 0), (1, 3), (3, -2), (4, 1)), [0.25, 0.5, 0.75])";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    args.c.insert_knots(&args.knots.value).at(args.knots.span)
}
