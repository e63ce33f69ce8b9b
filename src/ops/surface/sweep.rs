//! `sweep`: the surface that a section leaves behind along a path.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::{
    motion::{MotionArgs, Rails, Scale, Twist},
    ribbon::warn_of_ribbon,
    section::nurbs_within,
    swept::{warn, warn_of_corners, warn_of_short_legs, with_report},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Columns, ConstructionReport, Curve, FitError, FrameRule, Frames, GeomError, InputError,
        NurbsCurve, NurbsSurface, PathLeg, Side, Sweep, SweepResolution, ceiling::PIECES, legs,
        mitred, overreaches, swept, translated,
    },
    value::{At, Choice, Ctx, Length, op, shortest},
};

op! {
    /// Surface that a section leaves behind along a path: u along the section, v along the path,
    /// with the path's parameter.
    ///
    /// The section's x lies along the path, its y and z across it, its origin on it. Its z is up
    /// and its y to the left of the way: z starts as near to `up` as can be, and goes on as `frame`
    /// says. "translate"
    /// only moves it: exact. "fixed" keeps z as near to `up` as can be; "frenet" takes the path's
    /// binormal for z; "rotation_minimizing" never turns it about the path; "projection" carries z
    /// on by projecting it from place to place, as the places come ever closer: in that limit it
    /// does not turn about the path either, and both are one. Along a closed path the angle by
    /// which these miss their start is spread over the length. With `keep_path` the path is met
    /// exactly (the isocurve of a section's point at the origin); without it the surface is a cubic
    /// skin through placements of the section, and has weights only where the section does. The rest
    /// is within the tolerance of the true surface, measured at 36 places between two knots after half
    /// of the tolerance is kept at fewer; a number of `sections` is kept instead, and `report` tells
    /// the deviation. Where the section reaches beyond the centre of curvature, shrinks to
    /// nothing between the ends, or lies along the path and covers a strip twice, a warning says so.
    /// Piegl & Tiller, *The NURBS Book*, §10.4, A10.1, A10.2; Wang, Jüttler, Zheng & Liu,
    /// *Computation of rotation minimizing frames* (2008); Bloomenthal & Riesenfeld,
    /// *Approximation of sweep surfaces by tensor product NURBS* (1991).
    sweep in Surface -> NurbsSurface {
        /// The section.
        section: Spanned<Curve>,
        /// The path, without cusps.
        path: Spanned<Curve>,
        /// How the section turns with the path.
        frame: Spanned<FrameOption> = Spanned::unplaced(FrameOption::RotationMinimizing),
        /// The size along the way: a factor, one for each axis as a point, a list of these at even
        /// parameters with straight lines between, or a function of v.
        scale: Option<Spanned<Scale>>,
        /// The turn about the path: an angle that is reached at the end, or a function of v.
        twist: Option<Spanned<Twist>>,
        /// Where z points at the start; (0, 0, 1), or (1, 0, 0) where the path starts along it.
        up: Option<Spanned<DVec3>>,
        /// A curve that z points to, at the same fraction of its domain; or two, along which both
        /// ends of the section run, which is turned and sized for that.
        rail: Option<Spanned<Rails>>,
        /// What happens at corners of the path: an error, or both sides meet in the plane that
        /// halves the angle; straight legs stay prisms, bent ones are sheared near the corner.
        corner: CornerOption = CornerOption::Error,
        /// Whether the path itself is met exactly.
        keep_path: bool = true,
        /// How many placements of the section make the surface, instead of a tolerance; with
        /// `keep_path` no fewer than the path has control points, without it at even parameters.
        sections: Option<Spanned<usize>>,
        /// What the surface is made of: it passes through "placements" of the section; or
        /// "offsets" of the path's control points by those of the section, which take more columns
        /// and never swing out.
        method: Spanned<SweepMethod> = Spanned::unplaced(SweepMethod::Placements),
        /// How far the surface may be from the true one; the document's tolerance.
        tolerance: Option<Spanned<Length>>,
    }
    example "sweep(circle((0, 0, 0), 1, normal = (1, 0, 0)), line((0, 0), (5, 0)))(0, 0.5)" => "(2.5, 1, 0)";
    example "sweep(bezier((0, 0), (1, 1), (2, 0)), line((0, 0), (0, 0, 3)), frame = \"translate\")(0.5, 1)" => "(1, 0.5, 3)";
    example "norm(sweep(circle((0, 0), 1, normal = (1, 0, 0)), circle((0, 0), 4))(0, 0.25) - (0, 3, 0)) < 1e-14" => "true";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), polyline((0, 0), (5, 0), (5, 5)))" => "E0607: the path has a corner at parameter 1";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), line((0, 0), (5, 0)), frame = \"frenet\")" => "E0607: the curve is straight at parameter 0: there is no frenet frame";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), line((0, 0), (5, 0)), scale = 0)" => "E0607: the section is scaled to a point all along the path";
    refuses "sweep(circle((0, 0), 1, normal = (1, 0, 0)), circle((0, 0), 4), keep_path = false, method = \"offsets\")" => "E0401: \"offsets\" of the path's control points meet the path, which `keep_path = false` gives up";
    scene r#"
        // The section stands in the plane of y (green, to the left of the way) and z (blue, up);
        // its x (red) lies along the path. Blue marks along the way show where its z went.
        let flag = polyline((0, 0, 0), (0, 0, 2), (0, 1, 1.5), (0, 0, 1))
        curve path = bezier((0, 0, 0), (4, 0, 0), (6, 3, 0), (6, 8, 2)) with (color = "black")
        surface s = sweep(flag, path, tolerance = 1e-3) with (color = "lightgray")
        curves up = [for v in linspace(0.25, 1, 4): line(s(0, v), s(1, v))] with (color = "blue")
        curve section = flag with (color = "orange")
        curve x = line((0, 0, 0), (2.5, 0, 0)) with (color = "red")
        curve y = line((0, 0, 0), (0, 2.5, 0)) with (color = "green")
        curve z = line((0, 0, 0), (0, 0, 2.5)) with (color = "blue")
    "#;
}

