//! `is_closed` of a curve.

use crate::{
    diag::Result,
    kernel::Curve,
    value::{Ctx, op},
};

op! {
    /// Whether a curve ends where it starts, to within the tolerance; `c.closed` is the same.
    is_closed in Measure -> bool {
        /// The curve.
        c: Curve,
    }
    example "is_closed(circle((0, 0), 1))" => "true";
    example "is_closed(polyline((0, 0), (1, 0), (1, 1)))" => "false";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<bool> {
    Ok(args.c.is_closed(ctx.tolerance.distance))
}
