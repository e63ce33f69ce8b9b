//! Planes that pass an edge within the tolerance where it runs along them, or a place to which a face narrows.
//!
//! Such a plane and the one through the edge there are the same within the tolerance, but the first leaves slivers
//! between itself and the edge, of which no side can be told. Beside the tip of a cone, which is less than the tolerance
//! across there, nothing tells where the plane cuts it: the plane through the tip is taken at once, and so is that
//! through an edge which is within the tolerance from end to end. Where the solid itself is hardly thicker than the
//! tolerance, as a knife near its edge, that is told.

use std::sync::Arc;

use glam::DVec3;

use super::{Solid, SolidError, box_around, cut::heights};
use crate::{
    FaceError, Frame, GeomError, NurbsCurve, Surface, Tolerance,
    ceiling::RIMS_BESIDE_PLANE,
    sorting::sort_by,
    tolerance::{EXACT_RELATIVE, THIN_CUT, TIP_CUT},
};

/// Where along the curves of a cut the solid's thickness is looked at.
const SECTION_LOOKS: [f64; 3] = [0.23, 0.5, 0.77];

/// Where an edge runs along a plane, or ends, or a face narrows to a point.
#[derive(Clone, Copy, Debug)]
struct RimPlace {
    point: DVec3,
    /// Over the plane.
    height: f64,
    is_narrow: bool,
}

/// The plane through a place beside it.
fn moved(plane: Frame, place: &RimPlace) -> Frame {
    plane.at(plane.origin() + plane.z() * place.height)
}

impl Solid {
    /// What an operation makes of a plane, or of the parallel one through a place to which a face narrows, or an edge
    /// from end to end, within the tolerance; where it cannot tell, what it makes of the one through an edge that runs
    /// along it within the tolerance somewhere.
    ///
    /// # Errors
    /// Those of the operation; [`SolidError::ThinCut`] instead where an edge is hardly further than the tolerance,
    /// [`SolidError::ThinTip`] where such a place is, and [`SolidError::ThinSection`] where the solid is hardly thicker.
    pub(super) fn at_plane_or_rim<T>(
        &self,
        plane: Frame,
        tolerance: Tolerance,
        operation: impl Fn(Frame) -> Result<T, GeomError>,
    ) -> Result<T, GeomError> {
        match self.at_plane_or_beside(plane, tolerance, operation) {
            Err(error) if may_be_thin(&error) => {
                let thin = self.thin_section(plane, tolerance);
                Err(thin.map_or(error, Into::into))
            }
            found => found,
        }
    }

    fn at_plane_or_beside<T>(
        &self,
        plane: Frame,
        tolerance: Tolerance,
        operation: impl Fn(Frame) -> Result<T, GeomError>,
    ) -> Result<T, GeomError> {
        let distance = tolerance.distance_for(box_around(&self.faces).diagonal());
        let rounding = EXACT_RELATIVE * box_around(&self.faces).magnitude();
        let narrow = self.narrow_places(plane, [distance, TIP_CUT * distance])?;
        let mut one = self.rims_along(plane, distance, tolerance)?;
        one.extend(narrow.iter().filter(|place| place.height.abs() <= distance));
        let nearest = one.into_iter().min_by(|a, b| a.height.abs().total_cmp(&b.height.abs()));
        let plane = match nearest {
            Some(place) if rounding < place.height.abs() => moved(plane, &place),
            _ => plane,
        };
        let error = match operation(plane) {
            Err(error) if is_of_slivers(&error, !narrow.is_empty()) => error,
            found => return found,
        };
        let places = self.rim_places(plane, THIN_CUT * distance, tolerance)?;
        let near = places.iter().filter(|place| place.height.abs() <= distance);
        for place in near.take(RIMS_BESIDE_PLANE) {
            match operation(moved(plane, place)) {
                Err(error) if is_of_slivers(&error, !narrow.is_empty()) => {}
                found => return found,
            }
        }
        // At an edge in the plane itself nothing is thin.
        let mut nearest = [narrow.first(), places.first()].into_iter().flatten();
        let beside = nearest.find(|place| rounding < place.height.abs());
        Err(beside.map_or(error, |&RimPlace { point, height, is_narrow }| {
            let (thickness, tolerance) = (height.abs(), distance);
            match is_narrow {
                true => SolidError::ThinTip { point, thickness, tolerance }.into(),
                false => SolidError::ThinCut { point, thickness, tolerance }.into(),
            }
        }))
    }

