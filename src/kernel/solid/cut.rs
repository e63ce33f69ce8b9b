//! Solids cut by planes.

use super::{Solid, SolidError, box_around};
use crate::{Face, Frame, GeomError, Region, Tolerance};

/// What is on both sides of a plane: below it, and above it, where its normal points.
///
/// ```
/// use std::{f64::consts::PI, sync::Arc};
/// use virote_kernel::{Face, Frame, NurbsSurface, Solid, Tolerance, glam::DVec3};
///
/// let ball = Arc::new(NurbsSurface::sphere(Frame::XY, 2.0)?);
/// let ball = Solid::new(&[Face::whole(ball, Tolerance::DEFAULT)?], Tolerance::DEFAULT)?;
/// let halves = ball.cut(Frame::XY.at(DVec3::Z), Tolerance::DEFAULT)?;
/// let cap = halves.above.expect("the ball reaches above the plane");
/// assert!((cap.volume_mass()?.amount - 5.0 / 3.0 * PI).abs() < 1e-6);
/// assert!((halves.section[0].mass().amount - 3.0 * PI).abs() < 1e-6);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct CutSolid {
    /// The side to which the normal of the plane does not point.
    pub below: Option<Solid>,
    /// The other one.
    pub above: Option<Solid>,
    /// What the plane has of the solid, the largest region first; faces in the plane included.
    pub section: Vec<Region>,
}

impl Solid {
    /// Both sides of a plane, and what lies in it.
    ///
    /// The faces of a side are the parts of the solid's faces there, and plane faces within the rims that the
    /// plane leaves. Both volumes must come to the solid's, so that no loop of the cut is missed.
    ///
    /// # Errors
    /// [`SolidError::UncertainCut`] where they do not; those of [`crate::Face::split`] but for a plane that
    /// misses, and of [`Self::capped`].
    pub fn cut(&self, plane: Frame, tolerance: Tolerance) -> Result<CutSolid, GeomError> {
        let distance = tolerance.distance_for(box_around(&self.faces).diagonal());
        let mut sides = [Vec::new(), Vec::new()];
        let mut has_face_within = false;
        for face in &self.faces {
            GeomError::go_on(1)?;
            let is_within = face.height_above(plane, tolerance)?.abs() <= distance;
            has_face_within |= is_within;
            if !is_within {
                for (part, height) in face.divided_by_plane(plane, tolerance)? {
                    sides[usize::from(0.0 < height)].push(part);
                }
            }
        }
        if !has_face_within && sides.iter().any(Vec::is_empty) {
            let side = |faces: &Vec<Face>| (!faces.is_empty()).then(|| self.clone());
            let [below, above] = sides.each_ref().map(side);
            return Ok(CutSolid { below, above, section: Vec::new() });
        }
        let mut closed = [None, None];
        let mut caps = [Vec::new(), Vec::new()];
        for ((solid, caps), faces) in closed.iter_mut().zip(&mut caps).zip(&sides) {
            if !faces.is_empty() {
                let (made, regions) = Self::with_caps(faces, tolerance)?;
                (*solid, *caps) = (Some(made), regions);
            }
        }
        let whole = self.volume_mass()?;
        let mut parts = 0.0;
        for side in closed.iter().flatten() {
            parts += side.volume_mass()?.amount;
        }
        let allowed = distance * self.area_mass()?.amount + whole.relative_error * whole.amount;
        let missing = (whole.amount - parts).abs();
        if missing.is_nan() || allowed < missing {
            return Err(SolidError::UncertainCut { missing, allowed }.into());
        }
        let [below, above] = closed;
        let [under, over] = caps;
        let section = match has_face_within {
            // A face in the plane ends one side, and is not cut.
            true => Region::union(&[under, over].concat(), tolerance, 1)?,
            false => under,
        };
        Ok(CutSolid { below, above, section })
    }
}
