//! `decompose` of a surface: its Bézier patches.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsSurface,
    ops::list::check_length,
    value::{Ctx, op},
};

op! {
    /// Bézier patches that a surface consists of, as a grid: `[i][j]`, i along u, j along v, each
    /// on its own part of the domains.
    ///
    /// Exact. `join` makes the same surface of them. Piegl & Tiller, *The NURBS Book*, A5.7.
    decompose | to_bezier in Edit -> Vec<Vec<NurbsSurface>> {
        /// The surface.
        s: Arc<NurbsSurface>,
    }
    example "len(decompose(ruled(circle((0, 0), 1), circle((0, 0, 1), 1))))" => "4";
    example "decompose(refine(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), v = [0.5]))[0][1].domain_v" => "0.5..1";
    refuses "decompose(parametric((u, v) => (u, v, u*v), 0..1, 0..1))" => "E0301: `decompose`: `s` must be a NURBS surface, found a parametric surface";
    derivative affine;
    scene r#"
        let patches = decompose(bspline([for i in 0..5: [for j in 0..5: (i, j, sin(i)*cos(j))]])) with (hidden = true)
        let apart = [for i in 0..2, j in 0..2: translate(patches[i][j], (i, j))]
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Vec<NurbsSurface>>> {
    let [n_u, n_v] = args.s.n_patches();
    let size = (args.s.degree_u() + 1) * (args.s.degree_v() + 1);
    check_length(n_u as f64 * n_v as f64 * size as f64, ctx)?;
    let patches = args.s.decompose();
    Ok((0..n_u).map(|i| patches.row(i).to_vec()).collect())
}
