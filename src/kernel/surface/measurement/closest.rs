//! The point of a surface that is nearest to a given one.
//!
//! Of a NURBS that of the whole surface, its boundary included. Of a function nothing is known but
//! its values: there the best of a grid's local minima is, improved by Newton's method.

use std::convert::Infallible;

use glam::DVec3;

use crate::{
    GeomError, InputError, Interval,
    frame::norm,
    nearest::{ClosestPointTree, FootVector, PatchPart, SearchTarget, descend},
    surface::{NurbsSurface, ParametricSurface, Surface},
    tolerance::LAST_BIT,
};

/// Even parts of each domain of a function at whose corners it is asked for the distance.
const GRID: usize = 48;

/// The nearest point of a surface.
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, glam::DVec3};
///
/// let sphere = NurbsSurface::sphere(Frame::XY, 1.0)?;
/// let foot = sphere.closest(DVec3::new(0.0, 3.0, 4.0));
/// assert!((foot.distance - 4.0).abs() < 1e-12);
/// assert!(foot.point.distance(DVec3::new(0.0, 0.6, 0.8)) < 1e-9);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceClosestPoint {
    /// Where it is: along u and along v. At a seam and at a pole the start of the domain; what is
    /// at an end of a domain up to rounding is there.
    pub parameters: [f64; 2],
    /// The point.
    pub point: DVec3,
    /// How far away it is.
    pub distance: f64,
}

impl Surface {
    /// The nearest point to `p`, its boundary included: of a NURBS that of the whole surface; of a
    /// function the best that a search from places of a grid comes to.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn closest(&self, p: DVec3) -> Result<SurfaceClosestPoint, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.closest(p)),
            Self::Parametric(surface) => surface.closest(p),
        }
    }
}

impl NurbsSurface {
    /// The patches in their boxes, made once: where the nearest point is looked for, and what else
    /// lies in space.
    pub(in crate::surface) fn patch_boxes(&self) -> &ClosestPointTree {
        let knots = [&self.knots_u, &self.knots_v];
        self.nearest.get_or_make(|| ClosestPointTree::of_surface(knots, &self.control_points))
    }

    /// The nearest point to `p`, of the whole surface.
    ///
    /// Ma & Hewitt, *Point inversion and projection for NURBS curve and surface*, CAGD 20 (2003),
    /// say how a patch is left out; here that is decided without their conditions on the net.
    #[must_use]
    pub fn closest(&self, p: DVec3) -> SurfaceClosestPoint {
        if let Some((scaled, scale)) = &self.scaled
            && (p / *scale).is_finite()
        {
            let foot = scaled.closest(p / *scale);
            let point = self.point_at(foot.parameters[0], foot.parameters[1]);
            return SurfaceClosestPoint { point, distance: *scale * foot.distance, ..foot };
        }
        if let Some(foot) = self.closest_beside_jump(p) {
            return foot;
        }
        let near =
            self.patch_boxes().places(self.control_points.as_slice(), p, SearchTarget::One).single;
        let domains = [self.domain_u(), self.domain_v()];
        let parameters = near.first().copied().unwrap_or(domains.map(Interval::start));
        let at = |[u, v]: [f64; 2]| self.point_at(u, v);
        let point = at(parameters);
        let rounding = LAST_BIT * (p.abs().max_element() + point.abs().max_element());

        let mut foot = SurfaceClosestPoint { parameters, point, distance: norm(point - p) };
        for (direction, domain) in domains.into_iter().enumerate() {
            let on_end = [domain.start(), domain.end()].into_iter().find_map(|end| {
                let mut parameters = foot.parameters;
                parameters[direction] = end;
                let point = at(parameters);
                let is_there = norm(point - foot.point) <= 4.0 * rounding;
                is_there.then(|| SurfaceClosestPoint {
                    parameters,
                    point,
                    distance: norm(point - p),
                })
            });
            foot = on_end.unwrap_or(foot);
        }
        foot
    }

    /// The point that a search from parameters goes down to: near that place, perhaps not the nearest of all.
    pub(crate) fn foot_from(&self, start: [f64; 2], p: DVec3) -> SurfaceClosestPoint {
        self.place_near(start, p, 0.0)
    }

    /// A point as near as a distance to which a search from parameters goes down; where none is, as [`Self::foot_from`].
    pub(in crate::surface) fn place_near(
        &self,
        start: [f64; 2],
        p: DVec3,
        near: f64,
    ) -> SurfaceClosestPoint {
        let cell = PatchPart::between(self.domain_u(), self.domain_v());
        let Ok(found) = descend(&cell, start, near, |[u, v]| {
            let mut derivatives = self.second_order_at(u, v);
            derivatives[0] -= p;
            Ok::<FootVector, Infallible>(FootVector::new([u, v], derivatives))
        });
        let point = self.point_at(found.place[0], found.place[1]);
        SurfaceClosestPoint { parameters: found.place, point, distance: norm(point - p) }
    }
}

