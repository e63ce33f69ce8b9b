//! `volume` of a solid.

use super::{GivenSolid, mass};
use crate::{
    diag::Result,
    ops::measure::MassOf,
    value::{Ctx, LengthPower, Volume, op},
};

op! {
    /// Volume of a solid: the flux of the position through its faces by the theorem of Gauss, to some 12 digits where
    /// they are smooth.
    ///
    /// Edges that are cuts lie on both of their faces within the document's tolerance, and the volume is as near as that allows.
    volume in Solid -> Volume {
        /// The solid.
        s: GivenSolid,
    }
    example "volume(solid(box((0, 0, 0), (1, 2, 3))))" => "6";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Volume> {
    Ok(LengthPower(mass(&args.s, MassOf::Volume, "volume", ctx)?.amount))
}
