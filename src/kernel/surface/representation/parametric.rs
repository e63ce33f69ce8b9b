//! Surfaces of a function: any map of a rectangle into space that can tell its derivatives.

use std::{any::Any, fmt, sync::Arc};

use glam::{DAffine3, DVec3};

use crate::{
    Bounds, CurveFunction, FunctionFailure, GeomError, Grid, Interval, LocalError, ParametricCurve,
    frame::unit,
    scale::needed_scale,
    surface::{
        Direction,
        evaluation::normal::{fold_area, limit_normal, shading_place},
    },
};

/// Even parts of each domain at whose ends a function is tried when a surface is made of it.
const PROBES: usize = 4;

/// Even parts of an edge at whose ends it is compared with the opposite one.
const EDGE_SAMPLES: usize = 64;

/// A map of two parameters to points.
///
/// The paraboloid z = u² + v², whose Gaussian curvature at the bottom is 2·2:
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{
///     FunctionFailure, Grid, Interval, Jet, ParametricSurface, Surface, SurfaceFunction, glam::DVec3,
/// };
///
/// #[derive(Debug)]
/// struct Bowl;
///
/// impl SurfaceFunction for Bowl {
///     fn derivatives_at(
///         &self,
///         u: f64,
///         v: f64,
///         order: usize,
///     ) -> Result<Grid<DVec3>, FunctionFailure> {
///         let [u, v] = Jet::variables(u, v, order);
///         let height = u.times(&u).plus(&v.times(&v));
///         Ok(Grid::from_fn(order + 1, order + 1, |i, j| match i + j <= order {
///             true => DVec3::from([&u, &v, &height].map(|jet| jet.derivative(i, j))),
///             false => DVec3::ZERO,
///         }))
///     }
/// }
///
/// let domain = Interval::new(-1.0, 1.0)?;
/// let bowl = Surface::from(ParametricSurface::new(domain, domain, Arc::new(Bowl))?);
/// assert!((bowl.shape_at(0.0, 0.0)?.gaussian() - 4.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
pub trait SurfaceFunction: fmt::Debug + Send + Sync {
    /// Derivatives at `(u, v)`: row k, column l holds the one of order k in u and l in v, where
    /// k + l is up to `order`; the rest of the grid is zero. Exact up to rounding.
    ///
    /// # Errors
    /// Where the function has no such value, in words of its own.
    fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, FunctionFailure>;
}

/// A surface of a function. Cheap to clone.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{
///     FunctionFailure, Grid, Interval, ParametricSurface, SurfaceFunction, glam::DVec3,
/// };
///
/// #[derive(Debug)]
/// struct Plane;
///
/// impl SurfaceFunction for Plane {
///     fn derivatives_at(
///         &self,
///         u: f64,
///         v: f64,
///         order: usize,
///     ) -> Result<Grid<DVec3>, FunctionFailure> {
///         Ok(Grid::from_fn(order + 1, order + 1, |i, j| match (i, j) {
///             (0, 0) => DVec3::new(u, v, 0.0),
///             (1, 0) => DVec3::X,
///             (0, 1) => DVec3::Y,
///             _ => DVec3::ZERO,
///         }))
///     }
/// }
///
/// let domain = Interval::new(0.0, 2.0)?;
/// let plane = ParametricSurface::new(domain, domain, Arc::new(Plane))?;
/// assert_eq!(plane.normal_at(0.5, 1.5)?, DVec3::Z);
/// assert_eq!(plane.point_at(0.5, 1.5)?, DVec3::new(0.5, 1.5, 0.0));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ParametricSurface {
    domain_u: Interval,
    domain_v: Interval,
    function: Arc<dyn SurfaceFunction>,
    /// Where space has been moved to since.
    map: DAffine3,
    /// The area of Su × Sv over the whole domain that is rounding and no area.
    fold_area: f64,
    /// The surface divided by a power of two near its size, with that power, where squares of its
    /// coordinates are no numbers.
    scaled: Option<(Arc<Self>, f64)>,
    /// What the function may need to answer.
    _kept: Option<Arc<dyn Any + Send + Sync>>,
}

