//! `integrate`: the integral of a function over a range, a box, a curve or a surface.

use super::{
    SearchRange, six_digits,
    unknowns::{asked, numbers},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Curve, IntegralError, Interval, Jet, Surface, find_integral,
        tolerance::{EXACT_RELATIVE, INTEGRAL_RELATIVE},
    },
    value::{At, Callback, Ctx, Dimension, IntoValue, Number, Real, Value, Vector, op},
};

op! {
    /// Integral of a function over a range; or over a box of two or three ranges, the length of a curve, the area
    /// of a surface, or several of these together. Of numbers it is a number, of points a point.
    ///
    /// It is known to thirteen digits of the integral of the function's size, or within `tolerance`; over boxes
    /// and surfaces to twelve. Ends of ranges are never asked for, so that a function may grow without bound
    /// there; an integral that has no finite value, or does not settle, is refused with the place. Derivatives
    /// pass through: that of an integral is the integral of the derivative. Piessens et al., *QUADPACK*, §2.2.1.
    integrate in Math -> Value {
        /// A function that yields a number or a point: of a number over a range, of as many as there are ranges
        /// over a box, of a point over a curve or a surface.
        f: Spanned<Callback>,
        /// The range; or a list of two or three, a curve, a surface, a list of curves or of surfaces.
        over: Spanned<Value>,
        /// How far the integral may be off, in units of its own; thirteen digits unless given.
        tolerance: Option<Spanned<Number>>,
    }
    example "integrate(x => x^2, 0..3) ~= 9" => "true";
    example "integrate(t => sqrt(1 - t^2), -1..1) ~= pi/2" => "true";
    example "integrate(t => (t, 1), 0..2) ~= (2, 2)" => "true";
    example "integrate(x => 2cm, 0cm..30mm) == 3cm * 2cm" => "true";
    example "integrate((x, y) => x * y^2, [0..1, 0..3]) ~= 4.5" => "true";
    example "integrate(p => p.y^2, circle((0, 0), 2)) ~= 8*pi" => "true";
    example "integrate(p => p.z^2, sphere((0, 0), 1)) ~= 4*pi/3 within 1e-10" => "true";
    example "gradient(a => integrate(x => a^2 * x, 0..2), 3) ~= 12" => "true";
    refuses "integrate(x => 1/x, 0..1)" => "E0504: the integral does not settle near 0";
    refuses "integrate(x => x, 1..0)" => "E0606: an interval needs its start below its end, got 1..0";
    refuses "integrate(x => x, 3)" => "E0301: an integral is over a range, a box, a curve or a surface, found the number 3";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let domains = domains(&args.over)?;
    let tolerances = match &args.tolerance {
        Some(tolerance) => [EXACT_RELATIVE, tolerance.value.value],
        None => [INTEGRAL_RELATIVE, 0.0],
    };
    let is_varying = ctx.caller.is_varying(&args.f.value.0);
    let mut integrand = Integrand { ctx, f: &args.f, known: None, like: None, is_flat: false };
    let mut values: Vec<f64> = Vec::new();
    let mut dim = Dimension::NONE;
    for domain in &domains {
        values = sum(values, domain.integral(&mut integrand, tolerances)?);
        dim = domain.dimension();
    }
    let mut reals: Vec<Real> = values.iter().copied().map(Real::Plain).collect();
    if is_varying && integrand.like.is_some() {
        integrand.is_flat = true;
        let mut flat: Vec<f64> = Vec::new();
        for domain in &domains {
            flat = sum(flat, domain.integral(&mut integrand, tolerances)?);
        }
        if let Some(like) = &integrand.like {
            let series = flat.chunks(like.coefficients().len());
            let jets = series.zip(&values);
            reals = jets
                .map(|(series, &value)| Real::Jet(like.with_coefficients(series).with_value(value)))
                .collect();
        }
    }
    let own = integrand.known.map_or(Dimension::NONE, |(_, dim)| dim);
    match <[Real; 3]>::try_from(reals) {
        Ok(point) => Ok(Vector::new(point).into_value()),
        Err(reals) => {
            let Some(dim) = own.times(dim) else {
                let message = "the dimension of the integral has powers that are too high";
                return Diagnostic::error(Code::UnitMismatch, args.f.span, message).fail();
            };
            let value = reals.into_iter().next().unwrap_or(Real::Plain(0.0));
            Ok(Number { value, dim }.into_value())
        }
    }
}

