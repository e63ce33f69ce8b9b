//! `cubic_spline`: the C2 chain of Hermite cubics.

use glam::DVec3;

use super::fit::two_tangents;
use crate::{
    diag::{Result, Spanned},
    kernel::{Ends, Interpolator, NurbsCurve},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Chain of Hermite cubics through points, one unit of parameter each, whose inner derivatives
    /// are those that make it C2.
    ///
    /// The derivatives follow from P′ᵢ₋₁ + 4 P′ᵢ + P′ᵢ₊₁ = 3 (Pᵢ₊₁ − Pᵢ₋₁), solved for all
    /// points together. Hsu, *Curve representation*, (23) and (24).
    cubic_spline in Curve -> NurbsCurve {
        /// The points, two or more.
        points: Spanned<AtLeast<2, DVec3>>,
        /// The derivatives at the start and at the end.
        tangents: Spanned<Vec<DVec3>>,
    }
    example "derivative(cubic_spline([(0, 0), (2, 3), (5, 1)], [(1, 2), (3, 0)]), 1) ~= (11/4, 1/4)" => "true";
    example "cubic_spline([(0, 0), (1, 0)], [(0, 3), (0, -3)])(0.5)" => "(0.5, 0.75, 0)";
    refuses "cubic_spline([(0, 0), (2, 3)], [(1, 2)])" => "E0401: `tangents` are two, at the start and at the end, found 1";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let AtLeast(points) = args.points.value;
    let tangents = two_tangents(&args.tangents)?;
    let parameters: Vec<f64> = (0..points.len()).map(|i| i as f64).collect();
    let interpolator = Interpolator::new(&parameters, 3, Ends::Clamped).at(args.points.span)?;
    ctx.made_by(&|| interpolator.factors_with_tangents());
    interpolator.curve_with_tangents(&points, tangents).at(args.points.span)
}