/// What the surface is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SweepMethod {
    Placements,
    Offsets,
}

impl Choice for SweepMethod {
    const WORDS: &'static [&'static str] = &["placements", "offsets"];
    const MEANINGS: &'static [Self] = &[Self::Placements, Self::Offsets];
}

/// How a section turns with its path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FrameOption {
    Translate,
    Fixed,
    Frenet,
    Projection,
    RotationMinimizing,
}

impl Choice for FrameOption {
    const WORDS: &'static [&'static str] =
        &["translate", "fixed", "frenet", "projection", "rotation_minimizing"];
    const MEANINGS: &'static [Self] =
        &[Self::Translate, Self::Fixed, Self::Frenet, Self::Projection, Self::RotationMinimizing];
}

/// What happens at corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CornerOption {
    Error,
    Miter,
}

impl Choice for CornerOption {
    const WORDS: &'static [&'static str] = &["error", "miter"];
    const MEANINGS: &'static [Self] = &[Self::Error, Self::Miter];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let tolerance = tolerated(ctx, args.tolerance.as_ref())?;
    let (section_span, path_span) = (args.section.span, args.path.span);
    let section = nurbs_within(&args.section.value, 0.5 * tolerance).at(section_span)?;
    let path = nurbs_within(&args.path.value, 0.5 * tolerance).at(path_span)?;
    if section.is_point() {
        let message = "the section is one point";
        return Diagnostic::error(Code::Degenerate, section_span, message).fail();
    }
    let corners = corners(ctx, &path, path_span, args.corner)?;
    warn_of_ribbon(ctx, &section, (args.frame.value == FrameOption::Translate).then_some(&*path));
    if args.frame.value == FrameOption::Translate {
        unmoved(&args, "\"translate\"")?;
        let report = ConstructionReport::of("sweep").with("frame", "translate").with("exact", true);
        return Ok(translated(&section, &path).at(path_span)?.with_report(report));
    }
    let start = path.tangent_at(path.domain().start(), Side::Right).at(path_span)?;
    let up = args.up.unwrap_or_else(|| {
        let is_along = start.cross(DVec3::Z).length() <= ctx.tolerance.angle;
        Spanned::new(if is_along { DVec3::X } else { DVec3::Z }, path_span)
    });
    let is_ring = path.is_closed(ctx.tolerance.distance);
    let is_smooth = is_ring && is_smooth_at_seam(&path, path_span)?;
    let is_moved = args.scale.is_some() || args.twist.is_some() || args.rail.is_some();
    let is_polygon = path.degree() == 1 && !path.is_rational();
    if !corners.is_empty()
        && is_polygon
        && !is_moved
        && framing(args.frame.value) == FrameRule::RotationMinimizing
    {
        let report = ConstructionReport::of("sweep").with("corners", corners).with("exact", true);
        let surface = mitred(&section, &path, up.value, is_ring).at(up.span)?;
        warn_of_short_legs(ctx, overreaches(&surface, &path));
        return Ok(surface.with_report(report));
    }

    let has_corner_at_seam = is_ring && !is_smooth && args.corner == CornerOption::Miter;
    let legs = if corners.is_empty() && !has_corner_at_seam {
        vec![(NurbsCurve::clone(&path), framed(&path, args.frame.value, up, is_smooth)?)]
    } else {
        let (rule, reach) = (framing(args.frame.value), reach(&section));
        legs(&path, &corners, rule, up.value, has_corner_at_seam, reach).at(up.span)?
    };
    let fineness = fineness(ctx, &args, tolerance)?;
    let rails = rails(args.rail.as_ref(), &section, tolerance)?;
    let breaks = args.scale.as_ref().map_or(Vec::new(), |scale| scale.value.breaks(path.domain()));
    let motion = MotionArgs {
        ctx: &mut *ctx,
        scale: args.scale.map(|given| given.value),
        twist: args.twist.map(|given| given.value),
        rails,
        ends: [section.start(), section.end()],
        domain: path.domain(),
    };
    let sweeps = each_swept(&section, &legs, motion, &breaks, fineness)?;
    for (sweep, (_, frames)) in sweeps.iter().zip(&legs) {
        warn(ctx, sweep, frames);
    }
    warn_of_corners(ctx, &legs, reach(&section));
    with_report(sweeps, &legs, corners, ctx)
}

