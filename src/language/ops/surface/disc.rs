//! `disc`: the round part of a plane.

use std::sync::Arc;

use crate::{
    diag::{Result, Spanned},
    kernel::{Frame, NurbsSurface},
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Flat round part of a plane about its origin, as an exact rational surface on 0..1 in both
    /// directions.
    ///
    /// u goes around counter-clockwise from the plane's x, v from the rim to the centre, so that
    /// Su × Sv is the plane's normal.
    disc in Surface -> NurbsSurface {
        /// The plane; its origin is the centre.
        plane: Arc<Frame>,
        /// The radius, positive.
        radius: Spanned<Length>,
    }
    example "disc(XY, 2)(0.25, 0)" => "(0, 2, 0)";
    example "disc(plane((0, 0, 3), (0, 0, 1)), 2)(0.4, 1)" => "(0, 0, 3)";
    example "normal(disc(YZ, 2), 0.3, 0.5) ~= (1, 0, 0)" => "true";
    refuses "disc(XY, 0)" => "E0607: the radius must be positive, found 0";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let radius = radius("the radius", args.radius)?;
    NurbsSurface::cone(*args.plane, [radius, 0.0], 0.0).at(args.radius.span)
}
