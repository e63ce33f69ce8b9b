//! Points and derivatives of one curve at many parameters.
//!
//! Each half of a piece is expanded in powers of the distance from the knot beside it, once; after
//! that the knots cost a look into a table, and a point a Horner scheme. Over half a piece little
//! cancels: with p up to 5 the rounding is at most 2ᵖ that of the control points, and at the knots
//! it is theirs. Above that a piece is in Bézier form, where nothing cancels. Farin, *Curves and
//! Surfaces for CAGD*, §5.8; conversion by Ramshaw's blossoms, *Blossoming: a connect-the-dots
//! approach to splines*.

use glam::{DVec3, DVec4};

use crate::{
    curve::NurbsCurve,
    homogeneous,
    knots::{BATCH, LocalParameter, POWER_DEGREE, SpanLookup, add_in_powers, convert_to_bezier},
};

/// A curve prepared to be evaluated at many parameters.
///
/// Its points are those of the curve up to rounding; to make it takes as long as some points of
/// each piece by [`NurbsCurve::point_at`].
///
/// ```
/// use glam::DVec3;
/// use virote_kernel::NurbsCurve;
///
/// let peak = [DVec3::ZERO, DVec3::new(1.0, 2.0, 0.0), DVec3::new(2.0, 0.0, 0.0)];
/// let curve = NurbsCurve::bezier(&peak)?;
/// let parabola = curve.evaluator();
/// assert_eq!(parabola.points_at(&[0.0, 0.5]), [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)]);
/// let [_, velocity, acceleration] = parabola.second_order_at(0.5);
/// assert_eq!([velocity, acceleration], [DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, -8.0, 0.0)]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CurveEvaluator {
    degree: usize,
    is_rational: bool,
    lookup: SpanLookup,
    /// p + 1 of each half of a span: `Cₖ` of `Σ Cₖsᵏ`. Above [`POWER_DEGREE`] p + 1 Bézier points
    /// of each span.
    coefficients: Vec<DVec4>,
}

impl NurbsCurve {
    /// The same curve, prepared to be evaluated at many parameters: the first time O(p²) for each
    /// piece.
    #[must_use]
    pub fn evaluator(&self) -> &CurveEvaluator {
        self.evaluator.get_or_make(|| self.expanded())
    }

    fn expanded(&self) -> CurveEvaluator {
        let degree = self.degree();
        let lookup = SpanLookup::of_halves(&self.knots);
        let mut coefficients = Vec::with_capacity(2 * self.n_segments() * (degree + 1));
        let mut points = Vec::with_capacity(degree + 1);
        for span in self.knots.spans() {
            points.clear();
            points.extend_from_slice(&self.control_points[self.knots.support(span)]);
            convert_to_bezier(&self.knots, span, &mut points);
            if degree <= POWER_DEGREE {
                add_in_powers(&mut points, &mut coefficients);
            } else {
                coefficients.extend_from_slice(&points);
            }
        }
        CurveEvaluator { degree, is_rational: self.is_rational, lookup, coefficients }
    }
}

impl CurveEvaluator {
    /// Point at parameter `t`; outside the domain the first and the last piece go on.
    ///
    /// O(p), without allocation; a search only where knots crowd.
    #[must_use]
    #[inline]
    pub fn point_at(&self, t: f64) -> DVec3 {
        let place = self.lookup.place_at(t);
        match self.degree {
            0 => self.point_by::<1>(place),
            1 => self.point_by::<2>(place),
            2 => self.point_by::<3>(place),
            3 => self.point_by::<4>(place),
            4 => self.point_by::<5>(place),
            5 => self.point_by::<6>(place),
            _ => self.point_by_bezier(place),
        }
    }

    /// Points at many parameters: faster than one after the other.
    #[must_use]
    pub fn points_at(&self, parameters: &[f64]) -> Vec<DVec3> {
        let mut points = Vec::with_capacity(parameters.len());
        self.each_point(parameters, |point| points.push(point));
        points
    }

    /// Calls `visit` with the point at each of the parameters, in their order.
    #[inline]
    pub fn each_point(&self, parameters: &[f64], visit: impl FnMut(DVec3)) {
        match self.degree {
            0 => self.each(parameters, |place| self.point_by::<1>(place), visit),
            1 => self.each(parameters, |place| self.point_by::<2>(place), visit),
            2 => self.each(parameters, |place| self.point_by::<3>(place), visit),
            3 => self.each(parameters, |place| self.point_by::<4>(place), visit),
            4 => self.each(parameters, |place| self.point_by::<5>(place), visit),
            5 => self.each(parameters, |place| self.point_by::<6>(place), visit),
            _ => self.each(parameters, |place| self.point_by_bezier(place), visit),
        }
    }

    /// Point, first and second derivative at `t`; at a knot those of the piece to its right, at
    /// the end of the domain those from the left.
    ///
    /// O(p), without allocation. Of the derivatives by the place in the piece to those in space by
    /// Piegl & Tiller, *The NURBS Book*, (4.8).
    #[must_use]
    #[inline]
    pub fn second_order_at(&self, t: f64) -> [DVec3; 3] {
        let place = self.lookup.place_at(t);
        match self.degree {
            2 => self.second_order_by::<3>(place),
            3 => self.second_order_by::<4>(place),
            4 => self.second_order_by::<5>(place),
            5 => self.second_order_by::<6>(place),
            _ => self.second_order_by_any(place),
        }
    }

