//! Points and derivatives of surfaces.

use glam::{DVec3, DVec4};

use crate::{Grid, Interval, KnotVector, Side, homogeneous, knots::acting, surface::NurbsSurface};

impl NurbsSurface {
    /// Point at `(u, v)`; outside the domain the outer pieces go on.
    ///
    /// O(p² + q² + pq), without allocation up to degree 7. Piegl & Tiller, *The NURBS Book*, A4.3.
    #[must_use]
    pub fn point_at(&self, u: f64, v: f64) -> DVec3 {
        homogeneous::project(self.homogeneous_at(u, v))
    }

    /// Homogeneous point `(w·x, w·y, w·z, w)` at `(u, v)`.
    #[must_use]
    pub fn homogeneous_at(&self, u: f64, v: f64) -> DVec4 {
        self.knots_u.with_basis(u, |span_u, basis_u| {
            self.knots_v.with_basis(v, |span_v, basis_v| {
                let mut sum = DVec4::ZERO;
                let first = span_u + 1 - basis_u.len();
                for (i, &n_u) in basis_u.iter().enumerate() {
                    let row = acting(self.control_points.row(first + i), span_v, basis_v);
                    let along_v = row
                        .iter()
                        .zip(basis_v)
                        .fold(DVec4::ZERO, |sum, (&point, &n_v)| sum + point * n_v);
                    sum += along_v * n_u;
                }
                sum
            })
        })
    }

    /// Derivatives at `(u, v)`: row k, column l holds the one of order k in u and l in v, for
    /// both up to `order`.
    ///
    /// At a knot those of the piece to its right, at the end of a domain those from the left.
    /// Piegl & Tiller, *The NURBS Book*, A3.6 and A4.4.
    #[must_use]
    pub fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Grid<DVec3> {
        self.in_space(&self.homogeneous_derivatives(u, v, order))
    }

    /// Derivatives at `(u, v)` of what the surface is within a part of its domain that ends at knots, which goes on
    /// beyond them.
    pub(crate) fn derivatives_within(
        &self,
        part: [Interval; 2],
        [u, v]: [f64; 2],
        order: usize,
    ) -> Grid<DVec3> {
        let spans = self.spans_within(part, [u, v]);
        self.in_space(&self.homogeneous_derivatives_on(spans, [u, v], order))
    }

    /// The first of them, the point, to the last bit; without allocation up to degree 7.
    pub(crate) fn point_within(&self, part: [Interval; 2], [u, v]: [f64; 2]) -> DVec3 {
        let [span_u, span_v] = self.spans_within(part, [u, v]);
        let sum = self.knots_u.with_derivative_rows(span_u, u, |[basis_u]| {
            self.knots_v.with_derivative_rows(span_v, v, |[basis_v]| {
                let mut sum = DVec4::ZERO;
                let first = span_u + 1 - basis_u.len();
                for (i, &n_u) in basis_u.iter().enumerate() {
                    let row = acting(self.control_points.row(first + i), span_v, basis_v);
                    for (&point, &n_v) in row.iter().zip(basis_v) {
                        sum += point * (n_u * n_v);
                    }
                }
                sum
            })
        });
        sum.truncate() / sum.w
    }

    /// The spans of parameters that count as within a part of the domain that ends at knots.
    fn spans_within(&self, part: [Interval; 2], [u, v]: [f64; 2]) -> [usize; 2] {
        let span = |knots: &KnotVector, part: Interval, t: f64| match part.end() <= t {
            true => knots.span_beside(part.end(), Side::Left),
            false => knots.span_at(t.max(part.start())),
        };
        [span(&self.knots_u, part[0], u), span(&self.knots_v, part[1], v)]
    }

    fn in_space(&self, derivatives: &Grid<DVec4>) -> Grid<DVec3> {
        if self.is_rational {
            return homogeneous::quotient_grid(derivatives);
        }
        let weight = derivatives.get(0, 0).w;
        derivatives.map(|derivative| derivative.truncate() / weight)
    }

