//! What a skin is told beside its sections, those of surfaces and of solids.

use super::section::{
    SectionPairing, SectionPlaces, SectionShape, SectionTangent, warn_of_crossings,
    warn_of_lost_corners,
};
use super::{moving::moves, sweep_options::tolerated};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        ConstructionError, CountError, Curve, FormError, GeomError, InputError, NurbsSurface,
        SectionParameters, SkinBuilder, SkinError, SkinInput, SkinnedSurface,
    },
    value::{Ctx, Length, blamed_on, shortest},
};

/// The options of a skin, as the operations document them.
#[derive(Clone)]
pub(in crate::ops) struct SkinOptions {
    pub(in crate::ops) degree: Spanned<usize>,
    pub(in crate::ops) spine: Option<Spanned<Curve>>,
    pub(in crate::ops) at: Option<Spanned<Vec<f64>>>,
    pub(in crate::ops) parameters: Spanned<SectionPlaces>,
    pub(in crate::ops) is_closed: bool,
    pub(in crate::ops) is_aligned: bool,
    pub(in crate::ops) start_tangent: Option<Spanned<SectionTangent>>,
    pub(in crate::ops) end_tangent: Option<Spanned<SectionTangent>>,
    pub(in crate::ops) shape: Spanned<SectionShape>,
    pub(in crate::ops) pairing: SectionPairing,
    pub(in crate::ops) tolerance: Option<Spanned<Length>>,
}

/// The options among the arguments of an operation that documents them.
macro_rules! skin_options {
    ($args:ident) => {
        SkinOptions {
            degree: $args.degree,
            spine: $args.spine,
            at: $args.at,
            parameters: $args.parameters,
            is_closed: $args.closed,
            is_aligned: $args.align,
            start_tangent: $args.start_tangent,
            end_tangent: $args.end_tangent,
            shape: $args.shape,
            pairing: $args.pairing,
            tolerance: $args.tolerance,
        }
    };
}

pub(in crate::ops) use skin_options;

impl SkinOptions {
    /// The surface through sections that stand at `span` in the script; what is doubtful about it is warned of.
    pub(in crate::ops) fn surface(
        &self,
        ctx: &mut Ctx<'_>,
        sections: Vec<Curve>,
        span: Span,
    ) -> Result<NurbsSurface> {
        let tolerance = tolerated(ctx, self.tolerance.as_ref())?;
        let mut builder = self.builder(sections, ctx);
        if self.tolerance.is_some() {
            builder = builder.within(tolerance);
        }
        let made = builder.skin().map_err(|found| self.refused(ctx, found, span))?;
        warn_of_lost_corners(ctx, &made.unpaired, span);
        warn_of_weights(ctx, &made, tolerance);
        warn_of_crossings(ctx, &made.sections, span, tolerance);
        Ok(made.surface)
    }

    /// The rule by which parameters are found that move with the sections, where nothing but the degree is told besides.
    pub(in crate::ops) fn moving_rule(&self) -> Option<SectionParameters> {
        let is_told = self.spine.is_some()
            || self.is_closed
            || self.start_tangent.is_some()
            || self.end_tangent.is_some()
            || self.shape.value != SectionShape::Free
            || self.pairing != SectionPairing::Parameter
            || self.tolerance.is_some();
        match &self.parameters.value {
            SectionPlaces::By(rule) if !is_told => moves(*rule).then_some(*rule),
            _ => None,
        }
    }

