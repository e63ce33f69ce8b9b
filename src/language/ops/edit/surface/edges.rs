//! `edges`: the four sides of a surface.

use crate::{
    diag::Result,
    kernel::{Curve, Surface},
    value::{At, Ctx, op},
};

op! {
    /// The four sides of a surface as curves, `[u0, u1, v0, v1]`, each with the surface's
    /// parameter along it.
    edges in Edit -> Vec<Curve> {
        /// The surface.
        s: Surface,
    }
    example "[for e in edges(bilinear((0, 0), (0, 1), (2, 0), (2, 1))): e.end]" => "[(0, 1, 0), (2, 1, 0), (2, 0, 0), (2, 1, 0)]";
    derivative shape;
    scene r#"
        curves sides = edges(s) with (color = "red")
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Curve>> {
    args.s.edges().map(Vec::from).at(ctx.span)
}
