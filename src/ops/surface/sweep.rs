//! `sweep`: the surface that a section leaves behind along a path.

use glam::DVec3;

use super::{
    motion::{Given, Scale, Twist},
    section::nurbs_within,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Curve, Fineness, Frames, Framing, GeomError, NurbsCurve, NurbsSurface, Receipt, Side,
        Sweep, mitred, swept, translated,
    },
    value::{At, Choice, Ctx, Length, op, shortest},
};

op! {
    /// Surface that a section leaves behind along a path: u along the section, v along the path,
    /// with the path's parameter.
    ///
    /// The section's x lies along the path, its y and z across it, its origin on it. "translate"
    /// only moves it: exact. "fixed" keeps z as near to `up` as can be; "frenet" takes the path's
    /// binormal for z; "projection" carries z on by projecting it from place to place;
    /// "rotation_minimizing" never turns it about the path. Along a closed path the angle by which
    /// the last two miss their start is spread over the length. With `keep_path` the path is met
    /// exactly (the isocurve of a section's point at the origin). The rest is within the tolerance
    /// of the true surface, measured at eight places between two knots.
    /// Piegl & Tiller, *The NURBS Book*, §10.4; Wang, Jüttler, Zheng & Liu, *Computation of
    /// rotation minimizing frames* (2008).
    sweep in Surface -> NurbsSurface {
        /// The section.
        section: Spanned<Curve>,
        /// The path, without cusps.
        path: Spanned<Curve>,
        /// How the section turns with the path.
        frame: Spanned<Frame> = Spanned::unplaced(Frame::RotationMinimizing),
        /// The size along the way: a factor, one for each axis as a point, a list of these at even
        /// parameters with straight lines between, or a function of v.
        scale: Option<Spanned<Scale>>,
        /// The turn about the path: an angle that is reached at the end, or a function of v.
        twist: Option<Spanned<Twist>>,
        /// Where z points at the start; (0, 0, 1), or (1, 0, 0) where the path starts along it.
        up: Option<Spanned<DVec3>>,
        /// A curve that z points to, at the same fraction of its domain.
        rail: Option<Spanned<Curve>>,
        /// What happens at corners of the path; "miter" is for polygons.
        corner: Corner = Corner::Error,
        /// Whether the path itself is met exactly.
        keep_path: bool = true,
        /// How many placements of the section make the surface, instead of a tolerance.
        sections: Option<Spanned<usize>>,
        /// How far the surface may be from the true one; the document's tolerance.
        tolerance: Option<Spanned<Length>>,
    }
    example "sweep(circle((0, 0, 0), 1, normal = (1, 0, 0)), line((0, 0), (5, 0)))(0, 0.5)" => "(2.5, 1, 0)";
    example "sweep(bezier((0, 0), (1, 1), (2, 0)), line((0, 0), (0, 0, 3)), frame = \"translate\")(0.5, 1)" => "(1, 0.5, 3)";
    example "norm(sweep(circle((0, 0), 1, normal = (1, 0, 0)), circle((0, 0), 4))(0, 0.25) - (0, 3, 0)) < 1e-14" => "true";
}

/// How a section turns with its path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Frame {
    Translate,
    Fixed,
    Frenet,
    Projection,
    RotationMinimizing,
}

impl Choice for Frame {
    const WORDS: &'static [&'static str] =
        &["translate", "fixed", "frenet", "projection", "rotation_minimizing"];
    const MEANINGS: &'static [Self] =
        &[Self::Translate, Self::Fixed, Self::Frenet, Self::Projection, Self::RotationMinimizing];
}

/// What happens at corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Corner {
    Error,
    Miter,
}

