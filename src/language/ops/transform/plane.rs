//! `plane`: a plane by its normal.

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::Frame,
    value::{At, Ctx, op},
};

op! {
    /// Plane through a point, with the normal as its z.
    ///
    /// Its x is (1, 0, 0) made normal to the normal unless given, or (0, 1, 0) where those are
    /// parallel; its y makes them right-handed.
    plane in Transform -> Frame {
        /// A point of it, the origin of its coordinates.
        origin: DVec3,
        /// The direction that stands on it.
        normal: Spanned<DVec3>,
        /// The direction of its x; the part that is normal to the normal counts.
        x: Option<Spanned<DVec3>>,
    }
    example "plane((0, 0, 5), (0, 0, 2)).z" => "(0, 0, 1)";
    example "plane((0, 0), (1, 0, 0)).x" => "(0, 1, 0)";
    example "plane((0, 0), (0, 0, 1), x = (0, 3)).y" => "(-1, 0, 0)";
    refuses "plane((0, 0), (0, 0, 0))" => "E0607: the normal has no direction";
    refuses "plane((0, 0), (0, 0, 1), x = (0, 0, 2))" => "E0607: the x axis is parallel to the normal";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Frame> {
    let blamed = args.x.map_or(args.normal.span, |x| x.span);
    let no_x = Frame::from_normal(args.origin, args.normal.value, None).at(args.normal.span)?;
    match args.x {
        None => Ok(no_x),
        Some(x) => Frame::from_normal(args.origin, no_x.z(), Some(x.value)).at(blamed),
    }
}
