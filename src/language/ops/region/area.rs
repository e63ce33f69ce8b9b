//! `area` of a region.

use crate::{
    diag::Result,
    kernel::VariedRegion,
    value::{Area, At, Ctx, LengthPower, Real, RealRegion, op, with_slopes},
};

op! {
    /// Area of a region: Green's theorem along its borders, to rounding.
    area in Region -> Area<Real> {
        /// The region.
        r: RealRegion,
    }
    example "area(region(polyline([(0, 0), (3, 0), (0, 4)], closed = true)))" => "6";
    example "gradient(r => area(region(circle((0, 0), r))), 2) ~= 4*pi" => "true";
    example "area(region(ellipse((0, 0), 3, 2))) ~= 6*pi within 1e-12" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Area<Real>> {
    let slopes = args.r.varied().map(VariedRegion::area_slopes);
    with_slopes(args.r.plain().area(), slopes).map(LengthPower).at(ctx.span)
}
