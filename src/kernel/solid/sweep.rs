//! Solids that regions leave behind: moved along a vector, turned about an axis.
//!
//! The sides are the exact surfaces of the region's arcs, the ends plane faces with the region's own borders.

use std::{f64::consts::TAU, sync::Arc};

use glam::{DAffine3, DVec3};

use super::{Solid, SolidError};
use crate::{
    Axis, AxisContact, Face, GeomError, InputError, NurbsCurve, NurbsSurface, Region, Tolerance,
    frame::norm, tolerance::KNOT_RELATIVE,
};

impl Solid {
    /// What a region passes that is moved along a vector.
    ///
    /// Faces: where the region was, where it comes to, and one for each of its arcs, in its order.
    ///
    /// ```
    /// use virote_kernel::{CircleForm, Frame, NurbsCurve, Region, Solid, Tolerance, glam::DVec3};
    ///
    /// let disc = |radius: f64| NurbsCurve::ellipse(Frame::XY, [radius; 2], CircleForm::NinePoint);
    /// let ring = Region::new(&disc(2.0)?, &[disc(1.0)?], Tolerance::DEFAULT)?;
    /// let pipe = Solid::extruded(&ring, DVec3::new(1.0, 0.0, 5.0), Tolerance::DEFAULT)?;
    /// // Cavalieri: the slant adds nothing.
    /// assert!((pipe.volume_mass()?.amount - 15.0 * std::f64::consts::PI).abs() < 1e-9);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`SolidError::AlongPlane`]; those of [`NurbsSurface::extruded`] and [`Face::of_region`].
    pub fn extruded(
        region: &Region,
        vector: DVec3,
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let height = vector.dot(region.frame().z());
        let size = region.bounds().diagonal() + norm(vector);
        let distance = tolerance.distance_for(size);
        if height.is_nan() || height.abs() <= distance {
            let height = height.abs();
            return Err(SolidError::AlongPlane { height, tolerance: distance }.into());
        }
        let is_up = 0.0 < height;
        let floor = Face::of_region(region, tolerance)?;
        let lid = floor.transformed(&DAffine3::from_translation(vector))?;
        let mut faces = match is_up {
            true => vec![floor.reversed(), lid],
            false => vec![floor, lid.reversed()],
        };
        let to_space = region.frame().to_space();
        for arc in region.arcs().flatten() {
            let side = NurbsSurface::extruded(&arc.transformed(&to_space), vector)?;
            faces.push(facing(side, is_up, tolerance)?);
        }
        let shells = vec![(0..faces.len()).collect()];
        Ok(Self { faces, shells, may_cross: false })
    }

    /// What a region passes that is turned about an axis in its plane, by up to a full turn either way.
    ///
    /// Faces: one for each arc that is not on the axis, in the region's order; short of a full turn
    /// before them where the region was and where it comes to. A full turn of a region with holes leaves voids.
    ///
    /// ```
    /// use std::f64::consts::{PI, TAU};
    /// use virote_kernel::{Axis, CircleForm, Frame, NurbsCurve, Region, Solid, Tolerance, glam::DVec3};
    ///
    /// let disc = NurbsCurve::ellipse(Frame::ZX.at(DVec3::X * 3.0), [1.0; 2], CircleForm::NinePoint)?;
    /// let disc = Region::new(&disc, &[], Tolerance::DEFAULT)?;
    /// let axis = Axis::new(DVec3::ZERO, DVec3::Z)?;
    /// let torus = Solid::revolved(&disc, axis, TAU, Tolerance::DEFAULT)?;
    /// // Pappus: the area goes along the way of its centre.
    /// assert!((torus.volume_mass()?.amount - PI * 6.0 * PI).abs() < 1e-9);
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`SolidError::AxisOffPlane`], [`SolidError::AcrossAxis`], [`SolidError::PointOnAxis`]; those of
    /// [`NurbsSurface::revolved`] and [`Face::of_region`].
    pub fn revolved(
        region: &Region,
        axis: Axis,
        angle: f64,
        tolerance: Tolerance,
    ) -> Result<Self, GeomError> {
        let distance = tolerance.distance_for(region.bounds().diagonal());
        let half = HalfPlane::of(region, axis, distance)?;
        let is_full = TAU * (1.0 - KNOT_RELATIVE) <= angle.abs();
        let mut borders = Vec::new();
        for arcs in region.arcs() {
            borders.push(half.checked(arcs, is_full, distance)?);
        }
        // Where the region goes when it starts: along its normal or against it.
        let starts_up = (0.0 < angle) == half.turns_up;
        let (mut faces, mut shells) = (Vec::new(), Vec::new());
        if !is_full {
            let start = Face::of_region(region, tolerance)?;
            let end = start.transformed(&axis.turn(angle))?;
            faces = match starts_up {
                true => vec![start.reversed(), end],
                false => vec![start, end.reversed()],
            };
        }
        for arcs in borders {
            let first = faces.len();
            for arc in arcs {
                let side = NurbsSurface::revolved(&arc, axis, angle)?;
                faces.push(facing(side, !starts_up, tolerance)?);
            }
            shells.push((first..faces.len()).collect());
        }
        if !is_full {
            shells = vec![(0..faces.len()).collect()];
        }
        Ok(Self { faces, shells, may_cross: false })
    }
}

