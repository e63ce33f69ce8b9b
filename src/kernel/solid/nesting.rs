//! Which shells lie in which.
//!
//! Shells that do not meet lie in one another or beside one another: which, any place of one tells by the face of the
//! other that is nearest to it. Where that is a corner, the solid angle tells under which the other is seen: it is 4π
//! from inside and 0 from outside. That is asked last: parts of one body lie on the same surfaces, and an integral over
//! a face that begins beside it passes through the place.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;

use super::{Solid, SolidError, box_around};
use crate::{
    Bounds, Direction, Face, GeomError, Surface, Tolerance,
    frame::{norm, unit},
    tolerance::WHOLE_TURN_SLACK,
    trim::affine_map,
};

/// A body of a solid, by the numbers of its faces: a shell, and the voids directly within it.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance};
///
/// let ball = |radius: f64| Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, radius)?), Tolerance::DEFAULT);
/// let nested = Solid::new(&[ball(1.0)?, ball(3.0)?, ball(2.0)?], Tolerance::DEFAULT)?;
/// let bodies = nested.bodies(Tolerance::DEFAULT)?;
/// assert_eq!((&bodies[0].outer[..], bodies[0].voids.len()), (&[0][..], 0));
/// assert_eq!((&bodies[1].outer[..], &bodies[1].voids[..]), (&[1][..], &[vec![2]][..]));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SolidBody {
    /// The faces around it.
    pub outer: Vec<usize>,
    /// The faces of each void.
    pub voids: Vec<Vec<usize>>,
}

impl Solid {
    /// Its bodies: each shell that is no void, with the voids within it.
    ///
    /// # Errors
    /// [`SolidError::UnclearNesting`]; `GeomError::Ended`.
    pub fn bodies(&self, tolerance: Tolerance) -> Result<Vec<SolidBody>, GeomError> {
        let around = self.surrounding(tolerance)?;
        let mut bodies = Vec::new();
        for (shell, own) in around.iter().enumerate().filter(|(_, own)| own.len() % 2 == 0) {
            // A void is within one shell more, and that is this one.
            let is_void =
                |others: &Vec<usize>| others.len() == own.len() + 1 && others.contains(&shell);
            let voids = (0..around.len()).filter(|&other| is_void(&around[other]));
            let voids = voids.map(|other| self.shells[other].clone()).collect();
            bodies.push(SolidBody { outer: self.shells[shell].clone(), voids });
        }
        Ok(bodies)
    }

    /// Its bodies as solids of their own, each with the faces around it and then those of its voids.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance};
    ///
    /// let ball = |radius: f64| Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, radius)?), Tolerance::DEFAULT);
    /// let nested = Solid::new(&[ball(1.0)?, ball(3.0)?, ball(2.0)?], Tolerance::DEFAULT)?;
    /// let bodies = nested.separate_bodies(Tolerance::DEFAULT)?;
    /// let n_shells: Vec<usize> = bodies.iter().map(|body| body.shells().count()).collect();
    /// assert_eq!(n_shells, [1, 2]);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Self::bodies`].
    pub fn separate_bodies(&self, tolerance: Tolerance) -> Result<Vec<Self>, GeomError> {
        let alone = |body: SolidBody| {
            let mut own = Self { faces: Vec::new(), shells: Vec::new(), may_cross: self.may_cross };
            for shell in [body.outer].into_iter().chain(body.voids) {
                let first = own.faces.len();
                own.shells.push((first..first + shell.len()).collect());
                own.faces.extend(shell.into_iter().map(|face| self.faces[face].clone()));
            }
            own
        };
        Ok(self.bodies(tolerance)?.into_iter().map(alone).collect())
    }

    /// The shells that lie in an odd number of others.
    ///
    /// # Errors
    /// [`SolidError::ShellsMeet`], [`SolidError::UnclearNesting`]; those of [`Surface::intersections`].
    pub(super) fn voids(&self, tolerance: Tolerance) -> Result<Vec<usize>, GeomError> {
        for i in 0..self.shells.len() {
            for j in i + 1..self.shells.len() {
                self.check_apart([i, j], tolerance)?;
            }
        }
        let around = self.surrounding(tolerance)?.into_iter().enumerate();
        Ok(around.filter(|(_, own)| own.len() % 2 == 1).map(|(shell, _)| shell).collect())
    }

    /// For each shell those around it.
    fn surrounding(&self, tolerance: Tolerance) -> Result<Vec<Vec<usize>>, GeomError> {
        let boxes: Vec<Bounds> = self.shells().map(box_around).collect();
        let mut all = Vec::with_capacity(boxes.len());
        for (i, own) in boxes.iter().enumerate() {
            let mut around = Vec::new();
            for (j, other) in boxes.iter().enumerate().filter(|&(j, _)| j != i) {
                if other.holds(*own, 0.0) && self.is_within([i, j], tolerance)? {
                    around.push(j);
                }
            }
            all.push(around);
        }
        Ok(all)
    }

