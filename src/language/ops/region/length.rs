//! `length` of a region's borders.

use crate::{
    diag::Result,
    kernel::VariedRegion,
    value::{At, Ctx, Length, Real, RealRegion, op, with_slopes},
};

op! {
    /// Length of all borders of a region together.
    length in Region -> Length<Real> {
        /// The region.
        r: RealRegion,
    }
    example "length(region(polyline([(0, 0), (3, 0), (0, 4)], closed = true)))" => "12";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Length<Real>> {
    let slopes = args.r.varied().map(VariedRegion::length_slopes);
    with_slopes(args.r.plain().length(), slopes).map(Length).at(ctx.span)
}
