//! `hermite`: cubics through points with given derivatives.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::NurbsCurve,
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// Cubic through points with given derivatives (Ferguson's curve), one unit of parameter a
    /// segment.
    ///
    /// Each segment has the Bézier points A, A + a/3, B - b/3, B. Segments meet with one
    /// derivative (C1); a tangent of length zero makes the curve stand still at its point, where
    /// it may have a corner. Linkeová, *Curves and Surfaces for Computer Graphics*, (2.1), (2.13).
    hermite | ferguson in Curve -> NurbsCurve {
        /// The points, two or more.
        points: Spanned<AtLeast<2, DVec3>>,
        /// The derivative at each point.
        tangents: Spanned<Vec<DVec3>>,
    }
    example "hermite([(1, 0), (4, 2)], [(-1, 3), (2, -2)])(0.5)" => "(2.125, 1.625, 0)";
    example "derivative(hermite([(1, 0), (4, 2), (5, 5)], [(-1, 3), (2, -2), (0, 1)]), 1) ~= (2, -2)" => "true";
    refuses "hermite([(1, 0), (4, 2)], [(1, 1)])" => "E0401: 2 points need 2 tangents, got 1";
    refuses "hermite([(1, 0)], [(1, 1)])" => "E0601: `hermite`: `points` must be a list of 2 or more points, found a list of 1 point";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    ctx.made_by(&|| Some(NurbsCurve::factors_of_hermite(args.points.value.0.len())));
    NurbsCurve::hermite(&args.points.value.0, &args.tangents.value).at(args.tangents.span)
}
