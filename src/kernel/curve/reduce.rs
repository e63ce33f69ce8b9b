//! A lower degree, with the deviation that it costs.

use glam::DVec4;

use super::NurbsCurve;
use crate::{
    DegreeError, FitError, GeomError, KnotError, KnotVector, WeightError, refine::ControlLines,
    removal::removal,
};

impl NurbsCurve {
    /// The curve at another degree below its own, or at the lowest that the tolerance allows.
    ///
    /// Each step is the spline of one degree less, with every inner knot once less where it is
    /// repeated, that elevates to the nearest control points, the ends kept; it is accepted when
    /// no point of the whole curve is further than the tolerance from where it was.
    ///
    /// # Errors
    /// [`DegreeError::LowestDegree`]; [`FitError::NotReducible`] with the deviation where the
    /// tolerance allows no step, or not that degree.
    pub fn reduced(&self, degree: Option<usize>, tolerance: f64) -> Result<Self, GeomError> {
        let to = degree.unwrap_or(1).max(1);
        if self.degree() <= to {
            return Err(DegreeError::LowestDegree { degree: self.degree() }.into());
        }
        let mut reduced = self.clamped();
        while to < reduced.degree() {
            let next = reduced.reduced_once()?;
            // A curve whose weights are none is no curve at any distance.
            let error = next.as_ref().map_or(f64::INFINITY, |next| self.deviation_from(next));
            match next {
                Some(next) if error <= tolerance => reduced = next,
                _ if degree.is_some() || reduced.degree() == self.degree() => {
                    let degree = reduced.degree() - 1;
                    return Err(FitError::NotReducible { degree, error, tolerance }.into());
                }
                _ => break,
            }
        }
        Ok(reduced)
    }

    /// The same curve without a knot, as many times as asked for.
    ///
    /// # Errors
    /// [`KnotError::NoKnot`] where none stands inside the domain, or not so often;
    /// [`FitError::KnotNeeded`] with the deviation where it is more than the tolerance.
    pub fn without_knot(&self, t: f64, times: usize, tolerance: f64) -> Result<Self, GeomError> {
        let domain = self.domain();
        let knot = self.knots.snapped(domain.clamp_inside(t)?);
        let stands =
            if domain.start() < knot && knot < domain.end() { self.knots.times(knot) } else { 0 };
        if stands < times {
            let distance = |a: &f64| (a - t).abs();
            let inner =
                self.knots.breaks().into_iter().filter(|&t| domain.start() < t && t < domain.end());
            let nearest = inner.min_by(|a, b| distance(a).total_cmp(&distance(b)));
            return Err(KnotError::NoKnot { parameter: t, stands, nearest }.into());
        }
        let mut knots = self.knots.as_slice().to_vec();
        let mut points = self.control_points.clone();
        for _ in 0..times {
            let index = knots.partition_point(|&other| other <= knot) - 1;
            let removal = removal(self.degree(), &knots, &points, index);
            points.splice(removal.range, removal.points);
            knots.remove(index);
        }
        let knots = KnotVector::new(self.degree(), knots)?;
        let error = match Self::with_positive(knots, points) {
            Ok(curve) => match self.deviation_from(&curve) {
                error if error <= tolerance => return Ok(curve),
                error => error,
            },
            // Weights that are not positive are no curve at any distance.
            Err(_) => f64::INFINITY,
        };
        Err(GeomError::Fit(FitError::KnotNeeded { knot, error, tolerance }))
    }

    /// The curve, if all its weights are positive.
    fn with_positive(knots: KnotVector, points: Vec<DVec4>) -> Result<Self, GeomError> {
        match points.iter().position(|point| point.w <= 0.0) {
            Some(index) => {
                Err(GeomError::Weights(WeightError::BadWeight { index, weight: points[index].w }))
            }
            None => Self::new(knots, points),
        }
    }

    /// The nearest clamped spline of one degree less; none if its weights are not positive.
    fn reduced_once(&self) -> Result<Option<Self>, GeomError> {
        let knots = self.knots.lowered();
        let target = knots.elevated()?;
        let domain = self.domain();
        let missing = |(t, times): (f64, usize)| vec![t; times.saturating_sub(self.knots.times(t))];
        let inner =
            target.distinct().into_iter().filter(|&(t, _)| domain.start() < t && t < domain.end());
        let refined = self.insert_knots(&inner.flat_map(missing).collect::<Vec<f64>>())?;
        let points = Elevation::new(&knots)?.nearest(&refined.control_points);
        Ok(Self::with_positive(knots, points).ok())
    }
}

/// The matrix of degree elevation by one: row i has the shares of old points in new point i.
struct Elevation {
    /// First column of each row that is not zero.
    firsts: Vec<usize>,
    /// The shares from there on, as many as the old degree and one.
    rows: Vec<Vec<f64>>,
    n_columns: usize,
}

