//! `to_nurbs`: a curve as a NURBS.

use crate::{
    diag::{Result, Spanned},
    kernel::{ConstructionReport, Curve, GeomError, NurbsCurve, ParametricCurve, ReportEntry},
    ops::positive,
    value::{At, Ctx, Length, op},
};

op! {
    /// NURBS near a curve: of a parametric one a quintic spline on the same domain, of which no
    /// point is further from the function's than a tolerance; any other curve is one already.
    ///
    /// The spline has the function's points, first and second derivatives at its knots; where the
    /// function's derivatives jump it has a corner. Its distance is measured at 16 places of each
    /// piece, where half of the tolerance is kept; `report` tells what was found.
    /// de Boor, *A Practical Guide to Splines*, ch. I.
    to_nurbs in Edit -> NurbsCurve {
        /// The curve.
        c: Curve,
        /// How far the spline may be from the function at a parameter.
        tolerance: Spanned<Length>,
    }
    example "to_nurbs(parametric(t => (t, t^2), 0..2), 1e-9)(1.5) ~= (1.5, 2.25)" => "true";
    example "to_nurbs(circle((0, 0), 1), 1e-6).degree" => "2";
    refuses "to_nurbs(parametric(t => (t, t^2), 0..2), 0)" => "E0607: the tolerance must be positive, found 0";
    refuses "to_nurbs(parametric(t => (t, if t < 1 then 0 else 1), 0..2), 0.1)" => "E0607: the function jumps by 1 at parameter 1";
    scene r#"
        curve c = to_nurbs(parametric(t => (t, sin(t)), 0..7), 1e-3)
        curve polygon = control_polygon(c) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let tolerance = positive("the tolerance", args.tolerance)?;
    let (spline, worst) = match &args.c {
        Curve::Nurbs(curve) => (NurbsCurve::clone(curve), (0.0, curve.domain().start())),
        Curve::Parametric(curve) => {
            let spline = curve.to_nurbs(tolerance).at(ctx.span)?;
            let worst = deviation(&spline, curve).at(ctx.span)?;
            (spline, worst)
        }
    };
    let report = ConstructionReport::of("to_nurbs")
        .with(
            "deviation",
            ConstructionReport::default()
                .with("max", ReportEntry::Length(worst.0))
                .with("at", worst.1),
        )
        .with("degree", spline.degree())
        .with("control_points", spline.control_points().len());
    Ok(spline.with_report(report))
}

/// Places of a span at which the deviation is measured.
const N_PLACES: usize = 8;

/// How far the spline is from the function, and at which parameter.
fn deviation(
    spline: &NurbsCurve,
    curve: &ParametricCurve,
) -> std::result::Result<(f64, f64), GeomError> {
    let mut worst = (0.0, spline.domain().start());
    for span in spline.knots().spans() {
        for k in 0..N_PLACES {
            let t = spline.knots().span_interval(span).at((k as f64 + 0.5) / N_PLACES as f64);
            let miss = spline.point_at(t).distance(curve.point_at(t)?);
            if worst.0 < miss {
                worst = (miss, t);
            }
        }
    }
    Ok(worst)
}
