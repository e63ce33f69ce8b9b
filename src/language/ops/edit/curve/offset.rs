//! `offset` of a curve: the curve beside it.

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{ConstructionReport, Curve, CurveIntersection, NurbsCurve, Offset, ReportEntry},
    value::{At, Ctx, Length, op, shortest},
};

op! {
    /// Curve at a distance beside another one, to the right of it seen against the normal: a curve
    /// that runs counter-clockwise about the normal grows for a positive distance.
    ///
    /// A parametric curve is first replaced by the spline that `length` tells of.
    /// Each point goes to C + d·(T × n) / |T × n|. Circular arcs and polygons in a plane normal to
    /// the normal have exact offsets, polygons with their corners kept; others are splines of
    /// degree 5 on the same parameters, proven to be nowhere further from the true offset than the
    /// document's tolerance. At other corners an arc is put in, with parameters of its own, so that
    /// the later ones move. Nothing is cut off: where the distance is a radius of curvature on the
    /// side of the centre, the offset has a cusp; where the curve turns to its side within the
    /// distance, it folds back and crosses itself. Warnings tell all that, and `report` has
    /// `{distance, deviation, cusps, folds, crossings}`: cusps and folds by parameters of the
    /// curve, crossings `{t, s, point}` by those of the offset.
    /// Maekawa, *An overview of offset curves and surfaces*, CAD 31 (1999).
    offset in Edit -> NurbsCurve {
        /// The curve.
        c: Curve,
        /// The distance; a negative one goes to the left.
        distance: Length,
        /// What the curve turns about.
        normal: Spanned<DVec3> = Spanned::unplaced(DVec3::Z),
    }
    example "offset(line((0, 0), (4, 0)), 1).points" => "[(0, -1, 0), (4, -1, 0)]";
    example "norm(offset(circle((0, 0), 2), 1)(0.3)) ~= 3 within 1e-15" => "true";
    example "offset(polyline((0, 0), (4, 0), (4, 4)), 1).points" => "[(0, -1, 0), (5, -1, 0), (5, 4, 0)]";
    refuses "offset(line((0, 0, 0), (0, 0, 4)), 1)" => "E0607: the curve runs along the normal at parameter 0, so that it has no side";
    refuses "offset(circle((0, 0), 2), -2)" => "E0607: the offset shrinks to a point: the distance is the radius 2 of the arc";
    picture "[for d in [-0.4, -0.2, 0, 0.2, 0.4]: offset(bezier((0, 0), (1, 3), (3, -2), (4, 1)), d)]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsCurve> {
    let Args { c, distance, normal } = args;
    let offset = c.offset(distance.0, normal.value, ctx.tolerance).at(normal.span_or(ctx.span))?;
    for (message, hint) in doubts(&offset) {
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
    let crossing = |meeting: &CurveIntersection| {
        let CurveIntersection { first, second, point } = *meeting;
        ConstructionReport::default().with("t", first).with("s", second).with("point", point)
    };
    let report = ConstructionReport::of("offset")
        .with("distance", ReportEntry::Length(distance.0))
        .with("deviation", ReportEntry::Length(offset.deviation))
        .with("cusps", offset.cusps)
        .with("folds", offset.folds)
        .with(
            "crossings",
            offset.crossings.iter().map(crossing).collect::<Vec<ConstructionReport>>(),
        );
    Ok(offset.curve.with_report(report))
}

/// What may be unexpected about an offset, each with what to do.
fn doubts(offset: &Offset) -> Vec<(String, &'static str)> {
    let mut doubts = Vec::new();
    if !offset.cusps.is_empty() {
        let message = format!(
            "the offset has a cusp at {}: the distance is the radius of curvature there",
            listed(&offset.cusps)
        );
        doubts.push((message, "between two cusps it runs backwards; a smaller distance has none"));
    }
    if offset.is_reversed {
        let message =
            "the offset runs backwards: the distance is larger than every radius of curvature";
        doubts
            .push((message.to_owned(), "a smaller distance stays on the near side of the centre"));
    }
    if !offset.folds.is_empty() {
        let message = format!(
            "the offset folds back near {}: the curve turns to its side there within the distance",
            listed(&offset.folds)
        );
        doubts.push((message, "a smaller distance folds less"));
    }
    let cut = "the loop between the two parameters of the offset is kept; `trim` takes it off, and \
               `report` has all places";
    if let Some(CurveIntersection { first, second, .. }) = offset.crossings.first() {
        let place = format!("t = {} and {}", shortest(*first), shortest(*second));
        let message = match offset.crossings.len() {
            1 => format!("the offset crosses itself at {place}"),
            n => format!("the offset crosses itself {n} times, first at {place}"),
        };
        doubts.push((message, cut));
    }
    if offset.is_tangled {
        let message = "the offset crosses itself in too many places to tell them";
        doubts.push((message.to_owned(), "a smaller distance leaves fewer"));
    }
    if let Some(stretch) = offset.overlap {
        let message = format!(
            "the offset runs along itself from t = {} to {}",
            shortest(stretch.start()),
            shortest(stretch.end())
        );
        doubts.push((message, "a slightly different distance keeps both sides apart"));
    }
    doubts
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