impl Elevation {
    fn new(knots: &KnotVector) -> Result<Self, GeomError> {
        let (n_columns, width) = (knots.n_points(), knots.degree() + 1);
        // Columns that share no row are elevated together.
        let ones = |color: usize| -> Vec<DVec4> {
            let entry = |j: usize| if j % width == color { DVec4::X } else { DVec4::ZERO };
            (0..n_columns).map(entry).collect()
        };
        let lines = ControlLines { knots: knots.clone(), lines: (0..width).map(ones).collect() };
        let elevated = lines.elevated(width)?;
        let (mut firsts, mut rows) = (Vec::new(), Vec::new());
        for i in 0..elevated.knots.n_points() {
            let start = elevated.knots.as_slice()[i];
            let last = knots.as_slice()[..n_columns].partition_point(|&knot| knot <= start) - 1;
            let first = (last + 1).saturating_sub(width);
            let share = |j: usize| elevated.lines[j % width][i].x;
            rows.push((first..(first + width).min(n_columns)).map(share).collect());
            firsts.push(first);
        }
        Ok(Self { firsts, rows, n_columns })
    }

    /// The old points, the first and the last kept, that elevate to points nearest to the given
    /// ones in the sense of least squares.
    fn nearest(&self, points: &[DVec4]) -> Vec<DVec4> {
        let n = self.n_columns;
        let mut solution = vec![DVec4::ZERO; n];
        (solution[0], solution[n - 1]) = (points[0], points[points.len() - 1]);
        let normal = self.normal_equations();
        // Twice, because the normal equations square the condition.
        for _ in 0..2 {
            let mut gradient = vec![DVec4::ZERO; n];
            for ((&first, row), &point) in self.firsts.iter().zip(&self.rows).zip(points) {
                let image: DVec4 = row.iter().zip(&solution[first..]).map(|(&e, &q)| q * e).sum();
                for (&share, sum) in row.iter().zip(&mut gradient[first..]) {
                    *sum += (point - image) * share;
                }
            }
            normal.solve(&mut gradient);
            for (value, step) in solution.iter_mut().zip(&gradient) {
                *value += *step;
            }
        }
        solution
    }

    /// The product of the transposed matrix with itself; the first and the last unknown are fixed.
    fn normal_equations(&self) -> Cholesky {
        let width = self.rows.iter().map(Vec::len).max().unwrap_or(1);
        let n = self.n_columns;
        let mut bands = vec![vec![0.0; width]; n];
        for (&first, row) in self.firsts.iter().zip(&self.rows) {
            for (i, &a) in row.iter().enumerate() {
                for (j, &b) in row[..=i].iter().enumerate() {
                    bands[first + i][i - j] += a * b;
                }
            }
        }
        for fixed in [0, n - 1] {
            bands[fixed] = vec![0.0; width];
            for below in 1..width {
                if fixed + below < n {
                    bands[fixed + below][below] = 0.0;
                }
            }
            bands[fixed][0] = 1.0;
        }
        Cholesky::new(bands, [0, n - 1])
    }
}

/// A symmetric positive definite band matrix as the product of a triangle and its transpose.
/// Golub & Van Loan, *Matrix Computations*, §4.3.5.
struct Cholesky {
    /// Entry `[i][k]` stands k places left of the diagonal.
    bands: Vec<Vec<f64>>,
    /// Unknowns that stay as they are.
    fixed: [usize; 2],
}

impl Cholesky {
    fn new(mut bands: Vec<Vec<f64>>, fixed: [usize; 2]) -> Self {
        for i in 0..bands.len() {
            let width = bands[i].len().min(i + 1);
            for k in (0..width).rev() {
                let j = i - k;
                let common = (k + 1..width)
                    .map(|l| bands[i][l] * bands[j].get(l - k).copied().unwrap_or(0.0));
                let rest = bands[i][k] - common.sum::<f64>();
                bands[i][k] = if k == 0 { rest.sqrt() } else { rest / bands[j][0] };
            }
        }
        Self { bands, fixed }
    }

    fn solve(&self, values: &mut [DVec4]) {
        for fixed in self.fixed {
            values[fixed] = DVec4::ZERO;
        }
        for i in 0..values.len() {
            let row = &self.bands[i];
            let sum: DVec4 = (1..row.len().min(i + 1)).map(|k| values[i - k] * row[k]).sum();
            values[i] = (values[i] - sum) / row[0];
        }
        for i in (0..values.len()).rev() {
            values[i] /= self.bands[i][0];
            let value = values[i];
            for k in 1..self.bands[i].len().min(i + 1) {
                values[i - k] -= value * self.bands[i][k];
            }
        }
    }
}
