//! `line`: the straight curve between two points.

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{At, Ctx, op},
};

op! {
    /// Straight curve from one point to another, of degree 1 on 0..1.
    line in Curve -> NurbsCurve {
        /// Where it starts.
        a: DVec3,
        /// Where it ends.
        b: DVec3,
    }
    example "line((0, 0), (2, 4))(0.5)" => "(1, 2, 0)";
    derivative affine;
    picture "line((0, 0), (3, 1))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    NurbsCurve::line(args.a, args.b).at(ctx.span)
}