impl Choice for Corner {
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
    let has_corners = checked(ctx, &path, path_span, args.corner)?;
    let is_translation = args.frame.value == Frame::Translate;
    if is_translation || has_corners {
        let what = if is_translation { "\"translate\"" } else { "a sweep around corners" };
        unmoved(&args, what)?;
    }
    if is_translation {
        let receipt = Receipt::of("sweep").with("frame", "translate").with("exact", true);
        return Ok(translated(&section, &path).at(path_span)?.with_receipt(receipt));
    }
    let start = path.tangent_at(path.domain().start(), Side::Right).at(path_span)?;
    let up = args.up.unwrap_or_else(|| {
        let is_along = start.cross(DVec3::Z).length() <= ctx.tolerance.angle;
        Spanned::new(if is_along { DVec3::X } else { DVec3::Z }, path_span)
    });
    let is_ring = path.is_closed(ctx.tolerance.distance);
    if has_corners {
        let receipt = Receipt::of("sweep").with("corners", "miter").with("exact", true);
        return Ok(mitred(&section, &path, up.value, is_ring).at(up.span)?.with_receipt(receipt));
    }

    let is_closed = is_ring && is_smooth_at_seam(&path, path_span)?;
    let frames = framed(&path, args.frame.value, up, is_closed)?;
    let n_sections = counted(ctx, args.sections)?;
    let rail = match &args.rail {
        Some(rail) => Some(nurbs_within(&rail.value, tolerance).at(rail.span)?),
        None => None,
    };
    let breaks = args.scale.as_ref().map_or(Vec::new(), |scale| scale.value.breaks(path.domain()));
    let fineness = Fineness { n_sections, tolerance: 0.5 * tolerance, keeps_path: args.keep_path };
    let span = ctx.span;
    let mut motion = Given {
        ctx: &mut *ctx,
        scale: args.scale.map(|given| given.value),
        twist: args.twist.map(|given| given.value),
        rail,
        domain: path.domain(),
    };
    let sweep = match swept(&section, &path, &frames, &mut motion, &breaks, fineness) {
        Err(GeomError::ToleranceNotKept { found, .. }) => {
            let message = format!(
                "4096 placements of the section do not keep the tolerance {}: the surface is still {} off",
                shortest(tolerance),
                shortest(found)
            );
            return Diagnostic::error(Code::BeyondTolerance, span, message)
                .hint("allow a larger `tolerance`, or say with `sections` how many are enough")
                .fail();
        }
        made => made.at(span)?,
    };
    warn(ctx, &sweep, &frames);
    Ok(receipted(sweep, &frames))
}

