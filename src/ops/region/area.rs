//! `area` of a region.

use super::Given;
use crate::{
    diag::Result,
    value::{Area, Ctx, LengthPower, op},
};

op! {
    /// Area of a region: Green's theorem along its borders, to rounding.
    area in Region -> Area {
        /// The region.
        r: Given,
    }
    example "area(region(polyline([(0, 0), (3, 0), (0, 4)], closed = true)))" => "6";
    example "area(region(ellipse((0, 0), 3, 2))) ~= 6*pi within 1e-12" => "true";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Area> {
    Ok(LengthPower(args.r.area()))
}
