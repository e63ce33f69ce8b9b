//! `refine` of a surface: more knots.

use std::sync::Arc;

use super::{check_more, some_of};
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsSurface,
    value::{At, Ctx, op},
};

op! {
    /// The same surface with more knots along u, along v, or both; a knot that is to be there twice
    /// more is given twice.
    ///
    /// Exact: one row, or column, of control points more for each. A knot within rounding of one
    /// that is there already counts as that one. Piegl & Tiller, *The NURBS Book*, A5.5.
    refine in Edit -> NurbsSurface {
        /// The surface.
        s: Arc<NurbsSurface>,
        /// The knots of u to insert, in any order, inside the surface's domain.
        u: Option<Spanned<Vec<f64>>>,
        /// The knots of v to insert.
        v: Option<Spanned<Vec<f64>>>,
    }
    example "refine(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = [0.5], v = [0.25, 0.75]).patches" => "[2, 3]";
    refuses "refine(plane_patch((0, 0), (1, 0), (0, 1)), u = [2])" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "refine(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0401: neither `u` nor `v` is given";
    derivative shape;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 2), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        curves net = control_net(refine(s, u = [0.25, 0.5, 0.75])) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let all = some_of(args.u, args.v, ctx, "[0.5]")?;
    let mut refined = NurbsSurface::clone(&args.s);
    for (along, knots) in all {
        check_more(&refined, along, knots.value.len(), ctx)?;
        refined = refined.insert_knots(along, &knots.value).at(knots.span)?;
    }
    Ok(refined)
}