/// The tolerance that is given, or the document's.
pub(super) fn tolerated(ctx: &Ctx<'_>, given: Option<&Spanned<Length>>) -> Result<f64> {
    match given {
        Some(given) if given.value.0 <= 0.0 => {
            let error = GeomError::NotPositive { what: "the tolerance", got: given.value.0 };
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

fn framed(path: &NurbsCurve, frame: Frame, up: Spanned<DVec3>, is_closed: bool) -> Result<Frames> {
    let rule = match frame {
        Frame::Fixed => Framing::Fixed,
        Frame::Frenet => Framing::Frenet,
        Frame::Projection => Framing::Projection,
        Frame::RotationMinimizing | Frame::Translate => Framing::RotationMinimizing,
    };
    Frames::new(path, rule, up.value, is_closed).at(up.span).map_err(|found| {
        let hint = "`frame = \"rotation_minimizing\"` needs no bend, and `up` only at the start";
        let needs_more = matches!(rule, Framing::Frenet | Framing::Fixed);
        if needs_more { Box::new(found.hint(hint)) } else { found }
    })
}

/// How many placements are asked for.
fn counted(ctx: &Ctx<'_>, sections: Option<Spanned<usize>>) -> Result<Option<usize>> {
    match sections {
        Some(given) if given.value < 2 => {
            let message = format!("a sweep needs 2 placements or more, found {}", given.value);
            Diagnostic::error(Code::BadCall, given.span, message).fail()
        }
        Some(given) if MOST_PLACEMENTS.min(ctx.limits.list_length) < given.value => {
            let message = format!(
                "{} placements are more than the {MOST_PLACEMENTS} that a sweep takes",
                given.value
            );
            Diagnostic::error(Code::TooLarge, given.span, message).fail()
        }
        given => Ok(given.map(|given| given.value)),
    }
}

/// Placements that a script may ask for.
const MOST_PLACEMENTS: usize = 4096;

/// Whether the path has corners that are to be mitred.
fn checked(ctx: &Ctx<'_>, path: &NurbsCurve, span: Span, corner: Corner) -> Result<bool> {
    if path.is_point() {
        let message = "the path is one point, so that it leads nowhere";
        return Diagnostic::error(Code::Degenerate, span, message).fail();
    }
    if let Some(&t) = path.cusps(ctx.tolerance).first() {
        let message =
            format!("the path has a cusp at parameter {}, where it has no direction", shortest(t));
        return Diagnostic::error(Code::Degenerate, span, message)
            .hint("`split` it there, and sweep along both parts")
            .fail();
    }
    let corners = path.corners(ctx.tolerance);
    let Some(&t) = corners.first() else { return Ok(false) };
    if corner == Corner::Miter && path.degree() == 1 && !path.is_rational() {
        return Ok(true);
    }
    let message = format!("the path has a corner at parameter {}", shortest(t));
    let hint = match corner {
        Corner::Miter => {
            "\"miter\" is for polygons; `split` the path there, and sweep along both parts"
        }
        Corner::Error => {
            "`corner = \"miter\"` joins the legs of a polygon; another path is `split` there"
        }
    };
    Diagnostic::error(Code::Degenerate, span, message).hint(hint).fail()
}

/// Whether a closed path arrives in the direction in which it left.
fn is_smooth_at_seam(path: &NurbsCurve, span: Span) -> Result<bool> {
    const SMOOTH: f64 = crate::kernel::tolerance::TURN_RELATIVE;
    let domain = path.domain();
    let start = path.tangent_at(domain.start(), Side::Right).at(span)?;
    let end = path.tangent_at(domain.end(), Side::Left).at(span)?;
    Ok(start.distance(end) <= SMOOTH)
}

fn warn(ctx: &mut Ctx<'_>, sweep: &Sweep, frames: &Frames) {
    if let Some([before, behind]) = frames.flips().first() {
        let message = format!(
            "the frame turns around near parameter {} of the path",
            shortest(0.5 * (before + behind))
        );
        let hint = "`frame = \"rotation_minimizing\"` does not";
        ctx.warn(Diagnostic::warning(Code::FrameFlip, ctx.span, message).hint(hint));
    }
    if let Some(t) = sweep.folds {
        let message = format!(
            "near parameter {} of the path the section reaches beyond the centre of curvature, so that the surface crosses itself",
            shortest(t)
        );
        let hint = "a smaller section, or a path that bends less, does not";
        ctx.warn(Diagnostic::warning(Code::SelfIntersecting, ctx.span, message).hint(hint));
    }
}

fn receipted(sweep: Sweep, frames: &Frames) -> NurbsSurface {
    let (deviation, at) = sweep.deviation;
    let surface = sweep.surface;
    let net = surface.control_points();
    let both = |u: usize, v: usize| Receipt::default().with("u", u).with("v", v);
    let flips: Vec<f64> = frames.flips().iter().map(|[a, b]| 0.5 * (a + b)).collect();
    let receipt = Receipt::of("sweep")
        .with("placements", sweep.placements)
        .with("deviation", Receipt::default().with("max", deviation).with("at", at))
        .with("closing_angle", crate::kernel::Fact::Angle(frames.closing()))
        .with("flips", flips)
        .with("folds_at", sweep.folds)
        .with("degree", both(surface.degree_u(), surface.degree_v()))
        .with("control_points", both(net.n_rows(), net.n_columns()));
    surface.with_receipt(receipt)
}
