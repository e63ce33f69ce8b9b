//! The meshes of surfaces, as fine as a screen needs and as a screen can bear.

use super::{
    encode::Fineness,
    parts::{Piece, Shape},
};
use crate::{
    kernel::{
        CountError, Face, GeomError, Mesh, Surface, SurfacePiece, TessellationOptions,
        tessellate_any, tessellate_together,
    },
    page::ceilings::within_ceilings,
    session::Session,
};

/// Vertices that the surfaces of one definition may take so that their normals turn little from corner to
/// corner. A sharp edge with a round of its own, such as that of a blade, takes millions.
const SMOOTH_VERTICES: usize = 150_000;

/// How many times the angle is doubled before only the distance from the surface counts.
const DOUBLINGS: usize = 3;

/// The meshes of the surfaces and faces among the pieces, which share the vertices on common edges; where they
/// have none together, each alone.
pub(super) fn meshes(
    pieces: &[Piece],
    session: &Session,
    fineness: &Fineness,
) -> Vec<Result<Option<Mesh>, String>> {
    let together: Vec<SurfacePiece<'_>> = pieces.iter().flat_map(parts).collect();
    let together = within_ceilings(session, || {
        bearable(fineness, session.n_threads(), |options, most| {
            tessellate_together(&together, options, most)
        })
    });
    if let Ok(meshes) = together {
        let mut meshes = meshes.into_iter();
        let of_piece = |piece: &Piece| {
            let n_meshes = parts(piece).count();
            let own: Vec<Mesh> = meshes.by_ref().take(n_meshes).collect();
            let merged =
                || Mesh::merged(&own, fineness.most).map(Some).map_err(|err| err.to_string());
            if n_meshes == 0 { Ok(None) } else { merged() }
        };
        return pieces.iter().map(of_piece).collect();
    }
    let alone = |piece: &Piece| {
        if let Shape::Face(face) = &piece.shape {
            return of_face(face, session, fineness).map(Some);
        }
        let surfaces = piece.shape.surfaces();
        if surfaces.is_empty() {
            return Ok(None);
        }
        let mesh = |surface: &Surface| {
            within_ceilings(session, || {
                bearable(fineness, session.n_threads(), |options, most| {
                    tessellate_any(surface, options, most)
                })
            })
        };
        let meshes: Result<Vec<Mesh>, String> = surfaces.iter().map(mesh).collect();
        Mesh::merged(&meshes?, fineness.most).map(Some).map_err(|err| err.to_string())
    };
    pieces.iter().map(alone).collect()
}

/// What of a piece becomes triangles.
fn parts(piece: &Piece) -> impl Iterator<Item = SurfacePiece<'_>> {
    let face = match &piece.shape {
        Shape::Face(face) => Some(SurfacePiece::Part(face)),
        _ => None,
    };
    piece.shape.surfaces().iter().map(SurfacePiece::Whole).chain(face)
}

fn of_face(face: &Face, session: &Session, fineness: &Fineness) -> Result<Mesh, String> {
    within_ceilings(session, || {
        bearable(fineness, session.n_threads(), |options, most| face.mesh(options, most))
    })
}

/// What `tessellate` makes with the smallest angle for which that is not too much; else without one.
fn bearable<T>(
    fineness: &Fineness,
    n_threads: usize,
    tessellate: impl Fn(&TessellationOptions, usize) -> Result<T, GeomError>,
) -> Result<T, GeomError> {
    let within = TessellationOptions {
        weld: fineness.weld,
        n_threads,
        ..TessellationOptions::within(fineness.chord)
    };
    let mut angle = fineness.angle;
    for _ in 0..=DOUBLINGS {
        match tessellate(
            &TessellationOptions { angle, ..within },
            SMOOTH_VERTICES.min(fineness.most),
        ) {
            Err(GeomError::Count(CountError::TooManyVertices { .. })) => angle += angle,
            made => return made,
        }
    }
    tessellate(&within, fineness.most)
}
