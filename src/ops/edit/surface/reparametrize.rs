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
    reparametrize in Edit -> NurbsSurface {
        /// The surface.
        s: Arc<NurbsSurface>,
        /// The new domain of u.
        u: Option<Spanned<Interval>>,
        /// The new domain of v.
        v: Option<Spanned<Interval>>,
    }
    example "reparametrize(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), u = 0..4)(1, 1)" => "(0.5, 1, 0)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let domains = some_of(args.u, args.v, ctx, "0..1")?;
    let surface = NurbsSurface::clone(&args.s);
    Ok(domains
        .into_iter()
        .fold(surface, |s, (along, domain)| s.reparametrized(along, domain.value)))
}
