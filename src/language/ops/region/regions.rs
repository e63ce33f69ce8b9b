//! `regions`: what closed curves go around.

use super::nurbs;
use crate::{
    diag::{Result, Spanned},
    kernel::{Curve, Region},
    value::{At, Ctx, op},
};

op! {
    /// What an odd number of closed curves goes around, in one plane: outlines with their holes, sorted
    /// by what lies in what; the largest part first.
    ///
    /// Curves may cross themselves and one another, and run in either sense.
    regions in Region -> Vec<Region> {
        /// The closed curves.
        curves: Spanned<Vec<Curve>>,
    }
    example "regions([circle((0, 0), 1), circle((0, 0), 3), circle((0, 0), 2)])" => "[region with a hole, 2 arcs, region, 1 arc]";
    example "len(regions([polyline([(0, 0), (2, 2), (2, 0), (0, 2)], closed = true)]))" => "2";
    refuses "regions([circle((0, 0), 1), line((0, 0), (1, 0))])" => "E0607: `curves[1]` is not closed: its ends are 1 apart";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<Region>> {
    let curves = nurbs(&args.curves.value, args.curves.span)?;
    Region::even_odd(&curves, ctx.tolerance, ctx.n_threads).at(args.curves.span)
}
