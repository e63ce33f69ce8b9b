//! Why a cutter divides nothing of a face: whether it only touches it, in points or along lines.
//!
//! Along such a line the cutter is on one side of the face, both to the left and to the right of it, as far aside as both
//! part by the tolerance. This is looked at only where a cutter was found to divide nothing.

use std::sync::Arc;

use glam::DVec3;

use super::{Cutter, Face, FaceError, pull::MOST_BESIDE};
use crate::{
    Bounds, GeomError, LevelSet, NurbsCurve, NurbsSurface, Side, Surface, Tolerance, frame::unit,
    tolerance::VERTEX_REACH,
};

/// Where along a line it is looked at whether both sides of it are on one side of a cutter.
const LOOKS: [f64; 3] = [0.23, 0.5, 0.77];

/// What a face and a cutter have in common where they do not cross.
#[derive(Default)]
struct Touches {
    lines: Vec<NurbsCurve>,
    points: Vec<DVec3>,
}

/// A cutter that divides nothing.
pub(super) struct Undivided {
    pub(super) index: usize,
    /// Where its curves end inside of the face; none where nothing of them is there.
    pub(super) ends: Vec<DVec3>,
}

impl Touches {
    /// The line that goes through a point.
    fn line_at(&self, point: DVec3, distance: f64) -> Option<&NurbsCurve> {
        let reach = MOST_BESIDE * distance;
        self.lines.iter().find(|line| {
            line.bounds().distance(point) <= reach && line.foot_within(point, reach).is_some()
        })
    }
}

impl Face {
    /// What a cutter that divides nothing of it is told as: [`FaceError::TouchesAlong`] or [`FaceError::TouchesAt`]
    /// where it touches it alone, [`FaceError::TooSmall`], [`FaceError::EndsInside`], [`FaceError::Covered`], or
    /// [`FaceError::Misses`].
    ///
    /// # Errors
    /// Those of [`Surface::intersections`] and [`Self::clipped`].
    pub(super) fn told_undivided(
        &self,
        cutter: &Cutter,
        Undivided { index, ends }: Undivided,
        tolerance: Tolerance,
    ) -> Result<FaceError, GeomError> {
        if ends.is_empty() && self.is_covered_by(cutter, tolerance) {
            return Ok(FaceError::Covered { index });
        }
        if let Some((size, point)) = self.small_cutter(cutter, tolerance) {
            let tolerance = self.distance(tolerance);
            return Ok(FaceError::TooSmall { index, size, tolerance, point });
        }
        let touches = self.touches(cutter, tolerance)?;
        let shown = |point: DVec3| self.told_place(point);
        let along = |line: &NurbsCurve| FaceError::TouchesAlong {
            index,
            ends: [line.start(), line.end()].map(shown),
            length: line.length(line.domain()),
        };
        let distance = self.distance(tolerance);
        let is_crossing = |end: &&DVec3| touches.line_at(**end, distance).is_none();
        let crossing: Vec<DVec3> = ends.iter().filter(is_crossing).copied().collect();
        for &point in &crossing {
            if !self.is_on_border(self.plane.surface.closest(point).parameters, tolerance)? {
                return Ok(FaceError::EndsInside { point });
            }
        }
        if let Some(&point) = crossing.first() {
            // What it cuts off beside the border is thinner than the tolerance.
            return Ok(FaceError::TouchesAt { index, point: shown(point), n_points: 1 });
        }
        let ended = ends.first().and_then(|&end| touches.line_at(end, distance));
        Ok(match (ended.or(touches.lines.first()), touches.points.first()) {
            (Some(line), _) => along(line),
            (None, Some(&point)) => {
                FaceError::TouchesAt { index, point: shown(point), n_points: touches.points.len() }
            }
            (None, None) => FaceError::Misses { index },
        })
    }

    /// How large a cutter is that lies within reach of one vertex, and a place of the face there.
    fn small_cutter(&self, cutter: &Cutter, tolerance: Tolerance) -> Option<(f64, DVec3)> {
        let bounds = match cutter {
            Cutter::Curve(_) | Cutter::Plane(_) => return None,
            Cutter::Surface(surface) => surface.bounds(),
            Cutter::Face(face) => face.surface().bounds(),
            Cutter::Faces(faces) => {
                faces.iter().map(|face| face.surface().bounds()).reduce(Bounds::union)?
            }
        };
        let size = bounds.diagonal();
        let foot = self.plane.surface.closest(bounds.center());
        let is_small = size <= 2.0 * VERTEX_REACH * self.distance(tolerance);
        let is_there = foot.distance <= size && self.has(foot.parameters, tolerance);
        (is_small && is_there).then_some((size, foot.point))
    }

