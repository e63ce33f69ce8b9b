//! `grid_mesh`: triangles over a regular grid of parameters.

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{self, Mesh, Surface},
    value::{At, Ctx, op},
};

op! {
    /// Mesh of a surface over a regular grid of its parameters, two triangles a cell, with unit
    /// normals.
    ///
    /// Triangles run counter-clockwise seen from the side of Su × Sv. Those that a pole makes
    /// empty are left out. With `quads` the two of a cell are one face, which files that can hold
    /// quadrilaterals keep (`.obj`, `.ply`), and which is drawn without the diagonal.
    grid_mesh in Mesh -> Mesh {
        /// The surface.
        s: Surface,
        /// Cells along u.
        nu: Spanned<usize>,
        /// Cells along v.
        nv: Spanned<usize>,
        /// Whether a cell is one face of four corners.
        quads: bool = false,
    }
    example "grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 2, 3)" => "mesh of 12 vertices and 12 triangles";
    example "grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 2, 3, quads = true)" => "mesh of 12 vertices and 6 faces";
    refuses "grid_mesh(plane_patch((0, 0), (1, 0), (0, 1)), 0, 3)" => "E0607: a grid has one cell or more in each direction, found 0";
    picture "grid_mesh(bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]), 12, 12)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Mesh> {
    for count in [args.nu, args.nv] {
        if count.value == 0 {
            let message = "a grid has one cell or more in each direction, found 0";
            return Diagnostic::error(Code::Degenerate, count.span, message).fail();
        }
    }
    let (n_u, n_v, most) = (args.nu.value, args.nv.value, ctx.limits.mesh_vertices);
    let mesh = kernel::grid_mesh_any(&args.s, n_u, n_v, most, ctx.n_threads).at(ctx.span)?;
    let mesh = if args.quads { mesh.with_quadrilaterals() } else { mesh };
    if mesh.n_triangles() == 0 {
        let message = "the mesh has no triangles: at the corners of its cells the surface is one point or one line";
        let hint = "more cells see more of the surface; `tessellate` finds how many it needs";
        ctx.warn(Diagnostic::warning(Code::DegenerateResult, ctx.span, message).hint(hint));
    }
    Ok(mesh)
}
