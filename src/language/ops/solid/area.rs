//! `area` of a solid.

use super::mass;
use crate::{
    diag::Result,
    kernel::VariedSolid,
    ops::measure::MassOf,
    value::{Area, At, Ctx, LengthPower, Real, RealSolid, op, with_slopes},
};

op! {
    /// Area of all faces of a solid, those of its voids among them.
    area in Solid -> Area<Real> {
        /// The solid.
        s: RealSolid,
    }
    example "area(solid(box((0, 0, 0), (1, 2, 3))))" => "22";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Area<Real>> {
    let area = mass(args.s.plain(), MassOf::Area, "area", ctx)?.amount;
    let slopes = args.s.varied().map(VariedSolid::area_slopes);
    with_slopes(area, slopes).map(LengthPower).at(ctx.span)
}
