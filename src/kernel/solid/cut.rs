//! Solids cut by planes.

use glam::DVec3;

use super::{
    Solid, SolidError, areas_and_fluxes, box_around,
    caps::{PlaneCaps, plane_caps},
};
use crate::{
    Bounds, Face, Frame, GeomError, Region, RegionSide, Tolerance,
    surface::MassIntegral,
    tolerance::THIN_CUT,
    trim::{AreaAndFlux, amid},
};

/// The faces of a solid beside a plane.
struct FacesBeside {
    /// Below it, and above it, where its normal points.
    sides: [Vec<Face>; 2],
    /// Whether some lie in it.
    has_face_within: bool,
    /// Places that it has in common with surfaces of faces.
    contacts: Vec<DVec3>,
}

impl Solid {
    /// The part above a plane, where its normal points, or below it; none where there is nothing.
    ///
    /// Its faces are the parts of the solid's faces there, and plane faces within the rims that the plane leaves.
    /// Each side is judged by itself: that these close it shows in its volume, which must be what the flux through
    /// the solid's faces there tells, to which the plane adds nothing. Where that fails and an edge runs along the
    /// plane within the tolerance, the cut is that of the plane through it.
    ///
    /// ```
    /// use std::{f64::consts::PI, sync::Arc};
    /// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance, glam::DVec3};
    ///
    /// let ball = Arc::new(NurbsSurface::sphere(Frame::XY, 2.0)?);
    /// let ball = Solid::new(&[Face::whole(ball, Tolerance::DEFAULT)?], Tolerance::DEFAULT)?;
    /// let cap = ball.cut(Frame::XY.at(DVec3::Z), true, Tolerance::DEFAULT)?;
    /// let cap = cap.expect("the ball reaches above the plane");
    /// assert!((cap.volume_mass()?.amount - 5.0 / 3.0 * PI).abs() < 1e-6);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`SolidError::UncertainCut`] where the volume is another; [`SolidError::ThinCut`] where an edge is hardly
    /// further from the plane than the tolerance, [`SolidError::ThinTip`] where a place is to which a face narrows,
    /// [`SolidError::ThinSection`] where the solid is hardly thicker than that;
    /// those of [`Face::split`] but for a plane that misses, and of [`Self::capped`].
    pub fn cut(
        &self,
        plane: Frame,
        is_above: bool,
        tolerance: Tolerance,
    ) -> Result<Option<Self>, GeomError> {
        self.at_plane_or_rim(plane, tolerance, |plane| self.side(plane, is_above, tolerance))
    }

    /// # Errors
    /// Those of [`Self::cut`].
    fn side(
        &self,
        plane: Frame,
        is_above: bool,
        tolerance: Tolerance,
    ) -> Result<Option<Self>, GeomError> {
        let FacesBeside { sides: [below, above], contacts, .. } =
            self.faces_beside(plane, tolerance)?;
        let (faces, others) = if is_above { (above, below) } else { (below, above) };
        if faces.is_empty() {
            return Ok(None);
        }
        if others.is_empty() {
            return Ok(Some(self.clone()));
        }
        let distance = tolerance.distance_for(box_around(&self.faces).diagonal());
        let within = tolerance.with_distance(distance);
        let caps = plane_caps(&faces, tolerance)?;
        if let Some(point) = touching(&faces, &caps, contacts, plane, within)? {
            return Err(match line_along(&faces, point, plane, within)? {
                Some(ends) => SolidError::TouchesAlong { ends }.into(),
                None => SolidError::TouchesPlane { point }.into(),
            });
        }
        let has_knots = caps.has_knots;
        let known = areas_and_fluxes(&faces)?;
        let (side, of_side) = Self::closed_by(&faces, known.clone(), caps, tolerance)?;
        if has_knots {
            match side.topology(tolerance)?.pinch(2.0 * distance).as_deref() {
                Some(&[point]) => return Err(SolidError::TouchesPlane { point }.into()),
                Some(&[start, end]) => {
                    return Err(SolidError::TouchesAlong { ends: [start, end] }.into());
                }
                _ => {}
            }
        }
        let center = amid(&faces);
        let in_plane = center - plane.z() * (center - plane.origin()).dot(plane.z());
        let ((told, error), (found, its_error)) =
            (volume(&known, in_plane)?, volume(&of_side, center)?);
        let rounding = error * told + its_error * found;
        let allowed = distance * of_side.iter().map(AreaAndFlux::area).sum::<f64>() + rounding;
        let missing = (found - told).abs();
        if missing.is_nan() || allowed < missing {
            return Err(SolidError::UncertainCut { missing, allowed }.into());
        }
        Ok(Some(side))
    }

    /// What a plane has of it, the largest region first; faces in the plane are among it.
    ///
    /// ```
    /// use std::{f64::consts::PI, sync::Arc};
    /// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance, glam::DVec3};
    ///
    /// let ball = Arc::new(NurbsSurface::sphere(Frame::XY, 2.0)?);
    /// let ball = Solid::new(&[Face::whole(ball, Tolerance::DEFAULT)?], Tolerance::DEFAULT)?;
    /// let section = ball.section(Frame::XY.at(DVec3::Z), Tolerance::DEFAULT)?;
    /// assert!((section[0].mass().amount - 3.0 * PI).abs() < 1e-6);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Face::split`] but for a plane that misses, of [`Self::capped`] but for those of bodies, and of
    /// [`Region::union`].
    pub fn section(&self, plane: Frame, tolerance: Tolerance) -> Result<Vec<Region>, GeomError> {
        self.at_plane_or_rim(plane, tolerance, |plane| self.regions_in(plane, tolerance))
    }

