//! `normal_curvature` of a surface.

use glam::DVec3;

use super::shape;
use crate::{
    diag::{Result, Spanned},
    kernel::Surface,
    value::{At, Ctx, op},
};

op! {
    /// Normal curvature of a surface in a direction: the curvature of its section by the plane of the
    /// normal and that direction.
    ///
    /// Of a direction in space that is not tangent to the surface its part in the tangent plane counts.
    /// A curvature is positive where its centre lies on the side of Su × Sv. do Carmo, *Differential Geometry of
    /// Curves and Surfaces*, §3-2.
    normal_curvature in Measure -> f64 {
        /// The surface.
        s: Surface,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
        /// A direction of the tangent plane, of any length.
        direction: Spanned<DVec3>,
    }
    example "normal_curvature(cylinder((0, 0), 2, 1), 0, 0.5, (0, 1, 0)) ~= -1/2 within 1e-12" => "true";
    example "normal_curvature(cylinder((0, 0), 2, 1), 0, 0.5, (0, 1, 1)) ~= -1/4 within 1e-12" => "true";
    refuses "normal_curvature(plane_patch((0, 0), (1, 0), (0, 1)), 0, 0, (0, 0, 1))" => "E0607: the direction runs along the normal of the surface, so that it has no part in the tangent plane";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<f64> {
    let shape = shape(&args.s, args.u, args.v, ctx)?;
    shape.normal_curvature(args.direction.value, ctx.tolerance).at(args.direction.span)
}