/// A function with its points at the places of a grid, to be asked for many nearest ones.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{
///     FunctionFailure, Grid, Interval, ParametricSurface, SurfaceFunction, glam::DVec3,
/// };
/// # #[derive(Debug)]
/// # struct Plane;
/// #
/// # impl SurfaceFunction for Plane {
/// #     fn derivatives_at(
/// #         &self,
/// #         u: f64,
/// #         v: f64,
/// #         order: usize,
/// #     ) -> Result<Grid<DVec3>, FunctionFailure> {
/// #         Ok(Grid::from_fn(order + 1, order + 1, |i, j| match (i, j) {
/// #             (0, 0) => DVec3::new(u, v, 0.0),
/// #             (1, 0) => DVec3::X,
/// #             (0, 1) => DVec3::Y,
/// #             _ => DVec3::ZERO,
/// #         }))
/// #     }
/// # }
///
/// let domain = Interval::new(0.0, 2.0)?;
/// let plane = ParametricSurface::new(domain, domain, Arc::new(Plane))?;
/// let foot = plane.places()?.closest(DVec3::new(0.5, 1.5, 3.0))?;
/// assert!((foot.distance - 3.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Debug)]
pub struct ParametricPlaces<'a> {
    surface: &'a ParametricSurface,
    us: Vec<f64>,
    vs: Vec<f64>,
    points: Vec<DVec3>,
}

impl ParametricSurface {
    /// The nearest point to `p`, as [`ParametricPlaces::closest`].
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn closest(&self, p: DVec3) -> Result<SurfaceClosestPoint, GeomError> {
        if let Some((scaled, scale)) = self.scaled()
            && (p / scale).is_finite()
        {
            let foot = scaled.closest(p / scale)?;
            let point = self.point_at(foot.parameters[0], foot.parameters[1])?;
            return Ok(SurfaceClosestPoint { point, distance: scale * foot.distance, ..foot });
        }
        self.places()?.closest(p)
    }

    /// What answers for many nearest points.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn places(&self) -> Result<ParametricPlaces<'_>, GeomError> {
        let (us, vs) = (self.domain_u().steps(GRID), self.domain_v().steps(GRID));
        let mut points = Vec::with_capacity(us.len() * vs.len());
        for &u in &us {
            for &v in &vs {
                points.push(self.point_at(u, v)?);
            }
        }
        Ok(ParametricPlaces { surface: self, us, vs, points })
    }
}

impl ParametricPlaces<'_> {
    /// The nearest point to `p` that a search from places of a grid of 49 x 49 comes to. What
    /// the function does between these places may escape it.
    ///
    /// # Errors
    /// As [`ParametricSurface::derivatives_at`].
    pub fn closest(&self, p: DVec3) -> Result<SurfaceClosestPoint, GeomError> {
        let (surface, us, vs) = (self.surface, &self.us, &self.vs);
        let n = GRID + 1;
        let distances: Vec<f64> = self.points.iter().map(|&point| norm(point - p)).collect();
        let cell = PatchPart::between(surface.domain_u(), surface.domain_v());
        let mut best: Option<SurfaceClosestPoint> = None;
        for i in 0..n * n {
            if !is_least_around(&distances, n, i) {
                continue;
            }
            let found = descend(&cell, [us[i / n], vs[i % n]], 0.0, |[u, v]| {
                let all = surface.derivatives_at(u, v, 2)?;
                let orders = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)];
                let mut derivatives = orders.map(|(k, l)| all.get(k, l));
                derivatives[0] -= p;
                Ok::<FootVector, GeomError>(FootVector::new([u, v], derivatives))
            })?;
            let point = surface.point_at(found.place[0], found.place[1])?;
            let foot =
                SurfaceClosestPoint { parameters: found.place, point, distance: norm(point - p) };
            if best.is_none_or(|best| foot.distance < best.distance) {
                best = Some(foot);
            }
        }
        best.ok_or(GeomError::Input(InputError::NotFinite {
            what: "distance to the point",
            index: 0,
        }))
    }
}

/// Whether none of the neighbours on an n x n grid has less.
fn is_least_around(values: &[f64], n: usize, index: usize) -> bool {
    let (row, column) = (index / n, index % n);
    let rows = row.saturating_sub(1)..=(row + 1).min(n - 1);
    let columns = column.saturating_sub(1)..=(column + 1).min(n - 1);
    rows.flat_map(|i| columns.clone().map(move |j| i * n + j)).all(|i| values[index] <= values[i])
}
