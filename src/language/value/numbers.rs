//! Values that can be differentiated as numbers, one behind the other, with their slopes.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{IntoValue, JetRange, Number, Real, Value, Vector};
use crate::kernel::{
    Curve, Grid, Jet, NurbsCurve, NurbsSurface, PointSlopes, Surface, VariedCurve, VariedSurface,
};

/// What a number is that is no coordinate of a point, beside 0, 1 and 2 for x, y and z.
pub(super) const OTHER_NUMBER: usize = 3;

/// Numbers that are not zero, each with where it stands among all, in this order.
pub(super) type SparseNumbers = Vec<(usize, f64)>;

/// Points in rows: the control points of a curve, one in each row, those of a surface, a list of points, or a point by
/// itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointNet {
    /// How many rows and columns.
    pub(super) size: [usize; 2],
    /// Its first point among all points and other numbers.
    pub(super) first: usize,
    /// Which list it stands in, if any.
    pub(super) list: Option<usize>,
}

/// Where the [`numbers`] of values stand.
#[derive(Clone, Debug, Default)]
pub(super) struct NumberPlaces {
    /// Which coordinate of a point each is, or [`OTHER_NUMBER`], and to which point it belongs, where each number
    /// outside of points is one.
    pub(super) numbers: Vec<(usize, usize)>,
    /// The first number of each point.
    pub(super) points: Vec<usize>,
    pub(super) nets: Vec<PointNet>,
    n_lists: usize,
}

impl NumberPlaces {
    pub(super) fn of<'v>(values: impl IntoIterator<Item = &'v Value>) -> Self {
        let mut places = Self::default();
        values.into_iter().for_each(|value| places.add(value, None));
        places
    }

    fn add_points(&mut self, n_points: usize, n_coordinates: usize) {
        for _ in 0..n_points {
            self.points.push(self.numbers.len());
            let point = self.points.len() - 1;
            self.numbers.extend((0..n_coordinates).map(|axis| (axis, point)));
        }
    }

    fn add_net(&mut self, size: [usize; 2], n_coordinates: usize, list: Option<usize>) {
        self.nets.push(PointNet { size, first: self.points.len(), list });
        self.add_points(size[0] * size[1], n_coordinates);
    }

    fn add(&mut self, value: &Value, list: Option<usize>) {
        match value {
            Value::Point(_) => self.add_net([1, 1], 3, list),
            Value::Curve(Curve::Nurbs(curve)) => {
                self.add_net([curve.control_points().len(), 1], 4, list);
            }
            Value::Surface(Surface::Nurbs(surface)) => {
                let net = surface.control_points();
                self.add_net([net.n_rows(), net.n_columns()], 4, list);
            }
            Value::List(items) => {
                let are_points = items.values().all(|item| matches!(item, Value::Point(_)));
                if are_points {
                    return self.add_net([items.len(), 1], 3, list);
                }
                let own = self.n_lists;
                self.n_lists += 1;
                items.values().for_each(|item| self.add(&item, Some(own)));
            }
            Value::Record(record) => record.iter().for_each(|(_, value)| self.add(value, None)),
            other => each_number(other, &mut |_| {
                self.points.push(self.numbers.len());
                self.numbers.push((OTHER_NUMBER, self.points.len() - 1));
            }),
        }
    }

    /// Whether several curves or surfaces stand in one list.
    pub(super) fn has_lists(&self) -> bool {
        let mut lists = self.nets.iter().filter_map(|net| net.list).peekable();
        while let Some(list) = lists.next() {
            if lists.peek() == Some(&list) {
                return true;
            }
        }
        false
    }

    /// The net that a point belongs to, and its row and column there; none where it is in none.
    pub(super) fn in_net(&self, point: usize) -> Option<(usize, [usize; 2])> {
        let net = self.nets.partition_point(|net| net.first <= point).checked_sub(1)?;
        let PointNet { size: [n_rows, n_columns], first, .. } = self.nets[net];
        let idx = point - first;
        (idx < n_rows * n_columns).then(|| (net, [idx / n_columns, idx % n_columns]))
    }
}

/// The numbers of a value, one behind the other: of numbers, points, ranges, lists and records, and of
/// control points with their weights.
pub(super) fn numbers(value: &Value, all: &mut Vec<f64>) {
    each_number(value, &mut |number| all.push(number));
}

fn each_number(value: &Value, take: &mut dyn FnMut(f64)) {
    let point = |numbers: &[f64], take: &mut dyn FnMut(f64)| {
        numbers.iter().for_each(|number| take(*number));
    };
    match value {
        Value::Number(number) => take(number.value),
        Value::Point(own) => point(&own.to_array(), take),
        Value::Range(range) => {
            [range.start, range.end].into_iter().for_each(|end| take(end.value));
        }
        Value::Curve(Curve::Nurbs(curve)) => {
            curve.control_points().iter().for_each(|own| point(&own.to_array(), take));
        }
        Value::Surface(Surface::Nurbs(surface)) => {
            let net = surface.control_points().as_slice();
            net.iter().for_each(|own| point(&own.to_array(), take));
        }
        Value::List(items) => items.values().for_each(|item| each_number(&item, take)),
        Value::Record(record) => record.iter().for_each(|(_, value)| each_number(value, take)),
        _ => {}
    }
}

