//! Faces divided by curves on them, planes and surfaces.

use std::sync::Arc;

use glam::DVec3;

use super::{
    Face, FaceError,
    division::{ArcCourse, Division},
    loops::check_larger,
    pull::{ArcParameters, MOST_BESIDE, arcs_on_surface},
    touch::Undivided,
};
use crate::{Frame, GeomError, NurbsCurve, NurbsSurface, RegionSide, Tolerance};

/// What divides a face.
///
/// ```
/// use std::{cell::Cell, sync::Arc};
/// use virote_kernel::{Cutter, Face, Frame, NurbsSurface, Tolerance, glam::DVec3};
///
/// let sphere = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 1.0)?), Tolerance::DEFAULT)?;
/// let plane = Cutter::Plane(Frame::XY.at(DVec3::Z * 0.5));
/// let parts = sphere.split(&[plane], Tolerance::DEFAULT)?;
/// let areas: Vec<f64> = parts.iter().map(|part| part.mass().map_or(0.0, |mass| mass.amount)).collect();
/// assert!(areas.iter().any(|area| (area - std::f64::consts::PI).abs() < 1e-10));
/// assert!(areas.iter().any(|area| (area - 3.0 * std::f64::consts::PI).abs() < 1e-10));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub enum Cutter {
    /// A curve on the face, within the tolerance.
    Curve(NurbsCurve),
    /// A plane.
    Plane(Frame),
    /// A surface.
    Surface(Arc<NurbsSurface>),
    /// A part of a surface.
    Face(Arc<Face>),
    /// Faces that meet in edges, as those of a solid do: where they cut together counts.
    Faces(Arc<[Face]>),
}

/// What a plane makes of a face.
pub(crate) struct PartsBesidePlane {
    /// Its parts, each with the farthest height over the plane.
    pub(crate) parts: Vec<(Face, f64)>,
    /// Places that the plane has in common with the surface, one of each curve among them.
    pub(crate) contacts: Vec<DVec3>,
}

impl Face {
    /// The part of a surface to the left of closed curves on it, which may run over seams.
    ///
    /// # Errors
    /// [`FaceError::OffSurface`] beyond the tolerance, and those of [`Self::within`].
    pub fn bounded(
        surface: Arc<NurbsSurface>,
        loops: &[NurbsCurve],
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let whole = Self::whole(surface, tolerance)?;
        let distance = whole.distance(tolerance);
        let mut arcs = Vec::new();
        for (index, curve) in loops.iter().enumerate() {
            let gap = curve.start().distance(curve.end());
            if distance < gap {
                return Err(FaceError::Open { index, gap }.into());
            }
            check_larger(curve, distance)?;
            let limits = [distance, tolerance.angle];
            let (named, parameters) = (("loop", index), ArcParameters::Any);
            arcs.extend(arcs_on_surface(&whole.plane, curve, None, named, limits, parameters)?);
        }
        whole.to_the_left(&arcs, distance)
    }

    /// All parts into which cutters divide the face, in an order that depends on the face alone.
    ///
    /// A cutter on the plane, cylinder, cone, sphere or torus of the face, or on its own surface, divides what it lies
    /// on from what it does not. A line along which one only touches the face divides it as any other where it goes from
    /// border to border or around.
    ///
    /// # Errors
    /// [`FaceError::Misses`] of a cutter that does not meet the face, [`FaceError::TouchesAt`] and
    /// [`FaceError::TouchesAlong`] of one that only touches it and [`FaceError::EndsInside`] of another
    /// that divides nothing, [`FaceError::Covered`] of one that lies on all of it, [`FaceError::RunsAlong`] of a plane
    /// in which it lies, [`FaceError::RunsTogether`] of a surface that shares an area with its own and is another,
    /// [`FaceError::OffSurface`] of a curve beside it; those of `Surface::intersections`.
    pub fn split(&self, cutters: &[Cutter], tolerance: Tolerance) -> Result<Vec<Self>, GeomError> {
        let division = self.divided(cutters, tolerance)?;
        let parts = self.with_parts(&division);
        for (index, cutter) in cutters.iter().enumerate() {
            let Cutter::Plane(plane) = cutter else { continue };
            for part in &parts {
                let height = part.beside(*plane, tolerance)?;
                // What is cut off may be as thin.
                if parts.len() == 1 && height.abs() <= self.distance(tolerance) {
                    return Err(part.along_plane(*plane, index, tolerance).into());
                }
            }
        }
        Ok(parts)
    }