    /// # Errors
    /// Those of [`Self::section`].
    fn regions_in(&self, plane: Frame, tolerance: Tolerance) -> Result<Vec<Region>, GeomError> {
        let FacesBeside { sides: [below, above], has_face_within, .. } =
            self.faces_beside(plane, tolerance)?;
        let caps = |faces: &[Face]| Ok::<_, GeomError>(plane_caps(faces, tolerance)?.regions);
        if has_face_within {
            // A face in the plane ends one side, and is not cut.
            return Region::union(&[caps(&below)?, caps(&above)?].concat(), tolerance, 1);
        }
        match below.is_empty() || above.is_empty() {
            true => Ok(Vec::new()),
            false => caps(&below),
        }
    }

    /// # Errors
    /// Those of [`Face::split`] but for a plane that misses.
    fn faces_beside(&self, plane: Frame, tolerance: Tolerance) -> Result<FacesBeside, GeomError> {
        let distance = tolerance.distance_for(box_around(&self.faces).diagonal());
        let mut found = FacesBeside {
            sides: [Vec::new(), Vec::new()],
            has_face_within: false,
            contacts: Vec::new(),
        };
        for face in &self.faces {
            GeomError::go_on(1)?;
            let [lowest, highest] = heights(face.surface().bounds(), plane);
            if distance < lowest || highest < -distance {
                found.sides[usize::from(0.0 < lowest)].push(face.clone());
                continue;
            }
            let is_within = face.height_above(plane, tolerance).abs() <= distance;
            found.has_face_within |= is_within;
            if !is_within {
                let divided = face.divided_by_plane(plane, tolerance)?;
                for (part, height) in divided.parts {
                    found.sides[usize::from(0.0 < height)].push(part);
                }
                found.contacts.extend(divided.contacts);
            }
        }
        Ok(found)
    }
}

/// What faces that look outward enclose, by the flux of the way from a point, and by which fraction that may be wrong.
fn volume(faces: &[AreaAndFlux], about: DVec3) -> Result<(f64, f64), GeomError> {
    let mut flux = MassIntegral::<1>::default();
    faces.iter().for_each(|face| flux.add(face.flux_from(about), 1.0));
    flux.amount_of_volume()
}

/// How far below and above a plane a box reaches.
pub(super) fn heights(Bounds { min, max }: Bounds, plane: Frame) -> [f64; 2] {
    let (center, half) = (0.5 * (min + max), 0.5 * (max - min));
    let height = (center - plane.origin()).dot(plane.z());
    let reach = half.dot(plane.z().abs());
    [height - reach, height + reach]
}

/// A place in which the faces on one side of a plane come to the regions that close them, other than in their rims.
///
/// # Errors
/// Those of a search that was ended.
fn touching(
    faces: &[Face],
    caps: &PlaneCaps,
    contacts: Vec<DVec3>,
    plane: Frame,
    tolerance: Tolerance,
) -> Result<Option<DVec3>, GeomError> {
    let side_of_caps = |point: DVec3| {
        let sides = caps.regions.iter().map(|region| region.side_of(point, tolerance.distance));
        sides.into_iter().find(|&side| side != RegionSide::Outside)
    };
    let boxes: Vec<Bounds> = faces.iter().map(|face| face.surface().bounds()).collect();
    for point in contacts {
        let Some(side) = side_of_caps(point) else { continue };
        for (face, bounds) in faces.iter().zip(&boxes) {
            if tolerance.distance < bounds.distance(point) {
                continue;
            }
            let foot = face.surface().closest(point);
            if tolerance.distance < foot.distance || !face.has(foot.parameters, tolerance) {
                continue;
            }
            // In a rim of a region the border of a face ends in it, as it should.
            if side == RegionSide::Inside || !face.is_on_border(foot.parameters, tolerance)? {
                return Ok(Some(point));
            }
        }
    }
    let is_within = |point: &DVec3| side_of_caps(*point) == Some(RegionSide::Inside);
    let mut of_edges = caps.edges.iter().flat_map(|edge| edge.places_in(plane, tolerance));
    Ok(of_edges.find(is_within))
}

/// The ends of a line through a point that lies in a plane all along: an edge of faces, or where the plane touches one.
///
/// # Errors
/// Those of [`Face::edges`] and [`Face::line_touched_at`].
fn line_along(
    faces: &[Face],
    point: DVec3,
    plane: Frame,
    tolerance: Tolerance,
) -> Result<Option<[DVec3; 2]>, GeomError> {
    let distance = tolerance.distance;
    for face in faces {
        GeomError::go_on(1)?;
        if distance < face.surface().bounds().distance(point) {
            continue;
        }
        for edge in face.edges(tolerance)? {
            let is_within = |p: DVec3| (p - plane.origin()).dot(plane.z()).abs() <= distance;
            let goes_through = edge.bounds().distance(point) <= distance
                && edge.foot_within(point, distance).is_some();
            let is_long = THIN_CUT * distance < edge.bounds().diagonal();
            if goes_through && is_long && edge.points().into_iter().all(is_within) {
                return Ok(Some([edge.start(), edge.end()]));
            }
        }
    }
    for face in faces {
        if face.surface().bounds().distance(point) <= distance
            && let Some(line) = face.line_touched_at(plane, point, tolerance)?
        {
            return Ok(Some([line.start(), line.end()]));
        }
    }
    Ok(None)
}
