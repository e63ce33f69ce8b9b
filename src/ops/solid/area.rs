//! `area` of a solid.

use super::{GivenSolid, mass};
use crate::{
    diag::Result,
    ops::measure::MassOf,
    value::{Area, Ctx, LengthPower, op},
};

op! {
    /// Area of all faces of a solid, those of its voids among them.
    area in Solid -> Area {
        /// The solid.
        s: GivenSolid,
    }
    example "area(solid(box((0, 0, 0), (1, 2, 3))))" => "22";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Area> {
    Ok(LengthPower(mass(&args.s, MassOf::Area, "area", ctx)?.amount))
}