    /// What a face that lies in a plane tells of it.
    fn along_plane(&self, plane: Frame, index: usize, tolerance: Tolerance) -> FaceError {
        let places = self.some_places(tolerance);
        let point = places.first().copied().unwrap_or(plane.origin());
        FaceError::RunsAlong { index, point }
    }

    fn with_parts(&self, division: &Division) -> Vec<Self> {
        let parts = division.all().into_iter();
        parts.map(|parts| Self { parts, ..self.clone() }).collect()
    }

    /// The part beside a point, of those into which cutters divide the face.
    ///
    /// # Errors
    /// [`FaceError::NoPartAt`] for a point away from the face, [`FaceError::OnCut`] for one on a cut;
    /// those of [`Self::split`].
    pub fn part_at(
        &self,
        cutters: &[Cutter],
        point: DVec3,
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let distance = self.distance(tolerance);
        let foot = self.plane.surface.closest(point);
        if distance < foot.distance {
            return Err(FaceError::NoPartAt { point, distance: foot.distance }.into());
        }
        let parts = self.split(cutters, tolerance)?;
        let side = |part: &Self| part.side_of_parameters(foot.parameters, distance);
        if let Some(part) = parts.iter().find(|part| side(part) == RegionSide::Inside) {
            return Ok(part.clone());
        }
        let beside: Vec<&Self> =
            parts.iter().filter(|part| side(part) == RegionSide::Border).collect();
        match beside[..] {
            [] => Err(FaceError::NoPartAt { point, distance: foot.distance }.into()),
            // On the face's own border, or at a pole.
            [part] => Ok(part.clone()),
            _ => Err(FaceError::OnCut { point }.into()),
        }
    }

    /// The parts on the side of a plane to which its normal points, or on the other one; none where nothing is there.
    /// A plane that only touches it leaves it as it is.
    ///
    /// # Errors
    /// Those of [`Self::split`] but for a plane that misses the face; [`FaceError::RunsAlong`] of one in which it lies.
    pub fn beside_plane(
        &self,
        plane: Frame,
        is_above: bool,
        tolerance: Tolerance,
    ) -> Result<Vec<Self>, GeomError> {
        let parts = self.divided_by_plane(plane, tolerance)?.parts;
        if let [(part, height)] = &parts[..]
            && height.abs() <= self.distance(tolerance)
        {
            return Err(part.along_plane(plane, 0, tolerance).into());
        }
        let (above, below): (Vec<_>, Vec<_>) =
            parts.into_iter().partition(|&(_, height)| 0.0 < height);
        let (kept, others) = if is_above { (above, below) } else { (below, above) };
        Ok(match others.is_empty() {
            true => vec![self.clone()],
            false => kept.into_iter().map(|(part, _)| part).collect(),
        })
    }

    /// The parts into which a plane divides it, or all of it.
    ///
    /// # Errors
    /// Those of [`Self::beside_plane`].
    pub(crate) fn divided_by_plane(
        &self,
        plane: Frame,
        tolerance: Tolerance,
    ) -> Result<PartsBesidePlane, GeomError> {
        let (arcs, contacts) = self.plane_arcs(plane, 0, tolerance)?;
        let divided = match arcs.is_empty() {
            true => None,
            false => match self.divided_along(&arcs, &vec![0; arcs.len()], 1, tolerance)? {
                Ok(division) => Some(division),
                Err(undivided) => {
                    self.check_undivided(plane, undivided, tolerance)?;
                    None
                }
            },
        };
        let parts = match divided {
            None => vec![self.clone()],
            Some(division) => self.with_parts(&division),
        };
        let with_height = |part: Self| {
            let height = part.beside(plane, tolerance)?;
            Ok((part, height))
        };
        let parts = parts.into_iter().map(with_height).collect::<Result<_, GeomError>>()?;
        Ok(PartsBesidePlane { parts, contacts })
    }

    /// Fails where a plane that divides nothing ends inside, unless it touches the border or the face there.
    fn check_undivided(
        &self,
        plane: Frame,
        undivided: Undivided,
        tolerance: Tolerance,
    ) -> Result<(), GeomError> {
        let Some(&point) = undivided.ends.first() else { return Ok(()) };
        if self.is_on_border(self.plane.surface.closest(point).parameters, tolerance)? {
            return Ok(());
        }
        match self.told_undivided(&Cutter::Plane(plane), undivided, tolerance)? {
            FaceError::TouchesAlong { .. } => Ok(()),
            other => Err(other.into()),
        }
    }

    /// Some places of it, of its border among them.
    pub(crate) fn some_places(&self, tolerance: Tolerance) -> Vec<DVec3> {
        let places = self.parts.iter().flat_map(|part| part.some_places(tolerance));
        places.map(|place| self.plane.point(place)).collect()
    }