impl ParametricSurface {
    /// The surface of a function on a rectangle; the function is tried at the corners and at
    /// places between them.
    ///
    /// # Errors
    /// [`GeomError::Function`] where the function fails, [`LocalError::BeyondNumbers`].
    pub fn new(
        domain_u: Interval,
        domain_v: Interval,
        function: Arc<dyn SurfaceFunction>,
    ) -> Result<Self, GeomError> {
        let map = DAffine3::IDENTITY;
        let surface =
            Self { domain_u, domain_v, function, map, fold_area: 0.0, scaled: None, _kept: None };
        surface.measured()
    }

    /// The same with its size known, and what follows from that.
    fn measured(mut self) -> Result<Self, GeomError> {
        let mut points = Vec::with_capacity((PROBES + 1) * (PROBES + 1));
        for u in self.domain_u.steps(PROBES) {
            for v in self.domain_v.steps(PROBES) {
                points.push(self.point_at(u, v)?);
            }
        }
        let bounds = Bounds::of(points);
        self.fold_area = bounds.map_or(0.0, fold_area);
        self.scaled = None;
        if let Some(scale) = bounds.and_then(|bounds| needed_scale(bounds.magnitude())) {
            let divide = DAffine3::from_scale(DVec3::splat(scale.recip()));
            self.scaled = Some((Arc::new(self.transformed(&divide)?), scale));
        }
        Ok(self)
    }

    /// The parameters u that have points.
    #[must_use]
    pub fn domain_u(&self) -> Interval {
        self.domain_u
    }

    /// The parameters v that have points.
    #[must_use]
    pub fn domain_v(&self) -> Interval {
        self.domain_v
    }

    /// The parameters along a direction that have points.
    #[must_use]
    pub fn domain(&self, along: Direction) -> Interval {
        match along {
            Direction::U => self.domain_u,
            Direction::V => self.domain_v,
        }
    }