/// The face of a whole surface, turned unless it looks outward.
fn facing(
    surface: NurbsSurface,
    is_outward: bool,
    tolerance: Tolerance,
) -> Result<Face, GeomError> {
    let face = Face::whole(Arc::new(surface), tolerance)?;
    Ok(if is_outward { face } else { face.reversed() })
}

/// The plane of a region that turns, with the side of the axis on which the region is.
struct HalfPlane<'a> {
    region: &'a Region,
    axis: Axis,
    /// Away from the axis, to where the region is.
    out: DVec3,
    /// Whether a positive turn starts along the normal of the region.
    turns_up: bool,
}

impl<'a> HalfPlane<'a> {
    /// # Errors
    /// [`SolidError::AxisOffPlane`]; [`InputError::ZeroAxis`].
    fn of(region: &'a Region, axis: Axis, distance: f64) -> Result<Self, GeomError> {
        let normal = region.frame().z();
        let along = axis.direction();
        let bounds = region.bounds();
        // The axis beside the region.
        let middle = axis.foot() + along * (bounds.center() - axis.foot()).dot(along);
        let reach = 0.5 * bounds.diagonal();
        let height = |point: DVec3| (point - region.frame().origin()).dot(normal).abs();
        let by = height(middle + along * reach).max(height(middle - along * reach));
        if by.is_nan() || distance < by {
            return Err(SolidError::AxisOffPlane { by }.into());
        }
        let out = crate::unit(along.cross(normal));
        let out = out.ok_or(InputError::ZeroAxis { what: "the axis" })?;
        let out = if (region.mass().centroid - axis.foot()).dot(out) < 0.0 { -out } else { out };
        Ok(Self { region, axis, out, turns_up: 0.0 < along.cross(out).dot(normal) })
    }

    /// How far a point is from the axis; negative on the other side.
    fn distance(&self, point: DVec3) -> f64 {
        (point - self.axis.foot()).dot(self.out)
    }

    /// The arcs of a border in space that are not on the axis.
    ///
    /// # Errors
    /// [`SolidError::AcrossAxis`], [`SolidError::PointOnAxis`].
    fn checked(
        &self,
        arcs: &[NurbsCurve],
        is_full: bool,
        distance: f64,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let to_space = self.region.frame().to_space();
        let arcs: Vec<NurbsCurve> = arcs.iter().map(|arc| arc.transformed(&to_space)).collect();
        let on_axis = |arc: &NurbsCurve| {
            arc.points().into_iter().all(|point| self.distance(point).abs() <= distance)
        };
        let is_on_axis: Vec<bool> = arcs.iter().map(on_axis).collect();
        for (i, arc) in arcs.iter().enumerate().filter(|&(i, _)| !is_on_axis[i]) {
            let middle = arc.point_at(arc.domain().at(0.5));
            for point in [arc.start(), middle, arc.end()] {
                if self.distance(point) < -distance {
                    return Err(SolidError::AcrossAxis { point }.into());
                }
            }
            if let Some(&contact) = self.axis.contacts(arc, distance)?.first() {
                return Err(match contact {
                    AxisContact::Place { parameter, is_crossing: false } => {
                        SolidError::PointOnAxis { point: arc.point_at(parameter) }.into()
                    }
                    AxisContact::Place { parameter: at, .. }
                    | AxisContact::Stretch { start: at, .. } => {
                        SolidError::AcrossAxis { point: arc.point_at(at) }.into()
                    }
                });
            }
            let next = (i + 1) % arcs.len();
            let point = arc.end();
            if is_full && self.distance(point) <= distance && !is_on_axis[next] {
                return Err(SolidError::PointOnAxis { point }.into());
            }
        }
        Ok(arcs
            .into_iter()
            .zip(is_on_axis)
            .filter(|(_, is_on)| !is_on)
            .map(|(arc, _)| arc)
            .collect())
    }
}
