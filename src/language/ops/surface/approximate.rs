//! `approximate` of a grid: the spline surface near points.

use super::{
    PerDirection, cubic,
    fit::{GridData, SecondPass, chord},
    in_direction,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Approximator, Direction, KnotVector, LineFit, NurbsSurface},
    ops::{
        curve::{check_degree, fit::Parameters},
        positive,
    },
    value::{At, Ctx, Length, Rows, op},
};

op! {
    /// Spline surface near a grid of points, through its corners, on 0..1 by 0..1 or over the
    /// parameters that are listed.
    ///
    /// One of `control_points` and `tolerance` is given. Least squares along u, then along v of the
    /// control points found: with `control_points` over knots that spread the parameters evenly; with
    /// `tolerance` over knots that are added where points are missed and taken away where they are not
    /// needed, until every point is that near to the surface at its parameters and no knot can go.
    /// `report` has `{degree, control_points, deviation, parameters}`.
    /// Piegl & Tiller, *The NURBS Book*, §9.4.3, A9.7; Lyche & Mørken, *Knot removal for parametric
    /// B-spline curves and surfaces*, CAGD 4 (1987).
    approximate in Surface -> NurbsSurface {
        /// The points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// The degree, or `{u: , v: }`.
        degree: Spanned<PerDirection<usize>> = cubic(),
        /// How many control points, or `{u: , v: }`: from degree + 1 to the number of points.
        control_points: Option<Spanned<PerDirection<usize>>>,
        /// How far the surface may pass from a point.
        tolerance: Option<Spanned<Length>>,
        /// Where the points lie, by a rule or listed; for both directions or `{u: , v: }`.
        parameters: Spanned<PerDirection<Parameters>> = chord(),
        /// Whose distances give the parameters along v.
        second_pass: SecondPass = SecondPass::Data,
    }
    example "approximate([for i in 0..6: [for j in 0..6: (i, j, i * j)]], control_points = 4)(0.5, 0.5) ~= (3, 3, 9)" => "true";
    example "report(approximate([for i in 0..20: [for j in 0..20: (i, j, i^2 - i * j)]], tolerance = 1e-6, parameters = \"uniform\")).control_points" => "{u: 4, v: 4}";
    refuses "approximate([for i in 0..6: [for j in 0..6: (i, j)]])" => "E0401: `approximate` needs to know how near the surface shall come";
    refuses "approximate([for i in 0..6: [for j in 0..6: (i, j)]], control_points = 9)" => "E0601: along u: 9 control points for 7 points: degree 3 takes from 4 to 7";
    scene r#"
        let p = [for i in 0..12: [for j in 0..12: (i, j, 3*sin(i/3)*cos(j/3) + sin(3*i + 5*j)/3)]] with (hidden = true)
        surface s = approximate(p, control_points = 6) with (color = "lightgray")
        points measured = flatten(p) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let Rows(grid) = args.points.value;
    let span = args.points.span;
    let degrees = [args.degree.value.u, args.degree.value.v];
    let degrees = degrees.map(|degree| Spanned::new(degree, args.degree.span));
    let counts = [grid.n_rows(), grid.n_columns()];
    let data = GridData {
        points: Spanned::new(grid, span),
        parameters: args.parameters,
        second_pass: args.second_pass,
        operation: "approximate",
    };
    match (args.control_points, args.tolerance) {
        (Some(wanted), None) => {
            let near = |along: Direction, count: usize| {
                let (degree, n_points, counts) = (degrees[along], counts[along], wanted.span);
                move |parameters| {
                    near(degree, Spanned::new(count, counts), (n_points, span), parameters)
                }
            };
            let (along_u, along_v) =
                (near(Direction::U, wanted.value.u), near(Direction::V, wanted.value.v));
            data.surface([&along_u, &along_v])
        }
        (None, Some(tolerance)) => {
            let hint = "`interpolate` passes through all of the points";
            let within = positive("the tolerance", tolerance)
                .map_err(|mistake| Box::new(mistake.hint(hint)))?;
            for (degree, (n_points, along)) in
                degrees.into_iter().zip(counts.into_iter().zip(["u", "v"]))
            {
                check_degree(degree, Spanned::new(n_points, span))
                    .map_err(|found| in_direction(found, along, "points"))?;
            }
            let within = Spanned::new(within, tolerance.span);
            data.surface_within(degrees.map(|degree| degree.value), within)
        }
        (Some(_), Some(tolerance)) => {
            let message = "`control_points` and `tolerance` exclude one another";
            Diagnostic::error(Code::BadCall, tolerance.span, message)
                .hint("leave one of them out: the count decides how near the surface comes")
                .fail()
        }
        (None, None) => {
            let message = "`approximate` needs to know how near the surface shall come";
            Diagnostic::error(Code::BadCall, ctx.span, message)
                .hint(
                    "write `tolerance = ...`, or `control_points = ...`, which may be `{u: , v: }`",
                )
                .fail()
        }
    }
}

/// The fit of one direction with so many control points.
fn near(
    degree: Spanned<usize>,
    count: Spanned<usize>,
    (n_points, points): (usize, Span),
    parameters: Vec<f64>,
) -> Result<LineFit> {
    check_degree(degree, Spanned::new(n_points, points))?;
    if !(degree.value + 1..=n_points).contains(&count.value) {
        let least = degree.value + 1;
        let message = format!(
            "{} control points for {n_points} points: degree {} takes from {least} to {n_points}",
            count.value, degree.value
        );
        return Diagnostic::error(Code::TooFewPoints, count.span, message).fail();
    }
    let knots = KnotVector::spreading(degree.value, count.value, &parameters).at(count.span)?;
    let fit = Approximator::new(&parameters, knots).and_then(Approximator::determined);
    fit.at(count.span).map(LineFit::Near)
}