/// The sweep along each part of the path.
fn each_swept(
    section: &NurbsCurve,
    legs: &[PathLeg],
    mut motion: MotionArgs<'_, '_>,
    breaks: &[f64],
    fineness: SweepResolution,
) -> Result<Vec<Sweep>> {
    let span = motion.ctx.span;
    let mut sweeps = Vec::with_capacity(legs.len());
    for (part, frames) in legs {
        let domain = part.domain();
        let is_inside = |t: &f64| domain.start() < *t && *t < domain.end();
        let breaks: Vec<f64> = breaks.iter().copied().filter(is_inside).collect();
        sweeps.push(match swept(section, part, frames, &mut motion, &breaks, fineness) {
            Err(GeomError::Fit(FitError::ToleranceNotKept { found, .. })) => {
                let message = format!(
                    "{PIECES} placements of the section do not keep the tolerance {}: the surface is still {} off",
                    shortest(2.0 * fineness.tolerance),
                    shortest(found)
                );
                return Diagnostic::error(Code::BeyondTolerance, span, message)
                    .hint("allow a larger `tolerance`, or say with `sections` how many are enough")
                    .fail();
            }
            made => made.at(span)?,
        });
    }
    Ok(sweeps)
}

/// Points of the section that are looked at.
const N_POINTS: usize = 257;

/// How far the section reaches from the path.
fn reach(section: &NurbsCurve) -> f64 {
    section.sample(N_POINTS).iter().map(|p| DVec2::new(p.y, p.z).length()).fold(0.0, f64::max)
}

/// The rails as NURBS; a section between two has two ends.
fn rails(
    given: Option<&Spanned<Rails>>,
    section: &NurbsCurve,
    tolerance: f64,
) -> Result<Vec<Arc<NurbsCurve>>> {
    let Some(given) = given else { return Ok(Vec::new()) };
    if matches!(given.value, Rails::Two(_)) && section.is_closed(tolerance) {
        let message = "the section ends where it begins, so that two rails cannot hold its ends";
        return Diagnostic::error(Code::Degenerate, given.span, message)
            .hint("`split` the section, or give one rail, to which z points")
            .fail();
    }
    let nurbs = |rail: &Curve| nurbs_within(rail, tolerance).at(given.span);
    given.value.curves().iter().map(nurbs).collect()
}

/// The tolerance that is given, or the document's.
pub(super) fn tolerated(ctx: &Ctx<'_>, given: Option<&Spanned<Length>>) -> Result<f64> {
    match given {
        Some(given) if given.value.0 <= 0.0 => {
            let error = GeomError::Input(InputError::NotPositive {
                what: "the tolerance",
                got: given.value.0,
            });
            Err(error).at(given.span)
        }
        Some(given) => Ok(given.value.0),
        None => Ok(ctx.tolerance.distance),
    }
}

/// Fails where a section is to be moved in a way that the sweep does not have.
fn unmoved(args: &Args, what: &str) -> Result<()> {
    let moves = [
        args.scale.as_ref().map(|given| ("scale", given.span)),
        args.twist.as_ref().map(|given| ("twist", given.span)),
        args.rail.as_ref().map(|given| ("rail", given.span)),
    ];
    match moves.into_iter().flatten().next() {
        None => Ok(()),
        Some((name, span)) => {
            let message = format!("{what} takes no `{name}`");
            Diagnostic::error(Code::BadCall, span, message).fail()
        }
    }
}

