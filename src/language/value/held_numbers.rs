//! The numbers of plain arguments, some of which are moved.

use std::sync::Arc;

use super::{
    Number, Range, Value,
    numbers::{NumberPlaces, OTHER_NUMBER, SparseNumbers, numbers},
};
use crate::kernel::{Curve, Grid, NurbsCurve, NurbsSurface, Surface};

/// Arguments without derivatives.
pub(super) struct HeldNumbers {
    pub(super) args: Vec<Value>,
    pub(super) places: NumberPlaces,
    /// The [`numbers`] of all of them.
    pub(super) all: Vec<f64>,
}

impl HeldNumbers {
    pub(super) fn new(args: Vec<Value>) -> Self {
        let (places, mut all) = (NumberPlaces::of(&args), Vec::new());
        args.iter().for_each(|arg| numbers(arg, &mut all));
        Self { args, places, all }
    }

    /// The step along a direction over which what moves goes by its own size; none where nothing does.
    pub(super) fn unit_step(&self, direction: &SparseNumbers) -> Option<f64> {
        let slope = direction.iter().fold(0.0, |most: f64, (_, slope)| most.max(slope.abs()));
        if slope == 0.0 {
            return None;
        }
        // A point is as large as the largest of its coordinates.
        let size = |at: usize| {
            let (axis, point) = self.places.numbers[at];
            match axis {
                OTHER_NUMBER => self.all[at].abs(),
                _ => {
                    let first = self.places.points[point];
                    self.all[first..first + 3]
                        .iter()
                        .fold(0.0, |most: f64, own| most.max(own.abs()))
                }
            }
        };
        let size = direction.iter().map(|(at, _)| size(*at)).fold(0.0, f64::max);
        Some(unit_step(slope, size))
    }

    /// The arguments with their numbers moved along a direction; none where control points cannot go so far.
    pub(super) fn moved(&self, direction: &SparseNumbers, step: f64) -> Option<Vec<Value>> {
        let mut moving = NumbersMoved { left: direction, step, n_before: 0 };
        self.args.iter().map(|arg| moving.value(arg)).collect()
    }
}

/// The step over which what has such a slope moves by such a size: a power of two, so that a step costs no digits of its
/// own.
pub(super) fn unit_step(slope: f64, size: f64) -> f64 {
    let ratio = if size == 0.0 { slope.recip() } else { size / slope };
    libm::exp2(libm::log2(ratio).round())
}

/// Hands out values whose numbers are moved, in the order of these.
struct NumbersMoved<'d> {
    /// The slopes that are left.
    left: &'d [(usize, f64)],
    step: f64,
    /// How many numbers have been told.
    n_before: usize,
}

impl<'d> NumbersMoved<'d> {
    /// By how much those of the next numbers go that move, each with its place among these.
    fn next(&mut self, n_numbers: usize) -> impl ExactSizeIterator<Item = (usize, f64)> + use<'d> {
        let (from, step) = (self.n_before, self.step);
        self.n_before += n_numbers;
        let n_own = self.left.iter().take_while(|(at, _)| *at < self.n_before).count();
        let (own, behind) = self.left.split_at(n_own);
        self.left = behind;
        own.iter().map(move |(at, slope)| (at - from, step * slope))
    }

    fn number(&mut self, number: Number) -> Number {
        let growth: f64 = self.next(1).map(|(_, growth)| growth).sum();
        Number { value: number.value + growth, dim: number.dim }
    }

    fn curve(&mut self, curve: &Arc<NurbsCurve>) -> Option<Value> {
        let growths = self.next(4 * curve.control_points().len());
        if growths.len() == 0 {
            return Some(Value::Curve(Curve::Nurbs(Arc::clone(curve))));
        }
        let mut points = curve.control_points().to_vec();
        growths.for_each(|(at, growth)| points[at / 4][at % 4] += growth);
        let moved = NurbsCurve::new(curve.knots().clone(), points).ok()?;
        Some(Value::Curve(Curve::Nurbs(Arc::new(moved))))
    }

    fn surface(&mut self, surface: &Arc<NurbsSurface>) -> Option<Value> {
        let net = surface.control_points();
        let growths = self.next(4 * net.as_slice().len());
        if growths.len() == 0 {
            return Some(Value::Surface(Surface::Nurbs(Arc::clone(surface))));
        }
        let mut points = net.as_slice().to_vec();
        growths.for_each(|(at, growth)| points[at / 4][at % 4] += growth);
        let net = Grid::new(net.n_rows(), net.n_columns(), points).ok()?;
        let [u, v] = [surface.knots_u(), surface.knots_v()].map(Clone::clone);
        Some(Value::Surface(Surface::Nurbs(Arc::new(NurbsSurface::new(u, v, net).ok()?))))
    }

    fn value(&mut self, value: &Value) -> Option<Value> {
        if self.left.is_empty() {
            return Some(value.clone());
        }
        Some(match value {
            Value::Number(number) => Value::Number(self.number(*number)),
            Value::Point(point) => {
                let mut moved = *point;
                self.next(3).for_each(|(axis, growth)| moved[axis] += growth);
                Value::Point(moved)
            }
            Value::Range(range) => Value::Range(Range {
                start: self.number(range.start),
                end: self.number(range.end),
                closed: range.closed,
            }),
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
