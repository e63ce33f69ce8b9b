//! Points and derivatives of one surface at many scattered parameters.
//!
//! The basis functions of both directions are expanded in powers once, as in the evaluator of a
//! curve; a point then is a sum over the control points that act there. The net itself is not
//! expanded: its patches would take (p + 1)(q + 1) times its memory, and a look into that costs
//! more than the sum.

use glam::{DVec3, DVec4};

use super::NurbsSurface;
use crate::kernel::{
    homogeneous,
    knots::{BATCH, BasisExpansion, POWER_DEGREE, Place},
};

/// A surface prepared to be evaluated at many scattered parameters.
///
/// ```
/// use glam::DVec3;
/// use virote::kernel::NurbsSurface;
///
/// let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
/// let saddle = NurbsSurface::bilinear(o, y, x, DVec3::ONE)?;
/// let prepared = saddle.evaluator();
/// assert_eq!(prepared.point_at(0.5, 0.5), DVec3::new(0.5, 0.5, 0.25));
/// assert_eq!(prepared.second_order_at(0.5, 0.5)[4], DVec3::Z);
/// # Ok::<(), virote::kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SurfaceEvaluator<'a> {
    surface: &'a NurbsSurface,
    /// Along u and along v; none for degrees that powers are not good for.
    bases: Option<&'a [BasisExpansion; 2]>,
}

impl NurbsSurface {
    /// The surface prepared to be evaluated at many parameters; the first time this takes O(p³)
    /// for each span of either direction.
    #[must_use]
    pub fn evaluator(&self) -> SurfaceEvaluator<'_> {
        let is_low = self.degree_u().max(self.degree_v()) <= POWER_DEGREE;
        let expand = || [&self.knots_u, &self.knots_v].map(BasisExpansion::new);
        let bases = is_low.then(|| self.bases.get_or_make(expand));
        SurfaceEvaluator { surface: self, bases }
    }
}

