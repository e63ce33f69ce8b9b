//! `edge_surface`: the surface within two, three or four edges, however they lie.

use glam::DVec3;

use super::{
    boundary::{NamedEdge, edges, place, verb},
    with_area,
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{Blend, ConstructionReport, Curve, NurbsCurve, NurbsSurface, ReportEntry, aligned},
    value::{At, Ctx, op, rounded, shortest},
};

op! {
    /// Surface within two, three or four edges, in any order and direction.
    ///
    /// Two make a ruled surface, u along the first. Of three and four the ends must meet in a
    /// ring: these make a Coons surface, with the first edge at v = 0, u along it; opposite to it
    /// three have a corner, at which the edge v = 1 is collapsed. `report` tells the order and what
    /// was reversed. Parametric curves are converted within the document's tolerance.
    edge_surface in Surface -> NurbsSurface {
        /// The edges, two to four.
        curves: Spanned<Vec<Curve>>,
    }
    example "edge_surface([line((0, 0), (2, 0)), line((2, 2), (0, 2))])(0, 1)" => "(0, 2, 0)";
    example "edge_surface([line((0, 0), (2, 0)), line((0, 2), (2, 2)), line((2, 0), (2, 2)), line((0, 0), (0, 2))]).points" => "[[(0, 0, 0), (0, 2, 0)], [(2, 0, 0), (2, 2, 0)]]";
    example "edge_surface([line((0, 0), (2, 0)), line((2, 0), (0, 2)), line((0, 2), (0, 0))])(0.3, 1)" => "(0, 2, 0)";
    refuses "edge_surface([line((0, 0), (1, 0)), line((1, 0), (1, 1)), line((3, 3), (4, 4))])" => "E0609: the edges do not close: `reversed(curves[2])` ends at (3, 3, 0), and `curves[0]`, the nearest to it, starts at (0, 0, 0), 4.24264 apart, more than the tolerance 1e-6";
    refuses "edge_surface([line((0, 0), (1, 0))])" => "E0401: a surface has two, three or four edges, found 1";
    derivative shape;
    scene r#"
        curves around = [bezier((0, 0, 0), (2, 0, 3), (4, 0, 0)), line((4, 4, 0), (0, 4, 0)), bezier((4, 0, 0), (5, 2, 2), (4, 4, 0)), line((0, 4), (0, 0))] with (color = "red")
        surface s = edge_surface(around) with (color = "lightgray")
    "#;
}

/// The edges as they follow one another.
struct EdgeLoop {
    /// Index and whether it is run backwards.
    order: Vec<(usize, bool)>,
    gap: f64,
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let found = edges("curves", &args.curves, ctx)?;
    let ring = match found.len() {
        2 => facing(&found, ctx.tolerance.distance).at(ctx.span)?,
        3 | 4 => ring(&found),
        n => {
            let message = format!("a surface has two, three or four edges, found {n}");
            return Diagnostic::error(Code::BadCall, args.curves.span, message).fail();
        }
    };
    let oriented: Vec<NamedEdge> = ring
        .order
        .iter()
        .map(|&(idx, back)| if back { found[idx].reversed() } else { found[idx].clone() })
        .collect();
    let surface = match &oriented[..] {
        [low, high] => NurbsSurface::ruled(&low.curve, &high.curve).at(ctx.span)?,
        all => {
            check(all, args.curves.span, ctx.tolerance.distance)?;
            within(all).at(ctx.span)?
        }
    };
    let surface = with_area(ctx, surface);
    let order: Vec<usize> = ring.order.iter().map(|&(idx, _)| idx).collect();
    let reversed: Vec<usize> =
        ring.order.iter().filter(|&&(_, back)| back).map(|&(idx, _)| idx).collect();
    let report =
        ConstructionReport::of("edge_surface").with("order", order).with("reversed", reversed);
    Ok(surface.with_report(match found.len() {
        2 => report,
        _ => report.with("gap", ReportEntry::Length(ring.gap)),
    }))
}

