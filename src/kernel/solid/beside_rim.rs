//! Planes that pass an edge within the tolerance where it runs along them.
//!
//! Such a plane and the one through the edge there are the same within the tolerance, but the first leaves slivers
//! between itself and the edge, of which no side can be told.

use glam::DVec3;

use super::{Solid, SolidError, box_around};
use crate::{
    FaceError, Frame, GeomError, Tolerance,
    ceiling::RIMS_BESIDE_PLANE,
    sorting::sort_by,
    tolerance::{EXACT_RELATIVE, THIN_CUT},
};

/// Where an edge runs along a plane, or ends.
#[derive(Clone, Copy, Debug)]
struct RimPlace {
    point: DVec3,
    /// Over the plane.
    height: f64,
}

impl Solid {
    /// What an operation makes of a plane; where it cannot tell, what it makes of the parallel plane through an edge
    /// that runs along it within the tolerance.
    ///
    /// # Errors
    /// Those of the operation; [`SolidError::ThinCut`] instead where an edge is hardly further than the tolerance.
    pub(super) fn at_plane_or_rim<T>(
        &self,
        plane: Frame,
        tolerance: Tolerance,
        operation: impl Fn(Frame) -> Result<T, GeomError>,
    ) -> Result<T, GeomError> {
        let error = match operation(plane) {
            Err(error) if is_of_slivers(&error) => error,
            found => return found,
        };
        let distance = tolerance.distance_for(box_around(&self.faces).diagonal());
        let places = self.rim_places(plane, THIN_CUT * distance, tolerance)?;
        let near = places.iter().filter(|place| place.height.abs() <= distance);
        for place in near.take(RIMS_BESIDE_PLANE) {
            let moved = plane.at(plane.origin() + plane.z() * place.height);
            match operation(moved) {
                Err(error) if is_of_slivers(&error) => {}
                found => return found,
            }
        }
        let rounding = EXACT_RELATIVE * box_around(&self.faces).magnitude();
        Err(match places.first() {
            // At an edge in the plane itself nothing is thin.
            Some(place) if rounding < place.height.abs() => {
                let (point, thickness) = (place.point, place.height.abs());
                SolidError::ThinCut { point, thickness, tolerance: distance }.into()
            }
            _ => error,
        })
    }

    /// The places where edges run along a plane or end, no further from it than some reach; the nearest first, one
    /// of each height.
    ///
    /// # Errors
    /// Those of [`crate::Face::edges`].
    fn rim_places(
        &self,
        plane: Frame,
        reach: f64,
        tolerance: Tolerance,
    ) -> Result<Vec<RimPlace>, GeomError> {
        let place =
            |point: DVec3| RimPlace { point, height: (point - plane.origin()).dot(plane.z()) };
        let mut places = Vec::new();
        for face in &self.faces {
            GeomError::go_on(1)?;
            for edge in face.edges(tolerance)? {
                let turns = edge.extrema(plane.z(), tolerance).into_iter();
                let turns = turns.map(|t| edge.point_at(t));
                places.extend([edge.start(), edge.end()].into_iter().chain(turns).map(place));
            }
        }
        places.retain(|place| place.height.abs() <= reach);
        sort_by(&mut places, |a, b| a.height.abs().total_cmp(&b.height.abs()));
        let rounding = EXACT_RELATIVE * box_around(&self.faces).magnitude();
        places.dedup_by(|next, known| (next.height - known.height).abs() <= rounding);
        Ok(places)
    }
}

/// Whether an error may come from parts that are thinner than the tolerance.
const fn is_of_slivers(error: &GeomError) -> bool {
    matches!(
        error,
        GeomError::Region(_)
            | GeomError::Face(
                FaceError::EndsInside { .. }
                    | FaceError::OpenShell { .. }
                    | FaceError::CrowdedShell { .. }
                    | FaceError::OneSided { .. }
                    | FaceError::Narrow { .. }
                    | FaceError::PartsMissArea { .. }
            )
            | GeomError::Solid(
                SolidError::OpenRim { .. }
                    | SolidError::UnevenRim { .. }
                    | SolidError::Thin { .. }
                    | SolidError::UncertainCut { .. }
                    | SolidError::UnmatchedEdge { .. }
            )
    )
}