impl SurfaceEvaluator<'_> {
    /// Point at `(u, v)`; outside the domain the outer pieces go on. O(pq), without allocation up
    /// to degree 5.
    #[must_use]
    #[inline]
    pub fn point_at(&self, u: f64, v: f64) -> DVec3 {
        let Some(bases) = self.bases else { return self.surface.point_at(u, v) };
        let places = [bases[0].lookup.place_at(u), bases[1].lookup.place_at(v)];
        match self.n_functions() {
            [4, 4] => self.point_by(bases, places, [4, 4]),
            n => self.point_by(bases, places, n),
        }
    }

    /// Calls `visit` with the point at each of the pairs of parameters, in their order.
    #[inline]
    pub fn each_point(&self, parameters: &[[f64; 2]], visit: impl FnMut(DVec3)) {
        match (self.bases, self.n_functions()) {
            (Some(bases), [4, 4]) => {
                each(bases, parameters, |places| self.point_by(bases, places, [4, 4]), visit);
            }
            (Some(bases), n) => {
                each(bases, parameters, |places| self.point_by(bases, places, n), visit);
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
        let Some(bases) = self.bases else { return self.second_order_by_knots(u, v) };
        let places = [bases[0].lookup.place_at(u), bases[1].lookup.place_at(v)];
        match self.n_functions() {
            [4, 4] => self.second_order_by(bases, places, [4, 4]),
            n => self.second_order_by(bases, places, n),
        }
    }

    /// Calls `visit` with what [`Self::second_order_at`] tells at each of the pairs of parameters,
    /// in their order.
    #[inline]
    pub fn each_second_order(&self, parameters: &[[f64; 2]], visit: impl FnMut([DVec3; 6])) {
        match (self.bases, self.n_functions()) {
            (Some(bases), [4, 4]) => {
                each(
                    bases,
                    parameters,
                    |places| self.second_order_by(bases, places, [4, 4]),
                    visit,
                );
            }
            (Some(bases), n) => {
                each(bases, parameters, |places| self.second_order_by(bases, places, n), visit);
            }
            (None, _) => {
                parameters.iter().map(|&[u, v]| self.second_order_at(u, v)).for_each(visit);
            }
        }
    }

    fn n_functions(&self) -> [usize; 2] {
        [self.surface.degree_u() + 1, self.surface.degree_v() + 1]
    }

    #[inline(always)]
    fn point_by(
        &self,
        bases: &[BasisExpansion; 2],
        places: [Place; 2],
        [n_u, n_v]: [usize; 2],
    ) -> DVec3 {
        let (of_u, of_v) = (bases[0].values(places[0], n_u), bases[1].values(places[1], n_v));
        let mut sum = DVec4::ZERO;
        for (row, &n) in self.rows(bases, places, [n_u, n_v]).zip(&of_u) {
            sum += contracted(row, &of_v) * n;
        }
        homogeneous::project(sum)
    }

    #[inline(always)]
    fn second_order_by(
        &self,
        bases: &[BasisExpansion; 2],
        places: [Place; 2],
        [n_u, n_v]: [usize; 2],
    ) -> [DVec3; 6] {
        let of_u = bases[0].second_order(places[0], n_u);
        let of_v = bases[1].second_order(places[1], n_v);
        let mut sums = [DVec4::ZERO; 6];
        for (i, row) in self.rows(bases, places, [n_u, n_v]).enumerate() {
            let [value, slope, bend] = of_v.each_ref().map(|functions| contracted(row, functions));
            sums[0] += value * of_u[0][i];
            sums[1] += value * of_u[1][i];
            sums[2] += slope * of_u[0][i];
            sums[3] += value * of_u[2][i];
            sums[4] += slope * of_u[1][i];
            sums[5] += bend * of_u[0][i];
        }
        let per_u = bases[0].lookup.per_width(places[0].piece);
        let per_v = bases[1].lookup.per_width(places[1].piece);
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

    /// The control points that act, row by row.
    #[inline(always)]
    fn rows(
        &self,
        bases: &[BasisExpansion; 2],
        places: [Place; 2],
        [n_u, n_v]: [usize; 2],
    ) -> impl Iterator<Item = &[DVec4]> {
        let (first_u, first_v) = (bases[0].first(places[0]), bases[1].first(places[1]));
        let n_columns = self.surface.control_points.n_columns();
        let points = self.surface.control_points.as_slice();
        (first_u..first_u + n_u).map(move |i| &points[i * n_columns + first_v..][..n_v])
    }

    fn second_order_by_knots(&self, u: f64, v: f64) -> [DVec3; 6] {
        let all = self.surface.derivatives_at(u, v, 2);
        [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)].map(|(k, l)| all.get(k, l))
    }
}

/// Looks up many places before any is used, so that none waits for its lookup.
#[inline(always)]
fn each<T>(
    bases: &[BasisExpansion; 2],
    parameters: &[[f64; 2]],
    at: impl Fn([Place; 2]) -> T,
    mut visit: impl FnMut(T),
) {
    let (mut us, mut vs) = ([0.0; BATCH], [0.0; BATCH]);
    let (mut places_u, mut places_v) = ([Place::default(); BATCH], [Place::default(); BATCH]);
    for parameters in parameters.chunks(BATCH) {
        let n = parameters.len();
        for ((u, v), parameters) in us.iter_mut().zip(&mut vs).zip(parameters) {
            [*u, *v] = *parameters;
        }
        bases[0].lookup.places_at(&us[..n], &mut places_u);
        bases[1].lookup.places_at(&vs[..n], &mut places_v);
        for (&u, &v) in places_u[..n].iter().zip(&places_v) {
            visit(at([u, v]));
        }
    }
}

/// The sum of a row of control points.
#[inline(always)]
fn contracted(row: &[DVec4], functions: &[f64]) -> DVec4 {
    let mut sum = DVec4::ZERO;
    for (&point, &n) in row.iter().zip(functions) {
        sum += point * n;
    }
    sum
}
