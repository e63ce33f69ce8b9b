//! `skin`: the surface through sections.

use glam::DVec4;

use super::section::{
    Aligned, Section, SectionPairing, SectionPlaces, SectionShape, SectionSlope, align,
    drop_repeated, standing, warn_of_crossings, warn_of_lost_corners,
};
use super::sweep::tolerated;
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Along, CompatibleSections, ConstructionReport, Curve, GeomError, NurbsCurve, NurbsSurface,
        SectionParameters, Skin, WeightError, at_constant_speed, check_parameters,
    },
    value::{At, Ctx, Length, op, shortest},
};

op! {
    /// Surface through sections: u along them, v from one to the next.
    ///
    /// Sections of other degrees and knots are made compatible, exactly; rational ones are skinned
    /// in homogeneous space after their weights are normalised, so that a common factor of a
    /// section's weights changes nothing. A section may be a point where the surface begins or
    /// ends. Sections that run against their neighbour are reversed, and seams of closed ones that
    /// are far from their neighbour's are moved. Where closed sections have corners, such as the tails
    /// of aerofoils, all seams go to corners that belong together, smooth ones beside them;
    /// neighbours with as many corners have them at the same parameters, so that edges of the
    /// surface run through them. The sections stand at parameters averaged from
    /// the distances of their control points, over knots averaged from these. With a spine the
    /// derivatives by v at the sections point along its tangents, and v is its parameter. Where
    /// weights between rational sections do not stay positive, a warning says so; with a tolerance,
    /// or where they would vanish, these sections become splines within it.
    /// "monotone" keeps each coordinate of the control points between its values at two
    /// neighbouring sections, so that nothing swings out, with C1 where that needs it.
    /// Piegl & Tiller, *The NURBS Book*, §10.3.
    skin | loft in Surface -> NurbsSurface {
        /// The sections in order, two or more: curves, and points at the ends.
        sections: Spanned<Vec<Section>>,
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
        start_tangent: Option<Spanned<SectionSlope>>,
        /// The derivative by v along the last section.
        end_tangent: Option<Spanned<SectionSlope>>,
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
    scene r#"
        curves rings = [circle((0, 0, 0), 2), circle((0, 0, 2), 1), circle((0, 0, 4), 1.5), circle((0, 0, 6), 0.5)] with (color = "red")
        surface s = skin(rings) with (color = "lightgray")
    "#;
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<NurbsSurface> {
    check(&args)?;
    let span = args.sections.span;
    let mut curves = Section::curves(args.sections.value, span, ctx.tolerance.distance)?;
    if args.closed {
        drop_repeated(&mut curves, ctx.tolerance.distance);
    }
    check_count(ctx, &curves, args.closed, span)?;
    let aligned = match args.align {
        true => align(&mut curves, span, ctx.tolerance.distance)?,
        false => Aligned::default(),
    };
    warn_of_lost_corners(ctx, &aligned, span);

    let tolerance = tolerated(ctx, args.tolerance.as_ref())?;
    if args.pairing == SectionPairing::Length {
        curves = at_constant_speed(&curves, tolerance).at(span)?;
    }
    let slopes = [args.start_tangent, args.end_tangent];
    let (mut sections, slopes) = with_slopes(curves, slopes, span)?;
    let as_given = sections.clone();
    // Tangents at the ends hold on to the knots that they share with the sections.
    if args.tolerance.is_some() && slopes.iter().all(Option::is_none) {
        sections = sections.thinned(tolerance);
    }

    let degree = args.degree.value;
    let is_exact = args.tolerance.is_none();
    let has_slopes = slopes.iter().any(Option::is_some);
    let (along, parameters) = if let Some(spine) = args.spine {
        let degree = Spanned::new(degree, args.degree.span);
        let along = spine_way(ctx, sections.curves().len(), spine, args.at, degree, args.closed)?;
        (along.0, along.1)
    } else {
        let parameters = standing(&sections, args.parameters, args.closed, span)?;
        let along = match (args.shape.value, args.closed) {
            (SectionShape::Monotone, is_closed) => Along::monotone(&parameters, is_closed),
            (SectionShape::Free, true) => Along::closed(&parameters, degree),
            (SectionShape::Free, false) if slopes.iter().all(Option::is_none) => {
                Along::free(&parameters, degree)
            }
            (SectionShape::Free, false) => Along::with_slopes(&parameters, degree, slopes),
        };
        (along.at(span)?, parameters)
    };
    let (skin, refitted) = match has_slopes {
        // They belong to the control points that there are.
        true => (skinned(ctx, &sections, &along, span)?, Vec::new()),
        false => positive(ctx, [&sections, &as_given], &along, (is_exact, tolerance), span)?,
    };
    warn_of_crossings(ctx, sections.curves(), span, tolerance);
    Ok(with_report(skin, parameters, aligned, refitted))
}

/// The surface with its report.
fn with_report(
    skin: Skin,
    parameters: Vec<f64>,
    aligned: Aligned,
    refitted: Vec<usize>,
) -> NurbsSurface {
    let Skin { surface, bad_weight } = skin;
    let seam = |&(section, at): &(usize, f64)| {
        ConstructionReport::default().with("section", section).with("at", at)
    };
    let net = surface.control_points();
    let report = ConstructionReport::of("skin")
        .with("parameters", parameters)
        .with(
            "degree",
            ConstructionReport::default()
                .with("u", surface.degree_u())
                .with("v", surface.degree_v()),
        )
        .with(
            "control_points",
            ConstructionReport::default().with("u", net.n_rows()).with("v", net.n_columns()),
        )
        .with("reversed", aligned.reversed)
        .with("moved_seams", aligned.seams.iter().map(seam).collect::<Vec<_>>())
        .with("moved_corners", aligned.corners)
        .with("refitted", refitted)
        .with("least_weight", bad_weight.map(|(_, _, weight)| weight));
    surface.with_report(report)
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
        _ => Ok(()),
    }
}

/// Fails unless there are enough sections, and points only at the ends.
fn check_count(ctx: &Ctx<'_>, curves: &[NurbsCurve], is_closed: bool, span: Span) -> Result<()> {
    let (got, needed) = (curves.len(), if is_closed { 3 } else { 2 });
    if got < needed {
        let which = if is_closed { "a closed skin" } else { "a skin" };
        let message = format!("{which} needs {needed} sections or more, found {got}");
        return Diagnostic::error(Code::BadCall, span, message)
            .hint("a skin runs from section to section; of one curve `extrude`, `revolve` and `sweep` make surfaces")
            .fail();
    }
    let ends = if is_closed { 0..got } else { 1..got - 1 };
    let is_point = |curve: &NurbsCurve| curve.is_point();
    if let Some(index) = ends.clone().find(|&i| is_point(&curves[i])) {
        let (own, span) = ctx.element(span, index, "sections");
        let message = format!("{own} is a point; only the first and the last may be one");
        return Diagnostic::error(Code::Degenerate, span, message)
            .hint("make two skins that meet in the point")
            .fail();
    }
    if curves.iter().all(is_point) {
        let message = "both sections are points; one of them must be a curve";
        return Diagnostic::error(Code::Degenerate, span, message).fail();
    }
    Ok(())
}

/// The homogeneous derivatives by v along a section, one a control point.
type Slopes = Option<Vec<DVec4>>;

/// The sections on one basis, with derivatives along the first and the last.
fn with_slopes(
    mut curves: Vec<NurbsCurve>,
    slopes: [Option<Spanned<SectionSlope>>; 2],
    span: Span,
) -> Result<(CompatibleSections, [Slopes; 2])> {
    let n_sections = curves.len();
    let domain = curves[0].domain();
    for slope in slopes.iter().flatten() {
        let SectionSlope::Curve(vectors) = &slope.value else { continue };
        if vectors.is_rational() || curves.iter().any(NurbsCurve::is_rational) {
            let message = "a curve of tangents has no weights, and neither have its sections";
            return Diagnostic::error(Code::NotExact, slope.span, message)
                .hint("give one vector, or make the sections polynomial with `approximate`")
                .fail();
        }
        curves.push(vectors.reparametrized(domain));
    }
    let all = CompatibleSections::new(&curves).at(span)?;
    let mut vectors = all.curves()[n_sections..].iter();
    let sections = all.first(n_sections);
    let ends = [&sections.curves()[0], &sections.curves()[n_sections - 1]];
    let mut derivatives = [None, None];
    for ((slope, end), place) in slopes.iter().zip(ends).zip(&mut derivatives) {
        *place = match slope.as_ref().map(|slope| &slope.value) {
            None => None,
            Some(SectionSlope::Vector(v)) => {
                Some(end.control_points().iter().map(|p| (*v * p.w).extend(0.0)).collect())
            }
            Some(SectionSlope::Curve(_)) => vectors
                .next()
                .map(|curve| curve.points().into_iter().map(|v| v.extend(0.0)).collect()),
        };
    }
    Ok((sections, derivatives))
}

/// The way along a spine, and its parameters.
fn spine_way(
    ctx: &Ctx<'_>,
    n_sections: usize,
    spine: Spanned<Curve>,
    at: Option<Spanned<Vec<f64>>>,
    degree: Spanned<usize>,
    is_closed: bool,
) -> Result<(Along, Vec<f64>)> {
    if !(2..=3).contains(&degree.value) {
        let message = format!("with a spine the degree is 2 or 3, found {}", degree.value);
        return Diagnostic::error(Code::BadDegree, degree.span, message).fail();
    }
    let at = at.unwrap_or(Spanned::new(Vec::new(), spine.span));
    let (got, needed) = (at.value.len(), n_sections + usize::from(is_closed));
    if got != needed {
        let which = if is_closed {
            format!(
                "a closed skin of {n_sections} sections needs {needed} parameters of the spine, the last for its return to the first section"
            )
        } else {
            format!("{needed} sections need {needed} parameters of the spine")
        };
        let message = format!("{which}, found {got}");
        return Diagnostic::error(Code::BadParameters, at.span, message).fail();
    }
    check_parameters(&at.value, needed).at(at.span)?;
    let curve = super::section::nurbs_within(&spine.value, ctx.tolerance.distance).at(spine.span)?;
    let inside = |&t: &f64| curve.domain().clamp_inside(t);
    let places: std::result::Result<Vec<f64>, _> = at.value.iter().map(inside).collect();
    let along = Along::spine(&places.at(at.span)?, degree.value, &curve, is_closed).at(at.span)?;
    Ok((along, at.value))
}

/// The skin; where weights would vanish, or be negative and a tolerance is given, through
/// polynomial splines near the rational sections, whose indices are told.
fn positive(
    ctx: &mut Ctx<'_>,
    [sections, as_given]: [&CompatibleSections; 2],
    along: &Along,
    (is_exact, tolerance): (bool, f64),
    span: Span,
) -> Result<(Skin, Vec<usize>)> {
    let made = sections.skinned(along);
    let weight = match &made {
        Ok(Skin { bad_weight: None, .. }) => return Ok((made.at(span)?, Vec::new())),
        Ok(_) if is_exact => return Ok((skinned(ctx, sections, along, span)?, Vec::new())),
        Ok(Skin { bad_weight: Some((row, column, weight)), .. }) => {
            format!("the weight of control point [{row}][{column}] would be {}", shortest(*weight))
        }
        Err(GeomError::Weights(WeightError::VanishingWeightsAt { .. })) => {
            "weights would vanish".to_owned()
        }
        Err(_) => return Ok((made.at(span)?, Vec::new())),
    };
    let refitted: Vec<usize> =
        (0..sections.curves().len()).filter(|&i| sections.curves()[i].is_rational()).collect();
    let polynomial = as_given.polynomial(tolerance).at(span)?;
    let skin = polynomial.skinned(along).at(span)?;
    let message = format!(
        "between the sections {weight}, so that the rational sections became splines within {}",
        shortest(tolerance)
    );
    ctx.warn(
        Diagnostic::warning(Code::NotPositiveWeight, ctx.span, message).hint(
            "`shape = \"monotone\"`, a lower `degree`, or sections of one form keep them exact",
        ),
    );
    Ok((skin, refitted))
}

/// The skin as it is, with a warning of a weight that is not positive; weights that vanish between
/// the sections are an error.
fn skinned(
    ctx: &mut Ctx<'_>,
    sections: &CompatibleSections,
    along: &Along,
    span: Span,
) -> Result<Skin> {
    let skin = sections.skinned(along).at(span).map_err(|found| {
        let is_weights = found.code == Code::BadWeights;
        if is_weights { Box::new(found.hint(POSITIVE)) } else { found }
    })?;
    if let Some((row, column, weight)) = skin.bad_weight {
        let message = format!(
            "between the sections the weight of control point [{row}][{column}] became {}",
            shortest(weight)
        );
        ctx.warn(Diagnostic::warning(Code::NotPositiveWeight, ctx.span, message).hint(POSITIVE));
    }
    Ok(skin)
}

/// What to do against weights that swing below zero.
const POSITIVE: &str = "`shape = \"monotone\"`, a lower `degree`, or sections of one form keep the weights positive; with a `tolerance` rational sections become splines";
