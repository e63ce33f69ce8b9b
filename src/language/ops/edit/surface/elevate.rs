//! `elevate` of a surface: the same surface at higher degrees.

use std::sync::Arc;

use super::{check_size, some_of};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Direction, NurbsSurface},
    value::{At, Ctx, op},
};

op! {
    /// The same surface at a higher degree along u, along v, or both; the degrees of the result are
    /// named.
    ///
    /// Exact: points, parameters and continuity stay. Along an elevated direction the result begins
    /// and ends at its control points. Piegl & Tiller, *The NURBS Book*, §5.5.
    elevate in Edit -> NurbsSurface {
        /// The surface.
        s: Arc<NurbsSurface>,
        /// The degree along u, not below that of the surface.
        u: Option<Spanned<usize>>,
        /// The degree along v.
        v: Option<Spanned<usize>>,
    }
    example "elevate(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 2).points" => "[[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)], [(2, 0, 0), (2, 1, 0)]]";
    example "elevate(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 3, v = 2).degree_v" => "2";
    refuses "elevate(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0401: neither `u` nor `v` is given";
    refuses "elevate(plane_patch((0, 0), (1, 0), (0, 1)), u = 0)" => "E0604: degree 0 along u is below the degree 1 that it has";
    derivative shape;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 2), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        curves net = control_net(elevate(s, u = 4)) with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let degrees = some_of(args.u, args.v, ctx, "3")?;
    let mut elevated = NurbsSurface::clone(&args.s);
    for (along, degree) in degrees {
        let own = elevated.knots(along).degree();
        if degree.value < own {
            let name = along.name();
            let message = format!(
                "degree {} along {name} is below the degree {own} that it has",
                degree.value
            );
            return Diagnostic::error(Code::BadDegree, degree.span, message)
                .hint("name the degrees of the result")
                .fail();
        }
        let n = |along: Direction| elevated.knots(along).n_points();
        let more =
            degree.value.saturating_sub(elevated.knots(along).degree()).min(ctx.limits.degree);
        let n_breaks = elevated.knots(along).spans().count() + 1;
        check_size(n(along).saturating_add(more * n_breaks), n(along.other()), ctx)?;
        elevated = elevated.elevate_degree(along, degree.value).at(degree.span)?;
    }
    Ok(elevated)
}
