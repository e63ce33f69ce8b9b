//! Points and derivatives of one surface at many scattered parameters.
//!
//! The basis functions along u are expanded in powers once, and so is each row of control points
//! along v, as in the evaluator of a curve. A point then is a sum over the rows that act there, of
//! the powers of each. To expand the patches along u as well would take p + 1 times the memory
//! again, and a look into that costs more than the sum.

use glam::{DVec3, DVec4};

use crate::{
    homogeneous,
    knots::{
        BATCH, BasisExpansion, LocalParameter, POWER_DEGREE, SpanLookup, convert_to_bezier,
        in_powers,
    },
    surface::NurbsSurface,
};

/// A surface prepared to be evaluated at many scattered parameters.
///
/// ```
/// use glam::DVec3;
/// use virote_kernel::NurbsSurface;
///
/// let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
/// let saddle = NurbsSurface::bilinear(o, y, x, DVec3::ONE)?;
/// let prepared = saddle.evaluator();
/// assert_eq!(prepared.point_at(0.5, 0.5), DVec3::new(0.5, 0.5, 0.25));
/// assert_eq!(prepared.second_order_at(0.5, 0.5)[4], DVec3::Z);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SurfaceEvaluator<'a> {
    surface: &'a NurbsSurface,
    /// None for degrees that powers are not good for.
    expanded: Option<&'a Expanded>,
}

/// A surface in powers.
#[derive(Debug)]
pub(in crate::surface) struct Expanded {
    basis: BasisExpansion,
    /// The halves of the spans along v.
    lookup: SpanLookup,
    n_halves: usize,
    /// For each row of control points and each half of a span along v the coefficients of s⁰, s¹, …
    rows: Vec<DVec4>,
}

impl NurbsSurface {
    /// The surface prepared to be evaluated at many parameters; the first time this takes O(p³) for
    /// each span along u and O(q²) for each row and span along v, and some 2q + 2 times the memory
    /// of the control points.
    #[must_use]
    pub fn evaluator(&self) -> SurfaceEvaluator<'_> {
        let is_low = self.degree_u().max(self.degree_v()) <= POWER_DEGREE;
        let expanded = is_low.then(|| self.expanded.get_or_make(|| Expanded::new(self)));
        SurfaceEvaluator { surface: self, expanded }
    }
}

impl Expanded {
    fn new(surface: &NurbsSurface) -> Self {
        let knots = &surface.knots_v;
        let n_halves = 2 * knots.spans().count();
        let n_rows = surface.control_points.n_rows();
        let mut rows = Vec::with_capacity(n_rows * n_halves * (knots.degree() + 1));
        for i in 0..n_rows {
            for span in knots.spans() {
                let mut points = surface.control_points.row(i)[knots.support(span)].to_vec();
                convert_to_bezier(knots, span, &mut points);
                rows.extend(in_powers(points));
            }
        }
        let basis = BasisExpansion::new(&surface.knots_u);
        Self { basis, lookup: SpanLookup::of_halves(knots), n_halves, rows }
    }

    fn places_at(&self, u: f64, v: f64) -> [LocalParameter; 2] {
        [self.basis.lookup.place_at(u), self.lookup.place_at(v)]
    }

    /// The coefficients along v of the rows that act.
    #[inline(always)]
    fn acting(
        &self,
        places: [LocalParameter; 2],
        [n_u, n_v]: [usize; 2],
    ) -> impl Iterator<Item = &[DVec4]> {
        let first = self.basis.first(places[0]);
        (first..first + n_u)
            .map(move |i| &self.rows[(i * self.n_halves + places[1].piece) * n_v..][..n_v])
    }

    #[inline(always)]
    fn point(&self, places: [LocalParameter; 2], n: [usize; 2]) -> DVec3 {
        let of_u = self.basis.values(places[0], n[0]);
        let mut sum = DVec4::ZERO;
        for (row, &n_u) in self.acting(places, n).zip(&of_u) {
            let mut value = row[n[1] - 1];
            for &coefficient in row[..n[1] - 1].iter().rev() {
                value = value * places[1].s + coefficient;
            }
            sum += value * n_u;
        }
        homogeneous::project(sum)
    }

    #[inline(always)]
    fn second_order(&self, places: [LocalParameter; 2], n: [usize; 2]) -> [DVec3; 6] {
        let of_u = self.basis.second_order(places[0], n[0]);
        let mut sums = [DVec4::ZERO; 6];
        for (i, row) in self.acting(places, n).enumerate() {
            let [value, slope, half_bend] = second_order_in_powers(&row[..n[1]], places[1].s);
            sums[0] += value * of_u[0][i];
            sums[1] += value * of_u[1][i];
            sums[2] += slope * of_u[0][i];
            sums[3] += value * of_u[2][i];
            sums[4] += slope * of_u[1][i];
            sums[5] += half_bend * of_u[0][i];
        }
        sums[5] *= 2.0;
        let per_u = self.basis.lookup.per_width(places[0].piece);
        let per_v = self.lookup.per_width(places[1].piece);
        let [s, su, sv, suu, suv, svv] = homogeneous::second_order(sums);
        [
            s,
            su * per_u,
            sv * per_v,
            suu * (per_u * per_u),
            suv * (per_u * per_v),
            svv * (per_v * per_v),
        ]
    }

