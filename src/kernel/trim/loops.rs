//! Faces within loops of curves of parameters.

use std::sync::Arc;

use glam::DVec3;

use super::{Face, FaceError, division::Division};
use crate::{
    GeomError, NurbsCurve, NurbsSurface, PictureError, Region, RegionError, Tolerance,
    region::smooth_arcs, tolerance::EXACT_RELATIVE,
};

impl Face {
    /// The part of a surface to the left of closed curves of parameters, which lie in the plane z = 0
    /// of u and v.
    ///
    /// # Errors
    /// [`FaceError::OffDomain`] of a curve that leaves the domain, [`FaceError::Open`] of one that does
    /// not close, [`FaceError::BothSides`] where loops contradict one another or run back along
    /// themselves, [`FaceError::Apart`] where they bound several parts, [`FaceError::Nothing`];
    /// [`RegionError::TooSmall`] of one that is one place within the tolerance, other `GeomError::Region` where loops come
    /// too near one another.
    pub fn within(
        surface: Arc<NurbsSurface>,
        loops: &[NurbsCurve],
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let whole = Self::whole(surface, tolerance)?;
        let distance = tolerance.distance_for(whole.plane.surface.bounds().diagonal());
        let mut arcs = Vec::new();
        for (index, curve) in loops.iter().enumerate() {
            let curve = whole.plane.to_plane(curve);
            let ends = [curve.start(), curve.end()].map(|place| whole.plane.point(place));
            let gap = ends[0].distance(ends[1]);
            if distance < gap {
                return Err(FaceError::Open { index, gap }.into());
            }
            check_larger(&curve, distance).map_err(whole.in_space())?;
            whole.check_within_domain(&curve, index, distance)?;
            arcs.extend(smooth_arcs(&curve, tolerance.angle)?);
        }
        whole.to_the_left(&arcs, distance)
    }

    /// The part of the face to the left of arcs in the plane of parameters.
    ///
    /// # Errors
    /// Those of [`Self::within`].
    pub(super) fn to_the_left(
        &self,
        arcs: &[NurbsCurve],
        tolerance: f64,
    ) -> Result<Self, GeomError> {
        let division = Division::of(self, arcs, tolerance, 1).map_err(self.in_space())?;
        if let Some(&(_, end)) = division.loose.first() {
            return Err(FaceError::EndsInside { point: self.plane.point(end) }.into());
        }
        let parts = division
            .left_of_arcs()
            .map_err(|place| FaceError::BothSides { point: self.plane.point(place) })?;
        let n_parts = parts.len();
        match <[_; 1]>::try_from(parts) {
            Ok([parts]) => Ok(Self { parts, ..self.clone() }),
            Err(_) if n_parts == 0 => Err(FaceError::Nothing.into()),
            Err(parts) => {
                let points =
                    parts.iter().map(|part| self.told_place(self.plane.point(place_of(part))));
                Err(FaceError::Apart { n_parts, points: points.take(2).collect() }.into())
            }
        }
    }

    /// # Errors
    /// [`FaceError::OffDomain`].
    pub(super) fn check_within_domain(
        &self,
        curve: &NurbsCurve,
        index: usize,
        tolerance: f64,
    ) -> Result<(), GeomError> {
        let domain = self.plane.bounds();
        let reach = curve.bounds();
        let beyond = (domain.min - reach.min).max(reach.max - domain.max).truncate().max_element();
        if beyond <= tolerance {
            return Ok(());
        }
        let [u, v] = [0, 1].map(|i| [reach.min[i], reach.max[i]].map(|x| x / self.plane.scales[i]));
        Err(FaceError::OffDomain { index, u, v, domains: self.plane.domains() }.into())
    }

    /// A point on the border of its parameters.
    pub(crate) fn border_place(&self) -> DVec3 {
        self.plane.point(place_of(&self.parts))
    }

    /// A place as it is told: what of it is rounding of the surface's coordinates is zero.
    pub(super) fn told_place(&self, point: DVec3) -> DVec3 {
        let rounding = EXACT_RELATIVE * self.plane.surface.bounds().magnitude();
        DVec3::from(point.to_array().map(|x| if x.abs() <= rounding { 0.0 } else { x }))
    }

    /// Places of what was found in the plane of parameters, in space.
    pub(super) fn in_space(&self) -> impl Fn(GeomError) -> GeomError + '_ {
        |error| match error {
            GeomError::Region(RegionError::Unclear { point }) => {
                RegionError::Unclear { point: self.plane.point(point) }.into()
            }
            GeomError::Picture(PictureError::Crossing { point, .. }) => {
                FaceError::TouchesItself { point: self.plane.point(point) }.into()
            }
            GeomError::Region(RegionError::TooSmall { point, tolerance }) => {
                RegionError::TooSmall { point: self.plane.point(point), tolerance }.into()
            }
            GeomError::Region(RegionError::Thin { point, width, tolerance }) => {
                RegionError::Thin { point: self.plane.point(point), width, tolerance }.into()
            }
            other => other,
        }
    }
}

/// Fails of a loop that is one place within the tolerance, so that it bounds nothing.
pub(super) fn check_larger(border: &NurbsCurve, tolerance: f64) -> Result<(), GeomError> {
    let bounds = border.bounds();
    match bounds.diagonal() <= tolerance {
        true => Err(RegionError::TooSmall { point: border.start(), tolerance }.into()),
        false => Ok(()),
    }
}

/// A place of a part: one on its border.
pub(super) fn place_of(part: &[Region]) -> DVec3 {
    let mut arcs = part.iter().flat_map(Region::arcs).flatten();
    arcs.next().map_or(DVec3::ZERO, |arc| arc.point_at(arc.domain().at(0.5)))
}