    /// # Errors
    /// [`SolidError::ShellsMeet`]; those of [`Surface::intersections`].
    fn check_apart(&self, shells: [usize; 2], tolerance: Tolerance) -> Result<(), GeomError> {
        for &one in &self.shells[shells[0]] {
            for &other in &self.shells[shells[1]] {
                GeomError::go_on(1)?;
                let faces = [one, other];
                if let Some(point) = meeting(faces.map(|face| &self.faces[face]), tolerance)? {
                    return Err(SolidError::ShellsMeet { faces, point }.into());
                }
            }
        }
        Ok(())
    }

    /// Whether a shell lies within another one, which it does not meet.
    ///
    /// # Errors
    /// [`SolidError::UnclearNesting`]; those of [`Self::closest`].
    fn is_within(
        &self,
        [inner, outer]: [usize; 2],
        tolerance: Tolerance,
    ) -> Result<bool, GeomError> {
        let shell = &self.shells[outer];
        let places: Vec<DVec3> =
            self.shells[inner].iter().map(|&face| self.faces[face].border_place()).collect();
        for &place in &places {
            if let Some(is_behind) = self.is_behind(shell, place, tolerance)? {
                // Voids have their inside before them.
                return Ok(is_behind == self.looks_outward(shell)?);
            }
        }
        for &place in &places {
            let mut turns = 0.0;
            for &face in shell {
                turns += self.faces[face].solid_angle(place)? / (4.0 * PI);
            }
            if (turns - turns.round()).abs() <= WHOLE_TURN_SLACK {
                return Ok(turns.round() != 0.0);
            }
        }
        Err(SolidError::UnclearNesting { point: places[0] }.into())
    }

    /// Whether what faces that close enclose is behind them.
    fn looks_outward(&self, shell: &[usize]) -> Result<bool, GeomError> {
        let about = box_around(shell.iter().map(|&face| &self.faces[face])).center();
        let mut flux = 0.0;
        for &face in shell {
            flux += self.faces[face].flux_from(about)?.values[0];
        }
        Ok(0.0 < flux)
    }
}

/// A place that two faces have in common.
fn meeting(faces: [&Face; 2], tolerance: Tolerance) -> Result<Option<DVec3>, GeomError> {
    let [one, other] = faces.map(|face| face.surface().bounds());
    let apart = (one.min - other.max).max(other.min - one.max).max_element();
    if tolerance.distance_for(one.union(other).diagonal()) < apart {
        return Ok(None);
    }
    if are_on_one_carrier(faces, tolerance) {
        return meeting_on_carrier(faces, tolerance);
    }
    let [a, b] = faces.map(|face| Surface::Nurbs(Arc::clone(face.surface())));
    let set = a.intersections(&b, tolerance)?;
    let curves = faces[1].clipped(&faces[0].clipped(&set.curves, tolerance)?, tolerance)?;
    if let Some(curve) = curves.first() {
        return Ok(Some(curve.point_at(curve.domain().at(0.5))));
    }
    let is_on = |point: &DVec3| {
        faces.iter().all(|face| {
            let foot = face.surface().closest(*point);
            norm(foot.point - *point) <= 2.0 * tolerance.distance
                && face.has(foot.parameters, tolerance)
        })
    };
    Ok(set.touches.into_iter().chain(set.contacts).chain(set.uncertain).find(is_on))
}

/// Whether faces are parts of one surface, or of one plane.
fn are_on_one_carrier(faces: [&Face; 2], tolerance: Tolerance) -> bool {
    let [one, other] = faces.map(|face| &**face.surface());
    if one == other || *one == other.reversed(Direction::V) {
        return true;
    }
    let [Some(map), Some(_)] = [one, other].map(affine_map) else { return false };
    let Some(normal) = unit(map.x_axis.cross(map.y_axis)) else { return false };
    let distance = tolerance.distance_for(one.bounds().union(other.bounds()).diagonal());
    let is_within = |point: &DVec3| (*point - map.translation).dot(normal).abs() <= distance;
    other.points().iter().all(is_within)
}

/// A place that parts of one surface or plane have in common: where their borders meet, or on one that lies within
/// the other.
fn meeting_on_carrier(faces: [&Face; 2], tolerance: Tolerance) -> Result<Option<DVec3>, GeomError> {
    let [own, others] = faces.map(|face| face.edges(tolerance));
    let (own, others) = (own?, others?);
    for edge in &own {
        let around = edge.bounds();
        for other in
            others.iter().filter(|other| other.bounds().is_near(around, tolerance.distance))
        {
            GeomError::go_on(1)?;
            match edge.intersections(other, tolerance.distance) {
                Ok(meetings) => {
                    if let Some(meeting) = meetings.first() {
                        return Ok(Some(meeting.point));
                    }
                }
                Err(GeomError::Intersection(_)) => {
                    return Ok(Some(edge.point_at(edge.domain().at(0.5))));
                }
                Err(other) => return Err(other),
            }
        }
    }
    let is_on = |point: &DVec3, face: &Face| {
        let foot = face.surface().closest(*point);
        foot.distance <= 2.0 * tolerance.distance && face.has(foot.parameters, tolerance)
    };
    let places = faces.map(Face::border_place);
    let within = [(places[0], faces[1]), (places[1], faces[0])];
    Ok(within.into_iter().find(|(place, face)| is_on(place, face)).map(|(place, _)| place))
}
