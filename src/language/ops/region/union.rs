//! `union` of regions.

use super::Regions;
use crate::{
    diag::{Result, Spanned},
    kernel::Region,
    value::{At, Ctx, op},
};

op! {
    /// What is in any of several regions, as a list of its parts, the largest first.
    ///
    /// The borders of the result are parts of the given ones, exactly. Borders that run within the
    /// document's tolerance of one another are one; those that come as near without being one are
    /// refused with the place.
    union in Region -> Vec<Region> {
        /// The regions, in one plane; lists count as their members.
        regions: Spanned<Regions>,
    }
    example "area(union(region(circle((0, 0), 1)), region(circle((1, 0), 1)))[0]) ~= 4*pi/3 + sqrt(3)/2" => "true";
    example "len(union(region(circle((0, 0), 1)), region(circle((5, 0), 1))))" => "2";
    refuses "union(region(circle((0, 0), 1)), region(circle((0, 0, 1), 1)))" => "E0607: region [1] lies in another plane than region [0]: it is up to 1 away from that";
    picture "union([for i in 0..4: region(circle((i, 0.5*i), 1))])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Region>> {
    let regions = &args.regions;
    Region::union(&regions.value.all, ctx.tolerance, ctx.n_threads).at(regions.span)
}
