//! `sweep`: what a region leaves behind along a path.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, Face, Region, Solid, Tolerance},
    ops::solid::walls::of_walls,
    ops::surface::{
        motion::{Rails, Scale, Twist},
        sweep_options::{CornerOption, FrameOption, SweepMethod, SweepOptions},
    },
    value::{At, Ctx, Length, op, shortest},
};

op! {
    /// Solid that a region leaves behind along a path, with both ends closed by the region as it stands there; along a
    /// closed path there are none, unless it comes back in another size.
    ///
    /// The region lies across the path, in the plane x = 0, as the section of a swept surface does: its y is to the left
    /// of the way and its z up, its origin on the path. Each of its borders leaves the surface behind that `sweep` of it
    /// makes, holes too.
    sweep in Solid -> Solid {
        /// The region, in the plane x = 0.
        r: Spanned<Arc<Region>>,
        /// The path, without cusps.
        path: Spanned<Curve>,
        /// How the region turns with the path.
        frame: Spanned<FrameOption> = Spanned::unplaced(FrameOption::RotationMinimizing),
        /// The size along the way: a factor, one for each axis as a point, a list of these at even
        /// parameters with straight lines between, or a function of v.
        scale: Option<Spanned<Scale>>,
        /// The turn about the path: an angle that is reached at the end, or a function of v.
        twist: Option<Spanned<Twist>>,
        /// Where z points at the start; (0, 0, 1), or (1, 0, 0) where the path starts along it.
        up: Option<Spanned<DVec3>>,
        /// A curve that z points to, at the same fraction of its domain.
        rail: Option<Spanned<Curve>>,
        /// What happens at corners of the path: an error, or both sides meet in the plane that halves the angle.
        corner: CornerOption = CornerOption::Error,
        /// Whether the path itself is met exactly.
        keep_path: bool = true,
        /// How many placements of the region make the sides, instead of a tolerance; with `keep_path` no fewer than
        /// the path has control points, without it at even parameters.
        sections: Option<Spanned<usize>>,
        /// What the sides are made of: they pass through "placements" of the borders; or "offsets" of the path's control
        /// points by those of the borders, which take more columns and never swing out.
        method: Spanned<SweepMethod> = Spanned::unplaced(SweepMethod::Placements),
        /// How far the sides may be from the true ones; the document's tolerance.
        tolerance: Option<Spanned<Length>>,
    }
    example "volume(sweep(region(circle((0, 0), 1, normal = (1, 0, 0))), line((0, 0), (5, 0)))) ~= 5*pi" => "true";
    example "volume(sweep(region(circle((0, 0), 1, normal = (1, 0, 0)), holes = [circle((0, 0), 0.5, normal = (1, 0, 0))]), circle((0, 0), 4))) ~= 6*pi^2 within 1e-4" => "true";
    example "volume(sweep(region(polyline((0, -1, -1), (0, 1, -1), (0, 1, 1), (0, -1, 1), closed = true)), line((0, 0), (5, 0)), rail = line((0, 0, 2), (5, 2, 0)))) ~= 20 within 1e-4" => "true";
    refuses "sweep(region(circle((0, 0), 1)), line((0, 0), (5, 0)))" => "E0607: the region lies in another plane than x = 0, which is across the path: it leaves it by 1";
    scene r#"
        region r = region(circle((0, 0), 1, normal = (1, 0, 0)), holes = [circle((0, 0), 0.7, normal = (1, 0, 0))])
        solid pipe = sweep(r, bezier((0, 0, 0), (6, 0, 0), (6, 6, 0), (6, 6, 6)), tolerance = 1e-3)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Solid> {
    let span = args.r.span;
    let borders = args.r.value.borders().at(span)?;
    check_plane(&args.r.value, ctx.tolerance, span)?;
    let options = SweepOptions {
        path: args.path,
        frame: args.frame.value,
        scale: args.scale,
        twist: args.twist,
        up: args.up,
        rail: args.rail.map(|rail| Spanned::new(Rails::One(rail.value), rail.span)),
        corner: args.corner,
        keeps_path: args.keep_path,
        sections: args.sections,
        method: args.method,
        tolerance: args.tolerance,
    };
    let mut sides = Vec::with_capacity(borders.len());
    for border in borders {
        let side = options.surface(ctx, &Spanned::new(border.into(), span))?;
        sides.push(Face::whole(Arc::new(side), ctx.tolerance).at(span)?);
    }
    let made = Solid::capped(&sides, ctx.tolerance);
    of_walls(
        ctx,
        made,
        ctx.span,
        "a smaller region, or a path that bends less and keeps away from itself, does not",
    )
}

/// # Errors
/// A region that lies along the path.
fn check_plane(region: &Region, tolerance: Tolerance, span: Span) -> Result<()> {
    let bounds = region.bounds();
    let off = bounds.min.x.abs().max(bounds.max.x.abs());
    if off <= tolerance.distance_for(bounds.diagonal()) {
        return Ok(());
    }
    let message = format!(
        "the region lies in another plane than x = 0, which is across the path: it leaves it by {}",
        shortest(off)
    );
    Diagnostic::error(Code::Degenerate, span, message)
        .hint("draw it with y to the left of the way and z up, such as circles with `normal = (1, 0, 0)`")
        .fail()
}
