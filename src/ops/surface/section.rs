//! Sections of skins: what scripts give, brought to run beside one another.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Bounds, CompatibleSections, Curve, GeomError, InputError, NurbsCurve, SectionParameters,
        aligned, check_parameters, corners_of_ring, with_seam_at_corner,
    },
    value::{At, Choice, Ctx, FromValue, IntoValue, Mismatch, Type, Value, shortest},
};

/// A curve, or a point where a surface begins or ends.
#[derive(Clone, Debug)]
pub(super) enum Section {
    Curve(Curve),
    Point(DVec3),
}

impl FromValue for Section {
    const TYPE: Type = Type::OneOf(&[Type::Curve, Type::Point]);

    fn from_value(value: &Value, _: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Curve(curve) => Ok(Self::Curve(curve.clone())),
            Value::Point(point) => Ok(Self::Point(*point)),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl Section {
    /// The sections as NURBS; functions are followed within the tolerance.
    pub(super) fn curves(
        sections: Vec<Self>,
        span: Span,
        tolerance: f64,
    ) -> Result<Vec<NurbsCurve>> {
        let curve = |section: Self| match section {
            Self::Point(point) => NurbsCurve::bezier(&[point]).at(span),
            Self::Curve(curve) => {
                nurbs_within(&curve, tolerance).at(span).map(Arc::unwrap_or_clone)
            }
        };
        sections.into_iter().map(curve).collect()
    }
}

/// The curve itself, or a spline within the tolerance of a function.
pub(super) fn nurbs_within(
    curve: &Curve,
    tolerance: f64,
) -> std::result::Result<Arc<NurbsCurve>, GeomError> {
    curve.nurbs_within(tolerance)
}

/// Takes away the last section where it is the first one again.
pub(super) fn drop_repeated(curves: &mut Vec<NurbsCurve>, tolerance: f64) {
    let [first, .., last] = &curves[..] else { return };
    if apart(first, last) <= tolerance {
        curves.pop();
    }
}

/// A bound of how far two curves are apart at equal fractions of their domains.
fn apart(a: &NurbsCurve, b: &NurbsCurve) -> f64 {
    a.deviation_from(&b.reparametrized(a.domain()))
}

/// What was done to sections so that they run beside one another.
#[derive(Clone, Debug, Default)]
pub(super) struct Aligned {
    /// Sections that were reversed.
    pub(super) reversed: Vec<usize>,
    /// Sections whose seam was moved, and the parameter where it is now.
    pub(super) seams: Vec<(usize, f64)>,
    /// Sections whose corners were brought to the parameters of their neighbour's.
    pub(super) corners: Vec<usize>,
    /// Neighbours whose corners cannot be paired, with how many these are.
    pub(super) unpaired: Vec<[(usize, usize); 2]>,
}

/// Turns sections around, and moves seams, to run beside their neighbour: from the first section on
/// that has its seam at a corner, or else a corner anywhere, in both directions.
pub(super) fn align(curves: &mut [NurbsCurve], span: Span, tolerance: f64) -> Result<Aligned> {
    let is_closed = |curve: &NurbsCurve| curve.is_closed(tolerance);
    let real: Vec<usize> = (0..curves.len()).filter(|&i| !curves[i].is_point()).collect();
    let Some(&start) = real.first() else { return Ok(Aligned::default()) };
    let first_closed = is_closed(&curves[start]);
    if let Some(&other) = real.iter().find(|&&i| is_closed(&curves[i]) != first_closed) {
        let (closed, open) = if first_closed { (start, other) } else { (other, start) };
        let message = format!(
            "`sections[{closed}]` is closed, `sections[{open}]` is open, so that it is not clear where the closed one begins"
        );
        return Diagnostic::error(Code::Degenerate, span, message)
            .hint("cut the closed one where the open one begins, or take it as it is with `align = false`")
            .fail();
    }
    let mut done = Aligned::default();
    let mut anchor = 0;
    if first_closed {
        let corners: Vec<Vec<f64>> = real.iter().map(|&i| corners_of_ring(&curves[i])).collect();
        let at_seam = |own: &Vec<f64>| own.first().is_some_and(|&first| first <= 0.0);
        let has_any = |own: &Vec<f64>| !own.is_empty();
        anchor = corners.iter().position(at_seam).or(corners.iter().position(has_any)).unwrap_or(0);
        let own = real[anchor];
        if let Some((moved, t)) = with_seam_at_corner(&curves[own], tolerance).at(span)? {
            done.seams.push((own, t));
            curves[own] = moved;
        }
    }
    let onwards = real[anchor..].windows(2).map(|pair| (pair[0], pair[1]));
    let backwards = real[..=anchor].windows(2).rev().map(|pair| (pair[1], pair[0]));
    for (before, own) in onwards.chain(backwards) {
        let now = aligned(&curves[own], &curves[before], first_closed, tolerance).at(span)?;
        done.reversed.extend(now.is_reversed.then_some(own));
        done.seams.extend(now.seam.map(|t| (own, t)));
        done.corners.extend(now.has_moved_corners.then_some(own));
        done.unpaired.extend(now.unpaired.map(|[n, others]| [(own, n), (before, others)]));
        curves[own] = now.curve;
    }
    done.reversed.sort_unstable();
    done.seams.sort_by_key(|&(section, _)| section);
    done.corners.sort_unstable();
    Ok(done)
}

/// Warns of neighbours with different numbers of corners: an edge of the surface ends between them.
pub(super) fn warn_of_lost_corners(ctx: &mut Ctx<'_>, aligned: &Aligned, span: Span) {
    let Some(&[(own, n), (other, n_others)]) = aligned.unpaired.first() else { return };
    let [(a, of_a), (b, _)] = [own, other].map(|i| ctx.element(span, i, "sections"));
    let corners = |n: usize| if n == 1 { "1 corner".to_owned() } else { format!("{n} corners") };
    let message = format!(
        "{a} has {}, its neighbour {b} has {}, so that not all of them lie on an edge of the surface",
        corners(n),
        corners(n_others)
    );
    ctx.warn(
        Diagnostic::warning(Code::Unclean, of_a, message)
            .hint("their seams are at corners; with `align = false` all sections stay as they are"),
    );
}

/// One parameter a section, and one more for a closed skin.
pub(super) fn standing(
    sections: &CompatibleSections,
    given: Spanned<SectionPlaces>,
    is_closed: bool,
    span: Span,
) -> Result<Vec<f64>> {
    let n_sections = sections.curves().len();
    match given.value {
        SectionPlaces::Listed(listed) => {
            let needed = n_sections + usize::from(is_closed);
            check_parameters(&listed, needed).at(given.span)?;
            Ok(listed)
        }
        SectionPlaces::By(rule) => match sections.parameters(rule, is_closed) {
            Err(GeomError::Input(InputError::CoincidentPoints { first, second })) => {
                let message =
                    format!("`sections[{first}]` and `sections[{second}]` are at one place");
                Diagnostic::error(Code::Degenerate, span, message)
                    .hint("leave one of them out, or say with `parameters` where in v they stand")
                    .fail()
            }
            found => found.at(span),
        },
    }
}

/// Where sections stand along v.
#[derive(Clone, Debug)]
pub(super) enum SectionPlaces {
    By(SectionParameters),
    Listed(Vec<f64>),
}

impl Choice for SectionParameters {
    const WORDS: &'static [&'static str] = &["average", "centripetal", "uniform"];
    const MEANINGS: &'static [Self] = &[Self::Average, Self::Centripetal, Self::Uniform];
}

impl FromValue for SectionPlaces {
    const TYPE: Type = Type::OneOf(&[SectionParameters::TYPE, Type::List(&Type::Ratio, 0)]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Text(_) => SectionParameters::from_value(value, span).map(Self::By),
            Value::List(_) | Value::Range(_) => Vec::from_value(value, span).map(Self::Listed),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

impl IntoValue for SectionPlaces {
    const RETURNS: Type = Self::TYPE;

    fn into_value(self) -> Value {
        match self {
            Self::By(rule) => rule.into_value(),
            Self::Listed(parameters) => parameters.into_value(),
        }
    }
}

/// A derivative along a section.
#[derive(Clone, Debug)]
pub(super) enum SectionSlope {
    Vector(DVec3),
    Curve(Arc<NurbsCurve>),
}

impl FromValue for SectionSlope {
    const TYPE: Type = Type::OneOf(&[Type::Point, Type::Curve]);

    fn from_value(value: &Value, span: Span) -> std::result::Result<Self, Mismatch> {
        match value {
            Value::Point(vector) => Ok(Self::Vector(*vector)),
            Value::Curve(_) => Arc::from_value(value, span).map(Self::Curve),
            _ => Err(Mismatch::kind(Self::TYPE, value)),
        }
    }
}

/// What the surface may do between sections.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SectionShape {
    Free,
    Monotone,
}

impl Choice for SectionShape {
    const WORDS: &'static [&'static str] = &["free", "monotone"];
    const MEANINGS: &'static [Self] = &[Self::Free, Self::Monotone];
}

/// Which points of two sections belong together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SectionPairing {
    Parameter,
    Length,
}

