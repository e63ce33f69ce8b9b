//! `orient`: surfaces that face alike.

use crate::{
    diag::{Result, Spanned},
    kernel::{SurfacePiece, pieces_facing_unlike},
    ops::face::SurfaceOrFace,
    value::{At, AtLeast, Ctx, op},
};

op! {
    /// The surfaces and faces of a list, some of them flipped so that all that hang together face alike:
    /// outward where they enclose a volume, otherwise as the first of them.
    ///
    /// They hang together where their edges run within the document's tolerance; each part of the
    /// list that does is taken on its own. Surfaces that make a one-sided whole, and edges that three
    /// surfaces share, are refused. Exports of meshes turn what encloses a volume by themselves, and
    /// tell of it.
    orient in Edit -> Vec<SurfaceOrFace> {
        /// The surfaces and faces.
        surfaces: Spanned<AtLeast<1, SurfaceOrFace>>,
    }
    example "volume(tessellate(orient([for face in box((0, 0, 0), (1, 2, 3)): flip(face)]))) ~= 6" => "true";
    example "normal(orient([plane_patch((0, 0), (1, 0), (0, 1)), flip(plane_patch((1, 0), (1, 0), (0, 1)))])[1], 0.5, 0.5)" => "(0, 0, 1)";
    example "volume(tessellate(orient([trim(sphere((0, 0), 1), by = XY, keep = \"above\"), face(region(circle((0, 0), 1)))]), tolerance = 0.01)) ~= 2/3*pi within 0.02" => "true";
    refuses "orient([plane_patch((0, 0), (1, 0), (0, 1)), plane_patch((1, 0), (1, 0), (0, 1)), plane_patch((1, 0), (0, 0, 1), (0, 1))])" => "E0612: edge \"u1\" of surface [0] meets 2 other edges at (1, 0.01042, 0), \"u0\" of [1], \"u0\" of [2]; what encloses a volume has two surfaces at each edge";
    picture "orient([plane_patch((0, 0), (1, 0), (0, 1)), flip(plane_patch((1, 0), (1, 0), (0, 1)))])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<SurfaceOrFace>> {
    let AtLeast(surfaces) = args.surfaces.value;
    let pieces: Vec<SurfacePiece<'_>> = surfaces.iter().map(SurfaceOrFace::piece).collect();
    let turns = pieces_facing_unlike(&pieces, ctx.tolerance).at(args.surfaces.span)?;
    let turned = |(surface, turns): (&SurfaceOrFace, bool)| {
        if turns { surface.flipped().at(args.surfaces.span) } else { Ok(surface.clone()) }
    };
    surfaces.iter().zip(turns).map(turned).collect()
}