fn sum(mut a: Vec<f64>, b: Vec<f64>) -> Vec<f64> {
    a.resize(b.len(), 0.0);
    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    a
}

/// A part of what is integrated over.
enum Domain {
    Box(Vec<SearchRange>),
    Curve(Curve, Span),
    Surface(Surface, Span),
}

/// What an integral is over, in parts.
fn domains(over: &Spanned<Value>) -> Result<Vec<Domain>> {
    let range = |value: &Value| match value {
        Value::Range(range) => Some(SearchRange::new(Spanned::new(*range, over.span))),
        _ => None,
    };
    let one = |value: &Value| match value {
        Value::Curve(curve) => Ok(Domain::Curve(curve.clone(), over.span)),
        Value::Surface(surface) => Ok(Domain::Surface(surface.clone(), over.span)),
        other if other.is_jet() => super::no_derivatives(over.span),
        other => {
            let message = format!(
                "an integral is over a range, a box, a curve or a surface, found {}",
                other.phrase()
            );
            Diagnostic::error(Code::WrongKind, over.span, message)
                .hint("for example `integrate((x, y) => x * y, [0..1, 0..2])`")
                .fail()
        }
    };
    match &over.value {
        Value::List(items)
            if (2..=3).contains(&items.len())
                && items.iter().all(|item| matches!(item, Value::Range(_))) =>
        {
            Ok(vec![Domain::Box(items.iter().filter_map(range).collect::<Result<_>>()?)])
        }
        Value::List(items) if !items.is_empty() => items.iter().map(one).collect(),
        value => match range(value) {
            Some(range) => Ok(vec![Domain::Box(vec![range?])]),
            None => Ok(vec![one(value)?]),
        },
    }
}

/// A function of the script under the integral.
struct Integrand<'a, 'c> {
    ctx: &'a mut Ctx<'c>,
    f: &'a Spanned<Callback>,
    /// Of how many components its values are, and of which dimension.
    known: Option<(usize, Dimension)>,
    /// What its derivatives are by, where it has any.
    like: Option<Jet>,
    /// Whether the coefficients of all derivatives are wanted.
    is_flat: bool,
}

impl Integrand<'_, '_> {
    /// The components at a place, times a plain number.
    fn at(&mut self, args: &[Value], factor: f64) -> Result<Vec<f64>> {
        let span = self.f.span;
        let (value, place) = match args {
            [place] => (asked(self.ctx, &self.f.value, place)?, place.to_string()),
            args => {
                let place = Value::list(args.to_vec());
                let value = self.ctx.call(&self.f.value, args);
                (
                    value.map_err(|found| super::unknowns::from_here(self.ctx, *found, &place))?,
                    place.to_string(),
                )
            }
        };
        let mut parts: Vec<Number<Real>> = Vec::new();
        match &value {
            Value::List(_) | Value::Record(_) => {
                super::plain_number(&value, span)?;
            }
            value => numbers(value, span, &mut parts)?,
        }
        let dim = parts.first().map_or(Dimension::NONE, |part| part.dim);
        let (n_before, dim_before) = *self.known.get_or_insert((parts.len(), dim));
        if n_before != parts.len() {
            let message = format!(
                "the function yields {} at {place}, and something else before",
                value.phrase()
            );
            return Diagnostic::error(Code::WrongKind, span, message).fail();
        }
        if dim_before.common(dim).is_none() {
            let message = format!("the function yields {dim} at {place} and {dim_before} before");
            return Diagnostic::error(Code::UnitMismatch, span, message).fail();
        }
        if let Some(jet) = parts.iter().find_map(|part| match &part.value {
            Real::Jet(jet) => Some(jet),
            Real::Plain(_) => None,
        }) {
            self.like.get_or_insert_with(|| jet.clone());
        }
        Ok(match &self.like {
            Some(like) if self.is_flat => parts
                .iter()
                .flat_map(|part| part.value.like(like).scaled(factor).coefficients().to_vec())
                .collect(),
            _ => parts.iter().map(|part| factor * part.value.value()).collect(),
        })
    }
}

type Tolerances = [f64; 2];

