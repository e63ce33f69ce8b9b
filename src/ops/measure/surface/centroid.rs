//! `centroid` of surfaces, or of what they enclose.

use glam::DVec3;

use super::{MassOf, SurfacesTogether, mass};
use crate::{
    diag::{Result, Spanned},
    value::{Ctx, op},
};

op! {
    /// Centre of gravity of what closed surfaces enclose, or of the surfaces themselves.
    ///
    /// Of the volume the surfaces must close, as for `volume`; of the area they need not.
    /// Mirtich, *Fast and accurate computation of polyhedral mass properties*, JGT 1 (1996).
    centroid in Measure -> DVec3 {
        /// The surface, or a list of surfaces.
        s: Spanned<SurfacesTogether>,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "centroid(box((0, 0, 0), (1, 2, 3)))" => "(0.5, 1, 1.5)";
    example "centroid(bilinear((0, 0), (0, 2), (3, 0), (3, 2)), of = \"area\") ~= (1.5, 1)" => "true";
    refuses "centroid(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0612: the surfaces do not close: edge \"u0\" is 0.4896 from the nearest other edge, at (0, 0.5104, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<DVec3> {
    Ok(mass(&args.s, args.of, "centroid", ctx)?.centroid)
}
