//! `offset` of a region: what lies within a distance, or further inside.

use super::Given;
use crate::{
    diag::{Result, Spanned},
    kernel::{CornerStyle, Region},
    value::{At, Choice, Ctx, Length, op},
};

op! {
    /// Region grown by a distance, shrunk by a negative one, as a list of its parts, the largest first, as
    /// it may fall apart; `[]` where nothing is left.
    ///
    /// The result is what lies within the distance (or further than it from the outside), so that holes
    /// close, narrow bridges go, and nothing crosses itself. At corners that are torn open `"round"` puts an
    /// arc, `"miter"` lets both sides go on until they meet, no further than ten times the distance, where they
    /// are cut off straight across, and `"bevel"` cuts straight across at once. Lines and arcs stay such; other borders keep the document's
    /// tolerance.
    offset in Region -> Vec<Region> {
        /// The region.
        r: Spanned<Given>,
        /// The distance; a negative one shrinks.
        distance: Length,
        /// What becomes of corners.
        corner: CornerStyle = CornerStyle::Round,
    }
    example "area(offset(region(circle((0, 0), 2)), 1)[0]) ~= 9*pi" => "true";
    example "offset(region(circle((0, 0), 2)), -3)" => "[]";
    example "area(offset(region(polyline([(0, 0), (4, 0), (4, 4), (0, 4)], closed = true)), 1, corner = \"miter\")[0])" => "36";
    example "bounds(offset(region(polyline([(0, 0), (20, -0.5), (20, 0.5)], closed = true)), 0.1, corner = \"miter\")[0]).min.x ~= -1" => "true";
    scene r#"
        region r = region(polyline([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)], closed = true))
        regions grown = offset(r, 0.4) with (color = "gray")
        regions shrunk = offset(r, -0.3) with (color = "red")
    "#;
}

impl Choice for CornerStyle {
    const WORDS: &'static [&'static str] = &["round", "miter", "bevel"];
    const MEANINGS: &'static [Self] = &[Self::Round, Self::Miter, Self::Bevel];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Region>> {
    args.r.value.offset(args.distance.0, args.corner, ctx.tolerance).at(args.r.span)
}