    /// The line through a point along which a plane touches it; none where it does not touch it there along one.
    ///
    /// # Errors
    /// Those of [`Surface::section`] and [`Self::clipped`].
    pub(crate) fn line_touched_at(
        &self,
        plane: crate::Frame,
        point: DVec3,
        tolerance: Tolerance,
    ) -> Result<Option<NurbsCurve>, GeomError> {
        let touches = self.touches(&Cutter::Plane(plane), tolerance)?;
        Ok(touches.line_at(point, self.distance(tolerance)).cloned())
    }

    fn touches(&self, cutter: &Cutter, tolerance: Tolerance) -> Result<Touches, GeomError> {
        match cutter {
            Cutter::Curve(_) => Ok(Touches::default()),
            Cutter::Plane(plane) => {
                let found = self.whole_surface().section(*plane, tolerance)?;
                let height = |point: DVec3| (point - plane.origin()).dot(plane.z());
                self.touches_among(found, &height, tolerance)
            }
            Cutter::Surface(other) => self.touches_with(other, None, tolerance),
            Cutter::Face(face) => self.touches_with(face.surface(), Some(face), tolerance),
            Cutter::Faces(faces) => {
                let mut all = Touches::default();
                for face in faces.iter() {
                    let Touches { lines, points } =
                        self.touches_with(face.surface(), Some(face), tolerance)?;
                    all.lines.extend(lines);
                    all.points.extend(points);
                }
                Ok(all)
            }
        }
    }

    /// What it has in common with a surface, or a face on it, without crossing it.
    fn touches_with(
        &self,
        other: &Arc<NurbsSurface>,
        face: Option<&Self>,
        tolerance: Tolerance,
    ) -> Result<Touches, GeomError> {
        if self.lies_along(other, tolerance) {
            return Ok(Touches::default());
        }
        let surface = Surface::Nurbs(Arc::clone(other));
        let mut found = self.whole_surface().intersections(&surface, tolerance)?;
        if let Some(face) = face {
            found.curves = face.clipped(&found.curves, tolerance)?;
            let is_on = |point: &DVec3| face.has(other.closest(*point).parameters, tolerance);
            found.touches.retain(is_on);
            found.contacts.retain(is_on);
        }
        let height = |point: DVec3| {
            let foot = other.closest(point);
            let [u, v] = foot.parameters;
            let normal = other.normal_at(u, v);
            normal.map_or(f64::NAN, |normal| (point - foot.point).dot(normal))
        };
        self.touches_among(found, &height, tolerance)
    }

    /// Of what its surface has in common with a cutter over which heights are known, what is on the face and is no
    /// crossing.
    fn touches_among(
        &self,
        LevelSet { curves, touches, contacts, .. }: LevelSet,
        height: &dyn Fn(DVec3) -> f64,
        tolerance: Tolerance,
    ) -> Result<Touches, GeomError> {
        let distance = self.distance(tolerance);
        // About a tip a curve may be one place.
        let has_length = |curve: &NurbsCurve| distance < curve.bounds().diagonal();
        let (curves, places): (Vec<_>, Vec<_>) = curves.into_iter().partition(has_length);
        let mut found = Touches { lines: self.clipped(&curves, tolerance)?, points: touches };
        found.points.extend(places.iter().map(NurbsCurve::start));
        // A contact on no line is the edge of a cutter that hovers there.
        let is_hovering = |&contact: &DVec3| found.line_at(contact, distance).is_none();
        let hovering: Vec<DVec3> = contacts.into_iter().filter(is_hovering).collect();
        found.points.extend(hovering);
        found
            .points
            .retain(|&point| self.has(self.plane.surface.closest(point).parameters, tolerance));
        found.lines.retain(|line| self.is_touched_along(line, height, distance));
        Ok(found)
    }

    /// Whether what has a height of zero along a line is on one side of it beside the line.
    fn is_touched_along(
        &self,
        line: &NurbsCurve,
        height: &dyn Fn(DVec3) -> f64,
        distance: f64,
    ) -> bool {
        let surface = &self.plane.surface;
        let widest = surface.bounds().diagonal();
        let is_one_side = |share: f64| {
            let t = line.domain().at(share);
            let point = line.point_at(t);
            let [u, v] = surface.closest(point).parameters;
            let (Ok(normal), Ok(tangent)) =
                (surface.normal_at(u, v), line.tangent_at(t, Side::Right))
            else {
                return false;
            };
            let Some(aside) = unit(normal.cross(tangent)) else { return false };
            let is_above = |way: DVec3| {
                let steps = std::iter::successors(Some(distance), |step| Some(2.0 * step));
                let mut heights = steps
                    .take_while(|&step| step <= widest)
                    .map(|step| height(surface.closest(point + way * step).point));
                heights.find(|height| distance < height.abs()).map(|height| 0.0 < height)
            };
            let sides = [is_above(aside), is_above(-aside)];
            matches!(sides, [Some(left), Some(right)] if left == right)
        };
        LOOKS.into_iter().all(is_one_side)
    }

    fn whole_surface(&self) -> Surface {
        Surface::Nurbs(Arc::clone(&self.plane.surface))
    }
}
