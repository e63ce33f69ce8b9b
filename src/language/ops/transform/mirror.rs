//! `mirror`: geometry reflected in a plane.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::apply;
use crate::{
    diag::Result,
    kernel::Frame,
    value::{Ctx, Geometry, op},
};

op! {
    /// Geometry reflected in a plane.
    mirror in Transform -> Geometry {
        /// What is reflected.
        g: Geometry,
        /// The plane that stays.
        plane: Arc<Frame>,
    }
    example "mirror((1, 2, 3), XY)" => "(1, 2, -3)";
    example "mirror((3, 0), plane((1, 0), (1, 0))) ~= (-1, 0)" => "true";
    derivative shape;
    scene r#"
        curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
        curve image = mirror(c, plane((0, -1), (0, 1))) with (color = "red")
        curve plane_from_its_edge = line((-1, -1), (5, -1)) with (color = "gray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Geometry> {
    let flip = DAffine3::from_scale(DVec3::new(1.0, 1.0, -1.0));
    apply(&args.g, &(args.plane.to_space() * flip * args.plane.from_space()), ctx.span)
}
