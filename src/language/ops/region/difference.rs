//! `difference` of regions.

use super::Regions;
use crate::{
    diag::{Result, Spanned},
    kernel::Region,
    value::{At, Ctx, op},
};

op! {
    /// What is in the first of several regions and in none of the others, as a list of its parts, the
    /// largest first; `[]` where there is nothing.
    ///
    /// The borders of the result are parts of the given ones, exactly. Borders that run within the
    /// document's tolerance of one another are one; those that come as near without being one are
    /// refused with the place. Where a list of several comes first and others follow, a warning tells that only its first
    /// region is kept (W0013).
    difference in Region -> Vec<Region> {
        /// The regions, in one plane; lists count as their members.
        regions: Spanned<Regions>,
    }
    example "difference(region(circle((0, 0), 2)), region(circle((0, 0), 1)))" => "[region with a hole, 2 arcs]";
    example "difference(region(circle((0, 0), 1)), region(circle((0, 0), 2)))" => "[]";
    picture "difference(region(circle((0, 0), 2)), [for i in 0..5: region(circle((1.2*cos(i*60deg), 1.2*sin(i*60deg)), 0.4))])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Region>> {
    let regions = &args.regions;
    regions.value.listed.warn_of_difference(ctx, regions.span, "region");
    Region::difference(&regions.value.all, ctx.tolerance, ctx.n_threads).at(regions.span)
}
