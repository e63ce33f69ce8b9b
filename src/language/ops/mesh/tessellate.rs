//! `tessellate`: triangles within a tolerance.

use std::{f64::consts::PI, sync::Arc};

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{
        self, Bounds, Face, Mesh, Solid, Surface, SurfacePiece, TessellationOptions, Tolerance,
        tolerance::DEFAULT_CHORD_RELATIVE,
    },
    ops::positive,
    value::{Angle, At, Ctx, Geometry, Length, Number, Type, Value, op},
};

op! {
    /// Mesh of surfaces no further from them than a tolerance.
    ///
    /// No point of the triangles is further from the surface than the tolerance, and none of the
    /// surface further from the triangles, however small a feature is: bounds of the second
    /// derivatives tell how large a triangle may be. It has no cracks, at seams and poles neither;
    /// surfaces and faces of a list share the vertices where their edges run together, along the whole or from
    /// a corner of one to a corner of another, whatever their degrees, knots and parameters are. Normals are those of each side where there is a crease.
    /// The faces of one solid share theirs too, so that its mesh closes.
    /// Meshes in a list are taken along as they are. With `quads` the two triangles of a cell of the
    /// parameters are one face, which files that can hold quadrilaterals keep (`.obj`, `.ply`); at poles
    /// and along edges whose vertices are others than those of the lines inside there are triangles.
    /// Filip, Magedson & Markot, *Surface algorithms using bounds on derivatives*, CAGD 3 (1986).
    tessellate in Mesh -> Mesh {
        /// A surface, face or solid, or a list of them and meshes.
        g: Spanned<Geometry>,
        /// The tolerance; when left out a thousandth of the size of `g`.
        tolerance: Option<Spanned<Length>>,
        /// How far the surface's normal may turn over a triangle.
        angle: Spanned<Angle> = Spanned::unplaced(Angle(PI / 12.0)),
        /// The longest edge that triangles may have; any when left out.
        max_edge: Option<Spanned<Length>>,
        /// Whether cells are faces of four corners where they can be.
        quads: bool = false,
    }
    example "tessellate(bilinear((0, 0), (0, 1), (1, 0), (1, 1)))" => "mesh of 4 vertices and 2 triangles";
    example "tessellate(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), max_edge = 0.75)" => "mesh of 9 vertices and 8 triangles";
    example "tessellate(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), max_edge = 0.75, quads = true)" => "mesh of 9 vertices and 4 faces";
    refuses "tessellate(plane_patch((0, 0), (1, 0), (0, 1)), tolerance = 0)" => "E0607: the tolerance must be positive, found 0";
    refuses "tessellate(line((0, 0), (1, 0)))" => "E0301: surfaces and meshes become triangles, found a curve";
    picture "tessellate(torus((0, 0, 0), 3, 1), tolerance = 0.05)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Mesh> {
    let geometry = &args.g.value.0;
    let limit = |what: &str, given: Spanned<Length>, hint: &str| {
        positive(what, given).map_err(|mistake| Box::new(mistake.hint(hint)))
    };
    let tolerance = match args.tolerance {
        Some(given) => limit("the tolerance", given, "leave it out for a thousandth of the size")?,
        None => DEFAULT_CHORD_RELATIVE * size(geometry).filter(|size| 0.0 < *size).unwrap_or(1.0),
    };
    let angle = args.angle.value.0;
    if angle <= 0.0 {
        let found = Number::angle(angle);
        let message = format!("the angle must be positive, found {found}");
        return Diagnostic::error(Code::Degenerate, args.angle.span, message)
            .hint("180deg lets normals turn as far as the tolerance does")
            .fail();
    }
    let max_edge = match args.max_edge {
        Some(given) => limit("the longest edge", given, "leave it out for edges of any length")?,
        None => f64::INFINITY,
    };
    let (weld, n_threads) = (ctx.tolerance.distance, ctx.n_threads);
    let is_grid = args.quads;
    let limits = TessellationOptions { tolerance, angle, max_edge, weld, is_grid, n_threads };
    let most = ctx.limits.mesh_vertices;
    let hint = "a larger tolerance, angle or longest edge takes fewer vertices";
    let too_large = |mistake: Box<Diagnostic>| match mistake.code {
        Code::TooLarge => Box::new(mistake.hint(hint)),
        _ => mistake,
    };
    let mut parts = Vec::new();
    gather(geometry, &args.g, &mut parts)?;
    let pieces: Vec<SurfacePiece<'_>> = parts.iter().filter_map(MeshedPart::piece).collect();
    let made = kernel::tessellate_together(&pieces, &limits, most).at(ctx.span);
    let mut made = made.map_err(too_large)?.into_iter();
    let mut meshes = Vec::with_capacity(parts.len());
    for part in parts {
        meshes.extend(match part {
            MeshedPart::Surface(_) if args.quads => made.next().map(Mesh::with_quadrilaterals),
            MeshedPart::Surface(_) | MeshedPart::Face(_) => made.next(),
            MeshedPart::Solid(solid) => {
                Some(solid.mesh(&limits, most).at(ctx.span).map_err(too_large)?)
            }
            MeshedPart::Mesh(mesh) => Some(Mesh::clone(&mesh)),
        });
    }
    Mesh::merged(&meshes, most).at(ctx.span)
}

/// What a mesh is made of.
enum MeshedPart {
    Surface(Surface),
    Face(Arc<Face>),
    Solid(Arc<Solid>),
    Mesh(Arc<Mesh>),
}

impl MeshedPart {
    /// What shares vertices with others.
    fn piece(&self) -> Option<SurfacePiece<'_>> {
        match self {
            Self::Surface(surface) => Some(SurfacePiece::Whole(surface)),
            Self::Face(face) => Some(SurfacePiece::Part(face)),
            Self::Solid(_) | Self::Mesh(_) => None,
        }
    }
}

/// The parts of a value.
fn gather(value: &Value, whole: &Spanned<Geometry>, parts: &mut Vec<MeshedPart>) -> Result<()> {
    match value {
        Value::Surface(surface) => parts.push(MeshedPart::Surface(surface.clone())),
        Value::Face(face) => parts.push(MeshedPart::Face(Arc::clone(face))),
        Value::Solid(solid) => parts.push(MeshedPart::Solid(Arc::clone(solid))),
        Value::Mesh(mesh) => parts.push(MeshedPart::Mesh(Arc::clone(mesh))),
        Value::List(items) => {
            for item in items.iter() {
                gather(item, whole, parts)?;
            }
        }
        other => {
            let message = format!("surfaces and meshes become triangles, found {}", other.phrase());
            let found = Diagnostic::error(Code::WrongKind, whole.span, message);
            return match Type::Surface.remedy(other) {
                Some(remedy) => found.hint(remedy).fail(),
                None => found.fail(),
            };
        }
    }
    Ok(())
}

/// The diagonal of the box around a value.
fn size(value: &Value) -> Option<f64> {
    fn bounds(value: &Value) -> Option<Bounds> {
        match value {
            Value::Surface(surface) => surface.bounds().ok(),
            Value::Face(face) => face.bounds(Tolerance::DEFAULT).ok(),
            Value::Solid(solid) => solid.bounds(Tolerance::DEFAULT).ok(),
            Value::Mesh(mesh) => mesh.bounds(),
            Value::List(items) => items.iter().filter_map(bounds).reduce(Bounds::union),
            _ => None,
        }
    }
    bounds(value).map(Bounds::diagonal)
}
