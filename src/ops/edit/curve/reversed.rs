//! `reversed`: a curve run through backwards.

use std::sync::Arc;

use crate::{
    diag::Result,
    kernel::NurbsCurve,
    value::{Ctx, op},
};

op! {
    /// Curve run through backwards, on the same domain: its start is the end of `c`.
    reversed in Edit -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
    }
    example "reversed(line((0, 0), (2, 4)))(0.25)" => "(1.5, 3, 0)";
    example "reversed(polyline((0, 0), (3, 0), (3, 4))).domain" => "0..2";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    Ok(args.c.reversed())
}
