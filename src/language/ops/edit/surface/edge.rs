//! `edge`: one side of a surface.

use super::Edge;
use crate::{
    diag::Result,
    kernel::{Curve, Direction, Side, Surface},
    value::{At, Ctx, op},
};

op! {
    /// Side of a surface as a curve: exact, with the surface's parameter along it.
    ///
    /// "u0" and "u1" are where u starts and ends, so that v runs along them; "v0" and "v1"
    /// likewise.
    edge in Edit -> Curve {
        /// The surface.
        s: Surface,
        /// Which side.
        side: Edge,
    }
    example "edge(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), \"u1\").points" => "[(2, 0, 0), (2, 1, 0)]";
    example "edge(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), \"v0\").points" => "[(0, 0, 0), (2, 0, 0)]";
    refuses "edge(plane_patch((0, 0), (1, 0), (0, 1)), \"top\")" => "E0402: `edge`: `side` must be one of \"u0\", \"u1\", \"v0\" or \"v1\", found the string \"top\"";
    derivative shape;
    scene r#"
        curve side = edge(s, "u1") with (color = "red")
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Curve> {
    let (across, end) = args.side.place();
    let domain = args.s.domain(across);
    let at = match end {
        Side::Left => domain.start(),
        Side::Right => domain.end(),
    };
    let along: Direction = across.other();
    args.s.isocurve(along, at).at(ctx.span)
}
