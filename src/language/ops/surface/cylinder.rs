//! `cylinder`: the exact circular cylinder.

use glam::DVec3;

use super::{around, upward};
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsSurface,
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Exact wall of a circular cylinder as a rational surface on 0..1 in both directions, without
    /// its ends.
    ///
    /// u goes around the axis counter-clockwise, from the place of (1, 0, 0) made normal to the axis,
    /// or of (0, 1, 0) where those are parallel; v goes up from the base. Su × Sv points outward.
    /// Piegl & Tiller, *The NURBS Book*, §8.3.
    cylinder in Surface -> NurbsSurface {
        /// The centre of its lower circle.
        base: DVec3,
        /// Its radius, positive.
        radius: Spanned<Length>,
        /// Its height along the axis, positive.
        height: Spanned<Length>,
        /// The direction of its axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
    }
    example "cylinder((0, 0), 2, 5)(0.25, 0.5)" => "(0, 2, 2.5)";
    example "cylinder((0, 0), 2, 5, axis = (1, 0, 0))(0, 1)" => "(5, 2, 0)";
    refuses "cylinder((0, 0), 2, 0)" => "E0607: the height must be positive, found 0";
    refuses "cylinder((0, 0), 2, 5, axis = (0, 0, 0))" => "E0607: the axis has length zero, and no direction";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let radius = radius("the radius", args.radius)?;
    let height = upward(args.height)?;
    let frame = around(args.base, args.axis)?;
    NurbsSurface::cone(frame, [radius; 2], height).at(ctx.span)
}
