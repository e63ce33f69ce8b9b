//! By how much control points and coefficients count in what is made of them linearly: entries of matrices, each with the
//! point that is made, the one that it is made of, and the factor.

use crate::{
    Direction, Grid, Interpolator, Interval, KnotVector, NurbsCurve, NurbsSurface, bernstein,
    curve::power_weights,
};

/// Entries of a matrix by which points are made of others.
///
/// The middle of a line, which both ends make alike:
///
/// ```
/// use virote_kernel::{NurbsCurve, PointEntries, glam::DVec3};
///
/// let line = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
/// let middle: PointEntries = line.factors_of_places(&[0.5]);
/// assert_eq!(middle, [(0, 0, 0.5), (0, 1, 0.5)]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
pub type PointEntries = Vec<(usize, usize, f64)>;

impl NurbsCurve {
    /// By how much each homogeneous control point counts in the points at parameters of the domain.
    ///
    /// ```
    /// use virote_kernel::{NurbsCurve, glam::DVec3};
    ///
    /// let line = NurbsCurve::line(DVec3::ZERO, DVec3::X)?;
    /// assert_eq!(line.factors_of_places(&[0.25]), [(0, 0, 0.75), (0, 1, 0.25)]);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    #[must_use]
    pub fn factors_of_places(&self, parameters: &[f64]) -> PointEntries {
        let (knots, points) = (self.knots(), self.control_points());
        let of = |(made, &t): (usize, &f64)| {
            knots.with_basis(t, |span, basis| {
                let support = knots.support(span);
                let weight: f64 = support.clone().zip(basis).map(|(i, n)| points[i].w * n).sum();
                support.zip(basis).map(|(i, n)| (made, i, n / weight)).collect::<PointEntries>()
            })
        };
        parameters.iter().enumerate().flat_map(of).collect()
    }

    /// By how much each homogeneous control point counts in those of [`Self::de_casteljau`], level by level.
    #[must_use]
    pub fn factors_of_levels(&self, t: f64) -> PointEntries {
        let weights: Vec<f64> = self.control_points().iter().map(|point| point.w).collect();
        let weights = Grid::from_fn(weights.len(), 1, |i, _| weights[i]);
        factors_of_levels(&weights, [self.domain().fraction_of(t), 0.0])
    }

    /// By how much each control point counts in [`Self::power_coefficients`]; none where the domain does not start at 0
    /// or the curve is not in Bézier form, so that they are not the powers of its own parameter.
    #[must_use]
    pub fn factors_of_powers(&self) -> Option<PointEntries> {
        let rows = factors_of_powers(self.knots())?;
        Some(entries(&rows, &[vec![1.0]]))
    }

    /// By how much each coefficient of so many counts in the control points of [`Self::power_form`].
    #[must_use]
    pub fn factors_of_power_form(n_coefficients: usize, domain: Interval) -> PointEntries {
        entries(&power_weights(n_coefficients, domain), &[vec![1.0]])
    }
}

impl NurbsSurface {
    /// By how much each homogeneous control point counts in those of [`Self::de_casteljau`], level by level and row by
    /// row.
    #[must_use]
    pub fn factors_of_levels(&self, u: f64, v: f64) -> PointEntries {
        let weights = self.control_points().map(|point| point.w);
        factors_of_levels(
            &weights,
            [self.domain_u().fraction_of(u), self.domain_v().fraction_of(v)],
        )
    }

    /// As [`NurbsCurve::factors_of_powers`].
    #[must_use]
    pub fn factors_of_powers(&self) -> Option<PointEntries> {
        let rows = [self.knots_u(), self.knots_v()].map(factors_of_powers);
        let [Some(us), Some(vs)] = rows else { return None };
        Some(entries(&us, &vs))
    }

    /// By how much each control point counts in those of the isocurve along a direction.
    #[must_use]
    pub fn factors_of_isocurve(&self, along: Direction, at: f64) -> PointEntries {
        let net = self.control_points();
        let n_made = self.knots(along).n_points();
        let across = self.knots(along.other());
        let place = |own: usize, i: usize| match along {
            Direction::U => own * net.n_columns() + i,
            Direction::V => i * net.n_columns() + own,
        };
        across.with_basis(at, |span, basis| {
            let of = |own: usize| {
                across.support(span).zip(basis).map(move |(i, &n)| (own, place(own, i), n))
            };
            (0..n_made).flat_map(of).collect()
        })
    }
}

