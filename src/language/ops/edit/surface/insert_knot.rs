//! `insert_knot` of a surface.

use std::sync::Arc;

use super::{check_more, one_of};
use crate::{
    diag::{Result, Spanned},
    kernel::NurbsSurface,
    ops::edit::curve::{at_least_once, not_too_often},
    value::{At, Ctx, op},
};

op! {
    /// The same surface with one knot more along u or v, or with the same knot several times more.
    ///
    /// Exact: each time one row, or column, of control points more. A knot that stands as often as
    /// the degree has control points on its isocurve. Piegl & Tiller, *The NURBS Book*, A5.3.
    insert_knot in Edit -> NurbsSurface {
        /// The surface.
        s: Arc<NurbsSurface>,
        /// The knot of u, inside the surface's domain.
        u: Option<Spanned<f64>>,
        /// The knot of v; one of both is given.
        v: Option<Spanned<f64>>,
        /// How many times.
        times: Spanned<usize> = Spanned::unplaced(1),
    }
    example "insert_knot(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 0.5).points" => "[[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)], [(2, 0, 0), (2, 1, 0)]]";
    example "insert_knot(elevate(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), v = 2), v = 0.5, times = 2).knots_v" => "[0, 0, 0, 0.5, 0.5, 1, 1, 1]";
    refuses "insert_knot(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0401: neither `u` nor `v` is given";
    refuses "insert_knot(plane_patch((0, 0), (1, 0), (0, 1)), u = 2)" => "E0606: parameter 2 is outside the domain 0..1";
    refuses "insert_knot(plane_patch((0, 0), (1, 0), (0, 1)), u = 0.5, v = 0.5)" => "E0401: one of `u` and `v` is wanted, found both";
    derivative shape;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 2), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        curves net = control_net(insert_knot(s, u = 0.5)) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let (along, t) = one_of(args.u, args.v, ctx, "`refine` takes knots of both directions")?;
    at_least_once("inserted", args.times)?;
    not_too_often(args.s.knots(along), t, args.times)?;
    let times = args.times.value;
    check_more(&args.s, along, times, ctx)?;
    args.s.insert_knots(along, &vec![t.value; times]).at(t.span)
}
