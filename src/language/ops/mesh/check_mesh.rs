//! `check_mesh`: how the triangles of a mesh hang together.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{Mesh, MeshCheck},
    value::{Ctx, Record, Value, op},
};

op! {
    /// How the triangles of a mesh hang together: `{closed, manifold, oriented, euler, degenerate,
    /// boundaries, components, vertices, edges, triangles}`.
    ///
    /// Vertices within the document's tolerance are one, so that seams and creases, where several
    /// stand at one place, hang together. `closed`: every edge has two triangles or more;
    /// `manifold`: none has more than two, and around each vertex they are one fan; `oriented`:
    /// neighbours face alike. `euler` is vertices − edges + triangles: 2 of what is
    /// like a sphere, 0 of what is like a torus. `degenerate` counts the triangles without area,
    /// which count for nothing else; `boundaries` the holes that `border` goes around; `components`
    /// the parts that share no vertex.
    check_mesh in Mesh -> Record {
        /// The mesh.
        m: Arc<Mesh>,
    }
    example "check_mesh(tessellate(box((0, 0, 0), (1, 2, 3)))).euler" => "2";
    example "check_mesh(grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 1, 1))" => "{closed: false, manifold: true, oriented: true, euler: 1, degenerate: 0, boundaries: 1, components: 1, vertices: 4, edges: 5, triangles: 2}";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let MeshCheck {
        is_closed,
        is_manifold,
        is_oriented,
        degenerate,
        euler,
        boundaries,
        components,
        counts: [vertices, edges, triangles],
    } = args.m.check(ctx.tolerance);
    let truths = [("closed", is_closed), ("manifold", is_manifold), ("oriented", is_oriented)];
    let truths = truths.map(|(name, truth)| (Arc::from(name), Value::Bool(truth)));
    let counts = [
        ("euler", euler as f64),
        ("degenerate", degenerate as f64),
        ("boundaries", boundaries as f64),
        ("components", components as f64),
        ("vertices", vertices as f64),
        ("edges", edges as f64),
        ("triangles", triangles as f64),
    ];
    let counts = counts.map(|(name, count)| (Arc::from(name), Value::number(count)));
    Ok(Record::new(truths.into_iter().chain(counts)))
}
