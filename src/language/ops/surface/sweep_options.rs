//! What a sweep is told beside its section, that of a surface and that of a solid.

use glam::DVec3;

use super::{
    motion::{MotionArgs, Rails, Scale, Twist},
    ribbon::warn_of_ribbon,
    swept::warn,
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{
        Columns, Curve, FitError, FrameRule, GeomError, InputError, NurbsSurface, SweepBuilder,
        SweepError, SweepInput, ceiling::PIECES,
    },
    value::{At, Choice, Ctx, Length, blamed_on, rounded, shortest},
};

/// What the surface is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::ops) enum SweepMethod {
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

/// The options of a sweep, as the operations document them.
pub(in crate::ops) struct SweepOptions {
    pub(in crate::ops) path: Spanned<Curve>,
    pub(in crate::ops) frame: FrameOption,
    pub(in crate::ops) scale: Option<Spanned<Scale>>,
    pub(in crate::ops) twist: Option<Spanned<Twist>>,
    pub(in crate::ops) up: Option<Spanned<DVec3>>,
    pub(in crate::ops) rail: Option<Spanned<Rails>>,
    pub(in crate::ops) corner: CornerOption,
    pub(in crate::ops) keeps_path: bool,
    pub(in crate::ops) sections: Option<Spanned<usize>>,
    pub(in crate::ops) method: Spanned<SweepMethod>,
    pub(in crate::ops) tolerance: Option<Spanned<Length>>,
}

impl SweepOptions {
    /// The surface that a section leaves behind; what is doubtful about it is warned of.
    pub(in crate::ops) fn surface(
        &self,
        ctx: &mut Ctx<'_>,
        section: &Spanned<Curve>,
    ) -> Result<NurbsSurface> {
        let tolerance = tolerated(ctx, self.tolerance.as_ref())?;
        let rule = framing(self.frame);
        if rule.is_none() {
            self.check_unmoved("\"translate\"")?;
        }
        let domain = self.path.value.domain();
        let columns = columns(self.method, self.keeps_path)?;
        let n_sections = counted(ctx, self.sections)?;
        let mut motion = MotionArgs {
            scale: self.scale.as_ref().map(|given| given.value.clone()),
            twist: self.twist.as_ref().map(|given| given.value.clone()),
            ctx: &mut *ctx,
            domain,
        };
        let document = motion.ctx.tolerance;
        let mut builder =
            SweepBuilder::new(section.value.clone(), self.path.value.clone(), document)
                .within(tolerance)
                .columns(columns);
        builder = match rule {
            Some(rule) => builder.frames(rule),
            None => builder.translated(),
        };
        if let Some(up) = &self.up {
            builder = builder.up(up.value);
        }
        if self.corner == CornerOption::Miter {
            builder = builder.with_mitres();
        }
        if !self.keeps_path {
            builder = builder.beside_path();
        }
        if let Some(n_sections) = n_sections {
            builder = builder.sections(n_sections);
        }
        builder = match self.rail.as_ref().map(|rail| rail.value.clone()) {
            None => builder,
            Some(Rails::One(rail)) => builder.along_rail(rail),
            Some(Rails::Two(rails)) => builder.between_rails(rails),
        };
        if self.scale.is_some() || self.twist.is_some() {
            let breaks = |scale: &Spanned<Scale>| scale.value.breaks(domain);
            builder = builder.moved(&mut motion, self.scale.as_ref().map_or(Vec::new(), breaks));
        }
        let made = match builder.sweep() {
            Ok(made) => made,
            Err(found) => return Err(self.refused(ctx, found, section, tolerance)),
        };
        warn_of_ribbon(ctx, &made.section, rule.is_none().then_some(&*made.path));
        warn(ctx, &made);
        Ok(made.surface)
    }

    /// The error at the argument that is to blame.
    fn refused(
        &self,
        ctx: &mut Ctx<'_>,
        SweepError { blamed, error }: SweepError,
        section: &Spanned<Curve>,
        tolerance: f64,
    ) -> Box<Diagnostic> {
        // What lies along the path is worth telling, whatever goes wrong on the way.
        let is_swept = !matches!(blamed, SweepInput::Section | SweepInput::Path);
        if let (true, Ok(nurbs)) = (is_swept, section.value.nurbs_within(0.5 * tolerance)) {
            warn_of_ribbon(ctx, &nurbs, None);
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
            return Box::new(
                Diagnostic::error(Code::BeyondTolerance, ctx.span, message).hint(hint),
            );
        }
        let span = match blamed {
            SweepInput::Section => section.span,
            SweepInput::Path => self.path.span,
            SweepInput::Up => self.up.as_ref().map_or(self.path.span, |up| up.span),
            SweepInput::Rails => self.rail.as_ref().map_or(self.path.span, |rail| rail.span),
            SweepInput::Whole => ctx.span,
        };
        let found = blamed_on(error, span);
        let needs_more = matches!(framing(self.frame), Some(FrameRule::Frenet | FrameRule::Fixed));
        if blamed == SweepInput::Up && needs_more {
            let hint =
                "`frame = \"rotation_minimizing\"` needs no bend, and `up` only at the start";
            return Box::new(found.hint(hint));
        }
        found
    }

    /// Fails where a section is to be moved in a way that the sweep does not have.
    fn check_unmoved(&self, what: &str) -> Result<()> {
        let moves = [
            self.scale.as_ref().map(|given| ("scale", given.span)),
            self.twist.as_ref().map(|given| ("twist", given.span)),
            self.rail.as_ref().map(|given| ("rail", given.span)),
        ];
        match moves.into_iter().flatten().next() {
            None => Ok(()),
            Some((name, span)) => {
                let message = format!("{what} takes no `{name}`");
                Diagnostic::error(Code::BadCall, span, message).fail()
            }
        }
    }
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

const fn framing(frame: FrameOption) -> Option<FrameRule> {
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