impl Choice for SectionPairing {
    const WORDS: &'static [&'static str] = &["parameter", "length"];
    const MEANINGS: &'static [Self] = &[Self::Parameter, Self::Length];
}

/// Warns of neighbouring sections that cross.
pub(super) fn warn_of_crossings(
    ctx: &mut Ctx<'_>,
    sections: &[NurbsCurve],
    span: Span,
    tolerance: f64,
) {
    for (k, pair) in sections.windows(2).enumerate() {
        if pair.iter().any(NurbsCurve::is_point) {
            continue;
        }
        let [a, b] = [0, 1].map(|i| Bounds::of(pair[i].points()));
        let are_apart = a.zip(b).is_none_or(|(a, b)| {
            (a.max + tolerance).cmplt(b.min).any() || (b.max + tolerance).cmplt(a.min).any()
        });
        if are_apart {
            continue;
        }
        let Ok(meetings) = pair[0].intersections(&pair[1], tolerance) else { continue };
        let is_inner = |curve: &NurbsCurve, t: f64| {
            let domain = curve.domain();
            domain.start() < t && t < domain.end()
        };
        // At common ends surfaces may well come together in a point.
        let crossing =
            meetings.iter().find(|m| is_inner(&pair[0], m.first) && is_inner(&pair[1], m.second));
        let Some(meeting) = crossing else { continue };
        let [x, y, z] = meeting.point.to_array().map(shortest);
        let [(a, _), (b, of_b)] = [k, k + 1].map(|i| ctx.element(span, i, "sections"));
        let message =
            format!("{a} and {b} cross at ({x}, {y}, {z}), so that the surface crosses itself");
        ctx.warn(
            Diagnostic::warning(Code::SelfIntersecting, of_b, message)
                .hint("sections lie beside one another; leave one of them out, or move it"),
        );
        return;
    }
}
