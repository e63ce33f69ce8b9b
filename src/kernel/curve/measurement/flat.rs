//! Whether a curve lies on a line or in a plane.

use glam::DVec3;

use crate::{
    GeomError, Tolerance,
    curve::{Curve, NurbsCurve},
    frame::{norm, unit},
    homogeneous,
    tolerance::VANISHING_RELATIVE,
};

impl Curve {
    /// Whether it lies within the tolerance of one line; a single point does.
    ///
    /// Told from the control points, which lie on the line exactly when the curve does.
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn is_straight(&self, tolerance: Tolerance) -> Result<bool, GeomError> {
        Ok(self.spline()?.is_straight(tolerance))
    }

    /// Whether it lies within the tolerance of one plane; a straight curve does.
    ///
    /// Told from the control points, which lie in the plane exactly when the curve does.
    ///
    /// # Errors
    /// As [`Self::spline`].
    pub fn is_planar(&self, tolerance: Tolerance) -> Result<bool, GeomError> {
        Ok(lie_in_a_plane(&self.spline()?.places(), tolerance))
    }

    /// Unit normal of the one plane in which the curve lies, to within the tolerance; none of a
    /// curve that is straight or lies in no plane.
    ///
    /// # Errors
    /// As [`Self::is_planar`].
    pub fn plane_normal(&self, tolerance: Tolerance) -> Result<Option<DVec3>, GeomError> {
        Ok(self.spline()?.plane_normal(tolerance))
    }
}

/// Whether points lie within the tolerance of one plane; points of a line do.
pub(crate) fn lie_in_a_plane(points: &[DVec3], tolerance: Tolerance) -> bool {
    let Some(widest) = widest(points) else { return true };
    lie_across(points, widest.normal, allowed(points, tolerance))
}

impl NurbsCurve {
    /// Whether it lies within the tolerance of one line.
    pub(in crate::curve) fn is_straight(&self, tolerance: Tolerance) -> bool {
        let points = self.places();
        let allowed = allowed(&points, tolerance);
        let Some(line) = line(&points) else { return true };
        points.iter().all(|&point| norm(across(point - points[0], line)) <= allowed)
    }

    /// Whether it lies within the tolerance of one line along the direction.
    #[must_use]
    pub fn is_along(&self, direction: DVec3, tolerance: Tolerance) -> bool {
        let points = self.places();
        let allowed = allowed(&points, tolerance);
        let Some(line) = unit(direction) else { return false };
        points.iter().all(|&point| norm(across(point - points[0], line)) <= allowed)
    }

    /// The normal of the plane in which it lies within the tolerance; none for a curve in space,
    /// and none for one on a line, which has no plane of its own.
    pub(in crate::curve) fn plane_normal(&self, tolerance: Tolerance) -> Option<DVec3> {
        let points = self.places();
        let allowed = allowed(&points, tolerance);
        let widest = widest(&points).filter(|widest| allowed < widest.width)?;
        lie_across(&points, widest.normal, allowed).then_some(widest.normal)
    }

    /// The control points; one of weight zero, which is a direction, as a step from the first.
    fn places(&self) -> Vec<DVec3> {
        let first = homogeneous::place(self.control_points[0]);
        let place = |&point: &glam::DVec4| match point.w.abs() < f64::MIN_POSITIVE {
            true => first + point.truncate(),
            false => homogeneous::place(point),
        };
        self.control_points.iter().map(place).collect()
    }
}

/// A normal of the plane of points that are not on one line.
pub(crate) fn plane_of(points: &[DVec3]) -> Option<DVec3> {
    widest(points).map(|widest| widest.normal)
}

/// The tolerance's distance, or what rounding leaves of the coordinates where that is more.
fn allowed(points: &[DVec3], tolerance: Tolerance) -> f64 {
    let largest = points.iter().map(|point| point.abs().max_element()).fold(0.0, f64::max);
    let size = points.iter().map(|point| norm(*point - points[0])).fold(0.0, f64::max);
    tolerance.distance_for(size).max(VANISHING_RELATIVE * largest)
}

/// The plane through the first point, the one furthest from it, and the one furthest from the
/// line of both.
struct WidestPlane {
    normal: DVec3,
    /// How far the third point is from the line.
    width: f64,
}

fn widest(points: &[DVec3]) -> Option<WidestPlane> {
    let line = line(points)?;
    let sideways = points.iter().map(|&point| across(point - points[0], line));
    let furthest = sideways.max_by(|a, b| norm(*a).total_cmp(&norm(*b)))?;
    let normal = unit(line.cross(unit(furthest)?))?;
    Some(WidestPlane { normal, width: norm(furthest) })
}

/// Whether the points are as near as that to the plane through the first of them.
fn lie_across(points: &[DVec3], normal: DVec3, allowed: f64) -> bool {
    points.iter().all(|&point| normal.dot(point - points[0]).abs() <= allowed)
}

/// The direction to the point that is furthest from the first.
fn line(points: &[DVec3]) -> Option<DVec3> {
    let furthest = points.iter().map(|&point| point - points[0]);
    unit(furthest.max_by(|a, b| norm(*a).total_cmp(&norm(*b)))?)
}

/// The part of `v` that is normal to the unit vector `axis`.
fn across(v: DVec3, axis: DVec3) -> DVec3 {
    v - axis * v.dot(axis)
}
