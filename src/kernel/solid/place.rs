//! Where points are in relation to a solid.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Solid, SolidError, box_around};
use crate::{
    Direction, FaceClosestPoint, GeomError, RegionSide, Tolerance,
    sorting::sort_by,
    tolerance::{PARAMETER_RELATIVE, STRAIGHT_SLACK, WHOLE_TURN_SLACK},
};

/// The point of a solid's skin that is nearest to another.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance, glam::DVec3};
///
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 2.0)?), Tolerance::DEFAULT)?;
/// let ball = Solid::new(&[sphere], Tolerance::DEFAULT)?;
/// let nearest = ball.closest(DVec3::X * 0.5, Tolerance::DEFAULT)?;
/// assert_eq!(nearest.face, 0);
/// assert!((nearest.foot.distance - 1.5).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidClosestPoint {
    /// The number of the face.
    pub face: usize,
    /// Where on it.
    pub foot: FaceClosestPoint,
}

impl Solid {
    /// The nearest point of its faces, of equal ones that of the first face.
    ///
    /// # Errors
    /// Those of [`crate::Face::closest`].
    pub fn closest(
        &self,
        point: DVec3,
        tolerance: Tolerance,
    ) -> Result<SolidClosestPoint, GeomError> {
        Ok(self.nearest_feet(0..self.faces.len(), point, 0.0, tolerance)?[0])
    }

    /// The nearest points of some of the faces that are at most so much further away than the nearest, which comes
    /// first.
    fn nearest_feet(
        &self,
        among: impl IntoIterator<Item = usize>,
        point: DVec3,
        further: f64,
        tolerance: Tolerance,
    ) -> Result<Vec<SolidClosestPoint>, GeomError> {
        // With those first that may be nearest most of the others are known to be further away.
        let away = |face: usize| (self.faces[face].surface().bounds().distance(point), face);
        let mut by_box: Vec<(f64, usize)> = among.into_iter().map(away).collect();
        sort_by(&mut by_box, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let (mut feet, mut least): (Vec<SolidClosestPoint>, f64) = (Vec::new(), f64::INFINITY);
        for (away, face) in by_box {
            if least + further < away {
                break;
            }
            let foot = self.faces[face].closest(point, tolerance)?;
            least = least.min(foot.distance);
            feet.push(SolidClosestPoint { face, foot });
        }
        feet.retain(|near| near.foot.distance <= least + further);
        sort_by(&mut feet, |a, b| {
            a.foot.distance.total_cmp(&b.foot.distance).then(a.face.cmp(&b.face))
        });
        Ok(feet)
    }

    /// Where a point is; the border is as wide as the tolerance on either side of the faces.
    ///
    /// The nearest face has the inside behind it. Of two that meet where the point is nearest the one counts that
    /// looks towards it most; where more meet, the solid angle under which the shells are seen tells, which is 4π from
    /// inside and 0 from outside.
    ///
    /// ```
    /// use virote_kernel::{Frame, NurbsCurve, Region, RegionSide, Solid, Tolerance, glam::DVec3};
    ///
    /// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
    /// let triangle = Region::new(&NurbsCurve::polyline(&[o, x, y, o])?, &[], Tolerance::DEFAULT)?;
    /// let prism = Solid::extruded(&triangle, DVec3::Z, Tolerance::DEFAULT)?;
    /// let side = |x: f64, z: f64| prism.side_of(DVec3::new(x, 0.2, z), Tolerance::DEFAULT);
    /// assert_eq!(side(0.2, 0.5)?, RegionSide::Inside);
    /// assert_eq!(side(0.9, 0.5)?, RegionSide::Outside);
    /// assert_eq!(side(0.2, 1.0)?, RegionSide::Border);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`SolidError::UnclearSide`]; those of [`Self::closest`].
    pub fn side_of(&self, point: DVec3, tolerance: Tolerance) -> Result<RegionSide, GeomError> {
        let around = box_around(&self.faces);
        let distance = tolerance.distance_for(around.diagonal());
        if distance < around.distance(point) {
            return Ok(RegionSide::Outside);
        }
        let feet = self.nearest_feet(0..self.faces.len(), point, distance, tolerance)?;
        if feet[0].foot.distance <= distance {
            return Ok(RegionSide::Border);
        }
        let side = |is_inside: bool| match is_inside {
            true => RegionSide::Inside,
            false => RegionSide::Outside,
        };
        if let Some(ahead) = self.most_ahead(point, &feet, distance) {
            return Ok(side(ahead < 0.0));
        }
        let mut turns = 0.0;
        for face in &self.faces {
            turns += face.solid_angle(point)? / (4.0 * PI);
        }
        if WHOLE_TURN_SLACK < (turns - turns.round()).abs() {
            let distance = feet[0].foot.distance;
            return Err(SolidError::UnclearSide { point, distance }.into());
        }
        Ok(side(turns.round() != 0.0))
    }

    /// Whether some of the faces, which close, have a point behind them, where the nearest of them tells.
    pub(super) fn is_behind(
        &self,
        faces: &[usize],
        point: DVec3,
        tolerance: Tolerance,
    ) -> Result<Option<bool>, GeomError> {
        let distance = tolerance.distance_for(box_around(&self.faces).diagonal());
        let feet = self.nearest_feet(faces.iter().copied(), point, distance, tolerance)?;
        Ok(self.most_ahead(point, &feet, distance).map(|ahead| ahead < 0.0))
    }

    /// The cosine between the way from a face to a point and its normal, for a face that it is straight above or
    /// below, else for that of two on which it is farthest from 0; none where more than two may meet.
    fn most_ahead(&self, point: DVec3, feet: &[SolidClosestPoint], distance: f64) -> Option<f64> {
        let ahead = |near: &SolidClosestPoint| {
            let [u, v] = near.foot.parameters;
            let normal = self.faces[near.face].surface().normal_at(u, v).ok()?;
            Some((point - near.foot.point).dot(normal) / near.foot.distance)
        };
        let all: Vec<Option<f64>> = feet.iter().map(ahead).collect();
        let straight = all.iter().flatten().find(|ahead| 1.0 - STRAIGHT_SLACK <= ahead.abs());
        if let Some(&straight) = straight {
            return Some(straight);
        }
        let meet_alone =
            feet.len() == 2 && !feet.iter().any(|near| self.is_on_seam(near, distance));
        match all[..] {
            [Some(a), Some(b)] if meet_alone => Some(if a.abs() < b.abs() { b } else { a }),
            _ => None,
        }
    }

    /// Whether a place is at the end of the parameters of a closed surface, which may have a corner there.
    fn is_on_seam(&self, near: &SolidClosestPoint, distance: f64) -> bool {
        let surface = self.faces[near.face].surface();
        let closed = [surface.is_closed_u(distance), surface.is_closed_v(distance)];
        let ends = Direction::BOTH.into_iter().zip(near.foot.parameters).zip(closed);
        ends.filter(|&(_, is_closed)| is_closed).any(|((along, t), _)| {
            let domain = surface.domain(along);
            let slack = PARAMETER_RELATIVE * domain.length();
            t - domain.start() <= slack || domain.end() - t <= slack
        })
    }
}
