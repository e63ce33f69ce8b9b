//! `bilinear`: the surface of four corners.

use glam::DVec3;

use super::with_area;
use crate::{
    diag::Result,
    kernel::NurbsSurface,
    value::{At, Ctx, op},
};

op! {
    /// Surface of four corners, ruled by straight lines in both directions.
    ///
    /// The first index of a corner runs along u. Its corners in one plane make a plane piece, else
    /// it is a hyperbolic paraboloid. Piegl & Tiller, *The NURBS Book*, §8.3.
    bilinear | hyperbolic_paraboloid in Surface -> NurbsSurface {
        /// The corner at u = 0, v = 0.
        p00: DVec3,
        /// The corner at u = 0, v = 1.
        p01: DVec3,
        /// The corner at u = 1, v = 0.
        p10: DVec3,
        /// The corner at u = 1, v = 1.
        p11: DVec3,
    }
    example "bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1))(0.5, 0.5)" => "(0.5, 0.5, 0.25)";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let surface = NurbsSurface::bilinear(args.p00, args.p01, args.p10, args.p11).at(ctx.span)?;
    Ok(with_area(ctx, surface))
}