impl Interpolator {
    /// By how much each value, and behind them both tangents, count in the control points of
    /// [`Self::with_tangents`]; none unless the ends are [`Ends::Clamped`](crate::Ends::Clamped).
    #[must_use]
    pub fn factors_with_tangents(&self) -> Option<PointEntries> {
        let row = |i: usize, n: usize| {
            let mut own = vec![0.0; n];
            own[i] = 1.0;
            let (by_value, tangents) = self.growths_with_tangents(own)?;
            Some([by_value, tangents.to_vec()].concat())
        };
        let n = self.knots().n_points();
        let rows: Vec<Vec<f64>> = (0..n).map(|i| row(i, n)).collect::<Option<_>>()?;
        Some(entries(&rows, &[vec![1.0]]))
    }
}

/// The products of all entries of two matrices that are not zero, rows and columns of the second within those of the first.
fn entries(us: &[Vec<f64>], vs: &[Vec<f64>]) -> PointEntries {
    let n_columns = vs.first().map_or(0, Vec::len);
    let mut all = PointEntries::new();
    for (i, of_u) in us.iter().enumerate() {
        for (j, of_v) in vs.iter().enumerate() {
            for (k, u) in of_u.iter().enumerate() {
                for (l, v) in of_v.iter().enumerate().filter(|(_, v)| u * **v != 0.0) {
                    all.push((i * vs.len() + j, k * n_columns + l, u * v));
                }
            }
        }
    }
    all
}

/// Corner cutting at fractions of both domains, as far as there is a corner left in each direction: point (i, j) of level
/// k is the sum of Bernstein polynomials of degree k with the points from (i, j) on.
///
/// Farin, *Curves and Surfaces for CAGD*, (4.6).
fn factors_of_levels(weights: &Grid<f64>, at: [f64; 2]) -> PointEntries {
    let size = [weights.n_rows(), weights.n_columns()];
    let mut all = PointEntries::new();
    let mut n_before = 0;
    for level in 0..size[0].max(size[1]) {
        let degrees = size.map(|n| level.min(n - 1));
        let [us, vs] = [0, 1].map(|k| bernstein::basis(degrees[k], at[k]));
        let [n_rows, n_columns] = [0, 1].map(|k| size[k] - degrees[k]);
        for made in 0..n_rows * n_columns {
            let [row, column] = [made / n_columns, made % n_columns];
            let from = all.len();
            let mut weight = 0.0;
            for (k, u) in us.iter().enumerate() {
                for (l, v) in vs.iter().enumerate() {
                    weight += u * v * weights.get(row + k, column + l);
                    let place = (row + k) * size[1] + column + l;
                    all.push((n_before + made, place, u * v));
                }
            }
            all[from..].iter_mut().for_each(|entry| entry.2 /= weight);
        }
        n_before += n_rows * n_columns;
    }
    all
}