    fn builder(&self, sections: Vec<Curve>, ctx: &Ctx<'_>) -> SkinBuilder {
        let mut builder = SkinBuilder::new(sections, ctx.tolerance).degree(self.degree.value);
        if self.is_closed {
            builder = builder.closed();
        }
        if !self.is_aligned {
            builder = builder.unaligned();
        }
        builder = match &self.parameters.value {
            SectionPlaces::By(rule) => builder.parameters(*rule),
            SectionPlaces::Listed(parameters) => builder.parameters_at(parameters.clone()),
        };
        if let Some(slope) = &self.start_tangent {
            builder = builder.start_slope(slope.value.slope());
        }
        if let Some(slope) = &self.end_tangent {
            builder = builder.end_slope(slope.value.slope());
        }
        if self.shape.value == SectionShape::Monotone {
            builder = builder.monotone();
        }
        if let (Some(spine), Some(at)) = (&self.spine, &self.at) {
            builder = builder.along_spine(spine.value.clone(), at.value.clone());
        }
        match self.pairing {
            SectionPairing::Parameter => builder,
            SectionPairing::Length => builder.by_length(),
        }
    }

    /// The error at the argument that is to blame, in the words of the script.
    fn refused(
        &self,
        ctx: &Ctx<'_>,
        SkinError { blamed, error }: SkinError,
        sections: Span,
    ) -> Box<Diagnostic> {
        let span = match blamed {
            SkinInput::Sections => None,
            SkinInput::Parameters => Some(self.parameters.span),
            SkinInput::Spine => self.spine.as_ref().map(|spine| spine.span),
            SkinInput::At => self.at.as_ref().map(|at| at.span),
            SkinInput::StartSlope => self.start_tangent.as_ref().map(|slope| slope.span),
            SkinInput::EndSlope => self.end_tangent.as_ref().map(|slope| slope.span),
        };
        let span = span.unwrap_or(sections);
        Box::new(match (blamed, error) {
            (SkinInput::Sections, GeomError::Count(CountError::TooFewCurves { got, needed })) => {
                let which = if self.is_closed { "a closed skin" } else { "a skin" };
                let message = format!("{which} needs {needed} sections or more, found {got}");
                Diagnostic::error(Code::BadCall, span, message)
                    .hint("a skin runs from section to section; of one curve `extrude`, `revolve` and `sweep` make surfaces")
            }
            (_, GeomError::Construction(ConstructionError::PointBetween { index })) => {
                let (own, span) = ctx.element(span, index, "sections");
                let message = format!("{own} is a point; only the first and the last may be one");
                Diagnostic::error(Code::Degenerate, span, message)
                    .hint("make two skins that meet in the point")
            }
            (
                SkinInput::Sections,
                GeomError::Input(InputError::CoincidentPoints { first, second }),
            ) => {
                let message =
                    format!("`sections[{first}]` and `sections[{second}]` are at one place");
                Diagnostic::error(Code::Degenerate, span, message)
                    .hint("leave one of them out, or say with `parameters` where in v they stand")
            }
            (SkinInput::At, GeomError::Count(CountError::WrongCount { needed, got, .. })) => {
                let which = if self.is_closed {
                    format!(
                        "a closed skin of {} sections needs {needed} parameters of the spine, the last for its return to the first section",
                        needed - 1
                    )
                } else {
                    format!("{needed} sections need {needed} parameters of the spine")
                };
                Diagnostic::error(Code::BadParameters, span, format!("{which}, found {got}"))
            }
            (
                SkinInput::StartSlope | SkinInput::EndSlope,
                GeomError::Form(FormError::RationalFor { .. }),
            ) => {
                let message = "a curve of tangents has no weights, and neither have its sections";
                Diagnostic::error(Code::NotExact, span, message)
                    .hint("give one vector, or make the sections polynomial with `approximate`")
            }
            (_, error) => {
                let found = blamed_on(error, span);
                let has_slopes = self.start_tangent.is_some() || self.end_tangent.is_some();
                let is_weights = has_slopes && found.code == Code::BadWeights;
                return if is_weights { Box::new(found.hint(POSITIVE)) } else { found };
            }
        })
    }

