//! `approximate` of a grid: the spline surface near points.

use super::{
    PerDirection, cubic,
    fit::{GridData, SecondPass, chord},
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Approximator, KnotVector, LineFit, NurbsSurface},
    ops::curve::{check_degree, fit::Parameters},
    value::{At, Ctx, Rows, op},
};

op! {
    /// Spline surface near a grid of points, through its corners, on 0..1 by 0..1 or over the
    /// parameters that are listed.
    ///
    /// Least squares along u, then along v of the control points found, over knots that spread the
    /// parameters evenly. Piegl & Tiller, *The NURBS Book*, §9.4.3, A9.7.
    approximate in Surface -> NurbsSurface {
        /// The points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// The degree, or `{u: , v: }`.
        degree: Spanned<PerDirection<usize>> = cubic(),
        /// How many control points, or `{u: , v: }`: from degree + 1 to the number of points.
        control_points: Option<Spanned<PerDirection<usize>>>,
        /// Where the points lie, by a rule or listed; for both directions or `{u: , v: }`.
        parameters: Spanned<PerDirection<Parameters>> = chord(),
        /// Whose distances give the parameters along v.
        second_pass: SecondPass = SecondPass::Data,
    }
    example "approximate([for i in 0..6: [for j in 0..6: (i, j, i * j)]], control_points = 4)(0.5, 0.5) ~= (3, 3, 9)" => "true";
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
    let Some(counts) = args.control_points else {
        let message = "`approximate` needs to know how near the surface shall come";
        return Diagnostic::error(Code::BadCall, ctx.span, message)
            .hint("write `control_points = ...`, or `{u: , v: }`")
            .fail();
    };
    let near = |degree: usize, count: usize, n_points: usize| {
        let (degree, counts) = (Spanned::new(degree, args.degree.span), counts.span);
        move |parameters: Vec<f64>| {
            check_degree(degree, Spanned::new(n_points, span))?;
            if !(degree.value + 1..=n_points).contains(&count) {
                let least = degree.value + 1;
                let message = format!(
                    "{count} control points for {n_points} points: degree {} takes from {least} to {n_points}",
                    degree.value
                );
                return Diagnostic::error(Code::TooFewPoints, counts, message).fail();
            }
            let knots = KnotVector::spreading(degree.value, count, &parameters).at(counts)?;
            Approximator::new(&parameters, knots).at(counts).map(LineFit::Near)
        }
    };
    let along_u = near(args.degree.value.u, counts.value.u, grid.n_rows());
    let along_v = near(args.degree.value.v, counts.value.v, grid.n_columns());
    let data = GridData {
        points: Spanned::new(grid, span),
        parameters: args.parameters,
        second_pass: args.second_pass,
        operation: "approximate",
    };
    data.surface([&along_u, &along_v])
}
