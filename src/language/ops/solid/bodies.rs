//! `bodies` of a solid.

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::Solid,
    value::{At, Ctx, op},
};

op! {
    /// The bodies of a solid, each a solid: an outer shell, with the voids directly within it.
    ///
    /// What lies in a void is a body of its own.
    bodies in Solid -> Vec<Solid> {
        /// The solid.
        s: GivenSolid,
    }
    example "[for b in bodies(solid([sphere((0, 0), 3), sphere((0, 0), 2), sphere((0, 0), 1)])): len(b.shells)]" => "[2, 1]";
    example "sum([for b in bodies(solid([...box((0, 0, 0), (1, 1, 1)), ...box((2, 0, 0), (1, 1, 1))])): volume(b)]) ~= 2" => "true";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Solid>> {
    args.s.separate_bodies(ctx.tolerance).at(ctx.span)
}
