//! `insert_knot` of a curve.

use std::sync::Arc;

use super::{at_least_once, not_too_often};
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// The same curve with one knot more, or with the same knot several times more.
    ///
    /// Exact: each time one control point more, and the control polygon nearer to the curve. A knot
    /// that stands as often as the degree is a control point on the curve; once more is the most.
    /// Piegl & Tiller, *The NURBS Book*, A5.1.
    insert_knot in Edit -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The knot, inside the curve's domain.
        t: Spanned<f64>,
        /// How many times.
        times: Spanned<usize> = Spanned::unplaced(1),
    }
    example "insert_knot(bezier((0, 0), (2, 4), (4, 0)), 0.5).points" => "[(0, 0, 0), (1, 2, 0), (3, 2, 0), (4, 0, 0)]";
    example "insert_knot(bezier((0, 0), (2, 4), (4, 0)), 0.5, times = 2).knots" => "[0, 0, 0, 0.5, 0.5, 1, 1, 1]";
    refuses "insert_knot(bezier((0, 0), (1, 2), (2, 0)), 2)" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "insert_knot(bezier((0, 0), (1, 2), (2, 0)), 0.5, times = 4)" => "E0602: knot 0.5 would stand 4 times; at degree 2 it stands 3 times at most";
    derivative shape;
    picture "insert_knot(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 0.5)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let Args { c, t, times } = args;
    at_least_once("inserted", times)?;
    not_too_often(c.knots(), t, times)?;
    c.insert_knots(&vec![t.value; times.value]).at(t.span)
}
