//! How far a spline reaches in the direction of an axis, to rounding.
//!
//! A Bézier piece reaches no further than its control points, and as far as its corners. Pieces
//! whose control points stay behind a corner found already are dropped; the one that promises
//! most is halved. The promise comes down to the corners with the square of the size.

use std::{cmp::Ordering, collections::BinaryHeap};

use glam::{DVec3, DVec4};

use super::{
    Bounds, Direction, Grid, KnotVector, bezier, ceiling::HULL_PIECES, homogeneous::project,
    tolerance::BOUNDS_RELATIVE,
};

/// A tensor-product spline; a curve is one with a single row.
#[derive(Clone, Copy)]
pub(crate) struct TensorSpline<'a> {
    /// Knots along the rows' index and along the columns'.
    pub(crate) knots: [&'a KnotVector; 2],
    /// Homogeneous control points, with a positive denominator on the whole domain.
    pub(crate) points: &'a Grid<DVec4>,
}

/// A direction along an axis.
#[derive(Clone, Copy)]
struct AxisDirection {
    axis: usize,
    sign: f64,
}

/// A part of the spline with how far its control points reach.
struct SplinePart {
    promise: f64,
    shape: HullShape,
}

enum HullShape {
    /// A pair of spans, not cut out yet.
    Spans(usize, usize),
    /// The net of a Bézier patch.
    Net(Grid<DVec4>),
}

impl TensorSpline<'_> {
    /// The smallest box around all points of the spline.
    pub(crate) fn bounds(self) -> Bounds {
        let reach = |sign: f64| {
            // The sum turns a negative zero into a positive one.
            let along = |axis: usize| sign * self.reach(AxisDirection { axis, sign }) + 0.0;
            DVec3::new(along(0), along(1), along(2))
        };
        Bounds { min: reach(-1.0), max: reach(1.0) }
    }

    fn reach(self, direction: AxisDirection) -> f64 {
        let mut reached = f64::NEG_INFINITY;
        let mut parts: BinaryHeap<SplinePart> = self.spans(direction).into();
        for _ in 0..HULL_PIECES {
            let Some(part) = parts.pop() else { return reached };
            if part.promise <= reached + BOUNDS_RELATIVE * reached.abs() {
                return reached;
            }
            let nets = match part.shape {
                HullShape::Spans(u, v) => vec![bezier::patch(self.knots, self.points, u, v)],
                HullShape::Net(net) => bezier::halves(&net, direction.halved(&net)).into(),
            };
            for net in nets {
                reached = reached.max(direction.corner_reach(&net));
                let promise = direction.promise(net.iter());
                if reached < promise {
                    parts.push(SplinePart { promise, shape: HullShape::Net(net) });
                }
            }
        }
        parts
            .peek()
            .map_or(reached, |part| if part.promise.is_finite() { part.promise } else { reached })
    }

    fn spans(self, direction: AxisDirection) -> Vec<SplinePart> {
        let [knots_u, knots_v] = self.knots;
        let mut parts = Vec::new();
        for u in knots_u.spans() {
            for v in knots_v.spans() {
                let rows = knots_u.support(u).map(|i| &self.points.row(i)[knots_v.support(v)]);
                let promise = direction.promise(rows.flatten());
                parts.push(SplinePart { promise, shape: HullShape::Spans(u, v) });
            }
        }
        parts
    }
}

impl AxisDirection {
    /// How far the control points reach; a weight that is not positive promises nothing.
    fn promise<'a>(self, points: impl Iterator<Item = &'a DVec4>) -> f64 {
        let reach = |point: &DVec4| {
            if point.w <= 0.0 { f64::INFINITY } else { self.sign * point[self.axis] / point.w }
        };
        points.map(reach).fold(f64::NEG_INFINITY, f64::max)
    }

    fn corner_reach(self, net: &Grid<DVec4>) -> f64 {
        let (last_row, last_column) = (net.n_rows() - 1, net.n_columns() - 1);
        [(0, 0), (0, last_column), (last_row, 0), (last_row, last_column)]
            .into_iter()
            .map(|(i, j)| self.sign * project(net.get(i, j))[self.axis])
            .fold(f64::NEG_INFINITY, f64::max)
    }

    /// The direction along which halving brings the control points nearer to one another.
    fn halved(self, net: &Grid<DVec4>) -> Direction {
        let about = project(net.get(0, 0))[self.axis];
        let height = |point: DVec4| point[self.axis] - about * point.w;
        let bend = |line: &[DVec4]| {
            line.windows(2).map(|pair| (height(pair[1]) - height(pair[0])).abs()).sum::<f64>()
        };
        let along_v: f64 = (0..net.n_rows()).map(|i| bend(net.row(i))).sum();
        let along_u: f64 = (0..net.n_columns()).map(|j| bend(&net.column(j))).sum();
        let is_line = net.n_columns() == 1;
        let is_shorter = net.n_rows() > 1 && (is_line || along_v < along_u);
        if is_shorter { Direction::U } else { Direction::V }
    }
}

impl Ord for SplinePart {
    fn cmp(&self, other: &Self) -> Ordering {
        self.promise.total_cmp(&other.promise)
    }
}

impl PartialOrd for SplinePart {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for SplinePart {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for SplinePart {}
