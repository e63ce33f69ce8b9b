//! A surface of either kind: an exact NURBS, or a function.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::{
    Bounds, Curve, FormError, GeomError, Grid, Interval,
    surface::{GridSamples, NurbsSurface, ParametricSurface},
};

/// A surface. Cheap to clone.
///
/// A torus has the area 4π²·R·r:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, Surface};
///
/// let torus = Surface::from(NurbsSurface::torus(Frame::XY, 3.0, 1.0)?);
/// let (area, _) = torus.area()?;
/// assert!((area / (12.0 * std::f64::consts::PI.powi(2)) - 1.0).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// An exact NURBS.
    Nurbs(Arc<NurbsSurface>),
    /// A function.
    Parametric(Arc<ParametricSurface>),
}

impl Surface {
    /// The NURBS that it is.
    ///
    /// # Errors
    /// [`FormError::NotNurbs`] for a parametric surface.
    pub fn nurbs(&self) -> Result<&Arc<NurbsSurface>, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface),
            Self::Parametric(_) => Err(GeomError::Form(FormError::NotNurbs { what: "surface" })),
        }
    }

    /// The parameters u that have points.
    #[must_use]
    pub fn domain_u(&self) -> Interval {
        match self {
            Self::Nurbs(surface) => surface.domain_u(),
            Self::Parametric(surface) => surface.domain_u(),
        }
    }

    /// The parameters v that have points.
    #[must_use]
    pub fn domain_v(&self) -> Interval {
        match self {
            Self::Nurbs(surface) => surface.domain_v(),
            Self::Parametric(surface) => surface.domain_v(),
        }
    }

    /// Whether the edges at the two ends of u are within `distance` of one another.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn is_closed_u(&self, distance: f64) -> Result<bool, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.is_closed_u(distance)),
            Self::Parametric(surface) => surface.is_closed_u(distance),
        }
    }

    /// Whether the edges at the two ends of v are within `distance` of one another.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn is_closed_v(&self, distance: f64) -> Result<bool, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.is_closed_v(distance)),
            Self::Parametric(surface) => surface.is_closed_v(distance),
        }
    }

    /// Point at `(u, v)` of the domain.
    ///
    /// # Errors
    /// Where a parametric surface fails: [`ParametricSurface::derivatives_at`]. So do all
    /// questions.
    pub fn point_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.point_at(u, v)),
            Self::Parametric(surface) => surface.point_at(u, v),
        }
    }

    /// Derivatives at `(u, v)`: row k, column l holds the one of order k in u and l in v, where
    /// k + l is up to `order`; do not rely on the rest of the grid.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn derivatives_at(&self, u: f64, v: f64, order: usize) -> Result<Grid<DVec3>, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.derivatives_at(u, v, order)),
            Self::Parametric(surface) => surface.derivatives_at(u, v, order),
        }
    }

    /// Whether the surface goes on around a place to all sides, across a seam too, with derivatives that do not jump; a
    /// parametric surface inside of its domain.
    #[must_use]
    pub fn is_smooth_around(&self, u: f64, v: f64) -> bool {
        let is_inside = |domain: Interval, t: f64| domain.start() < t && t < domain.end();
        match self {
            Self::Nurbs(surface) => surface.is_smooth_around(u, v),
            Self::Parametric(surface) => {
                is_inside(surface.domain_u(), u) && is_inside(surface.domain_v(), v)
            }
        }
    }

    /// Point, Su and Sv at `(u, v)`.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn tangents_at(&self, u: f64, v: f64) -> Result<[DVec3; 3], GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.tangents_at(u, v)),
            Self::Parametric(surface) => {
                let derivatives = surface.derivatives_at(u, v, 1)?;
                Ok([derivatives.get(0, 0), derivatives.get(1, 0), derivatives.get(0, 1)])
            }
        }
    }

    /// The unit vector along Su × Sv, or its limit where the product vanishes.
    ///
    /// # Errors
    /// `LocalError::NoNormal`, and as [`Self::point_at`].
    pub fn normal_at(&self, u: f64, v: f64) -> Result<DVec3, GeomError> {
        match self {
            Self::Nurbs(surface) => surface.normal_at(u, v),
            Self::Parametric(surface) => surface.normal_at(u, v),
        }
    }

    /// The curve of constant `u`, which runs along v.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn isocurve_u(&self, u: f64) -> Result<Curve, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.isocurve_u(u).into()),
            Self::Parametric(surface) => surface.isocurve_u(u).map(Curve::from),
        }
    }

    /// The curve of constant `v`, which runs along u.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn isocurve_v(&self, v: f64) -> Result<Curve, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.isocurve_v(v).into()),
            Self::Parametric(surface) => surface.isocurve_v(v).map(Curve::from),
        }
    }

    /// The smallest axis-aligned box around the surface, to rounding; around a function to 1e-8 of
    /// its size, or to 1e-5 where that takes too many cells.
    ///
    /// # Errors
    /// As [`ParametricSurface::to_nurbs`] for a function.
    pub fn bounds(&self) -> Result<Bounds, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.bounds()),
            Self::Parametric(surface) => surface.bounds(),
        }
    }

    /// The image under an affine map.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn transformed(&self, map: &DAffine3) -> Result<Self, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.transformed(map).into()),
            Self::Parametric(surface) => surface.transformed(map).map(Self::from),
        }
    }

    /// Whether every coordinate that it is made of is a number.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Nurbs(surface) => surface.control_points().iter().all(|point| point.is_finite()),
            // It was tried when it was made.
            Self::Parametric(_) => true,
        }
    }

    /// Points at all pairs of the parameters, row i for the i-th u.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn points_on_grid(&self, us: &[f64], vs: &[f64]) -> Result<Grid<DVec3>, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.points_on_grid(us, vs)),
            Self::Parametric(surface) => over_grid(us, vs, |u, v| surface.point_at(u, v)),
        }
    }

    /// Points and unit normals at all pairs of the parameters, row i for the i-th u, of a NURBS by up
    /// to `n_threads` threads.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn samples_on_grid(
        &self,
        us: &[f64],
        vs: &[f64],
        n_threads: usize,
    ) -> Result<GridSamples, GeomError> {
        match self {
            Self::Nurbs(surface) => Ok(surface.samples_on_grid(us, vs, n_threads)),
            Self::Parametric(surface) => Ok(GridSamples {
                points: over_grid(us, vs, |u, v| surface.point_at(u, v))?,
                normals: over_grid(us, vs, |u, v| Ok(surface.shading_normal(u, v)))?,
            }),
        }
    }
}

fn over_grid(
    us: &[f64],
    vs: &[f64],
    at: impl Fn(f64, f64) -> Result<DVec3, GeomError>,
) -> Result<Grid<DVec3>, GeomError> {
    let mut values = Vec::with_capacity(us.len() * vs.len());
    for &u in us {
        for &v in vs {
            values.push(at(u, v)?);
        }
    }
    Ok(Grid::from_rows_of(vs.len(), values))
}

impl From<NurbsSurface> for Surface {
    fn from(surface: NurbsSurface) -> Self {
        Self::Nurbs(Arc::new(surface))
    }
}

impl From<ParametricSurface> for Surface {
    fn from(surface: ParametricSurface) -> Self {
        Self::Parametric(Arc::new(surface))
    }
}
