//! A curve of either kind: an exact NURBS, or a function.

use std::sync::Arc;

use glam::{DAffine3, DVec3};

use crate::{
    FormError, GeomError, Interval, Side,
    curve::{NurbsCurve, ParametricCurve},
};

/// A curve. Cheap to clone.
///
/// ```
/// use virote_kernel::{Curve, NurbsCurve, glam::DVec3};
///
/// let line = Curve::from(NurbsCurve::line(DVec3::ZERO, DVec3::new(3.0, 4.0, 0.0))?);
/// assert_eq!(line.point_at(0.5)?, DVec3::new(1.5, 2.0, 0.0));
/// assert!((line.length(line.domain())? - 5.0).abs() < 1e-14);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Curve {
    /// An exact NURBS.
    Nurbs(Arc<NurbsCurve>),
    /// A function.
    Parametric(Arc<ParametricCurve>),
}

impl Curve {
    /// The NURBS that it is.
    ///
    /// # Errors
    /// [`FormError::NotNurbs`] for a parametric curve.
    pub fn nurbs(&self) -> Result<&Arc<NurbsCurve>, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve),
            Self::Parametric(_) => Err(GeomError::Form(FormError::NotNurbs { what: "curve" })),
        }
    }

    /// The NURBS that it is, or a spline within the tolerance of a function.
    ///
    /// # Errors
    /// Those of [`ParametricCurve::to_nurbs`].
    pub fn nurbs_within(&self, tolerance: f64) -> Result<Arc<NurbsCurve>, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(Arc::clone(curve)),
            Self::Parametric(curve) => curve.to_nurbs(tolerance).map(Arc::new),
        }
    }

    /// The parameters that have a point.
    #[must_use]
    pub fn domain(&self) -> Interval {
        match self {
            Self::Nurbs(curve) => curve.domain(),
            Self::Parametric(curve) => curve.domain(),
        }
    }

    /// The point at the start of the domain.
    #[must_use]
    pub fn start(&self) -> DVec3 {
        match self {
            Self::Nurbs(curve) => curve.start(),
            Self::Parametric(curve) => curve.start(),
        }
    }

    /// The point at the end of the domain.
    #[must_use]
    pub fn end(&self) -> DVec3 {
        match self {
            Self::Nurbs(curve) => curve.end(),
            Self::Parametric(curve) => curve.end(),
        }
    }

    /// Whether start and end are within `distance` of one another, and of a small fraction of the
    /// size of the curve: a short curve is not closed.
    #[must_use]
    pub fn is_closed(&self, distance: f64) -> bool {
        match self {
            Self::Nurbs(curve) => curve.is_closed(distance),
            Self::Parametric(curve) => curve.is_closed(distance),
        }
    }

    /// Point at parameter `t` of the domain.
    ///
    /// # Errors
    /// Where a parametric curve fails: [`ParametricCurve::derivatives_at`]. So do all questions.
    pub fn point_at(&self, t: f64) -> Result<DVec3, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.point_at(t)),
            Self::Parametric(curve) => curve.point_at(t),
        }
    }

    /// Point and derivatives at `t` by order, `order + 1` of them; at a knot those of the piece
    /// to its right, at the end of the domain those from the left.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, GeomError> {
        self.derivatives_beside(t, Side::Right, order)
    }

    /// Derivatives at `t` of the piece on one side of it.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn derivatives_beside(
        &self,
        t: f64,
        side: Side,
        order: usize,
    ) -> Result<Vec<DVec3>, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.derivatives_beside(t, side, order)),
            Self::Parametric(curve) => curve.derivatives_at(curve.beside(t, side), order),
        }
    }

    /// Unit tangent at `t`, in the direction of growing parameters; where the derivative vanishes
    /// its limit from one side.
    ///
    /// # Errors
    /// `LocalError::VanishingTangent`, and as [`Self::point_at`].
    pub fn tangent_at(&self, t: f64, side: Side) -> Result<DVec3, GeomError> {
        match self {
            Self::Nurbs(curve) => curve.tangent_at(t, side),
            Self::Parametric(curve) => curve.tangent_at(t, side),
        }
    }

    /// `n` points at evenly spaced parameters, both ends among them; one point is the start.
    ///
    /// # Errors
    /// As [`Self::point_at`].
    pub fn sample(&self, n: usize) -> Result<Vec<DVec3>, GeomError> {
        match (self, n) {
            (Self::Nurbs(curve), _) => Ok(curve.sample(n)),
            (Self::Parametric(_), 0) => Ok(Vec::new()),
            (Self::Parametric(curve), _) => {
                self.domain().steps(n - 1).into_iter().map(|t| curve.point_at(t)).collect()
            }
        }
    }

    /// The image under an affine map.
    #[must_use]
    pub fn transformed(&self, map: &DAffine3) -> Self {
        match self {
            Self::Nurbs(curve) => curve.transformed(map).into(),
            Self::Parametric(curve) => curve.transformed(map).into(),
        }
    }

    /// Whether every coordinate that it is made of is a number.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Nurbs(curve) => curve.control_points().iter().all(|point| point.is_finite()),
            Self::Parametric(curve) => curve.start().is_finite() && curve.end().is_finite(),
        }
    }
}

impl From<NurbsCurve> for Curve {
    fn from(curve: NurbsCurve) -> Self {
        Self::Nurbs(Arc::new(curve))
    }
}

impl From<ParametricCurve> for Curve {
    fn from(curve: ParametricCurve) -> Self {
        Self::Parametric(Arc::new(curve))
    }
}
