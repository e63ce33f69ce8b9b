//! `revolve`: a region turned about an axis.

use std::{f64::consts::TAU, sync::Arc};

use glam::DVec3;

use crate::{
    diag::{Result, Spanned},
    kernel::{Axis, Region, Solid},
    ops::surface::check_axis,
    value::{Angle, At, Ctx, op},
};

op! {
    /// Solid that a region passes when it is turned about an axis in its plane.
    ///
    /// Exact: its sides are the surfaces of the region's curves, each as `revolve` of the curve gives it; short of a full turn the
    /// region where it was and where it comes to are faces before them. The region may run along the axis and may not reach over it. Holes
    /// become voids in a full turn.
    revolve in Solid -> Solid {
        /// The region.
        r: Arc<Region>,
        /// The direction of the axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// A point of the axis.
        about: DVec3 = DVec3::ZERO,
        /// How far it turns: up to a full turn, either way.
        angle: Spanned<Angle> = Spanned::unplaced(Angle(TAU)),
    }
    example "revolve(region(polyline([(0, 0), (2, 0), (0, 0, 3)], closed = true)))" => "solid of 2 faces";
    example "volume(revolve(region(polyline([(0, 0), (2, 0), (0, 0, 3)], closed = true)), angle = 90deg)) ~= pi" => "true";
    example "volume(revolve(region(circle((3, 0), 1)), axis = (0, 1, 0))) ~= 6*pi^2" => "true";
    refuses "revolve(region(circle((0.5, 0), 1)), axis = (0, 1, 0))" => "E0607: the region reaches over the axis at (-0.5, 0, 0), so that the solid would go through itself";
    refuses "revolve(region(circle((1, 0), 1)), axis = (0, 1, 0))" => "E0613: the solid would touch itself at (0, 0, 0): the region comes to the axis in this point alone";
    refuses "revolve(region(circle((3, 0), 1)))" => "E0607: the axis does not lie in the plane of the region: it is up to 1.414 away from it";
    picture "revolve(region(polyline([(1, 0, 0), (3, 0, 0), (3, 0, 1), (2, 0, 1), (1, 0, 3)], closed = true)), angle = 270deg)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Solid> {
    check_axis(args.axis)?;
    let axis = Axis::new(args.about, args.axis.value).at(args.axis.span_or(ctx.span))?;
    Solid::revolved(&args.r, axis, args.angle.value.0, ctx.tolerance).at(ctx.span)
}
