//! Values that can be differentiated as numbers, one behind the other, with their slopes.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{IntoValue, JetRange, Number, Real, Record, Value, Vector};
use crate::kernel::{
    Curve, Grid, Jet, NurbsCurve, NurbsSurface, PointSlopes, Surface, VariedCurve, VariedSurface,
};

/// What a number is that is no coordinate of a point, beside 0, 1 and 2 for x, y and z.
pub(super) const OTHER_NUMBER: usize = 3;

/// Where a number stands in what it belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NumberPlace {
    /// Which coordinate of a point it is, or [`OTHER_NUMBER`].
    pub(super) axis: usize,
    /// To which control point of a curve it belongs, or to which row of those of a surface; none elsewhere.
    pub(super) line: Option<usize>,
}

/// The numbers of a value, one behind the other: of numbers, points, ranges, lists and records, and of
/// control points with their weights.
pub(super) fn numbers(value: &Value, all: &mut Vec<f64>) {
    each_number(value, &mut |number, _| all.push(number));
}

/// Where each of the [`numbers`] of a value stands.
pub(super) fn places(value: &Value, all: &mut Vec<NumberPlace>) {
    each_number(value, &mut |_, place| all.push(place));
}

/// How many lines the curves and surfaces in a value have, as [`NumberPlace::line`] counts them; none where they differ,
/// or there are none.
pub(super) fn n_lines<'v>(values: impl IntoIterator<Item = &'v Value>) -> Option<usize> {
    let mut counts = values.into_iter().filter_map(|value| match value {
        Value::Curve(Curve::Nurbs(curve)) => Some(Some(curve.control_points().len())),
        Value::Surface(Surface::Nurbs(surface)) => Some(Some(surface.control_points().n_rows())),
        Value::List(items) if items.numbers().is_none() => Some(n_lines(items.iter())),
        _ => None,
    });
    let first = counts.next()??;
    counts.all(|count| count == Some(first)).then_some(first)
}

fn each_number(value: &Value, take: &mut dyn FnMut(f64, NumberPlace)) {
    let other = NumberPlace { axis: OTHER_NUMBER, line: None };
    let point = |numbers: &[f64], line: Option<usize>, take: &mut dyn FnMut(f64, NumberPlace)| {
        let places = (0..).map(|axis| NumberPlace { axis, line });
        numbers.iter().zip(places).for_each(|(number, place)| take(*number, place));
    };
    match value {
        Value::Number(number) => take(number.value, other),
        Value::Point(own) => point(&own.to_array(), None, take),
        Value::Range(range) => {
            [range.start, range.end].into_iter().for_each(|end| take(end.value, other));
        }
        Value::Curve(Curve::Nurbs(curve)) => {
            let points = curve.control_points().iter().enumerate();
            points.for_each(|(line, own)| point(&own.to_array(), Some(line), take));
        }
        Value::Surface(Surface::Nurbs(surface)) => {
            let net = surface.control_points();
            for line in 0..net.n_rows() {
                net.row(line).iter().for_each(|own| point(&own.to_array(), Some(line), take));
            }
        }
        Value::List(items) => items.values().for_each(|item| each_number(&item, take)),
        Value::Record(record) => record.iter().for_each(|(_, value)| each_number(value, take)),
        _ => {}
    }
}

/// Adds the slopes of the [`numbers`] of a value, moved by no steps, to those by each variable.
pub(super) fn slopes(value: &Value, all: &mut [Vec<f64>]) {
    let jet = |jet: &Jet, all: &mut [Vec<f64>]| {
        all.iter_mut().zip(jet.slopes()).for_each(|(own, slope)| own.push(*slope));
    };
    let real = |real: &Real, all: &mut [Vec<f64>]| match real {
        Real::Plain(_) => all.iter_mut().for_each(|own| own.push(0.0)),
        Real::Jet(own) => jet(own, all),
    };
    let points = |n_points: usize, slopes: &PointSlopes, all: &mut [Vec<f64>]| {
        let n = all.first().map_or(0, Vec::len) + 4 * n_points;
        for (variable, own) in slopes.by_variable() {
            all[*variable].extend(own.iter().flat_map(DVec4::to_array));
        }
        all.iter_mut().for_each(|own| own.resize(n, 0.0));
    };
    match value {
        Value::Jet(number) => real(&number.value, all),
        Value::JetPoint(jets) => jets.iter().for_each(|own| jet(own, all)),
        Value::JetRange(range) => {
            [&range.start, &range.end].into_iter().for_each(|end| real(&end.value, all));
        }
        Value::JetCurve(curve) => points(curve.curve().control_points().len(), curve.slopes(), all),
        Value::JetSurface(surface) => {
            points(surface.surface().control_points().as_slice().len(), surface.slopes(), all);
        }
        Value::List(items) if items.numbers().is_none() => {
            items.iter().for_each(|item| slopes(item, all));
        }
        Value::Record(record) => record.iter().for_each(|(_, value)| slopes(value, all)),
        plain => each_number(plain, &mut |_, _| all.iter_mut().for_each(|own| own.push(0.0))),
    }
}

