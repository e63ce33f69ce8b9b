//! Curves whose parameters are far from zero, such as seconds of an epoch.
//!
//! One step of such a parameter moves the point by more than a tolerance. What is searched by parameters
//! is searched on the same curve from zero on, where parameters have all their digits, and told by the
//! parameter nearest to it.

use glam::DVec3;

use crate::{
    Curve, Frame, GeomError, IntersectionError, Tolerance,
    curve::{CurveIntersection, NurbsCurve},
};

impl NurbsCurve {
    /// The curve over 0 to the length of its domain, if that is far from zero.
    pub(crate) fn near_zero(&self) -> Option<Self> {
        self.domain().near_zero().map(|domain| self.reparametrized(domain))
    }

    /// The points where the curve passes through a plane or touches it, as
    /// [`Self::plane_parameters`] finds them, in order.
    #[must_use]
    pub fn plane_points(&self, plane: Frame, tolerance: Tolerance) -> Vec<DVec3> {
        if let Some(near) = self.near_zero() {
            return near.plane_points(plane, tolerance);
        }
        let parameters = self.plane_parameters(plane, tolerance).into_iter();
        parameters.map(|t| self.point_at(t)).collect()
    }

    /// Meetings with another curve, or with itself, of curves that are far from zero; none where no curve is.
    pub(in crate::curve) fn meetings_near_zero(
        &self,
        other: Option<&Self>,
        tolerance: f64,
        left: &mut usize,
    ) -> Option<Result<Vec<CurveIntersection>, GeomError>> {
        let found = match (self.near_zero(), other.map(|other| (other, other.near_zero()))) {
            (None, None | Some((_, None))) => return None,
            (Some(near), None) => near.own_meetings(tolerance, left),
            (near, Some((other, near_other))) => {
                let [own, other] =
                    [near.as_ref().unwrap_or(self), near_other.as_ref().unwrap_or(other)];
                own.meetings_with(other, tolerance, left)
            }
        };
        let domains = [self, other.unwrap_or(self)].map(Self::domain);
        let told = |meeting: CurveIntersection| CurveIntersection {
            first: domains[0].far_from_zero(meeting.first),
            second: domains[1].far_from_zero(meeting.second),
            ..meeting
        };
        let found = found.map(|found| found.into_iter().map(told).collect());
        Some(found.map_err(|error| match error {
            GeomError::Intersection(IntersectionError::RunTogether { start, end }) => {
                let [start, end] = [start, end].map(|t| domains[0].far_from_zero(t));
                IntersectionError::RunTogether { start, end }.into()
            }
            GeomError::Intersection(IntersectionError::RunsAlongItself { start, end }) => {
                let [start, end] = [start, end].map(|t| domains[0].far_from_zero(t));
                IntersectionError::RunsAlongItself { start, end }.into()
            }
            other => other,
        }))
    }
}

impl Curve {
    /// As [`NurbsCurve::plane_points`].
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn plane_points(
        &self,
        plane: Frame,
        tolerance: Tolerance,
    ) -> Result<Vec<DVec3>, GeomError> {
        match self {
            Self::Nurbs(curve) => Ok(curve.plane_points(plane, tolerance)),
            Self::Parametric(_) => {
                let parameters = self.plane_parameters(plane, tolerance)?;
                parameters.into_iter().map(|t| self.point_at(t)).collect()
            }
        }
    }
}
