//! `tangent_plane` of a surface.

use super::inside;
use crate::{
    diag::{Result, Spanned},
    kernel::Frame,
    ops::face::SurfaceOrFace,
    value::{At, Ctx, op},
};

op! {
    /// Plane that touches a surface at a place.
    ///
    /// Its x axis runs along Su and its z axis, the normal of the plane, along Su × Sv. At a pole or a
    /// collapsed edge it is the limit, where that exists.
    tangent_plane in Measure -> Frame {
        /// The surface, or a part of one.
        s: SurfaceOrFace,
        /// The first parameter, inside its domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "tangent_plane(cylinder((0, 0), 2, 1), 0, 0.5).origin" => "(2, 0, 0.5)";
    example "tangent_plane(cylinder((0, 0), 2, 1), 0, 0.5).z" => "(1, 0, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Frame> {
    let (u, v) = inside(&args.s, args.u, args.v)?;
    args.s.tangent_plane_at(u, v).at(ctx.span)
}
