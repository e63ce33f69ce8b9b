//! Points and derivatives of curves.

use glam::{DVec3, DVec4};

use crate::{Grid, Interval, Side, curve::NurbsCurve, homogeneous, knots::acting};

impl NurbsCurve {
    /// Point at parameter `t`; outside the domain the first and the last piece go on.
    ///
    /// O(p²), without allocation up to degree 7. Piegl & Tiller, *The NURBS Book*, A4.1.
    #[must_use]
    #[inline]
    pub fn point_at(&self, t: f64) -> DVec3 {
        homogeneous::project(self.homogeneous_at(t))
    }

    /// Homogeneous point `(w·x, w·y, w·z, w)` at `t`.
    #[must_use]
    #[inline]
    pub fn homogeneous_at(&self, t: f64) -> DVec4 {
        self.knots.with_basis(t, |span, basis| {
            let points = acting(&self.control_points, span, basis).iter();
            points.zip(basis).fold(DVec4::ZERO, |sum, (&point, &n)| sum + point * n)
        })
    }

    /// Point and derivatives at `t` by order, `order + 1` of them; at a knot those of the piece
    /// to its right, at the end of the domain those from the left.
    ///
    /// Orders above the degree vanish for polynomial curves only. O(p²·order + order²).
    /// Piegl & Tiller, *The NURBS Book*, A3.2 and A4.2.
    #[must_use]
    pub fn derivatives_at(&self, t: f64, order: usize) -> Vec<DVec3> {
        self.derivatives_beside(t, Side::Right, order)
    }

    /// Derivatives at `t` of the piece on one side of it.
    #[must_use]
    pub fn derivatives_beside(&self, t: f64, side: Side, order: usize) -> Vec<DVec3> {
        self.derivatives_on(self.knots.span_beside(t, side), t, order)
    }

    /// Derivatives at `t` of the piece of one span.
    pub(in crate::curve) fn derivatives_on(&self, span: usize, t: f64, order: usize) -> Vec<DVec3> {
        let homogeneous = self.homogeneous_derivatives(span, t, order);
        if self.is_rational {
            return homogeneous::quotient(&homogeneous);
        }
        let weight = homogeneous[0].w;
        homogeneous.iter().map(|derivative| derivative.truncate() / weight).collect()
    }

    /// Point and first derivative at `t`, as [`Self::derivatives_at`] tells them, without allocation.
    pub(crate) fn velocity_at(&self, t: f64) -> [DVec3; 2] {
        self.velocity_on(self.knots.span_at(t), t)
    }

    /// Point and first derivative at `t` of the piece of one span, without allocation.
    pub(in crate::curve) fn velocity_on(&self, span: usize, t: f64) -> [DVec3; 2] {
        let [value, slope] = self.knots.with_slopes(span, t, |values, slopes| {
            let mut sums = [DVec4::ZERO; 2];
            let points = acting(&self.control_points, span, values);
            for ((&point, &n), &dn) in points.iter().zip(values).zip(slopes) {
                sums[0] += point * n;
                sums[1] += point * dn;
            }
            sums
        });
        let point = homogeneous::project(value);
        [point, (slope.truncate() - point * slope.w) / value.w]
    }

    pub(crate) fn homogeneous_derivatives(&self, span: usize, t: f64, order: usize) -> Vec<DVec4> {
        let points = &self.control_points[self.knots.support(span)];
        let basis: Grid<f64> = self.knots.basis_derivatives_on(span, t, order.min(self.degree()));
        let contract = |k: usize| {
            points.iter().zip(basis.row(k)).fold(DVec4::ZERO, |sum, (&point, &n)| sum + point * n)
        };
        (0..=order).map(|k| if k < basis.n_rows() { contract(k) } else { DVec4::ZERO }).collect()
    }

    /// `n` points at evenly spaced parameters, both ends among them; one point is the start.
    #[must_use]
    pub fn sample(&self, n: usize) -> Vec<DVec3> {
        let domain: Interval = self.domain();
        match n {
            0 => Vec::new(),
            _ => self.evaluator().points_at(&domain.steps(n - 1)),
        }
    }
}
