//! `sweep`: the surface that a section leaves behind along a path.

use glam::DVec3;

use super::{
    motion::{MotionArgs, Rails, Scale, Twist},
    ribbon::warn_of_ribbon,
    swept::warn,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Columns, Curve, FitError, FrameRule, GeomError, InputError, NurbsSurface, SweepBuilder,
        SweepError, SweepInput, ceiling::PIECES,
    },
    value::{At, Choice, Ctx, Length, blamed_on, op, rounded, shortest},
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
pub(in crate::ops) enum FrameOption {
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
pub(in crate::ops) enum CornerOption {
    Error,
    Miter,
}

impl Choice for CornerOption {
    const WORDS: &'static [&'static str] = &["error", "miter"];
    const MEANINGS: &'static [Self] = &[Self::Error, Self::Miter];
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    let tolerance = tolerated(ctx, args.tolerance.as_ref())?;
    let rule = framing(args.frame.value);
    let given = SweepGiven {
        section: args.section.clone(),
        path: args.path.span,
        up: args.up.as_ref().map_or(args.path.span, |up| up.span),
        rails: args.rail.as_ref().map_or(args.path.span, |rail| rail.span),
        rule,
        tolerance,
    };
    if rule.is_none() {
        unmoved(&args, "\"translate\"")?;
    }
    let domain = args.path.value.domain();
    let kinks = args.scale.as_ref().map_or(Vec::new(), |scale| scale.value.breaks(domain));
    let is_moved = args.scale.is_some() || args.twist.is_some();
    let columns = columns(args.method, args.keep_path)?;
    let n_sections = counted(ctx, args.sections)?;
    let mut motion = MotionArgs {
        scale: args.scale.map(|given| given.value),
        twist: args.twist.map(|given| given.value),
        ctx: &mut *ctx,
        domain,
    };
    let document = motion.ctx.tolerance;
    let mut builder = SweepBuilder::new(args.section.value, args.path.value, document)
        .within(tolerance)
        .columns(columns);
    builder = match rule {
        Some(rule) => builder.frames(rule),
        None => builder.translated(),
    };
    if let Some(up) = args.up {
        builder = builder.up(up.value);
    }
    if args.corner == CornerOption::Miter {
        builder = builder.with_mitres();
    }
    if !args.keep_path {
        builder = builder.beside_path();
    }
    if let Some(n_sections) = n_sections {
        builder = builder.sections(n_sections);
    }
    builder = match args.rail.map(|rail| rail.value) {
        None => builder,
        Some(Rails::One(rail)) => builder.along_rail(rail),
        Some(Rails::Two(rails)) => builder.between_rails(rails),
    };
    if is_moved {
        builder = builder.moved(&mut motion, kinks);
    }
    let made = match builder.sweep() {
        Ok(made) => made,
        Err(found) => return Err(refused(ctx, found, &given)),
    };
    warn_of_ribbon(ctx, &made.section, rule.is_none().then_some(&*made.path));
    warn(ctx, &made);
    Ok(made.surface)
}

/// What errors of a sweep are told of: arguments, and where they stand.
pub(in crate::ops) struct SweepGiven {
    pub(in crate::ops) section: Spanned<Curve>,
    pub(in crate::ops) path: Span,
    pub(in crate::ops) up: Span,
    pub(in crate::ops) rails: Span,
    pub(in crate::ops) rule: Option<FrameRule>,
    pub(in crate::ops) tolerance: f64,
}

/// The error at the argument that is to blame.
pub(in crate::ops) fn refused(
    ctx: &mut Ctx<'_>,
    SweepError { blamed, error }: SweepError,
    given: &SweepGiven,
) -> Box<Diagnostic> {
    let tolerance = given.tolerance;
    // What lies along the path is worth telling, whatever goes wrong on the way.
    let is_swept = !matches!(blamed, SweepInput::Section | SweepInput::Path);
    if let (true, Ok(section)) = (is_swept, given.section.value.nurbs_within(0.5 * tolerance)) {
        warn_of_ribbon(ctx, &section, None);
    }
    if let GeomError::Fit(FitError::ToleranceNotKept { found, .. }) = error
        && blamed == SweepInput::Whole
    {
        let message = format!(
            "{PIECES} placements of the section do not keep the tolerance {}: the surface is still {} off",
            shortest(tolerance),
            rounded(found)
        );
        let hint = "allow a larger `tolerance`, or say with `sections` how many are enough";
        return Box::new(Diagnostic::error(Code::BeyondTolerance, ctx.span, message).hint(hint));
    }
    let span = match blamed {
        SweepInput::Section => given.section.span,
        SweepInput::Path => given.path,
        SweepInput::Up => given.up,
        SweepInput::Rails => given.rails,
        SweepInput::Whole => ctx.span,
    };
    let found = blamed_on(error, span);
    let needs_more = matches!(given.rule, Some(FrameRule::Frenet | FrameRule::Fixed));
    if blamed == SweepInput::Up && needs_more {
        let hint = "`frame = \"rotation_minimizing\"` needs no bend, and `up` only at the start";
        return Box::new(found.hint(hint));
    }
    found
}

/// The tolerance that is given, or the document's.
pub(in crate::ops) fn tolerated(ctx: &Ctx<'_>, given: Option<&Spanned<Length>>) -> Result<f64> {
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

pub(in crate::ops) const fn framing(frame: FrameOption) -> Option<FrameRule> {
    match frame {
        FrameOption::Translate => None,
        FrameOption::Fixed => Some(FrameRule::Fixed),
        FrameOption::Frenet => Some(FrameRule::Frenet),
        // The limit of ever more projections.
        FrameOption::Projection | FrameOption::RotationMinimizing => {
            Some(FrameRule::RotationMinimizing)
        }
    }
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
