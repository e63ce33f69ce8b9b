//! `control_net`: the control points of a surface as polylines.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{NurbsCurve, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// Control net of a surface as polylines: those along u, then those along v.
    ///
    /// Points of weight zero are left out.
    control_net in Edit -> Vec<NurbsCurve> {
        /// The surface.
        s: Arc<NurbsSurface>,
    }
    example "[for leg in control_net(bilinear((0, 0), (0, 1), (2, 0), (2, 1))): leg.points]" => "[[(0, 0, 0), (2, 0, 0)], [(0, 1, 0), (2, 1, 0)], [(0, 0, 0), (0, 1, 0)], [(2, 0, 0), (2, 1, 0)]]";
    picture "control_net(bspline([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]]))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    args.s.control_net().at(ctx.span)
}
