//! What an integral is over.

use std::sync::Arc;

use super::{
    found::{Found, Tolerances, nested, place_text, shared},
    integrand::{IntegralRange, Integrand, settled},
    moving_cuts::RangeEnd,
    moving_range::{MovingRange, over_box},
    strips::over_strips,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        AreaStrip, Curve, Face, GeomError, Interval, Jet, Region, Side,
        ceiling::{INTEGRAL_LOOKS, INTEGRAL_LOOKS_OF_SEVERAL},
        glam::DVec3,
        tolerance::TURN_ACCURACY,
    },
    value::{
        At, CARRIES_DERIVATIVES, Dimension, FromValue, IntoValue, Real, RealCurve, RealSurface,
        Value, Vector, rounded,
    },
};

/// A part of what is integrated over.
pub(super) enum Domain {
    Box(Vec<MovingRange>),
    Curve(RealCurve, Span),
    Surface(RealSurface, Span),
    Region(Arc<Region>, Span),
    Face(Arc<Face>, Span),
}

/// What an integral is over, in parts.
///
/// # Errors
/// Values of other kinds; curves with areas; no part at all.
pub(super) fn domains(over: &Spanned<Value>) -> Result<Vec<Domain>> {
    let Value::List(items) = &over.value else { return Ok(vec![domain(&over.value, over)?]) };
    let is_range = |item: &Value| matches!(item, Value::Range(_) | Value::JetRange(_));
    if (2..=3).contains(&items.len()) && items.iter().all(is_range) {
        let ranges = items.iter().filter_map(|item| MovingRange::of(item, over));
        return Ok(vec![Domain::Box(ranges.collect::<Result<_>>()?)]);
    }
    let domains: Vec<Domain> =
        items.iter().map(|item| domain(item, over)).collect::<Result<_>>()?;
    let Some(first) = domains.first() else { return refused(&over.value, over.span) };
    if let Some(idx) = domains.iter().position(|other| other.n_numbers() != first.n_numbers()) {
        let message = format!(
            "element [0] has {} and element [{idx}] {}: integrals over them do not add up",
            first.extent(),
            domains[idx].extent(),
        );
        return Diagnostic::error(Code::WrongKind, over.span, message).fail();
    }
    Ok(domains)
}

fn domain(value: &Value, over: &Spanned<Value>) -> Result<Domain> {
    if let Some(range) = MovingRange::of(value, over) {
        return Ok(Domain::Box(vec![range?]));
    }
    let span = over.span;
    if let Ok(curve) = RealCurve::from_value(value, span) {
        return Ok(Domain::Curve(curve, span));
    }
    if let Ok(surface) = RealSurface::from_value(value, span) {
        return Ok(Domain::Surface(surface, span));
    }
    match value {
        Value::Region(region) => Ok(Domain::Region(Arc::clone(region), span)),
        Value::Face(face) => Ok(Domain::Face(Arc::clone(face), span)),
        other => refused(other, span),
    }
}

fn refused<T>(found: &Value, span: Span) -> Result<T> {
    let plain = found.looked_at();
    if found.is_jet() && matches!(plain, Value::Region(_) | Value::Face(_)) {
        let message = format!(
            "no derivative passes through an integral over {}, and derivatives are wanted",
            plain.phrase()
        );
        return Diagnostic::error(Code::NoDerivative, span, message)
            .hint(CARRIES_DERIVATIVES)
            .fail();
    }
    let message = format!(
        "an integral is over a range, a box, a curve, a region, a face or a surface, found {}",
        plain.phrase()
    );
    let hint = match plain {
        Value::Solid(_) => {
            "over the surface of a solid, its `.faces`: `integrate(p => p.z, body.faces)`"
        }
        _ => "for example `integrate((x, y) => x * y, [0..1, 0..2])`",
    };
    Diagnostic::error(Code::WrongKind, span, message).hint(hint).fail()
}

