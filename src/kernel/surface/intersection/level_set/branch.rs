//! Pieces of the zero set of a polynomial on the unit square that are graphs.

use std::rc::Rc;

use crate::{
    Grid, Interval, bernstein,
    numeric::polynomial_roots::{Signs, monotone_root},
    surface::intersection::square,
    tolerance::KNOT_RELATIVE,
};

/// Over an interval of one parameter a graph of the other, on a cell of a patch.
#[derive(Clone, Debug)]
pub(super) struct Branch {
    /// Grows or falls along its second parameter; none where the branch is straight.
    field: Option<Rc<PolynomialWithSlope>>,
    /// The cell, by fractions of the patch; its parameters exchanged with those of the field.
    low: [f64; 2],
    high: [f64; 2],
    is_swapped: bool,
    /// Where it begins and ends, by the first parameter of the field.
    ends: [f64; 2],
}

/// A polynomial with its derivative by its first parameter.
#[derive(Debug)]
struct PolynomialWithSlope {
    field: Grid<f64>,
    by_u: Grid<f64>,
}

impl Branch {
    /// All branches in a cell, from its low to its high corner, where the field's slope along v has the sign `is_rising`, or along
    /// u where the field is `swapped`: between two neighbouring roots on the sides across v the
    /// graph is inside the cell all the way or not at all.
    pub(super) fn all(
        cell: [[f64; 2]; 2],
        field: Grid<f64>,
        is_swapped: bool,
        is_rising: bool,
        rounding: f64,
    ) -> Vec<Self> {
        let sign = if is_rising { 1.0 } else { -1.0 };
        let sides = [field.column(0), field.column(field.n_columns() - 1)];
        let mut places = vec![0.0, 1.0];
        for side in &sides {
            let mut signs = Signs::default();
            signs.follow(Interval::UNIT, side, rounding);
            places.extend(signs.changes().iter().map(|&(t, _)| t));
        }
        places.sort_by(f64::total_cmp);
        places.dedup_by(|later, earlier| *later - *earlier <= KNOT_RELATIVE);
        let is_inside = |t: f64| {
            let [below, above] = sides.each_ref().map(|side| sign * bernstein::value(side, t));
            below <= 0.0 && 0.0 <= above
        };
        let mut stretches: Vec<[f64; 2]> = Vec::new();
        for ends in places.windows(2) {
            if !is_inside(0.5 * (ends[0] + ends[1])) {
                continue;
            }
            match stretches.last_mut() {
                Some(last) if last[1].total_cmp(&ends[0]).is_eq() => last[1] = ends[1],
                _ => stretches.push([ends[0], ends[1]]),
            }
        }
        let field = Rc::new(PolynomialWithSlope { by_u: square::slope_u(&field), field });
        let [low, high] = cell.map(|corner| swapped(corner, is_swapped));
        let branch = |ends: [f64; 2]| Self {
            field: Some(Rc::clone(&field)),
            low,
            high,
            is_swapped,
            // The higher side is to the left.
            ends: if is_rising == is_swapped { [ends[1], ends[0]] } else { ends },
        };
        stretches.into_iter().map(branch).collect()
    }

    /// A side of the patch: where the parameter of the index is constant.
    pub(super) fn side(constant: usize, fraction: f64) -> Self {
        Self {
            field: None,
            low: [0.0, fraction],
            high: [1.0, fraction],
            is_swapped: constant == 0,
            ends: [0.0, 1.0],
        }
    }

    /// A fraction of the way along, by fractions of the patch: the place, and the direction in which
    /// it runs there, of any length; zero where the field has no slope.
    pub(super) fn at(&self, fraction: f64) -> [[f64; 2]; 2] {
        let width = [0, 1].map(|i| self.high[i] - self.low[i]);
        let u = self.ends[0] * (1.0 - fraction) + self.ends[1] * fraction;
        let (v, slopes) = match &self.field {
            None => (0.0, [width[0], 0.0]),
            Some(sloped) => {
                let PolynomialWithSlope { field, by_u } = &**sloped;
                let line = square::along_v(field, u);
                let v_slopes = bernstein::derivative(&line);
                let v = monotone_root(&line, &v_slopes);
                let (by_u, by_v) = (square::value(by_u, [u, v]), bernstein::value(&v_slopes, v));
                let forward = if self.ends[0] < self.ends[1] { 1.0 } else { -1.0 };
                let sign = forward * if by_v < 0.0 { -1.0 } else { 1.0 };
                (v, [sign * by_v * width[0], -sign * by_u * width[1]])
            }
        };
        let along = |i: usize, t: f64| self.low[i] * (1.0 - t) + self.high[i] * t;
        [[along(0, u), along(1, v)], slopes].map(|pair| swapped(pair, self.is_swapped))
    }

    /// The place a fraction of the way along, in fractions of the patch.
    pub(super) fn place(&self, fraction: f64) -> [f64; 2] {
        self.at(fraction)[0]
    }
}

fn swapped([a, b]: [f64; 2], is_swapped: bool) -> [f64; 2] {
    if is_swapped { [b, a] } else { [a, b] }
}
