//! `sweep`: what a region leaves behind along a path.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{Curve, Face, NurbsCurve, Region, Solid, SweepBuilder, Tolerance},
    ops::surface::{
        motion::{MotionArgs, Scale, Twist},
        sweep::{CornerOption, FrameOption, SweepGiven, framing, refused, tolerated},
        swept::warn,
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
        /// What happens at corners of the path: an error, or both sides meet in the plane that halves the angle.
        corner: CornerOption = CornerOption::Error,
        /// How far the sides may be from the true ones; the document's tolerance.
        tolerance: Option<Spanned<Length>>,
    }
    example "volume(sweep(region(circle((0, 0), 1, normal = (1, 0, 0))), line((0, 0), (5, 0)))) ~= 5*pi" => "true";
    example "volume(sweep(region(circle((0, 0), 1, normal = (1, 0, 0)), holes = [circle((0, 0), 0.5, normal = (1, 0, 0))]), circle((0, 0), 4))) ~= 6*pi^2 within 1e-4" => "true";
    refuses "sweep(region(circle((0, 0), 1)), line((0, 0), (5, 0)))" => "E0607: the region lies in another plane than x = 0, which is across the path: it leaves it by 1";
    scene r#"
        region r = region(circle((0, 0), 1, normal = (1, 0, 0)), holes = [circle((0, 0), 0.7, normal = (1, 0, 0))])
        solid pipe = sweep(r, bezier((0, 0, 0), (6, 0, 0), (6, 6, 0), (6, 6, 6)), tolerance = 1e-3)
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Solid> {
    let tolerance = tolerated(ctx, args.tolerance.as_ref())?;
    let span = args.r.span;
    let borders = args.r.value.borders().at(span)?;
    check_plane(&args.r.value, ctx.tolerance, span)?;
    let rule = framing(args.frame.value);
    let domain = args.path.value.domain();
    let kinks = args.scale.as_ref().map_or(Vec::new(), |scale| scale.value.breaks(domain));
    let is_moved = args.scale.is_some() || args.twist.is_some();
    if let (None, true) = (rule, is_moved) {
        let message = "\"translate\" takes no `scale` and no `twist`";
        return Diagnostic::error(Code::BadCall, args.frame.span, message).fail();
    }
    let given = |border: NurbsCurve| SweepGiven {
        section: Spanned::new(border.into(), span),
        path: args.path.span,
        up: args.up.as_ref().map_or(args.path.span, |up| up.span),
        rails: args.path.span,
        rule,
        tolerance,
    };
    let mut sides = Vec::with_capacity(borders.len());
    for border in borders {
        let given = given(border);
        let mut motion = MotionArgs {
            scale: args.scale.as_ref().map(|given| given.value.clone()),
            twist: args.twist.as_ref().map(|given| given.value.clone()),
            ctx: &mut *ctx,
            domain,
        };
        let (section, path) = (given.section.value.clone(), args.path.value.clone());
        let document = motion.ctx.tolerance;
        let mut builder = SweepBuilder::new(section, path, document).within(tolerance);
        builder = match rule {
            Some(rule) => builder.frames(rule),
            None => builder.translated(),
        };
        if let Some(up) = &args.up {
            builder = builder.up(up.value);
        }
        if args.corner == CornerOption::Miter {
            builder = builder.with_mitres();
        }
        if is_moved {
            builder = builder.moved(&mut motion, kinks.clone());
        }
        let made = match builder.sweep() {
            Ok(made) => made,
            Err(found) => return Err(refused(ctx, found, &given)),
        };
        warn(ctx, &made);
        sides.push(Face::whole(Arc::new(made.surface), ctx.tolerance).at(span)?);
    }
    Solid::capped(&sides, ctx.tolerance).at(ctx.span)
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
