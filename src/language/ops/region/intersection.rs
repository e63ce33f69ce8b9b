//! `intersection` of regions.

use super::Regions;
use crate::{
    diag::{Result, Spanned},
    kernel::Region,
    value::{At, Ctx, op},
};

op! {
    /// What is in all of several regions, as a list of its parts, the largest first; `[]` where there is
    /// nothing.
    ///
    /// The borders of the result are parts of the given ones, exactly. Borders that run within the
    /// document's tolerance of one another are one; those that come as near without being one are
    /// refused with the place. Where nothing is in all of them, and a list of several stands among others, a warning
    /// tells that each of its members counts (W0013).
    intersection in Region -> Vec<Region> {
        /// The regions, in one plane; lists count as their members.
        regions: Spanned<Regions>,
    }
    example "area(intersection(region(circle((0, 0), 1)), region(circle((1, 0), 1)))[0]) ~= 2*pi/3 - sqrt(3)/2" => "true";
    example "intersection(region(circle((0, 0), 1)), region(circle((5, 0), 1)))" => "[]";
    picture "intersection(region(circle((0, 0), 1)), region(circle((1, 0), 1)))";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Region>> {
    let regions = &args.regions;
    let found =
        Region::intersection(&regions.value.all, ctx.tolerance, ctx.n_threads).at(regions.span)?;
    if found.is_empty() {
        regions.value.listed.warn_of_no_intersection(ctx, regions.span);
    }
    Ok(found)
}
