//! `lagrange`: the one polynomial through points.

use glam::DVec3;

use super::fit::{Parameters, distinct_parameters, swing};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{self, NurbsCurve, Parametrization},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// The one polynomial through all points, of one degree less than there are points.
    ///
    /// On 0..1, or from the first to the last of the parameters that are listed. With many points
    /// it swings out between them (Runge's phenomenon), which gives a warning; `interpolate`
    /// does not. Farin, *Curves and Surfaces for CAGD*, §6.2.
    lagrange in Curve -> NurbsCurve {
        /// The points, two or more.
        points: Spanned<AtLeast<2, DVec3>>,
        /// Where on the curve they lie: evenly spaced, by another rule, or listed.
        parameters: Spanned<Parameters> = Spanned::unplaced(Parameters::By(Parametrization::Uniform)),
    }
    example "lagrange((0, 0), (1, 1), (2, 4))(0.75)" => "(1.5, 2.25, 0)";
    example "lagrange((0, 0), (1, 1), (4, 16), parameters = [0, 1, 4])(3) ~= (3, 9)" => "true";
    refuses "lagrange([(0, 0)])" => "E0601: `lagrange`: `points` must be a list of 2 or more points, found a list of 1 point";
    derivative affine;
    scene r#"
        points p = [(0, 0), (1, 2), (2, 1), (4, 2), (5, 0)] with (color = "red")
        curve c = lagrange(p)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    let span = args.points.span;
    let parameters = distinct_parameters(args.parameters, Spanned::new(&points[..], span))?;
    let curve = kernel::lagrange(&points, &parameters).at(span)?;
    if let Some(message) = swing(&curve, &points, &parameters) {
        let hint = "polynomials of high degree do so; `interpolate` takes splines of low degree";
        ctx.warn(Diagnostic::warning(Code::Unclean, span, message).hint(hint));
    }
    Ok(curve)
}