const fn framing(frame: FrameOption) -> FrameRule {
    match frame {
        FrameOption::Fixed => FrameRule::Fixed,
        FrameOption::Frenet => FrameRule::Frenet,
        // The limit of ever more projections.
        FrameOption::Projection | FrameOption::RotationMinimizing | FrameOption::Translate => {
            FrameRule::RotationMinimizing
        }
    }
}

fn framed(
    path: &NurbsCurve,
    frame: FrameOption,
    up: Spanned<DVec3>,
    is_closed: bool,
) -> Result<Frames> {
    let rule = framing(frame);
    Frames::new(path, rule, up.value, is_closed).at(up.span).map_err(|found| {
        let hint = "`frame = \"rotation_minimizing\"` needs no bend, and `up` only at the start";
        let needs_more = matches!(rule, FrameRule::Frenet | FrameRule::Fixed);
        if needs_more { Box::new(found.hint(hint)) } else { found }
    })
}

/// How fine the sweep is to be, of which half is left for the curves.
fn fineness(ctx: &Ctx<'_>, args: &Args, tolerance: f64) -> Result<SweepResolution> {
    Ok(SweepResolution {
        n_sections: counted(ctx, args.sections)?,
        tolerance: 0.5 * tolerance,
        keeps_path: args.keep_path,
        columns: columns(args.method, args.keep_path)?,
    })
}

/// What the columns are to be, which offsets of a path that is not met cannot be.
fn columns(method: Spanned<SweepMethod>, keeps_path: bool) -> Result<Columns> {
    match (method.value, keeps_path) {
        (SweepMethod::Placements, _) => Ok(Columns::Through),
        (SweepMethod::Offsets, true) => Ok(Columns::Offset),
        (SweepMethod::Offsets, false) => {
            let message = "\"offsets\" of the path's control points meet the path, which `keep_path = false` gives up";
            Diagnostic::error(Code::BadCall, method.span, message)
                .hint("leave out `keep_path`, or `method`")
                .fail()
        }
    }
}

/// How many placements are asked for.
fn counted(ctx: &Ctx<'_>, sections: Option<Spanned<usize>>) -> Result<Option<usize>> {
    match sections {
        Some(given) if given.value < 2 => {
            let message = format!("a sweep needs 2 placements or more, found {}", given.value);
            Diagnostic::error(Code::BadCall, given.span, message).fail()
        }
        Some(given) if PIECES.min(ctx.limits.list_length) < given.value => {
            let message =
                format!("{} placements are more than the {PIECES} that a sweep takes", given.value);
            Diagnostic::error(Code::TooLarge, given.span, message).fail()
        }
        given => Ok(given.map(|given| given.value)),
    }
}

/// The corners of the path, if they are to be mitred.
fn corners(ctx: &Ctx<'_>, path: &NurbsCurve, span: Span, corner: CornerOption) -> Result<Vec<f64>> {
    if path.is_point() {
        let message = "the path is one point, so that it leads nowhere";
        return Diagnostic::error(Code::Degenerate, span, message).fail();
    }
    path.check_connected().at(span)?;
    if let Some(&t) = path.cusps(ctx.tolerance).first() {
        let message =
            format!("the path has a cusp at parameter {}, where it has no direction", shortest(t));
        return Diagnostic::error(Code::Degenerate, span, message)
            .hint("`split` it there, and sweep along both parts")
            .fail();
    }
    let corners = path.corners(ctx.tolerance);
    if corner == CornerOption::Miter || corners.is_empty() {
        return Ok(corners);
    }
    let at: Vec<String> = corners.iter().copied().map(shortest).collect();
    let message = match &at[..] {
        [only] => format!("the path has a corner at parameter {only}"),
        many => {
            format!("the path has {} corners, at the parameters {}", many.len(), many.join(", "))
        }
    };
    Diagnostic::error(Code::Degenerate, span, message)
        .hint("`corner = \"miter\"` lets both sides meet in the plane that halves the angle; or round the path, or `split` it there")
        .fail()
}

/// Whether a closed path arrives in the direction in which it left.
fn is_smooth_at_seam(path: &NurbsCurve, span: Span) -> Result<bool> {
    const SMOOTH: f64 = crate::kernel::tolerance::TURN_RELATIVE;
    let domain = path.domain();
    let start = path.tangent_at(domain.start(), Side::Right).at(span)?;
    let end = path.tangent_at(domain.end(), Side::Left).at(span)?;
    Ok(start.distance(end) <= SMOOTH)
}