    /// The same function over another domain of one parameter; it is tried there anew.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub(in crate::surface) fn over(
        &self,
        along: Direction,
        domain: Interval,
    ) -> Result<Self, GeomError> {
        match along {
            Direction::U => Self { domain_u: domain, ..self.clone() },
            Direction::V => Self { domain_v: domain, ..self.clone() },
        }
        .measured()
    }

    /// The function itself.
    #[must_use]
    pub fn function(&self) -> &Arc<dyn SurfaceFunction> {
        &self.function
    }

    /// Point at `(u, v)`.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn point_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        Ok(self.derivatives_at(u, v, 0)?.get(0, 0))
    }

    /// Derivatives at `(u, v)`: row k, column l holds the one of order k in u and l in v, where
    /// k + l is up to `order`; the rest of the grid is zero.
    ///
    /// # Errors
    /// [`GeomError::Function`] where the function fails, [`LocalError::BeyondNumbersAt`] where a
    /// coordinate overflows.
    pub fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, GeomError> {
        let derivatives = self.function.derivatives_at(u, v, order)?;
        let moved = Grid::from_fn(order + 1, order + 1, |k, l| match (k, l) {
            (0, 0) => self.map.transform_point3(derivatives.get(0, 0)),
            _ => self.map.transform_vector3(derivatives.get(k, l)),
        });
        if moved.iter().all(|derivative| derivative.is_finite()) {
            Ok(moved)
        } else {
            Err(GeomError::Local(LocalError::BeyondNumbersAt { u, v }))
        }
    }

    /// The unit vector along Su × Sv, or its limit where the product vanishes.
    ///
    /// # Errors
    /// [`LocalError::NoNormal`], and as [`Self::derivatives_at`].
    pub fn normal_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        if let Some((scaled, _)) = &self.scaled {
            return scaled.normal_at(u, v);
        }
        let derivatives = self.derivatives_at(u, v, 1)?;
        let normal = derivatives.get(1, 0).cross(derivatives.get(0, 1));
        let widths = [self.domain_u.length(), self.domain_v.length()];
        let found = if self.fold_area < normal.length() * widths[0] * widths[1] {
            unit(normal)
        } else {
            let derivatives = |order| self.derivatives_at(u, v, order);
            limit_normal(
                derivatives,
                widths,
                [(self.domain_u, u), (self.domain_v, v)],
                self.fold_area,
            )?
        };
        found.ok_or(GeomError::Local(LocalError::NoNormal { u, v }))
    }

    /// The area of Su × Sv over the whole domain that is rounding and no area.
    pub(in crate::surface) fn fold_area(&self) -> f64 {
        self.fold_area
    }

    /// As [`Surface::scaled`](crate::Surface).
    pub(in crate::surface) fn scaled(&self) -> Option<(&Arc<Self>, f64)> {
        self.scaled.as_ref().map(|(scaled, scale)| (scaled, *scale))
    }

    /// A unit vector for shading: the normal, or the nearest there is.
    pub(in crate::surface) fn shading_normal(&self, u: f64, v: f64) -> DVec3 {
        let [inner_u, inner_v] = [shading_place(self.domain_u, u), shading_place(self.domain_v, v)];
        self.normal_at(u, v).or_else(|_| self.normal_at(inner_u, inner_v)).unwrap_or(DVec3::Z)
    }

    /// Whether the edges at the two ends of u are within `distance` of one another where they are
    /// compared: at 65 places.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn is_closed_u(&self, distance: f64) -> Result<bool, GeomError> {
        let (start, end) = (self.domain_u.start(), self.domain_u.end());
        for v in self.domain_v.steps(EDGE_SAMPLES) {
            if distance < self.point_at(start, v)?.distance(self.point_at(end, v)?) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether the edges at the two ends of v are within `distance` of one another where they are
    /// compared: at 65 places.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn is_closed_v(&self, distance: f64) -> Result<bool, GeomError> {
        let (start, end) = (self.domain_v.start(), self.domain_v.end());
        for u in self.domain_u.steps(EDGE_SAMPLES) {
            if distance < self.point_at(u, start)?.distance(self.point_at(u, end)?) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The curve of constant `u`, which runs along v.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn isocurve_u(&self, u: f64) -> Result<ParametricCurve, GeomError> {
        let isocurve = Isocurve { surface: self.clone(), at: u, along: Direction::V };
        ParametricCurve::new(self.domain_v, Arc::new(isocurve))
    }

    /// The curve of constant `v`, which runs along u.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn isocurve_v(&self, v: f64) -> Result<ParametricCurve, GeomError> {
        let isocurve = Isocurve { surface: self.clone(), at: v, along: Direction::U };
        ParametricCurve::new(self.domain_u, Arc::new(isocurve))
    }

    /// Whether it keeps something alive for its function.
    #[must_use]
    pub fn is_keeping(&self) -> bool {
        self._kept.is_some()
    }

    /// The same surface, which keeps something alive that its function needs, as does all that is made of it.
    #[must_use]
    pub fn keeping(&self, kept: Arc<dyn Any + Send + Sync>) -> Self {
        let scaled = self.scaled.as_ref();
        let scaled = scaled.map(|(own, size)| (Arc::new(own.keeping(Arc::clone(&kept))), *size));
        Self { scaled, _kept: Some(kept), ..self.clone() }
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn transformed(&self, map: &DAffine3) -> Result<Self, GeomError> {
        Self { map: *map * self.map, ..self.clone() }.measured()
    }
}

/// Surfaces are equal when they are one function in memory, moved alike.
impl PartialEq for ParametricSurface {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.function, &other.function)
            && self.domain_u == other.domain_u
            && self.domain_v == other.domain_v
            && self.map == other.map
    }
}

/// A surface along one parameter line.
#[derive(Debug)]
struct Isocurve {
    surface: ParametricSurface,
    at: f64,
    along: Direction,
}

impl CurveFunction for Isocurve {
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure> {
        let [u, v] = self.along.pair(t, self.at);
        let derivatives = self.surface.derivatives_at(u, v, order).map_err(FunctionFailure::new)?;
        let along = |k| {
            let [k, l] = self.along.pair(k, 0);
            derivatives.get(k, l)
        };
        Ok((0..=order).map(along).collect())
    }
}
