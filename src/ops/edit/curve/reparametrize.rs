//! `reparametrize`: a curve over another domain.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::{Interval, NurbsCurve},
    value::{Ctx, op},
};

op! {
    /// The same points over another domain, the parameter mapped evenly.
    ///
    /// Derivatives of order k are divided by the k-th power of the domain's growth.
    reparametrize in Edit -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The new domain, such as `0..10`.
        domain: Interval,
    }
    example "reparametrize(line((0, 0), (2, 4)), 10..30)(15)" => "(0.5, 1, 0)";
    example "reparametrize(line((0, 0), (2, 4)), 0..length(line((0, 0), (3, 4)))).domain" => "0..5";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    Ok(args.c.reparametrized(args.domain))
}