    /// Point, Su and Sv at `(u, v)`, without allocation up to degree 7.
    #[must_use]
    pub fn tangents_at(&self, u: f64, v: f64) -> [DVec3; 3] {
        let (span_u, span_v) = (self.knots_u.span_at(u), self.knots_v.span_at(v));
        let [value, along_u, along_v] =
            self.knots_u.with_slopes(span_u, u, |values_u, slopes_u| {
                self.knots_v.with_slopes(span_v, v, |values_v, slopes_v| {
                    let mut sums = [DVec4::ZERO; 3];
                    let first = span_u + 1 - values_u.len();
                    for (i, (&n_u, &dn_u)) in values_u.iter().zip(slopes_u).enumerate() {
                        let row = acting(self.control_points.row(first + i), span_v, values_v);
                        let (mut value, mut slope) = (DVec4::ZERO, DVec4::ZERO);
                        for ((&point, &n_v), &dn_v) in row.iter().zip(values_v).zip(slopes_v) {
                            value += point * n_v;
                            slope += point * dn_v;
                        }
                        sums[0] += value * n_u;
                        sums[1] += value * dn_u;
                        sums[2] += slope * n_u;
                    }
                    sums
                })
            });
        let point = homogeneous::project(value);
        let tangent = |slope: DVec4| (slope.truncate() - point * slope.w) / value.w;
        [point, tangent(along_u), tangent(along_v)]
    }

    /// S, Su, Sv, Suu, Suv, Svv, without allocation up to degree 7; beyond the domain those of the last piece.
    pub(in crate::surface) fn second_order_at(&self, u: f64, v: f64) -> [DVec3; 6] {
        let (span_u, span_v) = (self.knots_u.span_at(u), self.knots_v.span_at(v));
        let sums = self.knots_u.with_derivative_rows(span_u, u, |basis_u: [&[f64]; 3]| {
            self.knots_v.with_derivative_rows(span_v, v, |basis_v: [&[f64]; 3]| {
                let mut sums = [DVec4::ZERO; 6];
                let first = span_u + 1 - basis_u[0].len();
                for i in 0..basis_u[0].len() {
                    let [n_u, dn_u, ddn_u] = basis_u.map(|row| row[i]);
                    let row = acting(self.control_points.row(first + i), span_v, basis_v[0]);
                    for (j, &point) in row.iter().enumerate() {
                        let [n_v, dn_v, ddn_v] = basis_v.map(|row| row[j]);
                        sums[0] += point * (n_u * n_v);
                        sums[1] += point * (dn_u * n_v);
                        sums[2] += point * (n_u * dn_v);
                        sums[3] += point * (ddn_u * n_v);
                        sums[4] += point * (dn_u * dn_v);
                        sums[5] += point * (n_u * ddn_v);
                    }
                }
                sums
            })
        });
        homogeneous::second_order(sums)
    }

    fn homogeneous_derivatives(&self, u: f64, v: f64, order: usize) -> Grid<DVec4> {
        let spans = [self.knots_u.span_at(u), self.knots_v.span_at(v)];
        self.homogeneous_derivatives_on(spans, [u, v], order)
    }

    /// Homogeneous derivatives of the piece over a pair of spans.
    pub(crate) fn homogeneous_derivatives_on(
        &self,
        [span_u, span_v]: [usize; 2],
        [u, v]: [f64; 2],
        order: usize,
    ) -> Grid<DVec4> {
        let (n_u, n_v) = (self.degree_u() + 1, self.degree_v() + 1);
        let n = order + 1;
        let mut sums = vec![DVec4::ZERO; n * n];
        self.knots_u.with_derivatives(span_u, u, order.min(n_u - 1), |rows_u| {
            self.knots_v.with_derivatives(span_v, v, order.min(n_v - 1), |rows_v| {
                for (i, row) in self.knots_u.support(span_u).enumerate() {
                    let row = &self.control_points.row(row)[self.knots_v.support(span_v)];
                    let of_rows = sums.chunks_exact_mut(n).zip(rows_u.chunks_exact(n_u));
                    for (sums, basis_u) in of_rows {
                        for (sum, basis_v) in sums.iter_mut().zip(rows_v.chunks_exact(n_v)) {
                            for (&point, &n_v) in row.iter().zip(basis_v) {
                                *sum += point * (basis_u[i] * n_v);
                            }
                        }
                    }
                }
            });
        });
        Grid::from_rows_of(n, sums)
    }
}
