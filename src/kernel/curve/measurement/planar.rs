//! The plane that a curve lies in.

use glam::DVec3;

use crate::{
    ConstructionError, FormError, Frame, GeomError, InputError,
    curve::NurbsCurve,
    frame::{across, norm, unit},
    homogeneous,
    tolerance::VANISHING_RELATIVE,
};

impl NurbsCurve {
    /// The plane of the curve, with its normal on the side of the unit vector `forward` and its
    /// origin nearest to the origin of space; of a straight curve the plane nearest to being
    /// normal to `forward`.
    ///
    /// # Errors
    /// [`FormError::NotPlanar`] where a control point is further from the plane than `distance`,
    /// [`InputError::ZeroAxis`] where all are at one place, [`ConstructionError::NoTurn`] on a line along
    /// `forward`.
    pub fn plane_across(&self, forward: DVec3, distance: f64) -> Result<Frame, GeomError> {
        let are_there = self.control_points().iter().filter(|point| point.w != 0.0);
        let points: Vec<DVec3> = are_there.map(|&point| homogeneous::place(point)).collect();
        let first = points[0];
        let farthest = |from: &dyn Fn(DVec3) -> f64| {
            points.iter().copied().max_by(|a, b| from(*a).total_cmp(&from(*b))).unwrap_or(first)
        };
        let along = unit(farthest(&|p| norm(p - first)) - first)
            .ok_or(GeomError::Input(InputError::ZeroAxis { what: "a section of one point" }))?;
        let off_line = |p: DVec3| (p - first) - along * (p - first).dot(along);
        let aside = off_line(farthest(&|p| norm(off_line(p))));
        let normal = if norm(aside) <= distance {
            across(forward, along).ok_or(GeomError::Construction(ConstructionError::NoTurn))?
        } else {
            facing(unit(along.cross(aside)).unwrap_or(forward), forward)
        };
        let by = points.iter().map(|p| (*p - first).dot(normal).abs()).fold(0.0, f64::max);
        if distance < by {
            return Err(FormError::NotPlanar { by }.into());
        }
        Frame::from_normal(normal * first.dot(normal), normal, None)
    }
}

/// The normal of a plane on the side of `forward`; where that lies in the plane, the upper one.
pub(crate) fn facing(normal: DVec3, forward: DVec3) -> DVec3 {
    let is_clear = |coordinate: &f64| VANISHING_RELATIVE < coordinate.abs();
    let sides = [normal.dot(forward), normal.z, normal.y, normal.x];
    let side = sides.into_iter().find(is_clear).unwrap_or(1.0);
    if side < 0.0 { -normal } else { normal }
}
