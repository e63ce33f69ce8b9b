//! `faces` of a solid.

use super::GivenSolid;
use crate::{
    diag::Result,
    kernel::Face,
    value::{Ctx, op},
};

op! {
    /// The faces of a solid, which look outward: `s.faces`.
    faces in Solid -> Vec<Face> {
        /// The solid.
        s: GivenSolid,
    }
    example "len(faces(solid(box((0, 0, 0), (1, 2, 3)))))" => "6";
    example "sum([for f in faces(solid(cylinder((0, 0), 1, 3), cap = true)): area(f)]) ~= 8*pi" => "true";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Vec<Face>> {
    Ok(args.s.faces().to_vec())
}
