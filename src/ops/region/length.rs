//! `length` of a region's borders.

use super::Given;
use crate::{
    diag::Result,
    value::{Ctx, Length, op},
};

op! {
    /// Length of all borders of a region together.
    length in Region -> Length {
        /// The region.
        r: Given,
    }
    example "length(region(polyline([(0, 0), (3, 0), (0, 4)], closed = true)))" => "12";
}

fn run(_: &mut Ctx<'_>, args: Args) -> Result<Length> {
    Ok(Length(args.r.length()))
}
