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
    refuses "control_net(parametric((u, v) => (u, v, u*v), 0..1, 0..1))" => "E0301: `control_net`: `s` must be a NURBS surface, found a parametric surface";
    derivative affine;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 2), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        curves net = control_net(s) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<NurbsCurve>> {
    args.s.control_net().at(ctx.span)
}
