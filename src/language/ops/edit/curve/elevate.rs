//! `elevate` of a curve: the same curve at a higher degree.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// The same curve at a higher degree, which is named.
    ///
    /// Exact: points, parameters and continuity stay; each inner knot stands once more for each
    /// degree. The result begins at its first control point and ends at its last.
    /// Prautzsch, *Degree elevation of B-spline curves*, CAGD 1 (1984).
    elevate in Edit -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The degree of the result, not below that of the curve.
        degree: Spanned<usize>,
    }
    example "elevate(bezier((0, 0), (3, 6), (6, 0)), 3).points" => "[(0, 0, 0), (2, 4, 0), (4, 4, 0), (6, 0, 0)]";
    refuses "elevate(bezier((0, 0), (1, 2), (2, 0)), 1)" => "E0604: degree 1 is below the degree 2 that it has";
    refuses "elevate(bezier((0, 0), (1, 2), (2, 0)), 200)" => "E0901: degree 200 is above 100, the highest that is allowed";
    derivative shape;
    picture "elevate(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 6)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    args.c.elevate_degree(args.degree.value).at(args.degree.span)
}
