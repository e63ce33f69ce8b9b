//! `orient`: surfaces that face alike.

use crate::{
    diag::{Result, Spanned},
    kernel::{Direction, Surface, facing_unlike},
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// The surfaces of a list, some of them flipped so that all that hang together face alike:
    /// outward where they enclose a volume, otherwise as the first of them.
    ///
    /// Surfaces hang together where their edges run within the document's tolerance; each part of the
    /// list that does is taken on its own. Surfaces that make a one-sided whole, and edges that three
    /// surfaces share, are refused. Exports of meshes turn what encloses a volume by themselves, and
    /// tell of it.
    orient in Edit -> Vec<Surface> {
        /// The surfaces.
        surfaces: Spanned<AtLeast<1, Surface>>,
    }
    example "volume(tessellate(orient([for face in box((0, 0, 0), (1, 2, 3)): flip(face)]))) ~= 6" => "true";
    example "normal(orient([plane_patch((0, 0), (1, 0), (0, 1)), flip(plane_patch((1, 0), (1, 0), (0, 1)))])[1], 0.5, 0.5)" => "(0, 0, 1)";
    refuses "orient([plane_patch((0, 0), (1, 0), (0, 1)), plane_patch((1, 0), (1, 0), (0, 1)), plane_patch((1, 0), (0, 0, 1), (0, 1))])" => "E0612: edge \"u1\" of surface [0] meets 2 other edges at (1, 0.01042, 0), \"u0\" of [1], \"u0\" of [2]; what encloses a volume has two surfaces at each edge";
    picture "orient([plane_patch((0, 0), (1, 0), (0, 1)), flip(plane_patch((1, 0), (1, 0), (0, 1)))])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Surface>> {
    let AtLeast(surfaces) = args.surfaces.value;
    let turns = facing_unlike(&surfaces, ctx.tolerance).at(args.surfaces.span)?;
    let turned = |(surface, turns): (Surface, bool)| {
        if turns { surface.reversed(Direction::V).at(args.surfaces.span) } else { Ok(surface) }
    };
    surfaces.into_iter().zip(turns).map(turned).collect()
}
