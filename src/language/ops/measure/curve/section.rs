//! `section` of a curve by a plane.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::Result,
    kernel::{Curve, Frame},
    value::{At, Ctx, op},
};

op! {
    /// Points where a curve passes through a plane or touches it, in the order of the parameter.
    ///
    /// Found completely; a piece that lies in the plane is told by its ends.
    /// A parametric curve is searched as the spline that `length` tells of; each place is then found
    /// on the function itself.
    section in Measure -> Vec<DVec3> {
        /// The curve.
        g: Curve,
        /// The plane.
        plane: Arc<Frame>,
    }
    example "section(bezier((0, 0), (1, 2), (2, 0)), ZX)" => "[(0, 0, 0), (2, 0, 0)]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<DVec3>> {
    args.g.plane_points(*args.plane, ctx.tolerance).at(ctx.span)
}