    /// Looks up many places before any is used, so that none waits for its lookup.
    #[inline(always)]
    fn each<T>(
        &self,
        parameters: &[[f64; 2]],
        at: impl Fn([LocalParameter; 2]) -> T,
        mut visit: impl FnMut(T),
    ) {
        let (mut us, mut vs) = ([0.0; BATCH], [0.0; BATCH]);
        let (mut places_u, mut places_v) =
            ([LocalParameter::default(); BATCH], [LocalParameter::default(); BATCH]);
        for parameters in parameters.chunks(BATCH) {
            let n = parameters.len();
            for ((u, v), parameters) in us.iter_mut().zip(&mut vs).zip(parameters) {
                [*u, *v] = *parameters;
            }
            self.basis.lookup.places_at(&us[..n], &mut places_u);
            self.lookup.places_at(&vs[..n], &mut places_v);
            for (&u, &v) in places_u[..n].iter().zip(&places_v) {
                visit(at([u, v]));
            }
        }
    }
}

/// The value of Σ Cₖsᵏ, its derivative, and half of its second one.
#[inline(always)]
fn second_order_in_powers(coefficients: &[DVec4], s: f64) -> [DVec4; 3] {
    let n = coefficients.len();
    let mut value = coefficients[n - 1];
    let (mut slope, mut half_bend) = (DVec4::ZERO, DVec4::ZERO);
    if 1 < n {
        slope = value;
        value = value * s + coefficients[n - 2];
    }
    if 2 < n {
        half_bend = slope;
        slope = slope * s + value;
        value = value * s + coefficients[n - 3];
        for &coefficient in coefficients[..n - 3].iter().rev() {
            half_bend = half_bend * s + slope;
            slope = slope * s + value;
            value = value * s + coefficient;
        }
    }
    [value, slope, half_bend]
}

impl SurfaceEvaluator<'_> {
    /// Point at `(u, v)`; outside the domain the outer pieces go on. O(pq), without allocation up
    /// to degree 5.
    #[must_use]
    #[inline]
    pub fn point_at(&self, u: f64, v: f64) -> DVec3 {
        let Some(expanded) = self.expanded else { return self.surface.point_at(u, v) };
        let places = expanded.places_at(u, v);
        match self.n_functions() {
            [4, 4] => expanded.point(places, [4, 4]),
            n => expanded.point(places, n),
        }
    }

    /// Calls `visit` with the point at each of the pairs of parameters, in their order.
    #[inline]
    pub fn each_point(&self, parameters: &[[f64; 2]], visit: impl FnMut(DVec3)) {
        match (self.expanded, self.n_functions()) {
            (Some(expanded), [4, 4]) => {
                expanded.each(parameters, |places| expanded.point(places, [4, 4]), visit);
            }
            (Some(expanded), n) => {
                expanded.each(parameters, |places| expanded.point(places, n), visit);
            }
            (None, _) => parameters.iter().map(|&[u, v]| self.point_at(u, v)).for_each(visit),
        }
    }

    /// The point and its derivatives at `(u, v)`: S, Su, Sv, Suu, Suv, Svv; at a knot those of
    /// the piece to its right, at the end of a domain those from the left.
    ///
    /// O(pq), without allocation up to degree 5. Piegl & Tiller, *The NURBS Book*, (4.20).
    #[must_use]
    #[inline]
    pub fn second_order_at(&self, u: f64, v: f64) -> [DVec3; 6] {
        let Some(expanded) = self.expanded else { return self.second_order_by_knots(u, v) };
        let places = expanded.places_at(u, v);
        match self.n_functions() {
            [4, 4] => expanded.second_order(places, [4, 4]),
            n => expanded.second_order(places, n),
        }
    }

    /// Calls `visit` with what [`Self::second_order_at`] tells at each of the pairs of parameters,
    /// in their order.
    #[inline]
    pub fn each_second_order(&self, parameters: &[[f64; 2]], visit: impl FnMut([DVec3; 6])) {
        match (self.expanded, self.n_functions()) {
            (Some(expanded), [4, 4]) => {
                expanded.each(parameters, |places| expanded.second_order(places, [4, 4]), visit);
            }
            (Some(expanded), n) => {
                expanded.each(parameters, |places| expanded.second_order(places, n), visit);
            }
            (None, _) => {
                parameters.iter().map(|&[u, v]| self.second_order_at(u, v)).for_each(visit);
            }
        }
    }

    fn n_functions(&self) -> [usize; 2] {
        [self.surface.degree_u() + 1, self.surface.degree_v() + 1]
    }

    fn second_order_by_knots(&self, u: f64, v: f64) -> [DVec3; 6] {
        let all = self.surface.derivatives_at(u, v, 2);
        [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)].map(|(k, l)| all.get(k, l))
    }
}
