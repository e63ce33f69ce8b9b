//! `project`: a curve onto a plane.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::apply;
use crate::{
    diag::Result,
    kernel::{Curve, Frame},
    value::{Ctx, Geometry, Value, op},
};

op! {
    /// Curve projected onto a plane along the plane's normal; exact.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §6.3.
    project in Transform -> Geometry {
        /// The curve.
        c: Curve,
        /// The plane.
        plane: Arc<Frame>,
    }
    example "project(line((0, 0, 1), (1, 2, 3)), XY).end" => "(1, 2, 0)";
    example "project(line((0, 0), (4, 0)), plane((0, 0), (1, 0, 1))).end ~= (2, 0, -2)" => "true";
    scene r#"
        curve c = helix((0, 0, 1), 2, 3, 1.5)
        curve shadow = project(c, XY) with (color = "gray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    let flatten = DAffine3::from_scale(DVec3::new(1.0, 1.0, 0.0));
    let map = args.plane.to_space() * flatten * args.plane.from_space();
    apply(&Geometry(Value::Curve(args.c)), &map, ctx.span)
}
