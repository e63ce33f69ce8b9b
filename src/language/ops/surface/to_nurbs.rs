//! `to_nurbs` of a surface: a surface as a NURBS.

use crate::{
    diag::{Result, Spanned},
    kernel::{
        ConstructionReport, GeomError, InputError, KnotVector, NurbsSurface, ParametricSurface,
        ReportEntry, Surface,
    },
    value::{At, Ctx, Length, op},
};

op! {
    /// NURBS near a surface: of a parametric one a biquintic spline on the same domain, of which no
    /// point is further from the function's than a tolerance; any other surface is one already.
    ///
    /// The spline has the function's points and its derivatives up to the second in each direction
    /// where its knots cross, and is C2 but along creases of the function, which must be lines of
    /// constant parameter. Its distance is measured at 36 places of each patch, where half of the
    /// tolerance is kept; `report` tells what is found in the middle of each. de Boor, *A Practical Guide to Splines*, ch. XVII.
    to_nurbs in Surface -> NurbsSurface {
        /// The surface.
        s: Surface,
        /// How far the spline may be from the function at a pair of parameters.
        tolerance: Spanned<Length>,
    }
    example "to_nurbs(parametric((u, v) => (u, v, u*v), 0..1, 0..2), 1e-9)(0.5, 2) ~= (0.5, 2, 1)" => "true";
    example "to_nurbs(parametric((u, v) => (u, v, u^2 - v^2), 0..1, 0..1), 1e-9).degree_u" => "5";
    refuses "to_nurbs(parametric((u, v) => (u, v, if u < 0.5 then 0 else 1), 0..1, 0..1), 0.1)" => "E0607: the function jumps by 1 at (0.5, 0)";
    scene r#"
        let f = parametric((u, v) => (u, v, sin(u)*cos(v)), 0..5, 0..5) with (hidden = true)
        surface s = to_nurbs(f, 1e-3)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let tolerance = args.tolerance.value.0;
    if tolerance <= 0.0 {
        return Err(InputError::NotPositive { what: "the tolerance", got: tolerance }.into())
            .at(args.tolerance.span);
    }
    let (spline, (worst, at)) = match &args.s {
        Surface::Nurbs(surface) => {
            let start = [surface.domain_u().start(), surface.domain_v().start()];
            (NurbsSurface::clone(surface), (0.0, start))
        }
        Surface::Parametric(surface) => {
            let spline = surface.to_nurbs(tolerance).at(ctx.span)?;
            let worst = deviation(&spline, surface).at(ctx.span)?;
            (spline, worst)
        }
    };
    let both = |u: usize, v: usize| ConstructionReport::default().with("u", u).with("v", v);
    let place = ConstructionReport::default().with("u", at[0]).with("v", at[1]);
    let net = spline.control_points();
    let report = ConstructionReport::of("to_nurbs")
        .with(
            "deviation",
            ConstructionReport::default().with("max", ReportEntry::Length(worst)).with("at", place),
        )
        .with("degree", both(spline.degree_u(), spline.degree_v()))
        .with("control_points", both(net.n_rows(), net.n_columns()));
    Ok(spline.with_report(report))
}

/// How far the spline is from the function in the middle of each cell at most, and where.
fn deviation(
    spline: &NurbsSurface,
    surface: &ParametricSurface,
) -> std::result::Result<(f64, [f64; 2]), GeomError> {
    let middles = |knots: &KnotVector| -> Vec<f64> {
        knots.spans().map(|span| knots.span_interval(span).at(0.5)).collect()
    };
    let (us, vs) = (middles(spline.knots_u()), middles(spline.knots_v()));
    let found = spline.points_on_grid(&us, &vs);
    let mut worst = (0.0, [us[0], vs[0]]);
    for (i, &u) in us.iter().enumerate() {
        for (j, &v) in vs.iter().enumerate() {
            let miss = found.get(i, j).distance(surface.point_at(u, v)?);
            if worst.0 < miss {
                worst = (miss, [u, v]);
            }
        }
    }
    Ok(worst)
}
