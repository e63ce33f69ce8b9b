//! Which shells lie in which.
//!
//! Shells that do not meet lie in one another or beside one another: the solid angle under which a shell is seen
//! from a place of another tells which, as it is 4π from inside and 0 from outside.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;

use super::{Solid, SolidError};
use crate::{
    Bounds, Face, GeomError, Surface, Tolerance, frame::norm, tolerance::WHOLE_TURN_SLACK,
};

impl Solid {
    /// The shells that lie in an odd number of others.
    ///
    /// # Errors
    /// [`SolidError::ShellsMeet`], [`SolidError::UnclearNesting`]; those of [`Surface::intersections`].
    pub(super) fn voids(&self, tolerance: Tolerance) -> Result<Vec<usize>, GeomError> {
        let boxes: Vec<Bounds> = self.shells().map(|shell| box_of(&shell)).collect();
        let mut voids = Vec::new();
        for (i, own) in boxes.iter().enumerate() {
            let mut n_around = 0;
            for (j, other) in boxes.iter().enumerate().filter(|&(j, _)| j != i) {
                if i < j {
                    self.check_apart([i, j], tolerance)?;
                }
                if holds(*other, *own) && self.is_within(i, j)? {
                    n_around += 1;
                }
            }
            if n_around % 2 == 1 {
                voids.push(i);
            }
        }
        Ok(voids)
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
    /// [`SolidError::UnclearNesting`]; `GeomError::Ended`.
    fn is_within(&self, inner: usize, outer: usize) -> Result<bool, GeomError> {
        let point = self.faces[self.shells[inner][0]].border_place();
        let mut turns = 0.0;
        for &face in &self.shells[outer] {
            turns += self.faces[face].solid_angle(point)? / (4.0 * PI);
        }
        if (turns - turns.round()).abs() <= WHOLE_TURN_SLACK {
            return Ok(turns.round() != 0.0);
        }
        Err(SolidError::UnclearNesting { point }.into())
    }
}

fn box_of(faces: &[&Face]) -> Bounds {
    let boxes = faces.iter().map(|face| face.surface().bounds());
    let Some(whole) = boxes.reduce(Bounds::union) else { unreachable!("a shell has faces") };
    whole
}

/// Whether a box holds another one.
fn holds(outer: Bounds, inner: Bounds) -> bool {
    outer.min.cmple(inner.min).all() && inner.max.cmple(outer.max).all()
}

/// A place that two faces have in common.
fn meeting(faces: [&Face; 2], tolerance: Tolerance) -> Result<Option<DVec3>, GeomError> {
    let [one, other] = faces.map(|face| face.surface().bounds());
    let apart = (one.min - other.max).max(other.min - one.max).max_element();
    if tolerance.distance_for(one.union(other).diagonal()) < apart {
        return Ok(None);
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
    Ok(set.touches.into_iter().chain(set.uncertain).find(is_on))
}
