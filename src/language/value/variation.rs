//! How values vary with the parameters of a function that is differentiated: moved along their slopes.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{IntoValue, List, Number, Range, Real, Record, Value, Vector, compare::equal};
use crate::kernel::{Curve, Jet, KnotVector, PointSlopes, Surface, tolerance::LAST_BIT};

/// Steps of variables, each with its index.
pub(super) type Steps<'s> = &'s [(usize, f64)];

/// How many variables a value depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Variables {
    /// Nothing in it varies.
    None,
    /// So many, to the first order.
    FirstOrder(usize),
    /// It is a series of a higher order.
    HigherOrder,
}

impl Variables {
    fn of_jet(jet: &Jet) -> Self {
        jet.n_variables().map_or(Self::HigherOrder, Self::FirstOrder)
    }

    fn of_real(real: &Real) -> Self {
        match real {
            Real::Plain(_) => Self::None,
            Real::Jet(jet) => Self::of_jet(jet),
        }
    }

    fn or(self, other: impl FnOnce() -> Self) -> Self {
        if self == Self::None { other() } else { self }
    }

    fn of_all<'v>(mut values: impl Iterator<Item = &'v Value>) -> Self {
        let first = values.find_map(|value| {
            let variables = Self::of(value);
            (variables != Self::None).then_some(variables)
        });
        first.unwrap_or(Self::None)
    }

    /// Those that a value depends on, lists and records searched to their ends.
    pub(super) fn of(value: &Value) -> Self {
        match value {
            Value::Jet(number) => Self::of_real(&number.value),
            Value::JetPoint(jets) => Self::of_jet(&jets[0]),
            Value::JetRange(range) => {
                Self::of_real(&range.start.value).or(|| Self::of_real(&range.end.value))
            }
            Value::JetCurve(curve) => Self::FirstOrder(curve.slopes().n_variables()),
            Value::JetSurface(surface) => Self::FirstOrder(surface.slopes().n_variables()),
            Value::JetRegion(region) => Self::FirstOrder(region.n_variables()),
            Value::JetSolid(solid) => Self::FirstOrder(solid.n_variables()),
            Value::List(items) if items.numbers().is_none() => Self::of_all(items.iter()),
            Value::Record(record) => Self::of_all(record.iter().map(|(_, value)| value)),
            _ => Self::None,
        }
    }
}

/// A value without derivatives, its variables moved by some steps. None where control points cannot go so far.
pub(super) fn moved(value: &Value, steps: Steps<'_>) -> Option<Value> {
    let number =
        |number: &Number<Real>| Number { value: stepped(&number.value, steps), dim: number.dim };
    Some(match value {
        Value::Jet(jet) => Value::Number(number(jet)),
        Value::JetPoint(jets) => {
            let coordinate = |jet: &Jet| stepped_jet(jet, steps);
            Value::Point(DVec3::from(jets.each_ref().map(coordinate)))
        }
        Value::JetRange(range) => Value::Range(Range {
            start: number(&range.start),
            end: number(&range.end),
            closed: range.closed,
        }),
        Value::JetCurve(curve) if steps.is_empty() => {
            Value::Curve(Curve::Nurbs(Arc::clone(curve.curve())))
        }
        Value::JetSurface(surface) if steps.is_empty() => {
            Value::Surface(Surface::Nurbs(Arc::clone(surface.surface())))
        }
        Value::JetCurve(curve) => curve.moved(steps).ok()?.into_value(),
        Value::JetSurface(surface) => surface.moved(steps).ok()?.into_value(),
        Value::List(items) if items.numbers().is_none() => {
            let items: Option<Vec<Value>> = items.iter().map(|item| moved(item, steps)).collect();
            Value::List(items?.into_iter().collect::<List>())
        }
        Value::Record(record) => {
            Value::Record(Arc::new(record.mapped(|value| moved(value, steps))?))
        }
        other => other.clone(),
    })
}

/// A value without derivatives, to its depths, on the knots that it has where these move.
#[must_use]
pub fn looked_at(value: &Value) -> Value {
    match value {
        Value::List(items) if items.numbers().is_none() => {
            Value::List(items.iter().map(looked_at).collect())
        }
        Value::Record(record) => {
            let fields = record.iter().map(|(label, value)| (Arc::from(label), looked_at(value)));
            Value::Record(Arc::new(Record::new(fields.collect::<Vec<_>>())))
        }
        other => other.looked_at(),
    }
}

/// Whether a value holds curves or surfaces whose knots move.
pub(super) fn has_moving_knots(value: &Value) -> bool {
    match value {
        Value::JetCurve(curve) => curve.has_moving_knots(),
        Value::JetSurface(surface) => surface.has_moving_knots(),
        Value::List(items) if items.numbers().is_none() => items.iter().any(has_moving_knots),
        Value::Record(record) => record.iter().any(|(_, value)| has_moving_knots(value)),
        _ => false,
    }
}

