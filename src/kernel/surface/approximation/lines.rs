//! Parameter lines of a surface between which patches take the derivatives at their corners.

use glam::DVec3;

use crate::{GeomError, Grid, Interval, KnotVector, curve::blossom_weights, tolerance::LAST_BIT};

/// Order of the derivatives in each direction.
pub(in crate::surface) const ORDER: usize = 2;

/// Degree in each direction.
pub(in crate::surface) const DEGREE: usize = 2 * ORDER + 1;

/// Even parts of each direction to begin with, so that what repeats itself shows.
pub(in crate::surface) const FIRST_PARTS: usize = 3;

/// Parameters of a direction, in order; at creases derivatives are taken on both sides.
#[derive(Clone, Debug)]
pub(in crate::surface) struct ParameterLines {
    pub(in crate::surface) domain: Interval,
    pub(in crate::surface) parameters: Vec<f64>,
    pub(in crate::surface) creases: Vec<f64>,
}

/// A row of control points: where its derivatives are taken, and what each counts.
pub(in crate::surface) struct ControlRow {
    pub(in crate::surface) place: f64,
    pub(in crate::surface) weights: Vec<f64>,
}

/// Derivatives up to [`ORDER`] in each direction.
pub(in crate::surface) type MixedDerivatives = Grid<DVec3>;

/// One cell between neighbouring lines: where its corners are, and where derivatives are taken.
#[derive(Clone, Copy)]
pub(in crate::surface) struct LineCell {
    pub(in crate::surface) u: [f64; 2],
    pub(in crate::surface) v: [f64; 2],
    pub(in crate::surface) places_u: [f64; 2],
    pub(in crate::surface) places_v: [f64; 2],
}

impl ParameterLines {
    pub(in crate::surface) fn new(domain: Interval) -> Self {
        Self { domain, parameters: domain.steps(FIRST_PARTS), creases: Vec::new() }
    }

    pub(in crate::surface) fn n_cells(&self) -> usize {
        self.parameters.len() - 1
    }

    pub(in crate::surface) fn is_crease(&self, t: f64) -> bool {
        self.creases.iter().any(|crease| crease.to_bits() == t.to_bits())
    }

    /// A step that leaves a parameter, and changes nothing but rounding.
    pub(in crate::surface) fn step(&self, t: f64) -> f64 {
        4.0 * LAST_BIT * t.abs().max(self.domain.length())
    }

    /// Both ends of the i-th cell, and where derivatives are taken for them.
    pub(in crate::surface) fn cell(&self, i: usize) -> ([f64; 2], [f64; 2]) {
        let [a, b] = [self.parameters[i], self.parameters[i + 1]];
        let place = |t: f64, sign: f64| if self.is_crease(t) { t + sign * self.step(t) } else { t };
        ([a, b], [place(a, 1.0), place(b, -1.0)])
    }

    /// Adds lines, and tells whether there was room for all.
    pub(in crate::surface) fn add(&mut self, lines: &[f64]) {
        self.parameters.extend_from_slice(lines);
        self.parameters.sort_by(f64::total_cmp);
        self.parameters.dedup();
    }

    /// The rows of control points between the lines, with the knots.
    pub(in crate::surface) fn rows(&self) -> Result<(KnotVector, Vec<ControlRow>), GeomError> {
        let last = self.parameters.len() - 1;
        let (mut knots, mut rows) = (vec![self.domain.start()], Vec::new());
        for (i, &t) in self.parameters.iter().enumerate() {
            let is_end = i == 0 || i == last;
            let before = self.parameters[i.saturating_sub(1)] - t;
            let behind = self.parameters[(i + 1).min(last)] - t;
            let (before_place, behind_place) = (t - self.step(t), t + self.step(t));
            let row = |place: f64| move |weights: Vec<f64>| ControlRow { place, weights };
            if is_end || !self.is_crease(t) {
                let place = match self.is_crease(t) {
                    true if i == 0 => behind_place,
                    true => before_place,
                    false => t,
                };
                knots.extend(vec![t; if is_end { DEGREE } else { ORDER + 1 }]);
                rows.extend(blossom_weights(before, behind, ORDER).into_iter().map(row(place)));
            } else {
                knots.extend(vec![t; DEGREE]);
                rows.extend(blossom_weights(before, 0.0, ORDER).into_iter().map(row(before_place)));
                // The point itself is there already.
                let rest = blossom_weights(0.0, behind, ORDER).into_iter().skip(1);
                rows.extend(rest.map(row(behind_place)));
            }
        }
        knots.push(self.domain.end());
        Ok((KnotVector::new(DEGREE, knots)?, rows))
    }
}

/// The sum of a node's derivatives with these weights.
pub(in crate::surface) fn combined(
    node: &MixedDerivatives,
    weights_u: &[f64],
    weights_v: &[f64],
) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for (k, u) in weights_u.iter().enumerate() {
        for (l, v) in weights_v.iter().enumerate() {
            sum += node.get(k, l) * (u * v);
        }
    }
    sum
}

/// The net of the Bézier patch of a cell.
pub(in crate::surface) fn net(cell: LineCell, corners: &[MixedDerivatives; 4]) -> Grid<DVec3> {
    let sides = |[a, b]: [f64; 2]| {
        let own = blossom_weights(0.0, b - a, ORDER).into_iter().map(|weights| (0, weights));
        let other = blossom_weights(a - b, 0.0, ORDER).into_iter().map(|weights| (1, weights));
        own.chain(other).collect::<Vec<(usize, Vec<f64>)>>()
    };
    let (rows, columns) = (sides(cell.u), sides(cell.v));
    Grid::from_fn(rows.len(), columns.len(), |i, j| {
        let ((side_u, weights_u), (side_v, weights_v)) = (&rows[i], &columns[j]);
        combined(&corners[2 * side_u + side_v], weights_u, weights_v)
    })
}

/// The point of a Bézier patch.
pub(in crate::surface) fn point_of(net: &Grid<DVec3>, a: f64, b: f64) -> DVec3 {
    let value = |row: &[DVec3], t: f64| {
        let mut row = row.to_vec();
        for n_left in (1..row.len()).rev() {
            for i in 0..n_left {
                row[i] = row[i].lerp(row[i + 1], t);
            }
        }
        row[0]
    };
    let column: Vec<DVec3> = (0..net.n_rows()).map(|i| value(net.row(i), b)).collect();
    value(&column, a)
}

pub(in crate::surface) fn between([a, b]: [f64; 2], fraction: f64) -> f64 {
    a * (1.0 - fraction) + b * fraction
}
