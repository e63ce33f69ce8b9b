//! `remove_knot` of a curve.

use std::sync::Arc;

use super::at_least_once;
use crate::{
    diag::{Result, Spanned},
    kernel::{ConstructionReport, NurbsCurve, ReportEntry},
    ops::positive,
    value::{At, Ctx, Length, op},
};

op! {
    /// Curve without an inner knot, where no point of it moves further than a tolerance.
    ///
    /// One control point less each time. Where the curve would move further it is an error that
    /// tells how far, as an upper bound rarely more than 2% above the truth. Undoes `insert_knot`.
    /// Piegl & Tiller, *The NURBS Book*, §5.4.
    remove_knot in Edit -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The knot, one between the ends of the domain.
        t: Spanned<f64>,
        /// How far a point of the curve may move.
        tolerance: Spanned<Length>,
        /// How many times.
        times: Spanned<usize> = Spanned::unplaced(1),
    }
    example "remove_knot(insert_knot(bezier((0, 0), (2, 4), (4, 0)), 0.5), 0.5, 1e-9).points" => "[(0, 0, 0), (2, 4, 0), (4, 0, 0)]";
    refuses "remove_knot(polyline((0, 0), (1, 2), (2, 0)), 1, 0.1)" => "E0608: without the knot 1 the curve would move by up to 2, more than the tolerance 0.1";
    refuses "remove_knot(bezier((0, 0), (1, 2), (2, 0)), 0.5, 0.1)" => "E0602: no inner knot stands at 0.5";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let tolerance = positive("the tolerance", args.tolerance)?;
    at_least_once("removed", args.times)?;
    let without = args.c.without_knot(args.t.value, args.times.value, tolerance).at(args.t.span)?;
    let deviation = args.c.deviation_from(&without);
    Ok(without.with_report(
        ConstructionReport::of("remove_knot").with("deviation", ReportEntry::Length(deviation)),
    ))
}