    /// Where the curves in which a plane cuts the faces run beside one another, hardly further apart than the
    /// tolerance: as near the tip of a knife's edge. None where they do not, or are not known.
    fn thin_section(&self, plane: Frame, tolerance: Tolerance) -> Option<SolidError> {
        let around = box_around(&self.faces);
        let distance = tolerance.distance_for(around.diagonal());
        let (least, most) = (EXACT_RELATIVE * around.magnitude(), THIN_CUT * distance);
        let mut curves: Vec<NurbsCurve> = Vec::new();
        for face in &self.faces {
            GeomError::go_on(1).ok()?;
            let [lowest, highest] = heights(face.surface().bounds(), plane);
            if lowest <= 0.0 && 0.0 <= highest {
                let surface = Surface::Nurbs(Arc::clone(face.surface()));
                let cut = surface.section(plane, tolerance).ok()?.curves;
                curves.extend(face.clipped(&cut, tolerance).ok()?);
            }
        }
        curves.retain(|curve| most < curve.bounds().diagonal());
        let mut thinnest: Option<(f64, DVec3)> = None;
        for (i, curve) in curves.iter().enumerate() {
            GeomError::go_on(curves.len()).ok()?;
            for t in SECTION_LOOKS.map(|at| curve.domain().at(at)) {
                let point = curve.point_at(t);
                let others = curves
                    .iter()
                    .enumerate()
                    .filter(|&(k, other)| k != i && other.bounds().distance(point) <= most);
                for (_, other) in others {
                    let gap = other.closest(point, distance).distance;
                    let is_thinner = thinnest.is_none_or(|(known, _)| gap < known);
                    if least < gap && gap <= most && is_thinner {
                        thinnest = Some((gap, point));
                    }
                }
            }
        }
        thinnest.map(|(thickness, point)| SolidError::ThinSection {
            point,
            thickness,
            tolerance: distance,
        })
    }

    /// A place of each edge that is within a distance of a plane from end to end.
    ///
    /// # Errors
    /// Those of [`crate::Face::edges`].
    fn rims_along(
        &self,
        plane: Frame,
        distance: f64,
        tolerance: Tolerance,
    ) -> Result<Vec<RimPlace>, GeomError> {
        let mut places = Vec::new();
        for face in &self.faces {
            GeomError::go_on(1)?;
            let [lowest, highest] = heights(face.surface().bounds(), plane);
            if distance < lowest || highest < -distance {
                continue;
            }
            for edge in face.edges(tolerance)? {
                let [lowest, highest] = heights(edge.bounds(), plane);
                if distance < lowest || highest < -distance {
                    continue;
                }
                let above = edge.points().into_iter().map(|p| (p - plane.origin()).dot(plane.z()));
                let [low, high] = above
                    .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], height| {
                        [height.min(a), height.max(b)]
                    });
                let is_along = -distance <= low && high <= distance;
                if is_along && THIN_CUT * distance < edge.bounds().diagonal() {
                    let (point, height) = (edge.start(), 0.5 * (low + high));
                    places.push(RimPlace { point, height, is_narrow: false });
                }
            }
        }
        Ok(places)
    }

    /// The places to which faces narrow no further from a plane than some reach, the nearest first.
    ///
    /// # Errors
    /// Those of a search that was ended.
    fn narrow_places(
        &self,
        plane: Frame,
        [distance, reach]: [f64; 2],
    ) -> Result<Vec<RimPlace>, GeomError> {
        let mut places = Vec::new();
        for face in &self.faces {
            GeomError::go_on(1)?;
            let [lowest, highest] = heights(face.surface().bounds(), plane);
            if reach < lowest || highest < -reach {
                continue;
            }
            places.extend(face.narrow_places(distance).into_iter().map(|point| {
                let height = (point - plane.origin()).dot(plane.z());
                RimPlace { point, height, is_narrow: true }
            }));
        }
        places.retain(|place| place.height.abs() <= reach);
        sort_by(&mut places, |a, b| a.height.abs().total_cmp(&b.height.abs()));
        Ok(places)
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
        let place = |point: DVec3| {
            let height = (point - plane.origin()).dot(plane.z());
            RimPlace { point, height, is_narrow: false }
        };
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

/// Whether an error may come from a solid that is hardly thicker than the tolerance where it is cut.
const fn may_be_thin(error: &GeomError) -> bool {
    is_of_slivers(error, false)
        || matches!(
            error,
            GeomError::Face(FaceError::AcrossPlane { .. } | FaceError::NearEdges { .. })
        )
}

/// Whether an error may come from parts that are thinner than the tolerance.
const fn is_of_slivers(error: &GeomError, is_beside_narrow: bool) -> bool {
    if is_beside_narrow
        && matches!(error, GeomError::Intersection(_) | GeomError::Face(_) | GeomError::Fit(_))
    {
        return true;
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Region;

    #[test]
    fn rims_of_a_block_are_told_by_height_the_nearest_first() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
        let corners = corners.map(|[x, y]| DVec3::new(x, y, 0.0));
        let border = NurbsCurve::polyline(&corners).expect("a rectangle");
        let region = Region::new(&border, &[], Tolerance::DEFAULT).expect("a region");
        let block = Solid::extruded(&region, DVec3::Z, Tolerance::DEFAULT).expect("a block");
        let heights = |at: f64, reach: f64| -> Vec<f64> {
            let plane = Frame::XY.at(DVec3::new(7.0, -3.0, at));
            let places = block.rim_places(plane, reach, Tolerance::DEFAULT).expect("edges");
            places.iter().map(|place| place.height).collect()
        };
        let check = |found: Vec<f64>, expected: &[f64]| {
            assert_eq!(found.len(), expected.len(), "{found:?}");
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
        };
        check(heights(0.3, 1.0), &[-0.3, 0.7]);
        check(heights(0.8, 1.0), &[0.2, -0.8]);
        check(heights(0.3, 0.5), &[-0.3]);
        check(heights(0.5, 0.4), &[]);
    }
}
