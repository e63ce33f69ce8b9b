//! `frame_of`: a frame by two directions.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::Frame,
    value::{At, Ctx, op},
};

op! {
    /// Frame at a point, with x along one direction and y in the half plane of another.
    ///
    /// Its axes are unit vectors at right angles; z makes them right-handed.
    frame_of in Transform -> Frame {
        /// Where it stands.
        origin: DVec3,
        /// The direction of x.
        x: DVec3,
        /// The direction whose part normal to x is y.
        y: Spanned<DVec3>,
    }
    example "frame_of((1, 2, 3), (0, 0, 2), (0, 5, 5)).y" => "(0, 1, 0)";
    example "frame_of((0, 0), (1, 0), (0, 1)).z" => "(0, 0, 1)";
    refuses "frame_of((0, 0), (1, 0), (2, 0))" => "E0607: the y axis is parallel to the x axis";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Frame> {
    Frame::from_axes(args.origin, args.x, args.y.value).at(ctx.span)
}
