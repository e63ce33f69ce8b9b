//! `reduce`: a curve at a lower degree.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{ConstructionReport, NurbsCurve},
    ops::positive,
    value::{At, Ctx, Length, op},
};

op! {
    /// Curve at the lowest degree that leaves every point within a tolerance, or at a degree that
    /// is named.
    ///
    /// Both ends stay. Where not even one degree less is within the tolerance it is an error that
    /// tells how far the curve would move, as an upper bound rarely more than 2% above the truth. Undoes
    /// `elevate`. Piegl & Tiller, *The NURBS Book*, §5.6.
    reduce in Edit -> NurbsCurve {
        /// The curve, of degree 2 or more.
        c: Arc<NurbsCurve>,
        /// How far a point of the curve may move.
        tolerance: Spanned<Length>,
        /// The degree of the result.
        degree: Option<Spanned<usize>>,
    }
    example "reduce(elevate(bezier((0, 0), (3, 6), (6, 0)), 4), 1e-9).degree" => "2";
    example "reduce(bezier((0, 0), (1, 0.02), (2, 0)), 0.02).points" => "[(0, 0, 0), (2, 0, 0)]";
    refuses "reduce(bezier((0, 0), (1, 2), (2, 0)), 0.1)" => "E0608: degree 1 would move the curve by up to 1, more than the tolerance 0.1";
    refuses "reduce(line((0, 0), (1, 0)), 0.1)" => "E0604: the curve has degree 1, below which there is none";
    picture "reduce(elevate(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 5), 1e-9)";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let tolerance = positive("the tolerance", args.tolerance)?;
    let degree = args.degree.map(|degree| degree.value);
    let span = args.degree.map_or(args.tolerance.span, |degree| degree.span);
    match degree {
        Some(degree) if degree == 0 || args.c.degree() <= degree => {
            let own = args.c.degree();
            let message = format!(
                "the degree of the result must be 1 or more and below the {own} of the curve, found {degree}"
            );
            Diagnostic::error(Code::BadDegree, span, message).fail()
        }
        _ => {
            let reduced = args.c.reduced(degree, tolerance).at(span)?;
            let report = ConstructionReport::of("reduce")
                .with("degree", reduced.degree())
                .with("deviation", args.c.deviation_from(&reduced));
            Ok(reduced.with_report(report))
        }
    }
}