impl Domain {
    pub(super) fn dimension(&self) -> Dimension {
        match self {
            Self::Box(ranges) => ranges
                .iter()
                .try_fold(Dimension::NONE, |dim, range| dim.times(range.dim()))
                .unwrap_or_default(),
            Self::Curve(..) => Dimension::LENGTH,
            Self::Surface(..) | Self::Region(..) | Self::Face(..) => {
                Dimension::LENGTH.times(Dimension::LENGTH).unwrap_or_default()
            }
        }
    }

    /// Along how many numbers it extends; of a range none, since it has a dimension of its own.
    fn n_numbers(&self) -> usize {
        match self {
            Self::Box(_) => 0,
            Self::Curve(..) => 1,
            Self::Surface(..) | Self::Region(..) | Self::Face(..) => 2,
        }
    }

    fn extent(&self) -> &'static str {
        match self {
            Self::Box(_) => "the extent of a range",
            Self::Curve(..) => "a length",
            Self::Surface(..) | Self::Region(..) | Self::Face(..) => "an area",
        }
    }

    /// A jet of the shape of those that it carries.
    pub(super) fn like(&self) -> Option<Jet> {
        let of_slopes = |n| Jet::with_slopes(0.0, &vec![0.0; n]).ok();
        match self {
            Self::Box(ranges) => ranges.iter().find_map(MovingRange::like).cloned(),
            Self::Curve(curve, _) => {
                curve.varied().and_then(|varied| of_slopes(varied.slopes().n_variables()))
            }
            Self::Surface(surface, _) => {
                surface.varied().and_then(|varied| of_slopes(varied.slopes().n_variables()))
            }
            Self::Region(..) | Self::Face(..) => None,
        }
    }

    /// The strips of which it consists if it is a region or a face.
    pub(super) fn strips(&self) -> Result<Vec<AreaStrip<'_>>> {
        match self {
            Self::Region(region, span) => region.area_strips().at(*span),
            Self::Face(face, span) => face.strips().at(*span),
            Self::Box(_) | Self::Curve(..) | Self::Surface(..) => Ok(Vec::new()),
        }
    }

    /// The integral over it, `strips` being its own.
    pub(super) fn integral(
        &self,
        strips: &[AreaStrip<'_>],
        integrand: &mut Integrand<'_, '_>,
        tolerances: Tolerances,
    ) -> Result<Found> {
        match self {
            Self::Box(ranges) => over_box(ranges, &mut Vec::new(), integrand, tolerances),
            Self::Curve(curve, span) => along(curve, *span, integrand, tolerances),
            Self::Surface(surface, span) => across(surface, *span, integrand, tolerances),
            Self::Region(..) | Self::Face(..) => over_strips(strips, integrand, tolerances),
        }
    }
}

