//! A lower degree, with the deviation that it costs.

use glam::DVec4;

use crate::{
    DegreeError, FitError, GeomError, KnotError, KnotVector, WeightError,
    curve::NurbsCurve,
    numeric::triangular_factor::{TriangularFactor, without_ends},
    refine::ControlLines,
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
        let stands = if domain.start() < knot && knot < domain.end() {
            self.knots.exact_multiplicity(knot)
        } else {
            0
        };
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

    /// The nearest clamped spline of one degree less; none if its weights are not positive
    /// numbers.
    fn reduced_once(&self) -> Result<Option<Self>, GeomError> {
        let knots = self.knots.degree_lowered();
        let target = knots.elevated()?;
        let domain = self.domain();
        let missing = |(t, times): (f64, usize)| {
            vec![t; times.saturating_sub(self.knots.exact_multiplicity(t))]
        };
        let inner =
            target.distinct().into_iter().filter(|&(t, _)| domain.start() < t && t < domain.end());
        let refined = self.insert_knots(&inner.flat_map(missing).collect::<Vec<f64>>())?;
        let points = Elevation::new(&knots)?.nearest(&refined.control_points);
        Ok(points.and_then(|points| Self::with_positive(knots, points).ok()))
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
    /// ones in the sense of least squares; none if rounding leaves one open.
    ///
    /// Seminormal equations with one step of refinement: Björck, *Numerical Methods for Least
    /// Squares Problems*, §2.9.
    fn nearest(&self, points: &[DVec4]) -> Option<Vec<DVec4>> {
        let n = self.n_columns;
        let n_inner = n.saturating_sub(2);
        let width = self.rows.iter().map(Vec::len).max().unwrap_or(1);
        let rows = || self.firsts.iter().copied().zip(self.rows.iter().map(Vec::as_slice));
        let inner_rows = rows().map(|row| without_ends(row, n_inner));
        let factor = TriangularFactor::new(inner_rows, n_inner, width)?;
        let mut solution = vec![DVec4::ZERO; n];
        (solution[0], solution[n - 1]) = (points[0], points[points.len() - 1]);
        for _ in 0..2 {
            let mut gradient = vec![DVec4::ZERO; n];
            for ((first, row), &point) in rows().zip(points) {
                let image: DVec4 = row.iter().zip(&solution[first..]).map(|(&e, &q)| q * e).sum();
                for (&share, sum) in row.iter().zip(&mut gradient[first..]) {
                    *sum += (point - image) * share;
                }
            }
            let inner = &mut gradient[1..n - 1];
            factor.solve_normal(inner);
            for (value, step) in solution[1..].iter_mut().zip(inner) {
                *value += *step;
            }
        }
        Some(solution)
    }
}