/// Coefficients of the powers of a parameter by the Bézier points: the i-th is C(p, i)/Lⁱ times their i-th difference. None
/// unless the knots are those of one Bézier segment that starts at 0.
///
/// Piegl & Tiller, *The NURBS Book*, §1.3.
fn factors_of_powers(knots: &KnotVector) -> Option<Vec<Vec<f64>>> {
    let (domain, p) = (knots.domain(), knots.degree());
    let is_bezier = knots.n_points() == p + 1
        && [domain.start(), domain.end()].iter().all(|&end| knots.exact_multiplicity(end) == p + 1);
    if !is_bezier || domain.start() != 0.0 {
        return None;
    }
    let row = |(i, scale): (usize, f64)| {
        let of = |(k, binomial): (usize, f64)| {
            scale * binomial * if (i - k).is_multiple_of(2) { 1.0 } else { -1.0 }
        };
        let mut row: Vec<f64> = bernstein::binomials(i).into_iter().enumerate().map(of).collect();
        row.resize(p + 1, 0.0);
        row
    };
    let lengths = std::iter::successors(Some(1.0), |power| Some(power * domain.length()));
    let scales = bernstein::binomials(p).into_iter().zip(lengths).map(|(n, power)| n / power);
    Some(scales.enumerate().map(row).collect())
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, DVec4};

    use super::PointEntries;
    use crate::{Direction, Ends, Grid, Interpolator, Interval, NurbsCurve, NurbsSurface};

    fn point(i: usize) -> DVec3 {
        let t = i as f64;
        DVec3::new(libm::sin(3.0 * t), libm::cos(2.0 * t), libm::sin(t * t))
    }

    /// The points that are made, each once, and the same by the entries.
    #[track_caller]
    fn check(entries: &PointEntries, given: &[DVec3], made: &[DVec3]) {
        let mut sums = vec![DVec3::ZERO; made.len()];
        entries.iter().for_each(|&(i, j, factor)| sums[i] += given[j] * factor);
        for (sum, made) in sums.iter().zip(made) {
            assert!(sum.distance(*made) < 1e-11, "{sum} is not {made}");
        }
    }

    #[test]
    fn entries_make_what_the_operations_make() {
        let given: Vec<DVec3> = (0..7).map(point).collect();
        let curve = NurbsCurve::bezier(&given).unwrap();
        check(&curve.factors_of_powers().unwrap(), &given, &curve.power_coefficients().unwrap());
        let levels = curve.de_casteljau(0.3).unwrap().concat();
        check(&curve.factors_of_levels(0.3), &given, &levels);
        let domain = Interval::new(-1.0, 2.0).unwrap();
        let form = NurbsCurve::power_form(&given, domain).unwrap();
        check(&NurbsCurve::factors_of_power_form(7, domain), &given, &form.points());
        let parameters: Vec<f64> = (0..7).map(f64::from).collect();
        let fit = Interpolator::new(&parameters, 3, Ends::Clamped).unwrap();
        let tangents = [DVec3::X, DVec3::new(0.0, 2.0, 1.0)];
        let spline = fit.curve_with_tangents(&given, tangents).unwrap();
        let all = [&given[..], &tangents].concat();
        check(&fit.factors_with_tangents().unwrap(), &all, &spline.points());
    }

    #[test]
    fn weights_divide_what_is_made_of_homogeneous_points() {
        let weighted: Vec<DVec4> =
            (0..5).map(|i| (point(i) * (1.0 + i as f64)).extend(1.0 + i as f64)).collect();
        let given: Vec<DVec3> = weighted.iter().map(|own| own.truncate()).collect();
        let knots = crate::KnotVector::bezier(4).unwrap();
        let curve = NurbsCurve::new(knots, weighted).unwrap();
        check(&curve.factors_of_levels(0.4), &given, &curve.de_casteljau(0.4).unwrap().concat());
        check(
            &curve.factors_of_places(&[0.2, 1.0]),
            &given,
            &[0.2, 1.0].map(|t| curve.point_at(t)),
        );
        assert!(NurbsCurve::line(DVec3::ZERO, DVec3::X).is_ok_and(|line| {
            let away = line.reparametrized(Interval::new(1.0, 2.0).unwrap());
            away.factors_of_powers().is_none()
        }));
    }

    #[test]
    fn entries_of_surfaces_are_counted_row_by_row() {
        let net = Grid::from_fn(3, 4, |i, j| point(4 * i + j));
        let surface = NurbsSurface::bezier(&net).unwrap();
        let given = net.as_slice();
        let powers = surface.power_coefficients().unwrap();
        check(&surface.factors_of_powers().unwrap(), given, powers.as_slice());
        let levels = surface.de_casteljau(0.3, 0.6).unwrap();
        let levels: Vec<DVec3> = levels.iter().flat_map(|own| own.as_slice().to_vec()).collect();
        check(&surface.factors_of_levels(0.3, 0.6), given, &levels);
        let along_v = surface.isocurve_u(0.3);
        check(&surface.factors_of_isocurve(Direction::V, 0.3), given, &along_v.points());
        let along_u = surface.isocurve_v(0.3);
        check(&surface.factors_of_isocurve(Direction::U, 0.3), given, &along_u.points());
    }
}
