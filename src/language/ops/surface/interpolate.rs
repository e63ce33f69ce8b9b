//! `interpolate` of a grid: the spline surface through points.

use super::{
    PerDirection, cubic,
    fit::{GridData, SecondPass, chord},
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Ends, Interpolator, LineFit, NurbsSurface},
    ops::curve::fit::Parameters,
    value::{At, Ctx, Rows, op},
};

op! {
    /// Spline surface through a grid of points, on 0..1 by 0..1 or over the parameters that are
    /// listed.
    ///
    /// First the lines along u become splines, then the rows of their control points along v, all
    /// with the same parameters: means over the lines. Along v these are means over the rows of
    /// the points ("data"), or over the rows of the control points of the first pass ("control").
    /// Too few lines lower the degree; three are enough for a cubic that has ends.
    /// Piegl & Tiller, *The NURBS Book*, §9.2.5; Vukašinović & Duhovnik, *Advanced CAD Modeling*,
    /// §1.3.
    interpolate in Surface -> NurbsSurface {
        /// The points: `points[i][j]`, i along u, j along v.
        points: Spanned<Rows>,
        /// The degree, or `{u: , v: }`.
        degree: Spanned<PerDirection<usize>> = cubic(),
        /// Where the points lie, by a rule or listed; for both directions or `{u: , v: }`.
        parameters: Spanned<PerDirection<Parameters>> = chord(),
        /// What a cubic does where it begins and ends, or `{u: , v: }`.
        ends: Spanned<PerDirection<Ends>> = Spanned::unplaced(PerDirection { u: Ends::Bessel, v: Ends::Bessel }),
        /// Whose distances give the parameters along v.
        second_pass: SecondPass = SecondPass::Data,
    }
    example "interpolate([for i in 0..3: [for j in 0..3: (i, j, i * j)]])(0.5, 0.5) ~= (1.5, 1.5, 2.25)" => "true";
    example "interpolate([for i in 0..4: [for j in 0..1: (i, j)]]).degree_v" => "1";
    refuses "interpolate([[(0, 0), (0, 1)], [(1, 0)]])" => "E0605: `interpolate`: `points`: row 1 has 1 point, row 0 has 2; every row needs the same number";
    refuses "interpolate([[(0, 0), (0, 1)], [(0, 0), (0, 1)]])" => "E0607: along u: points 0 and 1 are at one place";
    derivative affine;
    settling super::moving::GRID;
    scene r#"
        let p = [for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]] with (hidden = true)
        surface s = interpolate(p) with (color = "lightgray")
        points given = flatten(p) with (color = "red")
    "#;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let Rows(grid) = args.points.value;
    let span = args.points.span;
    check(args.degree.value.u, args.ends.value.u, &args.degree, &args.ends)?;
    check(args.degree.value.v, args.ends.value.v, &args.degree, &args.ends)?;
    let through = |degree: usize, ends: Ends| {
        move |parameters: Vec<f64>| {
            Interpolator::new(&parameters, degree, ends).at(span).map(LineFit::Through)
        }
    };
    let data = GridData {
        points: Spanned::new(grid, span),
        parameters: args.parameters,
        second_pass: args.second_pass,
        operation: "interpolate",
    };
    data.surface([
        &through(args.degree.value.u, args.ends.value.u),
        &through(args.degree.value.v, args.ends.value.v),
    ])
}

/// Fails unless the degree can have the ends.
fn check(
    degree: usize,
    ends: Ends,
    degrees: &Spanned<PerDirection<usize>>,
    given: &Spanned<PerDirection<Ends>>,
) -> Result<()> {
    if degree == 0 {
        let message = "the degree must be 1 or more, found 0";
        return Diagnostic::error(Code::BadDegree, degrees.span, message).fail();
    }
    if ends == Ends::Clamped {
        let message = "\"clamped\" ends need tangents, which a grid does not have";
        return Diagnostic::error(Code::BadCall, given.span, message).fail();
    }
    let is_asked = given.span != crate::diag::Span::default();
    if is_asked && degree != 3 && ends != Ends::Averaged {
        let message = format!("this condition is one for cubics, found degree {degree}");
        return Diagnostic::error(Code::BadCall, given.span, message)
            .hint("other degrees have \"averaged\" knots and need no condition")
            .fail();
    }
    Ok(())
}
