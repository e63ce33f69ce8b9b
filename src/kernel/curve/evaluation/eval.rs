//! Points and derivatives of curves.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use crate::{Interval, Side, curve::NurbsCurve, frame::norm, homogeneous, knots::acting};

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
        if order <= 2 {
            return self.second_order_on(span, t)[..=order].to_vec();
        }
        let homogeneous = self.homogeneous_derivatives(span, t, order);
        if self.is_rational {
            return homogeneous::quotient(&homogeneous);
        }
        let weight = homogeneous[0].w;
        homogeneous.iter().map(|derivative| derivative.truncate() / weight).collect()
    }

    /// Point, first and second derivative at `t` of the piece of one span, without allocation up to degree 7.
    ///
    /// Piegl & Tiller, *The NURBS Book*, (4.8).
    fn second_order_on(&self, span: usize, t: f64) -> [DVec3; 3] {
        let [value, slope, bend] = self.knots.with_derivative_rows(span, t, |rows: [&[f64]; 3]| {
            let mut sums = [DVec4::ZERO; 3];
            for (i, &point) in acting(&self.control_points, span, rows[0]).iter().enumerate() {
                for (sum, row) in sums.iter_mut().zip(rows) {
                    *sum += point * row[i];
                }
            }
            sums
        });
        if !self.is_rational {
            return [value, slope, bend].map(|derivative| derivative.truncate() / value.w);
        }
        let point = value.truncate() / value.w;
        let first = (slope.truncate() - point * slope.w) / value.w;
        let second = bend.truncate() - first * (2.0 * slope.w) - point * bend.w;
        [point, first, second / value.w]
    }

    /// Point and first derivative at `t`, as [`Self::derivatives_at`] tells them, without allocation.
    pub(crate) fn velocity_at(&self, t: f64) -> [DVec3; 2] {
        self.velocity_on(self.knots.span_at(t), t)
    }

    /// Point and first derivative at `t` of the piece of one span, without allocation.
    pub(crate) fn velocity_on(&self, span: usize, t: f64) -> [DVec3; 2] {
        self.knots.with_slopes(span, t, |values, slopes| {
            velocity(acting(&self.control_points, span, values), values, slopes)
        })
    }

    /// The speeds at many parameters of the piece of one span, by [`Self::velocity_on`] to the last bit.
    pub(in crate::curve) fn speeds_on(&self, span: usize, parameters: &[f64], speeds: &mut [f64]) {
        let are_squares = match self.degree() {
            1 => self.square_speeds::<2>(span, parameters, speeds),
            2 => self.square_speeds::<3>(span, parameters, speeds),
            3 => self.square_speeds::<4>(span, parameters, speeds),
            _ => false,
        };
        for (speed, &t) in speeds.iter_mut().zip(parameters) {
            let is_square = are_squares && speed.is_normal();
            *speed = if is_square { speed.sqrt() } else { norm(self.velocity_on(span, t)[1]) };
        }
    }

    /// The squares of speeds on a curve of degree N − 1, of parameters before the end of a span; whether they all are.
    fn square_speeds<const N: usize>(
        &self,
        span: usize,
        parameters: &[f64],
        squares: &mut [f64],
    ) -> bool {
        let Some(points) = self.control_points[span + 1 - N..].first_chunk::<N>() else {
            return false;
        };
        self.knots.make_of_slopes::<N>(span, parameters, squares, |values, slopes| {
            velocity(points, values, slopes)[1].length_squared()
        })
    }

    /// Homogeneous derivatives at `t` of the piece of one span, by order; no heap allocation up to degree 7 and order 3.
    pub(crate) fn homogeneous_derivatives(
        &self,
        span: usize,
        t: f64,
        order: usize,
    ) -> SmallVec<[DVec4; 4]> {
        let points = &self.control_points[self.knots.support(span)];
        let contract = |basis: &[f64]| {
            points.iter().zip(basis).fold(DVec4::ZERO, |sum, (&point, &n)| sum + point * n)
        };
        self.knots.with_derivatives(span, t, order.min(self.degree()), |rows| {
            let mut found: SmallVec<[DVec4; 4]> =
                rows.chunks_exact(points.len()).map(contract).collect();
            found.resize(order + 1, DVec4::ZERO);
            found
        })
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

/// Point and first derivative, of the control points that a basis acts on and of its derivatives.
#[inline]
fn velocity(points: &[DVec4], values: &[f64], slopes: &[f64]) -> [DVec3; 2] {
    let mut sums = [DVec4::ZERO; 2];
    for ((&point, &n), &dn) in points.iter().zip(values).zip(slopes) {
        sums[0] += point * n;
        sums[1] += point * dn;
    }
    let [value, slope] = sums;
    let point = homogeneous::project(value);
    [point, (slope.truncate() - point * slope.w) / value.w]
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, DVec4};

    use crate::{KnotVector, curve::NurbsCurve, frame::norm};

    #[test]
    fn few_derivatives_are_the_first_of_more_to_the_last_bit() {
        for degree in 0..=9 {
            let knots = KnotVector::uniform_clamped(degree, degree + 3, 2.0).expect("knots");
            for is_rational in [false, true] {
                let point = |i: usize| {
                    let (x, w) =
                        (i as f64, if is_rational { 1.0 + 0.3 * (i % 3) as f64 } else { 2.0 });
                    DVec4::new(x, libm::sin(3.0 * x), 0.1 * x * x, 1.0) * w
                };
                let points: Vec<DVec4> = (0..degree + 3).map(point).collect();
                let curve = NurbsCurve::new(knots.clone(), points).expect("a curve");
                for t in curve.domain().steps(24) {
                    let many = curve.derivatives_at(t, 4);
                    for order in 0..3 {
                        assert_eq!(
                            curve.derivatives_at(t, order),
                            many[..=order],
                            "degree {degree}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn speeds_of_many_are_those_of_each_to_the_last_bit() {
        for degree in 1..=5 {
            let knots = KnotVector::uniform_clamped(degree, degree + 3, 2.0).expect("knots");
            let point = |i: usize| {
                let x = i as f64;
                (DVec3::new(x, libm::sin(3.0 * x), 0.1 * x * x)).extend(1.0)
                    * (1.0 + 0.3 * (x % 2.0))
            };
            let points: Vec<DVec4> = (0..degree + 3).map(point).collect();
            let curve = NurbsCurve::new(knots, points).expect("a curve");
            for span in curve.knots().spans() {
                // The last is the end of the span, and of the last span that of the domain.
                let parameters = curve.knots().span_interval(span).steps(9);
                for parameters in [&parameters[..9], &parameters[..]] {
                    let mut speeds = vec![0.0; parameters.len()];
                    curve.speeds_on(span, parameters, &mut speeds);
                    for (speed, &t) in speeds.iter().zip(parameters) {
                        let one = norm(curve.velocity_on(span, t)[1]);
                        assert_eq!(speed.to_bits(), one.to_bits(), "degree {degree} at {t}");
                    }
                }
            }
        }
    }
}
