//! `disc` about a point.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{Frame, NurbsSurface},
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Flat round surface about a point, as an exact rational surface on 0..1 in both directions.
    ///
    /// u goes around counter-clockwise about the normal from where a `circle` of that normal starts, v from the
    /// rim to the centre, so that Su × Sv is the normal.
    disc in Surface -> NurbsSurface {
        /// Its centre.
        center: DVec3,
        /// Its radius, positive.
        radius: Spanned<Length>,
        /// The direction that it faces.
        normal: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
    }
    example "disc((0, 0, 3), 2)(0.25, 0)" => "(0, 2, 3)";
    example "normal(disc((1, 0), 2, normal = (1, 0, 0)), 0.3, 0.5) ~= (1, 0, 0)" => "true";
    example "edge(disc((1, 2, 3), 2, normal = (1, 1, 1)), \"v0\")(0.3) ~= circle((1, 2, 3), 2, normal = (1, 1, 1))(0.3)" => "true";
    refuses "disc((0, 0), 0)" => "E0607: the radius must be positive, found 0";
    refuses "disc((0, 0), 1, normal = (0, 0, 0))" => "E0607: the normal has no direction";
    derivative affine;
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let radius = radius("the radius", args.radius)?;
    let frame = Frame::from_normal(args.center, args.normal.value, None).at(args.normal.span)?;
    NurbsSurface::cone(frame, [radius, 0.0], 0.0).at(args.radius.span)
}
