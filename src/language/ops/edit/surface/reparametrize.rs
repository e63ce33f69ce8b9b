//! `reparametrize` of a surface: other domains.

use std::sync::Arc;

use super::some_of;
use crate::{
    diag::{Result, Spanned},
    kernel::{Interval, NurbsSurface},
    value::{Ctx, op},
};

op! {
    /// The same surface over other domains of u, of v, or both: the parameters change linearly.
    ///
    /// Piegl & Tiller, *The NURBS Book*, §6.4.
    reparametrize in Edit -> NurbsSurface {
        /// The surface.
        s: Arc<NurbsSurface>,
        /// The new domain of u.
        u: Option<Spanned<Interval>>,
        /// The new domain of v.
        v: Option<Spanned<Interval>>,
    }
    example "reparametrize(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 0..4)(1, 1)" => "(0.5, 1, 0)";
    refuses "reparametrize(plane_patch((0, 0), (1, 0), (0, 1)), u = 2..2)" => "E0606: `reparametrize`: `u`: an interval needs its start below its end, got 2..2";
    refuses "reparametrize(plane_patch((0, 0), (1, 0), (0, 1)))" => "E0401: neither `u` nor `v` is given";
    derivative shape;
    scene r#"
        surface s = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]) with (color = "lightgray")
        surface longer = reparametrize(translate(s, (6, -2)), u = 0..4) with (color = "lightgray")
        curves speeds = [for v in 0..1, g in [s, longer]: arrows(g(_, v), "derivative", samples = 4, scale = 1/4)] |> flatten with (color = "red")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let domains = some_of(args.u, args.v, ctx, "0..1")?;
    let surface = NurbsSurface::clone(&args.s);
    Ok(domains
        .into_iter()
        .fold(surface, |s, (along, domain)| s.reparametrized(along, domain.value)))
}
