//! `de_casteljau` of a surface: corner cutting of its net, level by level.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Grid, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// All levels of nets of de Casteljau's algorithm for a Bézier surface.
    ///
    /// Level 0 is the control net; each next one divides the cells of the one before it in the ratio
    /// of both parameters, and where one direction is used up the legs of the other; the last is
    /// the point of the surface. With weights they are divided in homogeneous space. The
    /// algorithm by curves is that of the isocurves: `de_casteljau(s(_, v), u)`.
    /// Linkeová, *Curves and Surfaces for Computer Graphics*, (3.43) to (3.45).
    de_casteljau in Edit -> Vec<Vec<Vec<DVec3>>> {
        /// The surface, of one Bézier patch.
        s: Spanned<Arc<NurbsSurface>>,
        /// The first parameter, inside the surface's domain.
        u: Spanned<f64>,
        /// The second parameter.
        v: Spanned<f64>,
    }
    example "de_casteljau(bezier([[(0, 0), (0, 2)], [(1, 0), (1, 2)], [(4, 0, 4), (4, 2)]]), 0.5, 0.5)[1]" => "[[(0.5, 1, 0)], [(2.5, 1, 1)]]";
    example "de_casteljau(bezier([[(0, 0), (0, 2)], [(1, 0), (1, 2)], [(4, 0, 4), (4, 2)]]), 0.5, 0.5)[2]" => "[[(1.5, 1, 0.5)]]";
    refuses "de_casteljau(refine(plane_patch((0, 0), (1, 0), (0, 1)), u = [0.5]), 0.5, 0.5)" => "E0611: a Bézier surface is one patch, but the surface has 2 x 1";
    derivative affine;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Vec<Vec<DVec3>>>> {
    let (surface, span) = (args.s.value, args.s.span);
    let u = surface.domain_u().clamp_inside(args.u.value).at(args.u.span)?;
    let v = surface.domain_v().clamp_inside(args.v.value).at(args.v.span)?;
    ctx.made_by(&|| Some(surface.factors_of_levels(u, v)));
    let Some(levels) = surface.de_casteljau(u, v) else {
        let message = match surface.n_patches() {
            [1, 1] => "the surface is one patch, but not in Bézier form".to_owned(),
            [n, m] => format!("a Bézier surface is one patch, but the surface has {n} x {m}"),
        };
        return Diagnostic::error(Code::NotExact, span, message)
            .hint("`decompose` gives its patches as Bézier surfaces")
            .fail();
    };
    let rows = |level: &Grid<DVec3>| (0..level.n_rows()).map(|i| level.row(i).to_vec()).collect();
    Ok(levels.iter().map(rows).collect())
}
