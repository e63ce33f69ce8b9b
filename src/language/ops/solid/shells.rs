//! `shells` of a solid.

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::Face,
    value::{Ctx, op},
};

op! {
    /// The faces of each shell of a solid, outer ones and voids: `s.shells`.
    ///
    /// A shell is what hangs together over edges. `bodies` has each outer one with its voids.
    shells in Solid -> Vec<Vec<Face>> {
        /// The solid.
        s: GivenSolid,
    }
    example "[for shell in shells(solid([sphere((0, 0), 2), sphere((0, 0), 1)])): len(shell)]" => "[1, 1]";
    example "len(shells(solid(box((0, 0, 0), (1, 2, 3)))))" => "1";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Vec<Face>>> {
    Ok(args.s.shells().map(|shell| shell.into_iter().cloned().collect()).collect())
}
