//! `region`: what lies within a closed plane curve.

use std::sync::Arc;

use super::RealBorder;
use crate::{
    diag::{Result, Spanned},
    kernel::{NurbsCurve, Region, VariedRegion},
    value::{At, Ctx, RealRegion, op},
};

op! {
    /// What lies within a closed plane curve and outside of others, which are holes.
    ///
    /// A list of curves is joined first, as `join` does. The curves may run in either sense; seen from
    /// where the plane's normal points, which is up, borders run with the region to their left:
    /// `r.outer` counter-clockwise, `r.holes` clockwise. `r.plane` is the plane. Curves that cross or
    /// touch make no border; `regions` fills them by the even-odd rule, and `difference` cuts one
    /// region out of another. A parametric curve becomes a spline within 1e-13 of its size.
    region in Region -> RealRegion {
        /// The closed curve, or curves that are joined to one.
        outer: Spanned<RealBorder>,
        /// Closed curves within it.
        holes: Option<Spanned<Vec<RealBorder>>>,
    }
    example "region(circle((0, 0), 2))" => "region, 1 arc";
    example "area(region(circle((0, 0), 2), holes = [circle((0, 0), 1)])) ~= 3*pi" => "true";
    example "region([line((0, 0), (3, 0)), line((3, 0), (0, 4)), line((0, 4), (0, 0))]).outer.end" => "(0, 0, 0)";
    example "gradient(h => centroid(region(polyline([(0, 0), (3, 0), (0, h)], closed = true))).y, 6) ~= 1/3" => "true";
    refuses "region(line((0, 0), (1, 0)))" => "E0607: the curve is not closed: its ends are 1 apart";
    refuses "region(circle((0, 0), 1), holes = [circle((5, 0), 1)])" => "E0607: `curves[1]` is no hole: it does not lie within `curves[0]`";
    refuses "region(polyline([(0, 0), (2, 2), (2, 0), (0, 2)], closed = true))" => "E0607: the curve crosses or touches itself at (1, 1, 0)";
    picture "region(circle((0, 0), 3), holes = [circle((1, 0), 1), circle((-1.5, 0), 0.8)])";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<RealRegion> {
    let outer = args.outer;
    let holes = args.holes.unwrap_or(Spanned::new(Vec::new(), outer.span));
    let border = outer.value.plain.curve(outer.span, ctx)?;
    let curves = holes.value.iter().map(|hole| hole.plain.curve(holes.span, ctx));
    let curves: Vec<NurbsCurve> = curves.collect::<Result<_>>()?;
    let region = Arc::new(Region::new(&border, &curves, ctx.tolerance).at(holes.span)?);
    let borders = || std::iter::once(&outer.value).chain(&holes.value);
    let Some(n_variables) = borders().find_map(RealBorder::n_variables) else {
        return Ok(RealRegion::Plain(region));
    };
    let curves: Result<Vec<_>> =
        borders().map(|border| border.varied(n_variables, ctx.span)).collect();
    let varied = VariedRegion::new(region, curves?).at(ctx.span)?;
    Ok(RealRegion::Varied(Arc::new(varied)))
}