/// An answer with slopes, of the same shape on knots that do not move, as what it is on those that move; none
/// unless both are of one shape.
#[must_use]
pub fn with_form_of(found: &Value, answer: &Value) -> Option<Value> {
    Some(match (found, answer) {
        (Value::JetCurve(found), Value::Curve(Curve::Nurbs(own))) => {
            Value::JetCurve(Arc::new((**found).clone().of_moving_knots(Arc::clone(own))?))
        }
        (Value::JetSurface(found), Value::Surface(Surface::Nurbs(own))) => {
            Value::JetSurface(Arc::new((**found).clone().of_moving_knots(Arc::clone(own))?))
        }
        (Value::Jet(found), Value::Number(own)) if found.dim == own.dim => {
            Number { value: found.value.clone().with_value(own.value), dim: own.dim }.into_value()
        }
        (Value::JetPoint(found), Value::Point(own)) => {
            Vector::Jets(Box::new((**found).clone())).with_value(*own).into_value()
        }
        (Value::List(found), Value::List(own)) if found.len() == own.len() => {
            let pairs = found.values().zip(own.values());
            Value::list(
                pairs.map(|(found, own)| with_form_of(&found, &own)).collect::<Option<_>>()?,
            )
        }
        (Value::Record(found), Value::Record(own)) if found.len() == own.len() => {
            let field = |((label, found), (_, own)): ((&str, &Value), (&str, &Value))| {
                Some((Arc::from(label), with_form_of(found, own)?))
            };
            let fields: Option<Vec<(Arc<str>, Value)>> =
                found.iter().zip(own.iter()).map(field).collect();
            Value::Record(Arc::new(Record::new(fields?)))
        }
        (Value::Curve(_), Value::Curve(_)) | (Value::Surface(_), Value::Surface(_)) => {
            answer.clone()
        }
        (found, own) => (!found.is_jet() && found.kind() == own.kind()).then(|| own.clone())?,
    })
}

fn stepped(real: &Real, steps: Steps<'_>) -> f64 {
    match real {
        Real::Plain(value) => *value,
        Real::Jet(jet) => stepped_jet(jet, steps),
    }
}

fn stepped_jet(jet: &Jet, steps: Steps<'_>) -> f64 {
    steps.iter().fold(jet.value(), |sum, &(variable, step)| sum + step * jet.slopes()[variable])
}

/// The largest slope of a value by a variable, and the largest number of what has one.
pub(super) fn sizes(value: &Value, variable: usize) -> [f64; 2] {
    let larger = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
    let of_jet = |jet: &Jet| [jet.slopes()[variable].abs(), jet.value().abs()];
    let of_real = |real: &Real| match real {
        Real::Plain(_) => [0.0, 0.0],
        Real::Jet(jet) => of_jet(jet),
    };
    let of_points = |points: &[DVec4], slopes: &PointSlopes| {
        let of_variable = slopes.by_variable().iter().find(|(idx, _)| *idx == variable);
        let Some((_, slopes)) = of_variable else { return [0.0, 0.0] };
        let largest =
            |all: &[DVec4]| all.iter().map(|part| part.abs().max_element()).fold(0.0, f64::max);
        [largest(slopes), largest(points)]
    };
    let found = match value {
        Value::Jet(number) => of_real(&number.value),
        Value::JetPoint(jets) => jets.iter().map(of_jet).fold([0.0; 2], larger),
        Value::JetRange(range) => larger(of_real(&range.start.value), of_real(&range.end.value)),
        Value::JetCurve(curve) => of_points(curve.curve().control_points(), curve.slopes()),
        Value::JetSurface(surface) => {
            of_points(surface.surface().control_points().as_slice(), surface.slopes())
        }
        Value::List(items) if items.numbers().is_none() => {
            items.iter().map(|item| sizes(item, variable)).fold([0.0; 2], larger)
        }
        Value::Record(record) => {
            record.iter().map(|(_, value)| sizes(value, variable)).fold([0.0; 2], larger)
        }
        _ => [0.0; 2],
    };
    // What does not move says nothing of the size of a step.
    if found[0] > 0.0 { found } else { [0.0; 2] }
}

/// Whether two values differ in their [numbers](super::numbers::numbers) alone.
pub(super) fn are_alike(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => a.dim == b.dim,
        (Value::Point(_), Value::Point(_)) => true,
        (Value::Range(a), Value::Range(b)) => {
            a.closed == b.closed && a.start.dim == b.start.dim && a.end.dim == b.end.dim
        }
        (Value::Curve(Curve::Nurbs(a)), Value::Curve(Curve::Nurbs(b))) => {
            are_same_knots(a.knots(), b.knots())
        }
        (Value::Surface(Surface::Nurbs(a)), Value::Surface(Surface::Nurbs(b))) => {
            are_same_knots(a.knots_u(), b.knots_u()) && are_same_knots(a.knots_v(), b.knots_v())
        }
        (Value::List(a), Value::List(b)) => {
            a.len() == b.len() && a.values().zip(b.values()).all(|(a, b)| are_alike(&a, &b))
        }
        (Value::Record(a), Value::Record(b)) => {
            let is_alike = |((label, a), (other, b)): ((&str, &Value), (&str, &Value))| {
                label == other && are_alike(a, b)
            };
            a.len() == b.len() && a.iter().zip(b.iter()).all(is_alike)
        }
        (a, b) => equal(a, b) == Some(true),
    }
}

/// Whether knots are the same but for rounding.
fn are_same_knots(a: &KnotVector, b: &KnotVector) -> bool {
    const ROUNDINGS: f64 = 64.0;
    let (a_knots, b_knots) = (a.as_slice(), b.as_slice());
    let size = a_knots.iter().fold(0.0, |most: f64, knot| most.max(knot.abs()));
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= ROUNDINGS * LAST_BIT * size;
    a.degree() == b.degree()
        && a_knots.len() == b_knots.len()
        && a_knots.iter().zip(b_knots).all(is_near)
}
