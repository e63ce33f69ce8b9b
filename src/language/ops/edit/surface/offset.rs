//! `offset` of a surface: the surface beside it.

use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{ConstructionReport, NurbsSurface, ReportEntry, Surface},
    ops::positive,
    value::{At, Ctx, Length, op, rounded, shortest},
};

op! {
    /// Surface at a distance beside another one, on the side of its normal for a positive distance:
    /// the points S + d·N, on the same parameters.
    ///
    /// Exact, with the degrees, knots and weights of the surface, where that is possible: planes,
    /// spheres, cylinders, cones, tori. Others are quintic splines through points of the true
    /// offset, with knots added until its distance, measured at 16 places of each patch, is
    /// below half of the tolerance; `report` tells the largest with its parameters. At a pole the limit of the normal
    /// counts. A crease, and a place where the normal has no limit, are errors. Where the distance is
    /// beyond a radius of curvature on that side the offset turns back: it is kept, and a
    /// warning tells the tightest place.
    /// Piegl & Tiller, *Computing offsets of NURBS curves and surfaces*, CAD 31 (1999).
    offset in Edit -> NurbsSurface {
        /// The surface.
        s: Surface,
        /// The distance; a negative one goes against the normal.
        distance: Length,
        /// How far the result may be from the true offset.
        tolerance: Spanned<Length>,
    }
    example "offset(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), 3, 1e-6).points" => "[[(0, 0, 3), (0, 1, 3)], [(2, 0, 3), (2, 1, 3)]]";
    example "{ let s = ruled(circle((0, 0), 2), circle((0, 0, 1), 2))  norm(offset(s, 1, 1e-6)(0.3, 0)) ~= 3 within 1e-14 }" => "true";
    example "report(offset(bilinear((0, 0), (0, 1), (2, 0), (2, 1)), 3, 1e-6)).exact" => "true";
    refuses "offset(bspline([[(0, 0), (0, 1)], [(1, 0), (1, 1)], [(1, 0, 1), (1, 1, 1)]], degree = 1), 1, 0.01)" => "E0607: the surface has a crease at u = 0.5: its offset would be torn there by 1.414";
    refuses "offset(plane_patch((0, 0), (1, 0), (0, 1)), 1, 0)" => "E0607: the tolerance must be positive, found 0";
    picture "[bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]), offset(bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]]), 0.8, tolerance = 1e-3)]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let tolerance = positive("the tolerance", args.tolerance)?;
    let distance = args.distance.0;
    let offset = args.s.offset(distance, tolerance).at(ctx.span)?;
    if let Some(turn) = offset.turn {
        let [u, v] = turn.at.map(shortest);
        let message = format!(
            "the offset turns back near ({u}, {v}): the radius of curvature there is {}, within the distance {}",
            rounded(turn.radius),
            shortest(distance.abs()),
        );
        let hint = "a distance below the smallest radius on that side has no such place";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
    let deviation = ConstructionReport::default()
        .with("max", ReportEntry::Length(offset.deviation))
        .with("mean", ReportEntry::Length(offset.mean))
        .with("at", offset.at.to_vec());
    let mut report = ConstructionReport::of("offset")
        .with("exact", offset.is_exact)
        .with("deviation", deviation);
    if let Some(turn) = offset.turn {
        report = report
            .with("turns_back_at", turn.at.to_vec())
            .with("radius", ReportEntry::Length(turn.radius));
    }
    Ok(offset.surface.with_report(report))
}