/// An integral over one range, with its refusal.
fn over_range(
    span: Span,
    range: &SearchRange,
    [relative, absolute]: Tolerances,
    ask: impl FnMut(f64) -> Result<Vec<f64>>,
) -> Result<Vec<f64>> {
    find_integral(ask, range.ends, relative, absolute).map(|found| found.value).map_err(|err| match err {
        IntegralError::Function(found) => found,
        IntegralError::Unsettled { at, error } => {
            let message = format!("the integral does not settle near {}", range.place_text(at));
            let left = match error.is_finite() {
                true => format!("it may be off by {} still", six_digits(error, None)),
                false => "its value is beyond all numbers".to_owned(),
            };
            Box::new(Diagnostic::error(Code::NoAnswer, span, message).label(left).hint(
                "it may have no finite value; else divide the range there, or give a larger `tolerance`",
            ))
        }
    })
}

impl Domain {
    fn dimension(&self) -> Dimension {
        match self {
            Self::Box(ranges) => ranges
                .iter()
                .try_fold(Dimension::NONE, |dim, range| dim.times(range.dim))
                .unwrap_or_default(),
            Self::Curve(..) => Dimension::LENGTH,
            Self::Surface(..) => Dimension::LENGTH.times(Dimension::LENGTH).unwrap_or_default(),
        }
    }

    fn integral(
        &self,
        integrand: &mut Integrand<'_, '_>,
        tolerances: Tolerances,
    ) -> Result<Vec<f64>> {
        let span = integrand.f.span;
        match self {
            Self::Box(ranges) => over_box(ranges, &mut Vec::new(), integrand, tolerances),
            Self::Curve(curve, place) => {
                let mut total = Vec::new();
                for range in
                    pieces(curve.domain(), curve.nurbs().ok().map(|it| it.knots().as_slice()))
                {
                    let found = over_range(span, &range, tolerances, |t| {
                        let derivatives = curve.derivatives_at(t, 1).at(*place)?;
                        integrand.at(&[Value::Point(derivatives[0])], derivatives[1].length())
                    })?;
                    total = sum(total, found);
                }
                Ok(total)
            }
            Self::Surface(surface, place) => over_surface(surface, *place, integrand, tolerances),
        }
    }
}

/// An integral over ranges, one inside the other, behind the arguments that are known.
fn over_box(
    ranges: &[SearchRange],
    known: &mut Vec<Value>,
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Vec<f64>> {
    let Some((first, rest)) = ranges.split_first() else { return integrand.at(known, 1.0) };
    let span = integrand.f.span;
    let own = if rest.is_empty() { tolerances } else { around(tolerances) };
    over_range(span, first, own, |at| {
        known.push(first.place(at).into_value());
        let found = over_box(rest, known, integrand, tolerances);
        known.pop();
        found
    })
}

/// The tolerances of an integral of integrals, whose values have errors of their own.
fn around([relative, absolute]: Tolerances) -> Tolerances {
    [10.0 * relative, absolute]
}

fn over_surface(
    surface: &Surface,
    place: Span,
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Vec<f64>> {
    let span = integrand.f.span;
    let nurbs = surface.nurbs().ok();
    let along_u = pieces(surface.domain_u(), nurbs.map(|it| it.knots_u().as_slice()));
    let along_v = pieces(surface.domain_v(), nurbs.map(|it| it.knots_v().as_slice()));
    let mut total = Vec::new();
    for u_range in &along_u {
        for v_range in &along_v {
            let found = over_range(span, u_range, around(tolerances), |u| {
                over_range(span, v_range, tolerances, |v| {
                    let at_place = surface.derivatives_at(u, v, 1).at(place)?;
                    let stretch = at_place.get(1, 0).cross(at_place.get(0, 1)).length();
                    integrand.at(&[Value::Point(at_place.get(0, 0))], stretch)
                })
            })?;
            total = sum(total, found);
        }
    }
    Ok(total)
}

/// The parts of a domain between knots.
fn pieces(domain: Interval, knots: Option<&[f64]>) -> Vec<SearchRange> {
    let mut places = vec![domain.start()];
    let inside = knots
        .unwrap_or_default()
        .iter()
        .filter(|knot| domain.start() < **knot && **knot < domain.end());
    places.extend(inside);
    places.push(domain.end());
    places.dedup();
    places
        .windows(2)
        .map(|ends| SearchRange { ends: [ends[0], ends[1]], dim: Dimension::NONE })
        .collect()
}