/// Slopes of the [`numbers`] of a value by variables, handed out in their order.
pub(super) struct NumberSlopes<'s> {
    /// How many variables there are.
    pub(super) n_variables: usize,
    /// For those that the value depends on, the slope of each number.
    pub(super) by_variable: &'s [(usize, Vec<f64>)],
    /// How many numbers have theirs.
    pub(super) n_used: usize,
}

impl NumberSlopes<'_> {
    /// A number with its slopes; plain if they are all zero.
    fn real(&mut self, value: f64) -> Option<Real> {
        let mut slopes = vec![0.0; self.n_variables];
        for (variable, own) in self.by_variable {
            slopes[*variable] = own[self.n_used];
        }
        self.n_used += 1;
        if slopes.iter().all(|slope| *slope == 0.0) {
            return Some(Real::Plain(value));
        }
        Jet::with_slopes(value, &slopes).ok().map(Real::Jet)
    }

    fn number(&mut self, number: Number) -> Option<Number<Real>> {
        Some(Number { value: self.real(number.value)?, dim: number.dim })
    }

    fn points(&mut self, n_points: usize) -> Option<PointSlopes> {
        let from = self.n_used;
        self.n_used += 4 * n_points;
        let own = |(variable, slopes): &(usize, Vec<f64>)| {
            let points = slopes[from..self.n_used].chunks_exact(4).map(DVec4::from_slice);
            (*variable, points.collect())
        };
        let by_variable = self.by_variable.iter().map(own).collect();
        PointSlopes::new(self.n_variables, n_points, by_variable).ok()
    }

    fn curve(&mut self, curve: &Arc<NurbsCurve>) -> Option<Value> {
        let slopes = self.points(curve.control_points().len())?;
        if slopes.is_fixed() {
            return Some(Value::Curve(Curve::Nurbs(Arc::clone(curve))));
        }
        Some(Value::JetCurve(Arc::new(VariedCurve::new(Arc::clone(curve), slopes).ok()?)))
    }

    fn surface(&mut self, surface: &Arc<NurbsSurface>) -> Option<Value> {
        let net: &Grid<DVec4> = surface.control_points();
        let slopes = self.points(net.as_slice().len())?;
        if slopes.is_fixed() {
            return Some(Value::Surface(Surface::Nurbs(Arc::clone(surface))));
        }
        Some(Value::JetSurface(Arc::new(VariedSurface::new(Arc::clone(surface), slopes).ok()?)))
    }

    /// A value with the slopes of its numbers; none where one of them is no number.
    pub(super) fn value(&mut self, value: &Value) -> Option<Value> {
        Some(match value {
            Value::Number(number) => self.number(*number)?.into_value(),
            Value::Point(DVec3 { x, y, z }) => {
                Vector::new([self.real(*x)?, self.real(*y)?, self.real(*z)?]).into_value()
            }
            Value::Range(range) => {
                let (start, end) = (self.number(range.start)?, self.number(range.end)?);
                let is_plain = |end: &Number<Real>| matches!(end.value, Real::Plain(_));
                if is_plain(&start) && is_plain(&end) {
                    return Some(value.clone());
                }
                Value::JetRange(Arc::new(JetRange { start, end, closed: range.closed }))
            }
            Value::Curve(Curve::Nurbs(curve)) => self.curve(curve)?,
            Value::Surface(Surface::Nurbs(surface)) => self.surface(surface)?,
            Value::List(items) => {
                let items: Option<Vec<Value>> =
                    items.values().map(|item| self.value(&item)).collect();
                Value::list(items?)
            }
            Value::Record(record) => {
                let field = |(label, value)| Some((Arc::from(label), self.value(value)?));
                let fields: Option<Vec<(Arc<str>, Value)>> = record.iter().map(field).collect();
                Value::Record(Arc::new(Record::new(fields?)))
            }
            other => other.clone(),
        })
    }
}
