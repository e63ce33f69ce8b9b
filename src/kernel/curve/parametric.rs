//! Curves of a function: any map of an interval into space that can tell its derivatives.

use std::{fmt, sync::Arc};

use glam::{DAffine3, DVec3};

use crate::kernel::{FunctionFailure, GeomError, Interval};

/// Even parts of a domain at whose ends a function is tried when a curve is made of it.
const PROBES: usize = 8;

/// A map of parameters to points.
pub trait CurveFunction: fmt::Debug + Send + Sync {
    /// Point and derivatives at `t` by order, `order + 1` of them; exact up to rounding.
    ///
    /// # Errors
    /// Where the function has no such value, in words of its own.
    fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, FunctionFailure>;
}

/// A curve of a function. Cheap to clone.
///
/// Invariant: the function has a point at both ends of the domain.
#[derive(Clone, Debug)]
pub struct ParametricCurve {
    domain: Interval,
    function: Arc<dyn CurveFunction>,
    /// Where space has been moved to since.
    map: DAffine3,
    ends: [DVec3; 2],
}

impl ParametricCurve {
    /// The curve of a function on a domain; the function is tried at the ends and at places
    /// between them.
    ///
    /// # Errors
    /// [`GeomError::Function`] where the function fails, [`GeomError::BeyondNumbers`].
    pub fn new(domain: Interval, function: Arc<dyn CurveFunction>) -> Result<Self, GeomError> {
        let mut curve = Self { domain, function, map: DAffine3::IDENTITY, ends: [DVec3::ZERO; 2] };
        let probes = domain.steps(PROBES).into_iter().map(|t| curve.point_at(t));
        let points: Vec<DVec3> = probes.collect::<Result<_, _>>()?;
        curve.ends = [points[0], points[PROBES]];
        Ok(curve)
    }

    /// The parameters that have a point.
    #[must_use]
    pub fn domain(&self) -> Interval {
        self.domain
    }

    /// The function itself.
    #[must_use]
    pub fn function(&self) -> &Arc<dyn CurveFunction> {
        &self.function
    }

    /// The point at the start of the domain.
    #[must_use]
    pub fn start(&self) -> DVec3 {
        self.ends[0]
    }

    /// The point at the end of the domain.
    #[must_use]
    pub fn end(&self) -> DVec3 {
        self.ends[1]
    }

    /// Point at parameter `t`.
    ///
    /// # Errors
    /// As [`Self::derivatives_at`].
    pub fn point_at(&self, t: f64) -> Result<DVec3, GeomError> {
        Ok(self.derivatives_at(t, 0)?[0])
    }

    /// Point and derivatives at `t` by order, `order + 1` of them.
    ///
    /// # Errors
    /// [`GeomError::Function`] where the function fails, [`GeomError::BeyondNumbers`] where a
    /// coordinate overflows.
    pub fn derivatives_at(&self, t: f64, order: usize) -> Result<Vec<DVec3>, GeomError> {
        let mut derivatives = self.function.derivatives_at(t, order)?;
        for (k, derivative) in derivatives.iter_mut().enumerate() {
            *derivative = match k {
                0 => self.map.transform_point3(*derivative),
                _ => self.map.transform_vector3(*derivative),
            };
        }
        match derivatives.iter().position(|derivative| !derivative.is_finite()) {
            Some(order) => Err(GeomError::BeyondNumbers { order, parameter: t }),
            None => Ok(derivatives),
        }
    }

    /// The image under an affine map.
    #[must_use]
    pub fn transformed(&self, map: &DAffine3) -> Self {
        Self {
            map: *map * self.map,
            ends: self.ends.map(|end| map.transform_point3(end)),
            ..self.clone()
        }
    }
}

/// Curves are equal when they are one function in memory, moved alike.
impl PartialEq for ParametricCurve {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.function, &other.function)
            && self.domain == other.domain
            && self.map == other.map
    }
}