fn along(
    curve: &RealCurve,
    place: Span,
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Found> {
    let pieces = pieces(curve.domain(), curve.nurbs().ok().map(|it| it.knots().as_slice()));
    let n_looks = (INTEGRAL_LOOKS / pieces.len()).max(INTEGRAL_LOOKS_OF_SEVERAL);
    let mut total = Found::default();
    for ends in &pieces {
        let text = |t| curve.point_at(t).map_or_else(|_| rounded(t), place_text);
        let beyond = match integrand.carried() {
            Some(_) => [end_of(curve, *ends, 0).at(place)?, end_of(curve, *ends, 1).at(place)?],
            None => [RangeEnd::Last; 2],
        };
        let range = IntegralRange { n_looks, beyond, ..integrand.range(*ends) };
        let found = settled(&range, shared(tolerances, pieces.len()), text, |t| {
            let t = t.value();
            // What stands on a knot belongs to the piece that is looked at.
            let side = if t < ends[1] { Side::Right } else { Side::Left };
            let jet = match integrand.carried() {
                Some(_) => curve.jet_of(&Real::Plain(t)).at(place)?,
                None => None,
            };
            let [point, speed] = match jet {
                Some(t) => {
                    let mut series = curve.series_beside(&t, side, 1).at(place)?;
                    let speed = series.remove(1);
                    [series.remove(0), speed]
                }
                None => {
                    let found = curve.derivatives_at(t, 1).at(place)?;
                    [Vector::Plain(found[0]), Vector::Plain(found[1])]
                }
            };
            integrand.at(&[point.into_value()], &speed.norm().at(place)?)
        })?;
        total = total.plus(found);
    }
    Ok(total)
}

fn across(
    surface: &RealSurface,
    place: Span,
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Found> {
    surface.check_function().at(place)?;
    let nurbs = surface.nurbs().ok();
    let along_u = pieces(surface.domain_u(), nurbs.map(|it| it.knots_u().as_slice()));
    let along_v = pieces(surface.domain_v(), nurbs.map(|it| it.knots_v().as_slice()));
    let tolerances = shared(tolerances, along_u.len() * along_v.len());
    let text = |u, v| surface.point_at(u, v).map_or_else(|_| rounded(u), place_text);
    let mut total = Found::default();
    for ends_u in &along_u {
        let [own, inner] = nested(tolerances, ends_u[1] - ends_u[0]);
        for ends_v in &along_v {
            let middle = 0.5 * (ends_v[0] + ends_v[1]);
            let range = integrand.range(*ends_u).between(surface.domain_u());
            let found = settled(
                &range,
                own,
                |u| text(u, middle),
                |u| {
                    let (u, range) =
                        (u.value(), integrand.range(*ends_v).between(surface.domain_v()));
                    settled(
                        &range,
                        inner,
                        |v| text(u, v),
                        |v| {
                            let (point, stretch) =
                                element(surface, [u, v.value()], place, integrand)?;
                            integrand.at(&[point.into_value()], &stretch)
                        },
                    )
                },
            )?;
            total = total.plus(found);
        }
    }
    Ok(total)
}

/// A point of a surface, and the area there to one of its parameters.
fn element(
    surface: &RealSurface,
    [u, v]: [f64; 2],
    place: Span,
    integrand: &Integrand<'_, '_>,
) -> Result<(Vector, Real)> {
    let jets = match integrand.carried() {
        Some(_) => surface.jets_of([&Real::Plain(u), &Real::Plain(v)], None).at(place)?,
        None => None,
    };
    if let Some([u, v]) = jets {
        let series = surface.series_at([&u, &v], 1).at(place)?;
        let [point, along_u, along_v] = [(0, 0), (1, 0), (0, 1)].map(|(k, l)| &series.row(k)[l]);
        return Ok((point.clone(), along_u.cross(along_v).norm().at(place)?));
    }
    let found = surface.derivatives_at(u, v, 1).at(place)?;
    let stretch = found.get(1, 0).cross(found.get(0, 1)).length();
    Ok((Vector::Plain(found.get(0, 0)), Real::Plain(stretch)))
}

/// How a curve goes on beyond an end of a piece: over an inner knot, or where it closes.
fn end_of(curve: &Curve, ends: [f64; 2], which: usize) -> std::result::Result<RangeEnd, GeomError> {
    let (at, domain) = (ends[which], curve.domain());
    let (own, other) =
        if which == 0 { (Side::Right, Side::Left) } else { (Side::Left, Side::Right) };
    let further = match () {
        () if domain.start() < at && at < domain.end() => at,
        () if !curve.is_closed(0.0) => return Ok(RangeEnd::Last),
        () if at <= domain.start() => domain.end(),
        () => domain.start(),
    };
    let [own, other] =
        [(at, own), (further, other)].map(|(t, side)| curve.derivatives_beside(t, side, 1));
    let directions = [own?[1], other?[1]].map(DVec3::normalize_or_zero);
    Ok(match directions[0].distance(directions[1]) <= TURN_ACCURACY {
        true => RangeEnd::Smooth,
        false => RangeEnd::Corner,
    })
}

/// The parts of a domain between knots.
pub(super) fn pieces(domain: Interval, knots: Option<&[f64]>) -> Vec<[f64; 2]> {
    let mut places = vec![domain.start()];
    let inside = |knot: &&f64| domain.start() < **knot && **knot < domain.end();
    places.extend(knots.unwrap_or_default().iter().filter(inside));
    places.push(domain.end());
    places.dedup();
    places.windows(2).map(|ends| [ends[0], ends[1]]).collect()
}
