//! `region`: what lies within a closed plane curve.

use super::Border;
use crate::{
    diag::{Result, Spanned},
    kernel::{NurbsCurve, Region},
    value::{At, Ctx, op},
};

op! {
    /// What lies within a closed plane curve and outside of others, which are holes.
    ///
    /// A list of curves is joined first, as `join` does. The curves may run in either sense; seen from
    /// where the plane's normal points, which is up, borders run with the region to their left:
    /// `r.outer` counter-clockwise, `r.holes` clockwise. `r.plane` is the plane. Curves that cross or
    /// touch make no border; `regions` fills them by the even-odd rule, and `difference` cuts one
    /// region out of another. A parametric curve becomes a spline within 1e-13 of its size.
    region in Region -> Region {
        /// The closed curve, or curves that are joined to one.
        outer: Spanned<Border>,
        /// Closed curves within it.
        holes: Option<Spanned<Vec<Border>>>,
    }
    example "region(circle((0, 0), 2))" => "region, 1 arc";
    example "area(region(circle((0, 0), 2), holes = [circle((0, 0), 1)])) ~= 3*pi" => "true";
    example "region([line((0, 0), (3, 0)), line((3, 0), (0, 4)), line((0, 4), (0, 0))]).outer.end" => "(0, 0, 0)";
    refuses "region(line((0, 0), (1, 0)))" => "E0607: the curve is not closed: its ends are 1 apart";
    refuses "region(circle((0, 0), 1), holes = [circle((5, 0), 1)])" => "E0607: `curves[1]` is no hole: it does not lie within `curves[0]`";
    refuses "region(polyline([(0, 0), (2, 2), (2, 0), (0, 2)], closed = true))" => "E0607: the curve crosses or touches itself at (1, 1, 0)";
    picture "region(circle((0, 0), 3), holes = [circle((1, 0), 1), circle((-1.5, 0), 0.8)])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Region> {
    let outer = args.outer;
    let border = outer.value.curve(outer.span, ctx)?;
    let Some(holes) = args.holes else {
        return Region::new(&border, &[], ctx.tolerance).at(outer.span);
    };
    let curves = holes.value.iter().map(|hole| hole.curve(holes.span, ctx));
    let curves: Vec<NurbsCurve> = curves.collect::<Result<_>>()?;
    Region::new(&border, &curves, ctx.tolerance).at(holes.span)
}