/// The surface within edges that follow one another, each from the end of the one before.
fn within(ring: &[NamedEdge]) -> std::result::Result<NurbsSurface, crate::kernel::GeomError> {
    let [low, up] = [&ring[0].curve, &ring[1].curve];
    let down = ring[ring.len() - 1].curve.reversed();
    let high = match ring.len() {
        3 => NurbsCurve::bezier(&[up.end().midpoint(down.end())])?,
        _ => ring[2].curve.reversed(),
    };
    NurbsSurface::coons([low, &high], [&down, up], Blend::Linear)
}

/// Two edges in the direction in which their ends are nearer to one another, and closed ones in that in which
/// they run beside one another.
///
/// # Errors
/// Those of [`aligned`].
fn facing(
    found: &[NamedEdge],
    tolerance: f64,
) -> std::result::Result<EdgeLoop, crate::kernel::GeomError> {
    let [first, second] = [&found[0].curve, &found[1].curve];
    let is_back = if [first, second].iter().all(|curve| curve.is_closed(tolerance)) {
        aligned(second, first, true, tolerance)?.is_reversed
    } else {
        let between = |i: usize, back: bool| {
            apart(found[0].end(i), found[1].end(if back { 1 - i } else { i }))
        };
        let both = |back: bool| libm::hypot(between(0, back), between(1, back));
        both(true) < both(false)
    };
    Ok(EdgeLoop { order: vec![(0, false), (1, is_back)], gap: 0.0 })
}

/// The order and directions in which the widest gap between an end and the next start is least;
/// the first of them among equals.
fn ring(found: &[NamedEdge]) -> EdgeLoop {
    let orders: &[&[usize]] = match found.len() {
        3 => &[&[1, 2], &[2, 1]],
        _ => &[&[1, 2, 3], &[3, 2, 1], &[2, 1, 3], &[2, 3, 1], &[1, 3, 2], &[3, 1, 2]],
    };
    let of = |rest: &[usize], directions: usize| {
        let back = |k: usize| directions & (1 << k) != 0;
        let rest = rest.iter().enumerate().map(|(k, &idx)| (idx, back(k)));
        let order: Vec<(usize, bool)> = [(0, false)].into_iter().chain(rest).collect();
        let gap = gaps(found, &order).into_iter().fold(0.0, f64::max);
        EdgeLoop { order, gap }
    };
    // There is always one, however far apart the ends are.
    let mut best = of(orders[0], 0);
    for rest in orders {
        for directions in 0..1_usize << rest.len() {
            let ring = of(rest, directions);
            if ring.gap < best.gap {
                best = ring;
            }
        }
    }
    best
}

/// The distance of two places, also where its square is beyond the numbers.
fn apart(a: DVec3, b: DVec3) -> f64 {
    let way = b - a;
    let (plain, scale) = (way.length(), way.abs().max_element());
    if plain.is_finite() || !scale.is_finite() { plain } else { scale * (way / scale).length() }
}

/// From each edge to the next.
fn gaps(found: &[NamedEdge], order: &[(usize, bool)]) -> Vec<f64> {
    let end = |&(idx, back): &(usize, bool), which: usize| {
        found[idx].end(if back { 1 - which } else { which })
    };
    let next = order.iter().cycle().skip(1);
    order.iter().zip(next).map(|(edge, next)| apart(end(edge, 1), end(next, 0))).collect()
}

/// Fails unless each edge starts where the one before ends.
fn check(ring: &[NamedEdge], span: crate::diag::Span, tolerance: f64) -> Result<()> {
    let next = ring.iter().cycle().skip(1);
    let widest = ring.iter().zip(next).max_by(|a, b| {
        let gap = |(edge, next): &(&NamedEdge, &NamedEdge)| apart(edge.end(1), next.end(0));
        gap(a).total_cmp(&gap(b))
    });
    let Some((edge, next)) = widest else { return Ok(()) };
    let gap = apart(edge.end(1), next.end(0));
    if gap <= tolerance {
        return Ok(());
    }
    let message = format!(
        "the edges do not close: `{}` {} at {}, and `{}`, the nearest to it, {} at {}, {} apart, more than the tolerance {}",
        edge.name,
        verb(1),
        place(edge.end(1)),
        next.name,
        verb(0),
        place(next.end(0)),
        rounded(gap),
        shortest(tolerance)
    );
    Diagnostic::error(Code::Gap, span, message)
        .hint("three or four edges make a ring in which each shares both its ends with others")
        .fail()
}