    /// Calls `visit` with point, first and second derivative at each of the parameters, in their
    /// order.
    #[inline]
    pub fn each_second_order(&self, parameters: &[f64], visit: impl FnMut([DVec3; 3])) {
        match self.degree {
            2 => self.each(parameters, |place| self.second_order_by::<3>(place), visit),
            3 => self.each(parameters, |place| self.second_order_by::<4>(place), visit),
            4 => self.each(parameters, |place| self.second_order_by::<5>(place), visit),
            5 => self.each(parameters, |place| self.second_order_by::<6>(place), visit),
            _ => self.each(parameters, |place| self.second_order_by_any(place), visit),
        }
    }

    /// Looks up many places before any is used, so that none waits for its lookup.
    #[inline(always)]
    fn each<T>(
        &self,
        parameters: &[f64],
        at: impl Fn(LocalParameter) -> T,
        mut visit: impl FnMut(T),
    ) {
        let mut places = [LocalParameter::default(); BATCH];
        for parameters in parameters.chunks(BATCH) {
            self.lookup.places_at(parameters, &mut places);
            for &place in &places[..parameters.len()] {
                visit(at(place));
            }
        }
    }

    #[inline(always)]
    fn point_by<const N: usize>(&self, place: LocalParameter) -> DVec3 {
        let coefficients = self.expansion::<N>(place);
        let mut value = coefficients[N - 1];
        for &coefficient in coefficients[..N - 1].iter().rev() {
            value = value * place.s + coefficient;
        }
        homogeneous::project(value)
    }

    /// For a degree of 2 or more.
    #[inline(always)]
    fn second_order_by<const N: usize>(&self, place: LocalParameter) -> [DVec3; 3] {
        let (coefficients, s) = (self.expansion::<N>(place), place.s);
        let [mut value, mut slope, mut bend] = [coefficients[N - 1]; 3];
        value = value * s + coefficients[N - 2];
        slope = slope * s + value;
        value = value * s + coefficients[N - 3];
        for &coefficient in coefficients[..N - 3].iter().rev() {
            bend = bend * s + slope;
            slope = slope * s + value;
            value = value * s + coefficient;
        }
        self.in_space(place, [value, slope, bend * 2.0])
    }

    fn point_by_bezier(&self, place: LocalParameter) -> DVec3 {
        let (points, s, r) = self.bezier(place);
        homogeneous::project(nested(points, s, r))
    }

    #[inline(never)]
    fn second_order_by_any(&self, place: LocalParameter) -> [DVec3; 3] {
        let homogeneous = match self.degree {
            0 => [self.coefficients[place.piece], DVec4::ZERO, DVec4::ZERO],
            1 => {
                let [start, slope] = *self.expansion::<2>(place);
                [slope * place.s + start, slope, DVec4::ZERO]
            }
            degree => {
                let (points, s, r) = self.bezier(place);
                let [a, b, c] = [0, 1, 2].map(|i| nested(&points[i..][..degree - 1], s, r));
                let (start, end) = (a * r + b * s, b * r + c * s);
                let degree = degree as f64;
                let bend = ((c - b) - (b - a)) * (degree * (degree - 1.0));
                [start * r + end * s, (end - start) * degree, bend]
            }
        };
        self.in_space(place, homogeneous)
    }

    /// Derivatives in space by the parameter, of homogeneous ones by the place in the piece.
    #[inline(always)]
    fn in_space(&self, place: LocalParameter, [value, slope, bend]: [DVec4; 3]) -> [DVec3; 3] {
        let per_weight = 1.0 / value.w;
        let per_width = self.lookup.per_width(place.piece);
        let point = value.truncate() * per_weight;
        let [first, second] = if self.is_rational {
            let first = (slope.truncate() - point * slope.w) * per_weight;
            [first, (bend.truncate() - first * (2.0 * slope.w) - point * bend.w) * per_weight]
        } else {
            [slope, bend].map(|derivative| derivative.truncate() * per_weight)
        };
        [point, first * per_width, second * (per_width * per_width)]
    }

    /// The coefficients of a half, in a number that the compiler knows.
    #[inline(always)]
    fn expansion<const N: usize>(&self, place: LocalParameter) -> &[DVec4; N] {
        match self.coefficients[place.piece * N..].first_chunk() {
            Some(coefficients) => coefficients,
            None => unreachable!("a half of a span has p + 1 coefficients"),
        }
    }

    /// The Bézier points of a span, and the place between its ends from both of them.
    fn bezier(&self, LocalParameter { piece, s }: LocalParameter) -> (&[DVec4], f64, f64) {
        let n = self.degree + 1;
        let is_left = piece.is_multiple_of(2);
        let (s, r) = if is_left { (s, 1.0 - s) } else { (1.0 + s, -s) };
        (&self.coefficients[piece / 2 * n..][..n], s, r)
    }
}

/// The point of Bézier points: `Σ C(p, i) sⁱ r^{p−i} Pᵢ`, nested in r.
#[inline(never)]
fn nested(points: &[DVec4], s: f64, r: f64) -> DVec4 {
    let degree = points.len() - 1;
    let (mut sum, mut binomial, mut power) = (points[0], 1.0, 1.0);
    for (i, &point) in points.iter().enumerate().skip(1) {
        binomial *= (degree + 1 - i) as f64 / i as f64;
        power *= s;
        sum = sum * r + point * (binomial * power);
    }
    sum
}