    /// What an argument excludes, and how many sections it needs.
    pub(in crate::ops) fn check(&self) -> Result<()> {
        if self.degree.value == 0 {
            let message = "the degree along v is 1 or more, found 0";
            return Diagnostic::error(Code::BadDegree, self.degree.span, message).fail();
        }
        let tangents = [("start_tangent", &self.start_tangent), ("end_tangent", &self.end_tangent)];
        let tangent =
            tangents.iter().find_map(|(name, slope)| slope.as_ref().map(|s| (*name, s.span)));
        let is_monotone = self.shape.value == SectionShape::Monotone;
        let excluded = match (&self.spine, tangent) {
            (Some(_), Some((name, span))) => Some((
                span,
                format!("a spine gives the tangents at all sections; leave out it or `{name}`"),
            )),
            (Some(_), None) if is_monotone => Some((
                self.shape.span,
                "a spine gives the tangents at all sections, which \"monotone\" chooses".to_owned(),
            )),
            (None, Some((name, span))) if is_monotone => {
                Some((span, format!("\"monotone\" chooses the tangents; leave out it or `{name}`")))
            }
            (None, Some((name, span))) if self.degree.value == 1 => Some((
                span,
                format!(
                    "a skin of degree 1 has no tangents to choose; leave out `{name}`, or state a `degree` of 2 or more"
                ),
            )),
            (None, Some((name, span))) if self.is_closed => {
                Some((span, format!("a closed skin has no end where `{name}` could be")))
            }
            _ => None,
        };
        if let Some((span, message)) = excluded {
            return Diagnostic::error(Code::BadCall, span, message).fail();
        }
        match (&self.spine, &self.at) {
            (Some(spine), None) => {
                let message = "with a spine, `at` tells its parameters at the sections";
                Diagnostic::error(Code::BadCall, spine.span, message)
                    .hint("write `at = [...]`, one parameter a section")
                    .fail()
            }
            (None, Some(at)) => {
                let message = "`at` are parameters of a spine, and there is none";
                Diagnostic::error(Code::BadCall, at.span, message)
                    .hint("write `spine = ...`; without a spine, `parameters = [...]` says where in v the sections stand")
                    .fail()
            }
            (Some(_), Some(_)) if self.parameters.span != Span::default() => {
                let message = "with a spine its parameters `at` are those of the sections";
                Diagnostic::error(Code::BadCall, self.parameters.span, message)
                    .hint("leave out `parameters`")
                    .fail()
            }
            (Some(_), Some(_)) if !(2..=3).contains(&self.degree.value) => {
                let message =
                    format!("with a spine the degree is 2 or 3, found {}", self.degree.value);
                Diagnostic::error(Code::BadDegree, self.degree.span, message).fail()
            }
            _ => Ok(()),
        }
    }
}

/// Warns of weights that did not stay positive, and of what became of them.
fn warn_of_weights(ctx: &mut Ctx<'_>, made: &SkinnedSurface, tolerance: f64) {
    let (message, hint) = match (made.is_refitted, made.bad_weight) {
        (false, None) => return,
        (false, Some((row, column, weight))) => (
            format!(
                "between the sections the weight of control point [{row}][{column}] became {}",
                shortest(weight)
            ),
            POSITIVE,
        ),
        (true, weight) => {
            let weight = match weight {
                Some((row, column, weight)) => format!(
                    "the weight of control point [{row}][{column}] would be {}",
                    shortest(weight)
                ),
                None => "weights would vanish".to_owned(),
            };
            let message = format!(
                "between the sections {weight}, so that the rational sections became splines within {}",
                shortest(tolerance)
            );
            let hint =
                "`shape = \"monotone\"`, a lower `degree`, or sections of one form keep them exact";
            (message, hint)
        }
    };
    ctx.warn(Diagnostic::warning(Code::NotPositiveWeight, ctx.span, message).hint(hint));
}

/// What to do against weights that swing below zero.
const POSITIVE: &str = "`shape = \"monotone\"`, a lower `degree`, or sections of one form keep the weights positive; with a `tolerance` rational sections become splines";
