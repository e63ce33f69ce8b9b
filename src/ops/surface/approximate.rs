//! `approximate` of a grid: the spline surface near points.

use super::{
    Both, cubic,
    fit::{Data, SecondPass, chord},
    in_direction,
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Approximator, KnotVector, LineFit, NurbsSurface, approximate_grid_within},
    ops::curve::{
        check_degree,
        fit::{Parameters, one_of_both, positive},
    },
    value::{At, Ctx, Length, Rows, op},
};

op! {
    /// Spline surface near a grid of points, through its corners, on 0..1 by 0..1 or over the
    /// parameters that are listed.
    ///
    /// With `control_points` by least squares along u, then along v of the control points found,
    /// over knots that spread the parameters evenly. With `tolerance` that near to every point, at
    /// its parameters, with as few control points as are found. Piegl & Tiller, *The NURBS Book*, §9.4.3, A9.7.
    approximate in Surface -> NurbsSurface {
        /// The points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// The degree, or `{u: , v: }`.
        degree: Spanned<Both<usize>> = cubic(),
        /// How many control points, or `{u: , v: }`: from degree + 1 to the number of points.
        control_points: Option<Spanned<Both<usize>>>,
        /// How far the surface may pass from a point.
        tolerance: Option<Spanned<Length>>,
        /// Where the points lie, by a rule or listed; for both directions or `{u: , v: }`.
        parameters: Spanned<Both<Parameters>> = chord(),
        /// Whose distances give the parameters along v.
        second_pass: SecondPass = SecondPass::Data,
    }
    example "approximate([for i in 0..6: [for j in 0..6: (i, j, i * j)]], control_points = 4)(0.5, 0.5) ~= (3, 3, 9)" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let Rows(grid) = args.points.value;
    let span = args.points.span;
    let counts = match (args.control_points, args.tolerance) {
        (Some(counts), None) => counts,
        (None, Some(tolerance)) => {
            let data = Data {
                points: Spanned::new(grid, span),
                parameters: args.parameters,
                second_pass: args.second_pass,
            };
            return within(data, args.degree, tolerance);
        }
        (counts, tolerance) => return one_of_both(ctx.span, counts.is_some(), tolerance),
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
    let data = Data {
        points: Spanned::new(grid, span),
        parameters: args.parameters,
        second_pass: args.second_pass,
    };
    data.surface([&along_u, &along_v])
}

/// The surface that keeps a tolerance.
fn within(
    data: Data,
    degree: Spanned<Both<usize>>,
    tolerance: Spanned<Length>,
) -> Result<NurbsSurface> {
    let distance = positive(tolerance)?;
    if data.second_pass == SecondPass::Control {
        let message =
            "the control points of the first pass are not known before the tolerance is kept";
        return Diagnostic::error(Code::BadCall, tolerance.span, message)
            .hint("leave out `second_pass`, or write `control_points = ...` instead")
            .fail();
    }
    let Spanned { value: grid, span } = &data.points;
    let sizes = [grid.n_rows(), grid.n_columns()];
    for (k, degree_of) in [degree.value.u, degree.value.v].into_iter().enumerate() {
        check_degree(Spanned::new(degree_of, degree.span), Spanned::new(sizes[k], *span))
            .map_err(|found| in_direction(found, ["u", "v"][k], ["rows", "points in a row"][k]))?;
    }
    let [u, v] = data.means()?;
    let degrees = [degree.value.u, degree.value.v];
    approximate_grid_within(&data.points.value, [&u, &v], degrees, distance).at(tolerance.span)
}