/// Adds the slopes of the [`numbers`] of a value, moved by no steps, to those by each variable, behind so many numbers;
/// how many there are with its own.
pub(super) fn slopes(value: &Value, behind: usize, all: &mut [SparseNumbers]) -> usize {
    let jet = |jet: &Jet, at: usize, all: &mut [SparseNumbers]| {
        let own = all.iter_mut().zip(jet.slopes()).filter(|(_, slope)| **slope != 0.0);
        own.for_each(|(own, slope)| own.push((at, *slope)));
        at + 1
    };
    let real = |real: &Real, at: usize, all: &mut [SparseNumbers]| match real {
        Real::Plain(_) => at + 1,
        Real::Jet(own) => jet(own, at, all),
    };
    let points = |n_points: usize, slopes: &PointSlopes, all: &mut [SparseNumbers]| {
        for (variable, own) in slopes.by_variable() {
            let numbers = own.iter().flat_map(DVec4::to_array);
            let moving = (behind..).zip(numbers).filter(|(_, slope)| *slope != 0.0);
            all[*variable].extend(moving);
        }
        behind + 4 * n_points
    };
    match value {
        Value::Jet(number) => real(&number.value, behind, all),
        Value::JetPoint(jets) => jets.iter().fold(behind, |at, own| jet(own, at, all)),
        Value::JetRange(range) => {
            let ends = [&range.start, &range.end];
            ends.into_iter().fold(behind, |at, end| real(&end.value, at, all))
        }
        Value::JetCurve(curve) => points(curve.curve().control_points().len(), curve.slopes(), all),
        Value::JetSurface(surface) => {
            points(surface.surface().control_points().as_slice().len(), surface.slopes(), all)
        }
        Value::List(items) if items.numbers().is_none() => {
            items.iter().fold(behind, |at, item| slopes(item, at, all))
        }
        Value::Record(record) => {
            record.iter().fold(behind, |at, (_, value)| slopes(value, at, all))
        }
        plain => {
            let mut n = behind;
            each_number(plain, &mut |_| n += 1);
            n
        }
    }
}

/// Slopes of the [`numbers`] of a value by variables, handed out in their order.
pub(super) struct NumberSlopes<'s> {
    /// How many variables there are.
    n_variables: usize,
    /// For each of those that the value depends on, the slopes that are left.
    left: Vec<(usize, &'s [(usize, f64)])>,
    /// How many numbers have theirs.
    n_used: usize,
}

impl<'s> NumberSlopes<'s> {
    pub(super) fn new(n_variables: usize, by_variable: &'s [(usize, SparseNumbers)]) -> Self {
        let left = by_variable.iter().map(|(variable, own)| (*variable, &own[..])).collect();
        Self { n_variables, left, n_used: 0 }
    }

    /// The slopes of the next numbers by each variable that moves one of them, with their places among these.
    fn next(&mut self, n_numbers: usize) -> Vec<(usize, &'s [(usize, f64)])> {
        self.n_used += n_numbers;
        let mut found = Vec::new();
        for (variable, left) in &mut self.left {
            let n_own = left.iter().take_while(|(at, _)| *at < self.n_used).count();
            let (own, behind) = left.split_at(n_own);
            *left = behind;
            if !own.is_empty() {
                found.push((*variable, own));
            }
        }
        found
    }

    /// A number with its slopes; plain if they are all zero.
    fn real(&mut self, value: f64) -> Option<Real> {
        let own = self.next(1);
        if own.is_empty() {
            return Some(Real::Plain(value));
        }
        let mut slopes = vec![0.0; self.n_variables];
        own.into_iter().for_each(|(variable, own)| slopes[variable] = own[0].1);
        Jet::with_slopes(value, &slopes).ok().map(Real::Jet)
    }

    fn number(&mut self, number: Number) -> Option<Number<Real>> {
        Some(Number { value: self.real(number.value)?, dim: number.dim })
    }

    fn points(&mut self, n_points: usize) -> Option<PointSlopes> {
        let from = self.n_used;
        let own = |(variable, slopes): (usize, &[(usize, f64)])| {
            let mut points = vec![DVec4::ZERO; n_points];
            for (at, slope) in slopes {
                points[(at - from) / 4][(at - from) % 4] = *slope;
            }
            (variable, points)
        };
        let by_variable = self.next(4 * n_points).into_iter().map(own).collect();
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
                Value::Record(Arc::new(record.mapped(|value| self.value(value))?))
            }
            other => other.clone(),
        })
    }
}

#[cfg(test)]
mod tests;
