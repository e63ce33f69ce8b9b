//! `offset` of a curve: the curve beside it.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{NurbsCurve, Receipt},
    value::{At, Ctx, Length, op, shortest},
};

op! {
    /// Curve at a distance beside another one, to the right of it seen against the normal: a curve
    /// that runs counter-clockwise about the normal grows for a positive distance.
    ///
    /// Each point goes to C + d·(T × n) / |T × n|. Circular arcs and polygons in a plane normal to
    /// the normal have exact offsets, polygons with their corners kept; others are splines of
    /// degree 5 on the same parameters, nowhere further from the true offset than the document's
    /// tolerance. At other corners an arc is put in. Where the distance is a radius of curvature on
    /// the side of the centre, the offset has a cusp: it is kept, and a warning tells the
    /// parameters. Maekawa, *An overview of offset curves and surfaces*, CAD 31 (1999).
    offset in Edit -> NurbsCurve {
        /// The curve.
        c: Arc<NurbsCurve>,
        /// The distance; a negative one goes to the left.
        distance: Length,
        /// What the curve turns about.
        normal: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
    }
    example "offset(line((0, 0), (4, 0)), 1).points" => "[(0, -1, 0), (4, -1, 0)]";
    example "norm(offset(circle((0, 0), 2), 1)(0.3)) ~= 3 within 1e-15" => "true";
    example "offset(polyline((0, 0), (4, 0), (4, 4)), 1).points" => "[(0, -1, 0), (5, -1, 0), (5, 4, 0)]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let Args { c, distance, normal } = args;
    let offset = c.offset(distance.0, normal.value, ctx.tolerance).at(normal.span_or(ctx.span))?;
    if !offset.cusps.is_empty() {
        let message = format!(
            "the offset has a cusp at {}: the distance is the radius of curvature there",
            listed(&offset.cusps)
        );
        let hint = "between two cusps it runs backwards; a smaller distance has none";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
    if !offset.crossings.is_empty() {
        let message = format!(
            "the offset crosses itself near {}: the curve turns to its side there within the distance",
            listed(&offset.crossings)
        );
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message));
    }
    let receipt = Receipt::of("offset")
        .with("distance", distance.0)
        .with("deviation", offset.deviation)
        .with("cusps", offset.cusps)
        .with("crossings", offset.crossings);
    Ok(offset.curve.with_receipt(receipt))
}

/// `t = 0.25, 0.75 and 3 more`.
fn listed(parameters: &[f64]) -> String {
    const MOST: usize = 6;
    let shown: Vec<String> = parameters.iter().take(MOST).map(|&t| shortest(t)).collect();
    match parameters.len().checked_sub(MOST + 1) {
        None => format!("t = {}", shown.join(", ")),
        Some(more) => format!("t = {} and {} more", shown.join(", "), more + 1),
    }
}
