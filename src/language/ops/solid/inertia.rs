//! `inertia` of a solid, or of its skin.

use super::{GivenSolid, mass};
use crate::{
    diag::Result,
    ops::measure::{MassOf, inertia_told},
    value::{Ctx, Record, op},
};

op! {
    /// Inertia of a solid about its centroid, or of its faces: `{tensor, moments, axes}` as for surfaces.
    inertia in Solid -> Record {
        /// The solid.
        s: GivenSolid,
        /// What is heavy: the inside or the skin.
        of: MassOf = MassOf::Volume,
    }
    example "inertia(solid(box((0, 0, 0), (1, 2, 3)))).moments ~= [2.5, 5, 6.5]" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    Ok(inertia_told(mass(&args.s, args.of, "inertia", ctx)?.inertia, args.of))
}
