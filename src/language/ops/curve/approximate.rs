//! `approximate`: the spline near points.

use glam::DVec3;

use super::fit::{Parameters, chord, loose_parameters};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{self, NurbsCurve},
    ops::positive,
    value::{At, AtLeast, Ctx, Length, op},
};

/// Fewer points than so many times those of one polynomial say nothing of how they scatter.
const ENOUGH: usize = 4;

op! {
    /// Spline near points, through the first and the last, on 0..1 or over the parameters that
    /// are listed.
    ///
    /// One of `control_points` and `tolerance` is given. With `control_points` it is the one whose
    /// squared distances at the parameters sum to least, over knots that spread the parameters
    /// evenly. With `tolerance` it comes that near to every point, with as few control points as
    /// are found; it moves the parameters along the curve unless they are listed, and has corners
    /// where the points turn sharply, if that takes no more control points. Points that scatter by more
    /// than the tolerance are followed one by one, without detours, which gives a warning. `report` has
    /// `{control_points, deviation, corners, parameters}`. Piegl & Tiller, *The NURBS Book*,
    /// §9.4.1, (9.68), (9.69); Hoschek & Lasser, *Fundamentals of Computer Aided Geometric
    /// Design*, §4.4.
    approximate in Curve -> NurbsCurve {
        /// The points, more than the degree.
        points: Spanned<AtLeast<2, DVec3>>,
        /// The degree.
        degree: Spanned<usize> = Spanned::unplaced(3),
        /// How many control points, from degree + 1 to the number of points.
        control_points: Option<Spanned<usize>>,
        /// How far the curve may pass from a point.
        tolerance: Option<Spanned<Length>>,
        /// Where on the curve the points lie: by a rule, or listed.
        parameters: Spanned<Parameters> = chord(),
    }
    example "approximate([for t in 0..8: (t, t^2)], degree = 2, control_points = 3).end" => "(8, 64, 0)";
    example "len(approximate([for i in 0..60: polar(1, i * 3deg)], tolerance = 1e-3).points) < 9" => "true";
    refuses "approximate([for t in 0..8: (t, t^2)])" => "E0401: `approximate` needs to know how near the curve shall come";
    refuses "approximate([for t in 0..8: (t, t^2)], control_points = 12)" => "E0601: 12 control points for 9 points: degree 3 takes from 4 to 9";
    refuses "approximate([for t in 0..8: (t, t^2)], control_points = 4, tolerance = 0.1)" => "E0401: `control_points` and `tolerance` exclude one another";
    scene r#"
        points p = [for i in 0..20: (i/2, 3*sin(i/3) + sin(2*i)/2)]
        curve c = approximate(p, control_points = 8) with (color = "red")
        curve polygon = control_polygon(c) with (color = "gray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    let span = args.points.span;
    super::check_degree(args.degree, Spanned::new(points.len(), span))?;
    let degree = args.degree.value;
    let are_fixed = matches!(args.parameters.value, Parameters::Listed(_));
    let parameters = loose_parameters(args.parameters, Spanned::new(&points[..], span))?;
    match (args.control_points, args.tolerance) {
        (Some(count), None) => {
            check_count(count, degree, points.len())?;
            kernel::approximate(&points, &parameters, degree, count.value).at(count.span)
        }
        (None, Some(tolerance)) => {
            let hint = "`interpolate` passes through all of the points";
            let within = positive("the tolerance", tolerance)
                .map_err(|mistake| Box::new(mistake.hint(hint)))?;
            let curve = kernel::approximate_within(&points, &parameters, degree, within, are_fixed)
                .at(tolerance.span)?;
            if let Some(message) = followed(curve.control_points().len(), degree, points.len()) {
                let hint = "a larger tolerance smooths points that scatter, and more points tell more of what bends; through all goes `interpolate`";
                ctx.warn(Diagnostic::warning(Code::Unclean, tolerance.span, message).hint(hint));
            }
            Ok(curve)
        }
        (Some(_), Some(tolerance)) => complain(
            tolerance.span,
            "`control_points` and `tolerance` exclude one another",
            "leave one of them out: the count decides how near the curve comes",
        ),
        (None, None) => complain(
            ctx.span,
            "`approximate` needs to know how near the curve shall come",
            "write `tolerance = ...`, or `control_points = ...`",
        ),
    }
}

/// What is to be said of a curve that has a control point for nearly every point.
fn followed(n_control: usize, degree: usize, n_points: usize) -> Option<String> {
    let is_all = ENOUGH * (degree + 1) <= n_points && 9 * n_points <= 10 * n_control;
    is_all.then(|| {
        format!(
            "{n_control} control points for {n_points} points: no curve of fewer was found within the tolerance"
        )
    })
}

fn complain<T>(span: Span, message: &str, hint: &str) -> Result<T> {
    Diagnostic::error(Code::BadCall, span, message).hint(hint).fail()
}

fn check_count(count: Spanned<usize>, degree: usize, n_points: usize) -> Result<()> {
    if (degree + 1..=n_points).contains(&count.value) {
        return Ok(());
    }
    let message = format!(
        "{} control points for {n_points} points: degree {degree} takes from {} to {n_points}",
        count.value,
        degree + 1
    );
    let diagnostic = Diagnostic::error(Code::TooFewPoints, count.span, message);
    if n_points < count.value {
        diagnostic.hint("`interpolate` passes through all of the points").fail()
    } else {
        diagnostic.fail()
    }
}
