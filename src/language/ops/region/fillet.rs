//! `fillet` of a region: corners rounded by arcs.

use glam::DVec3;

use super::Given;
use crate::{
    diag::{Result, Spanned},
    kernel::Region,
    ops::radius,
    value::{At, Ctx, Length, op},
};

op! {
    /// Region with its corners rounded by arcs that touch both sides: all corners, or those at points.
    ///
    /// Outer corners lose what is beyond the arc, inner ones gain it. Beside lines, arcs and any other
    /// curves the arc touches both to the last bits.
    fillet in Region -> Region {
        /// The region.
        r: Spanned<Given>,
        /// The radius of the arcs.
        radius: Spanned<Length>,
        /// Where the corners are; all when left out.
        at: Option<Spanned<Vec<DVec3>>>,
    }
    example "area(fillet(region(polyline([(0, 0), (4, 0), (4, 4), (0, 4)], closed = true)), 1)) ~= 12 + pi" => "true";
    refuses "fillet(region(polyline([(0, 0), (4, 0), (4, 4), (0, 4)], closed = true)), 5)" => "E0616: a circle of radius 5 does not fit at the corner (4, 0, 0): one up to 2 does";
    refuses "fillet(region(polyline([(0, 0), (4, 0), (4, 4), (0, 4)], closed = true)), 1, at = [(2, 0)])" => "E0607: there is no corner at (2, 0, 0): the nearest is 2 away";
    picture "fillet(region(polyline([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)], closed = true)), 0.4)";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Region> {
    let radius = radius("the radius", args.radius)?;
    let (at, span) = match &args.at {
        Some(points) => (Some(&points.value[..]), points.span),
        None => (None, args.radius.span),
    };
    args.r.value.filleted(radius, at, ctx.tolerance).at(span)
}
