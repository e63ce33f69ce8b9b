//! `revolve`: a region turned about an axis.

use std::{f64::consts::TAU, sync::Arc};

use glam::DVec3;

use super::{n_variables, varied_region};
use crate::{
    diag::{Result, Spanned},
    kernel::{Axis, RegionWay, Solid, VariedSolid},
    ops::surface::check_axis,
    value::{Angle, At, Ctx, Real, RealRegion, RealSolid, op},
};

op! {
    /// Solid that a region passes when it is turned about an axis in its plane.
    ///
    /// Exact: its sides are the surfaces of the region's curves, each as `revolve` of the curve gives it; short of a full turn the
    /// region where it was and where it comes to are faces before them. The region may run along the axis and may not reach over it. Holes
    /// become voids in a full turn.
    revolve in Solid -> RealSolid {
        /// The region.
        r: RealRegion,
        /// The direction of the axis.
        axis: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
        /// A point of the axis.
        about: DVec3 = DVec3::ZERO,
        /// How far it turns: up to a full turn, either way.
        angle: Spanned<Angle<Real>> = Spanned::unplaced(Angle(Real::Plain(TAU))),
    }
    example "revolve(region(polyline([(0, 0), (2, 0), (0, 0, 3)], closed = true)))" => "solid of 2 faces";
    example "volume(revolve(region(polyline([(0, 0), (2, 0), (0, 0, 3)], closed = true)), angle = 90deg)) ~= pi" => "true";
    example "volume(revolve(region(circle((3, 0), 1)), axis = (0, 1, 0))) ~= 6*pi^2" => "true";
    example "gradient(x => volume(revolve(region(circle((x, 0), 1)), axis = (0, 1, 0))), 3) ~= 2*pi^2" => "true";
    refuses "revolve(region(circle((0.5, 0), 1)), axis = (0, 1, 0))" => "E0607: the region reaches over the axis at (-0.5, 0, 0), so that the solid would go through itself";
    refuses "revolve(region(circle((1, 0), 1)), axis = (0, 1, 0))" => "E0613: the solid would touch itself at (0, 0, 0): the region comes to the axis in this point alone";
    refuses "revolve(region(circle((3, 0), 1)))" => "E0607: the axis does not lie in the plane of the region: it is up to 1.414 away from it";
    picture "revolve(region(polyline([(1, 0, 0), (3, 0, 0), (3, 0, 1), (2, 0, 1), (1, 0, 3)], closed = true)), angle = 270deg)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RealSolid> {
    check_axis(args.axis)?;
    let axis = Axis::new(args.about, args.axis.value).at(args.axis.span_or(ctx.span))?;
    let Angle(angle) = args.angle.value;
    let solid = Solid::revolved(args.r.plain(), axis, angle.value(), ctx.tolerance).at(ctx.span)?;
    let Some(n_variables) = n_variables(&args.r, std::slice::from_ref(&angle), ctx.span)? else {
        return Ok(RealSolid::Plain(Arc::new(solid)));
    };
    let slopes = match &angle {
        Real::Plain(_) => vec![0.0; n_variables],
        Real::Jet(jet) => jet.slopes().to_vec(),
    };
    let region = varied_region(&args.r, n_variables).at(ctx.span)?;
    let way = RegionWay::About(axis, angle.value(), slopes);
    Ok(RealSolid::Varied(Arc::new(VariedSolid::new(solid.into(), region, way))))
}