    /// The farthest height over a plane of some places of a face that is on one side of it.
    pub(crate) fn height_above(&self, plane: Frame, tolerance: Tolerance) -> f64 {
        let [lowest, highest] = self.heights_above(plane, tolerance).map(|(height, _)| height);
        if highest < -lowest { lowest } else { highest }
    }

    /// The same of a part that the plane should have cut off.
    ///
    /// # Errors
    /// [`FaceError::AcrossPlane`].
    fn beside(&self, plane: Frame, tolerance: Tolerance) -> Result<f64, GeomError> {
        let [(lowest, below), (highest, above)] = self.heights_above(plane, tolerance);
        if MOST_BESIDE * self.distance(tolerance) < highest.min(-lowest) {
            let heights = [lowest, highest];
            let point = below + (above - below) * (lowest / (lowest - highest));
            return Err(FaceError::AcrossPlane { heights, point }.into());
        }
        Ok(if highest < -lowest { lowest } else { highest })
    }

    /// The lowest and the highest of some of its places over a plane, each with its height, or a place in the plane.
    fn heights_above(&self, plane: Frame, tolerance: Tolerance) -> [(f64, DVec3); 2] {
        let mut ends = [(0.0, plane.origin()); 2];
        for point in self.some_places(tolerance) {
            let height = (point - plane.origin()).dot(plane.z());
            if height < ends[0].0 {
                ends[0] = (height, point);
            }
            if ends[1].0 < height {
                ends[1] = (height, point);
            }
        }
        ends
    }

    pub(super) fn distance(&self, tolerance: Tolerance) -> f64 {
        tolerance.distance_for(self.plane.surface.bounds().diagonal())
    }

    fn divided(&self, cutters: &[Cutter], tolerance: Tolerance) -> Result<Division, GeomError> {
        let (mut arcs, mut cutter_of) = (Vec::new(), Vec::new());
        for (index, cutter) in cutters.iter().enumerate() {
            let found = self.arcs_of(cutter, index, tolerance)?;
            if found.is_empty() {
                let undivided = Undivided { index, ends: Vec::new() };
                return Err(self.told_undivided(cutter, undivided, tolerance)?.into());
            }
            cutter_of.resize(cutter_of.len() + found.len(), index);
            arcs.extend(found);
        }
        let division = match self.divided_along(&arcs, &cutter_of, cutters.len(), tolerance)? {
            Ok(division) => division,
            Err(undivided) => {
                let cutter = &cutters[undivided.index];
                return Err(self.told_undivided(cutter, undivided, tolerance)?.into());
            }
        };
        if division.n_parts() == 1 {
            // What lies on all of it may run along its border.
            let covers = |cutter: &Cutter| self.is_covered_by(cutter, tolerance);
            if let Some(index) = cutters.iter().position(covers) {
                return Err(FaceError::Covered { index }.into());
            }
        }
        Ok(division)
    }

    /// What arcs of several cutters, each with the number of its own, make of it; the first cutter that divides nothing
    /// where there is one.
    fn divided_along(
        &self,
        arcs: &[NurbsCurve],
        cutter_of: &[usize],
        n_cutters: usize,
        tolerance: Tolerance,
    ) -> Result<Result<Division, Undivided>, GeomError> {
        let distance = self.distance(tolerance);
        let division = Division::of(self, arcs, distance, 1).map_err(self.in_space())?;
        let mut courses = vec![ArcCourse::default(); n_cutters];
        for (course, &index) in division.arc_courses(arcs.len()).iter().zip(cutter_of) {
            courses[index].is_along |= course.is_along;
            courses[index].is_between |= course.is_between;
        }
        for (index, course) in courses.into_iter().enumerate() {
            if course.is_between {
                continue;
            }
            let is_its = |arc: usize| cutter_of[arc] == index;
            // What runs over the rest of the surface alone does not meet the face.
            let is_within = |place: DVec3| {
                let parameters = self.plane.parameters(place);
                self.side_of_parameters(parameters, distance) != RegionSide::Outside
            };
            let ends = division.loose.iter().filter(|&&(arc, end)| is_its(arc) && is_within(end));
            let ends: Vec<DVec3> = ends.map(|&(_, end)| self.plane.point(end)).collect();
            // What runs around a ring opens it, but leaves it one part.
            if !ends.is_empty() || !course.is_along {
                return Ok(Err(Undivided { index, ends }));
            }
        }
        Ok(Ok(division))
    }
}
