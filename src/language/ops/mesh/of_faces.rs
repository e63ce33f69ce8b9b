//! `mesh`: vertices and faces.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{self, GeomError, Mesh, MeshError},
    value::{At, Ctx, FromValue, Value, op},
};

op! {
    /// Mesh of vertices and of faces over them: each the list of its corners, which are indices of
    /// vertices from 0, counter-clockwise seen from outside.
    ///
    /// A face of more than three corners stays a face, in `faces`, in the drawing and in files that can
    /// hold it (`.obj`, `.ply`); for everything else it is split into triangles. A quadrilateral is cut by
    /// the diagonal that leaves the larger least triangle, a convex polygon from its first corner, any
    /// other by a Delaunay triangulation within it. Faces need not be plane. The mesh has no normals, so
    /// that pictures show it faceted.
    mesh in Mesh -> Mesh {
        /// The vertices.
        vertices: Spanned<Vec<DVec3>>,
        /// The faces, a list of indices each.
        faces: Spanned<Vec<Vec<Value>>>,
    }
    example "mesh([(0, 0), (2, 0), (2, 1), (0, 1)], [[0, 1, 2, 3]])" => "mesh of 4 vertices and 1 face";
    example "volume(mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])) ~= 1/6" => "true";
    example "mesh([(0, 0), (2, 0), (2, 1), (0, 1)], [[0, 1, 2, 3]]).faces" => "[[0, 1, 2, 3]]";
    refuses "mesh([(0, 0), (1, 0), (0, 1)], [[0, 1, 3]])" => "E0307: face 0 names vertex 3; there are 3, counted from 0";
    refuses "mesh([(0, 0), (1, 0), (0, 1)], [[0, 1, 1]])" => "E0607: face 0 names vertex 1 twice";
    refuses "mesh([(0, 0), (1, 0), (0, 1)], [[0, 1]])" => "E0601: face 0 has 2 corners; a face needs 3 or more";
    refuses "mesh([(0, 0), (1, 0), (0, 1)], [[0, 1, 1.5]])" => "E0301: corner 2 of face 0 is the number 1.5; corners are indices of vertices, whole numbers from 0";
    picture "mesh([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 1, 2)], [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])";
}

/// What the corners of faces are.
const INDICES: &str = "corners are indices of vertices, whole numbers from 0";

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Mesh> {
    let faces = &args.faces;
    let place = |face: usize, corner: Option<usize>| place(ctx, faces.span, face, corner);
    let mut all: Vec<Vec<usize>> = Vec::with_capacity(faces.value.len());
    for (face, corners) in faces.value.iter().enumerate() {
        let mut indices = Vec::with_capacity(corners.len());
        for (corner, found) in corners.iter().enumerate() {
            indices.push(usize::from_value(found, faces.span).map_err(|_| {
                let found = found.phrase();
                let message = format!("corner {corner} of face {face} is {found}; {INDICES}");
                let span = place(face, Some(corner));
                Box::new(Diagnostic::error(Code::WrongKind, span, message))
            })?);
        }
        all.push(indices);
    }
    let made = kernel::polygon_mesh(args.vertices.value, &all, ctx.limits.mesh_vertices);
    let span = match &made {
        Err(GeomError::Mesh(MeshError::BadFace { face, corner, .. })) => place(*face, *corner),
        _ => ctx.span,
    };
    made.at(span)
}

/// Where a face stands, or one of its corners, if the list is written out there.
fn place(ctx: &Ctx<'_>, faces: Span, face: usize, corner: Option<usize>) -> Span {
    let (_, span) = ctx.element(faces, face, "faces");
    match corner {
        Some(corner) if span != faces => ctx.element(span, corner, "faces").1,
        _ => span,
    }
}
