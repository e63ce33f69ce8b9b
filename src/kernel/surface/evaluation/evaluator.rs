//! Points and derivatives of one surface at many scattered parameters.
//!
//! The basis functions along u are expanded in powers once, and so is each row of control points
//! along v, as in the evaluator of a curve. A point then is a sum over the rows that act there, of
//! the powers of each. To expand the patches along u as well would take p + 1 times the memory
//! again, and a look into that costs more than the sum.

use glam::DVec3;

use super::expansion::SurfaceExpansion;
use crate::{knots::POWER_DEGREE, surface::NurbsSurface};

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
    expanded: Option<&'a SurfaceExpansion>,
}

impl NurbsSurface {
    /// The surface prepared to be evaluated at many parameters; the first time this takes O(p³) for
    /// each span along u and O(q²) for each row and span along v, and some 2q + 2 times the memory
    /// of the control points.
    #[must_use]
    pub fn evaluator(&self) -> SurfaceEvaluator<'_> {
        let is_low = self.degree_u().max(self.degree_v()) <= POWER_DEGREE;
        let expanded = is_low.then(|| {
            self.expanded.get_or_make(|| {
                SurfaceExpansion::new([&self.knots_u, &self.knots_v], &self.control_points)
            })
        });
        SurfaceEvaluator { surface: self, expanded }
    }
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
