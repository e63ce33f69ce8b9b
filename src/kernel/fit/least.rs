//! Splines that come nearest to points: linear least squares.

use glam::{DVec3, DVec4};

use super::equation::Equation;
use crate::kernel::{GeomError, KnotVector, NurbsCurve, tolerance::RANK_RELATIVE};

/// A basis, with the factored equations of a spline over it that begins at the first value, ends
/// at the last, and comes nearest to those between: the sum of the squared distances at the
/// parameters is least. Curves and the rows and columns of surfaces share it.
#[derive(Clone, Debug)]
pub struct Approximator {
    knots: KnotVector,
    /// An equation for each parameter.
    rows: Vec<Equation>,
    factor: Triangle,
}

impl Approximator {
    /// For values at the parameters, over the given knots. O(n·p²) for n parameters.
    ///
    /// # Errors
    /// [`GeomError::Undetermined`] where parts of the spline have too few parameters.
    pub fn new(parameters: &[f64], knots: KnotVector) -> Result<Self, GeomError> {
        let rows: Vec<Equation> = parameters.iter().map(|&t| Equation::point(&knots, t)).collect();
        let n_inner = knots.n_points() - 2;
        let inner = rows.iter().filter_map(|row| inside(row, n_inner));
        let control_points = knots.n_points();
        let factor = Triangle::new(inner, n_inner, knots.degree() + 1)
            .ok_or(GeomError::Undetermined { control_points })?;
        Ok(Self { knots, rows, factor })
    }

    /// The knots of the splines.
    #[must_use]
    pub fn knots(&self) -> &KnotVector {
        &self.knots
    }

    /// The control points of the spline nearest to the values.
    ///
    /// Seminormal equations with one step of refinement, as accurate as a QR factorization:
    /// Björck, *Numerical Methods for Least Squares Problems*, §2.9.
    ///
    /// # Errors
    /// [`GeomError::WrongCount`] unless there is one value a parameter.
    pub fn near(&self, values: &[DVec4]) -> Result<Vec<DVec4>, GeomError> {
        let (needed, got) = (self.rows.len(), values.len());
        if got != needed {
            return Err(GeomError::WrongCount { what: "points", needed, got });
        }
        let mut points = vec![DVec4::ZERO; self.knots.n_points()];
        let last = points.len() - 1;
        (points[0], points[last]) = (values[0], values[got - 1]);
        for _ in 0..2 {
            let correction = self.correction(&points, values);
            for (point, step) in points[1..last].iter_mut().zip(correction) {
                *point += step;
            }
        }
        Ok(points)
    }

    /// What is missing from inner control points.
    fn correction(&self, points: &[DVec4], values: &[DVec4]) -> Vec<DVec4> {
        let mut sums = vec![DVec4::ZERO; points.len()];
        for (row, &value) in self.rows.iter().zip(values) {
            let places = row.columns().zip(&row.values);
            let found = places.clone().fold(DVec4::ZERO, |sum, (i, &n)| sum + n * points[i]);
            for (i, &n) in places {
                sums[i] += n * (value - found);
            }
        }
        let mut inner = sums[1..points.len() - 1].to_vec();
        self.factor.solve_normal(&mut inner);
        inner
    }

    /// The polynomial curve nearest to points.
    ///
    /// # Errors
    /// Those of [`Self::near`].
    pub fn curve(&self, points: &[DVec3]) -> Result<NurbsCurve, GeomError> {
        let values: Vec<DVec4> = points.iter().map(|point| point.extend(1.0)).collect();
        let found: Vec<DVec3> = self.near(&values)?.into_iter().map(DVec4::truncate).collect();
        NurbsCurve::polynomial(self.knots.clone(), &found)
    }
}

/// The part of an equation that is about the control points between the first and the last.
fn inside(row: &Equation, n_inner: usize) -> Option<Equation> {
    let columns = row.columns();
    let (start, end) = (columns.start.max(1), columns.end.min(n_inner + 1));
    let values = row.values.get(start - row.first..end.checked_sub(row.first)?)?.to_vec();
    (!values.is_empty()).then_some(Equation { first: start - 1, values })
}

/// The triangular factor of a band of equations, more than there are unknowns.
///
/// Givens rotations, an equation after the other. Golub & Van Loan, *Matrix Computations*, §5.2.
#[derive(Clone, Debug)]
struct Triangle {
    width: usize,
    /// Rows from the diagonal on.
    rows: Vec<f64>,
}

impl Triangle {
    /// `None` where the equations leave an unknown open.
    fn new(equations: impl Iterator<Item = Equation>, n: usize, width: usize) -> Option<Self> {
        let mut rows = vec![0.0; n * width];
        for equation in equations {
            let mut row = vec![0.0; width];
            row[..equation.values.len()].copy_from_slice(&equation.values);
            for i in equation.first..n {
                if row.iter().all(|value| value.abs() <= 0.0) {
                    break;
                }
                rotate(&mut rows[i * width..][..width], &mut row);
                row.rotate_left(1);
            }
        }
        let diagonal = || rows.iter().step_by(width);
        let largest = diagonal().fold(0.0_f64, |most, value| most.max(value.abs()));
        let is_open = |value: &f64| value.abs() <= RANK_RELATIVE * largest;
        if diagonal().any(is_open) { None } else { Some(Self { width, rows }) }
    }

    /// Solves RᵀR x = values in place.
    fn solve_normal(&self, values: &mut [DVec4]) {
        let n = values.len();
        for i in 0..n {
            let row = &self.rows[i * self.width..][..self.width];
            values[i] /= row[0];
            let value = values[i];
            for (later, &coefficient) in values[i + 1..].iter_mut().zip(&row[1..]) {
                *later -= coefficient * value;
            }
        }
        for i in (0..n).rev() {
            let row = &self.rows[i * self.width..][..self.width];
            let known = row[1..].iter().zip(&values[i + 1..]);
            let sum =
                known.fold(values[i], |sum, (&coefficient, &value)| sum - coefficient * value);
            values[i] = sum / row[0];
        }
    }
}

/// Turns two rows so that the second begins with zero.
fn rotate(upper: &mut [f64], lower: &mut [f64]) {
    let length = libm::hypot(upper[0], lower[0]);
    if length <= 0.0 {
        return;
    }
    let (cosine, sine) = (upper[0] / length, lower[0] / length);
    for (a, b) in upper.iter_mut().zip(lower) {
        (*a, *b) = (cosine * *a + sine * *b, cosine * *b - sine * *a);
    }
    // What rounding leaves there would be rotated on.
}
