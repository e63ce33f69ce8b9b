//! `place`: geometry carried from the origin to a frame.

use std::sync::Arc;

use super::apply;
use crate::{
    diag::Result,
    kernel::Frame,
    value::{Ctx, Geometry, op},
};

op! {
    /// Geometry drawn about the origin, carried to a frame: its x, y and z along those of the
    /// frame.
    place in Transform -> Geometry {
        /// What is carried.
        g: Geometry,
        /// Where it goes.
        frame: Arc<Frame>,
    }
    example "place((1, 2, 3), YZ)" => "(3, 1, 2)";
    example "place((1, 0), frame_of((5, 5), (0, 1), (-1, 0)))" => "(5, 6, 0)";
    scene r#"
        curve c = bezier((0, 0, 0), (4, 0, 4), (4, 6, -2), (0, 6, 2)) with (color = "gray")
        curves squares = [for t in linspace(0, 1, 6): place(polyline((1, 1), (-1, 1), (-1, -1), (1, -1), closed = true), normal_plane(c, t))]
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    apply(&args.g, &args.frame.to_space(), ctx.span)
}
