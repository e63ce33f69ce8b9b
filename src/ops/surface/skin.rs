//! `skin`: the surface through sections.

use super::section::{
    SectionPairing, SectionPlaces, SectionShape, SectionTangent, SkinSection, warn_of_crossings,
    warn_of_lost_corners,
};
use super::sweep::tolerated;
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        ConstructionError, CountError, Curve, FormError, GeomError, InputError, NurbsSurface,
        SectionParameters, SkinBuilder, SkinError, SkinInput, SkinnedSurface,
    },
    value::{At, Ctx, Length, blamed_on, op, shortest},
};

op! {
    /// Surface through sections: u along them, v from one to the next.
    ///
    /// Sections of other degrees and knots are made compatible, exactly; rational ones are skinned
    /// in homogeneous space after their weights are normalised, so that a common factor of a
    /// section's weights changes nothing. A section may be a point where the surface begins or
    /// ends. Sections that run against their neighbour are reversed, closed ones as the way between
    /// them passes both, and seams of closed ones that are far from their neighbour's are moved. Where closed sections have corners, such as the tails
    /// of aerofoils, all seams go to corners that belong together, smooth ones beside them;
    /// neighbours with as many corners have them at the same parameters, so that edges of the
    /// surface run through them. The sections stand at parameters averaged from
    /// the distances of their control points, over knots averaged from these; of sections of unlike weights from distances
    /// in homogeneous space about the first control point, in which a weight counts as a length of the document's unit,
    /// or with "places" from those of their places, whatever the unit. With a spine the
    /// derivatives by v at the sections point along its tangents, and v is its parameter. Where
    /// weights between rational sections do not stay positive, a warning says so; with a tolerance,
    /// or where they would vanish, these sections become splines within it.
    /// "monotone" keeps each coordinate of the control points between its values at two
    /// neighbouring sections, so that nothing swings out, with C1 where that needs it.
    /// Piegl & Tiller, *The NURBS Book*, §10.3.
    skin | loft in Surface -> NurbsSurface {
        /// The sections in order, two or more: curves, and points at the ends.
        sections: Spanned<Vec<SkinSection>>,
        /// The degree along v, from 1; fewer sections than degree + 1 lower it.
        degree: Spanned<usize> = Spanned::unplaced(3),
        /// A curve whose tangents the surface takes at the sections; degree 2 or 3.
        spine: Option<Spanned<Curve>>,
        /// The parameters of the spine at the sections.
        at: Option<Spanned<Vec<f64>>>,
        /// Where in v the sections stand: by a rule, or listed. A closed skin takes one more, for
        /// its return to the first section.
        parameters: Spanned<SectionPlaces> = Spanned::unplaced(SectionPlaces::By(SectionParameters::Average)),
        /// Whether the surface goes on from the last section to the first, as smooth there as
        /// anywhere.
        closed: bool = false,
        /// Whether sections are turned around, and seams moved, to run beside their neighbours.
        align: bool = true,
        /// The derivative by v along the first section: a vector, or a curve of vectors.
        start_tangent: Option<Spanned<SectionTangent>>,
        /// The derivative by v along the last section.
        end_tangent: Option<Spanned<SectionTangent>>,
        /// Whether the surface may swing out between sections.
        shape: Spanned<SectionShape> = Spanned::unplaced(SectionShape::Free),
        /// Whether points of equal parameter or of equal fraction of the length belong together;
        /// by "length", sections of uneven speed become cubic splines within the tolerance.
        pairing: SectionPairing = SectionPairing::Parameter,
        /// How far sections may move so that the surface has fewer knots along them.
        tolerance: Option<Spanned<Length>>,
    }
    example "skin([line((0, 0), (1, 0)), line((0, 1, 1), (1, 1, 1)), line((0, 2), (1, 2))])(0.5, 0.5)" => "(0.5, 1, 1)";
    example "skin([for z in 0..3: circle((0, 0, z), 1 + z)]).degree_v" => "3";
    example "skin([(0, 0, 0), circle((0, 0, 1), 1), circle((0, 0, 3), 1)])(0.3, 0)" => "(0, 0, 0)";
    refuses "skin([line((0, 0), (1, 0))])" => "E0401: a skin needs 2 sections or more, found 1";
    refuses "skin([line((0, 0), (1, 0)), (0, 1), line((0, 2), (1, 2))])" => "E0607: `(0, 1)` is a point; only the first and the last may be one";
    refuses "skin([line((0, 0), (1, 0)), line((0, 0), (1, 0)), line((0, 2), (1, 2))])" => "E0607: `sections[0]` and `sections[1]` are at one place";
    derivative shape;
    settling super::moving::SKIN;
    scene r#"
        curves rings = [circle((0, 0, 0), 2), circle((0, 0, 2), 1), circle((0, 0, 4), 1.5), circle((0, 0, 6), 0.5)] with (color = "red")
        surface s = skin(rings) with (color = "lightgray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    check(&args)?;
    let span = args.sections.span;
    let tolerance = tolerated(ctx, args.tolerance.as_ref())?;
    let spans = SkinSpans {
        sections: span,
        parameters: args.parameters.span,
        spine: args.spine.as_ref().map_or(span, |spine| spine.span),
        at: args.at.as_ref().map_or(span, |at| at.span),
        slopes: [&args.start_tangent, &args.end_tangent]
            .map(|slope| slope.as_ref().map_or(span, |slope| slope.span)),
        has_slopes: args.start_tangent.is_some() || args.end_tangent.is_some(),
        is_closed: args.closed,
    };
    let sections = args.sections.value.into_iter().map(SkinSection::curve);
    let sections: std::result::Result<Vec<Curve>, GeomError> = sections.collect();
    let mut builder = SkinBuilder::new(sections.at(span)?, ctx.tolerance).degree(args.degree.value);
    if args.closed {
        builder = builder.closed();
    }
    if !args.align {
        builder = builder.unaligned();
    }
    builder = match args.parameters.value {
        SectionPlaces::By(rule) => builder.parameters(rule),
        SectionPlaces::Listed(parameters) => builder.parameters_at(parameters),
    };
    if let Some(slope) = args.start_tangent {
        builder = builder.start_slope(slope.value.slope());
    }
    if let Some(slope) = args.end_tangent {
        builder = builder.end_slope(slope.value.slope());
    }
    if args.shape.value == SectionShape::Monotone {
        builder = builder.monotone();
    }
    if let (Some(spine), Some(at)) = (args.spine, args.at) {
        builder = builder.along_spine(spine.value, at.value);
    }
    if args.pairing == SectionPairing::Length {
        builder = builder.by_length();
    }
    if args.tolerance.is_some() {
        builder = builder.within(tolerance);
    }
    let made = builder.skin().map_err(|found| refused(ctx, found, &spans))?;
    warn_of_lost_corners(ctx, &made.unpaired, span);
    warn_of_weights(ctx, &made, tolerance);
    warn_of_crossings(ctx, &made.sections, span, tolerance);
    Ok(made.surface)
}

/// Warns of weights that did not stay positive, and of what became of them.
pub(in crate::ops) fn warn_of_weights(ctx: &mut Ctx<'_>, made: &SkinnedSurface, tolerance: f64) {
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

/// Where the arguments stand that a skin is made of.
pub(in crate::ops) struct SkinSpans {
    pub(in crate::ops) sections: Span,
    pub(in crate::ops) parameters: Span,
    pub(in crate::ops) spine: Span,
    pub(in crate::ops) at: Span,
    pub(in crate::ops) slopes: [Span; 2],
    pub(in crate::ops) has_slopes: bool,
    pub(in crate::ops) is_closed: bool,
}

/// The error at the argument that is to blame, in the words of the script.
pub(in crate::ops) fn refused(
    ctx: &Ctx<'_>,
    SkinError { blamed, error }: SkinError,
    spans: &SkinSpans,
) -> Box<Diagnostic> {
    let span = match blamed {
        SkinInput::Sections => spans.sections,
        SkinInput::Parameters => spans.parameters,
        SkinInput::Spine => spans.spine,
        SkinInput::At => spans.at,
        SkinInput::StartSlope => spans.slopes[0],
        SkinInput::EndSlope => spans.slopes[1],
    };
    Box::new(match (blamed, error) {
        (SkinInput::Sections, GeomError::Count(CountError::TooFewCurves { got, needed })) => {
            let which = if spans.is_closed { "a closed skin" } else { "a skin" };
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
        (SkinInput::Sections, GeomError::Input(InputError::CoincidentPoints { first, second })) => {
            let message = format!("`sections[{first}]` and `sections[{second}]` are at one place");
            Diagnostic::error(Code::Degenerate, span, message)
                .hint("leave one of them out, or say with `parameters` where in v they stand")
        }
        (SkinInput::At, GeomError::Count(CountError::WrongCount { needed, got, .. })) => {
            let which = if spans.is_closed {
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
            let is_weights = spans.has_slopes && found.code == Code::BadWeights;
            return if is_weights { Box::new(found.hint(POSITIVE)) } else { found };
        }
    })
}

/// What an argument excludes, and how many sections it needs.
fn check(args: &Args) -> Result<()> {
    if args.degree.value == 0 {
        let message = "the degree along v is 1 or more, found 0";
        return Diagnostic::error(Code::BadDegree, args.degree.span, message).fail();
    }
    let tangents = [("start_tangent", &args.start_tangent), ("end_tangent", &args.end_tangent)];
    let tangent = tangents.iter().find_map(|(name, slope)| slope.as_ref().map(|s| (*name, s.span)));
    let is_monotone = args.shape.value == SectionShape::Monotone;
    let excluded = match (&args.spine, tangent) {
        (Some(_), Some((name, span))) => Some((
            span,
            format!("a spine gives the tangents at all sections; leave out it or `{name}`"),
        )),
        (Some(_), None) if is_monotone => Some((
            args.shape.span,
            "a spine gives the tangents at all sections, which \"monotone\" chooses".to_owned(),
        )),
        (None, Some((name, span))) if is_monotone => {
            Some((span, format!("\"monotone\" chooses the tangents; leave out it or `{name}`")))
        }
        (None, Some((name, span))) if args.degree.value == 1 => Some((
            span,
            format!(
                "a skin of degree 1 has no tangents to choose; leave out `{name}`, or state a `degree` of 2 or more"
            ),
        )),
        (None, Some((name, span))) if args.closed => {
            Some((span, format!("a closed skin has no end where `{name}` could be")))
        }
        _ => None,
    };
    if let Some((span, message)) = excluded {
        return Diagnostic::error(Code::BadCall, span, message).fail();
    }
    match (&args.spine, &args.at) {
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
        (Some(_), Some(_)) if args.parameters.span != Span::default() => {
            let message = "with a spine its parameters `at` are those of the sections";
            Diagnostic::error(Code::BadCall, args.parameters.span, message)
                .hint("leave out `parameters`")
                .fail()
        }
        (Some(_), Some(_)) if !(2..=3).contains(&args.degree.value) => {
            let message = format!("with a spine the degree is 2 or 3, found {}", args.degree.value);
            Diagnostic::error(Code::BadDegree, args.degree.span, message).fail()
        }
        _ => Ok(()),
    }
}

/// What to do against weights that swing below zero.
const POSITIVE: &str = "`shape = \"monotone\"`, a lower `degree`, or sections of one form keep the weights positive; with a `tolerance` rational sections become splines";
