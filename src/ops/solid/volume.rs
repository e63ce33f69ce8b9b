//! `volume` of a solid.

use super::mass;
use crate::{
    diag::Result,
    kernel::VariedSolid,
    ops::measure::MassOf,
    value::{At, Ctx, LengthPower, Real, RealSolid, Volume, op, with_slopes},
};

op! {
    /// Volume of a solid: the flux of the position through its faces by the theorem of Gauss, to some 12 digits where
    /// they are smooth.
    ///
    /// Edges that are cuts lie on both of their faces within the document's tolerance, and the volume is as near as that allows.
    volume in Solid -> Volume<Real> {
        /// The solid.
        s: RealSolid,
    }
    example "volume(solid(box((0, 0, 0), (1, 2, 3))))" => "6";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Volume<Real>> {
    let volume = mass(args.s.plain(), MassOf::Volume, "volume", ctx)?.amount;
    let slopes = args.s.varied().map(VariedSolid::volume_slopes);
    with_slopes(volume, slopes).map(LengthPower).at(ctx.span)
}
