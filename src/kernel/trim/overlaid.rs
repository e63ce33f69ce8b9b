//! Cutters that lie on a face: parts of its plane, cylinder, cone, sphere or torus, or of its own surface.
//!
//! Such a cutter crosses the face nowhere. It has an area in common with it, which the cutter's border bounds: this is
//! what divides the face, as a boolean of plane regions in the plane of parameters.

use glam::{DAffine3, DMat3, DVec3};

use super::{Cutter, Face, FaceError, lift::affine_map, pull::COMPARED};
use crate::{
    GeomError, IntersectionError, Interval, NurbsCurve, NurbsSurface, RegionSide, Tolerance,
    ceiling::SHARED_STRETCHES, frame::norm, region::smooth_arcs, tolerance::EDGE_SHARE,
};

impl Face {
    /// Whether a surface lies on its own within the tolerance, so that nothing crosses.
    pub(super) fn lies_along(&self, other: &NurbsSurface, tolerance: Tolerance) -> bool {
        // Borders of cutters are known within the rest.
        let distance = (1.0 - EDGE_SHARE) * self.distance(tolerance);
        self.plane.surface.shares_carrier(other, distance)
    }

    /// The arcs of the border of a face that lies along it, in its plane of parameters; they may go on beyond it.
    ///
    /// # Errors
    /// [`FaceError::OffSurface`] of an arc that leaves the surface beside its edges; those of [`Self::edges`].
    pub(super) fn overlaid_arcs(
        &self,
        other: &Self,
        index: usize,
        tolerance: Tolerance,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let edges = other.edges(tolerance)?;
        if let Some(map) = self.map_from_space() {
            let arcs =
                edges.iter().map(|edge| smooth_arcs(&edge.transformed(&map), tolerance.angle));
            return Ok(arcs.collect::<Result<Vec<_>, _>>()?.concat());
        }
        let mut parts = Vec::new();
        for edge in &edges {
            parts.extend(self.parts_on_surface(edge, index, self.distance(tolerance))?);
        }
        self.pulled(&parts, None, index, [self.distance(tolerance), tolerance.angle])
    }

    /// The map from space to its plane of parameters, straight along the normal, where the surface is even everywhere.
    fn map_from_space(&self) -> Option<DAffine3> {
        let map = affine_map(&self.plane.surface)?;
        let [along_u, along_v] = [map.matrix3.x_axis, map.matrix3.y_axis];
        let normal = along_u.cross(along_v);
        let whole = DAffine3 {
            matrix3: DMat3::from_cols(along_u, along_v, normal / norm(normal)),
            translation: map.translation,
        };
        let [u, v] = self.plane.scales;
        Some(DAffine3::from_scale(DVec3::new(u, v, 0.0)) * whole.inverse())
    }

    /// The parts of a curve on the carrier of the surface that are on the surface.
    ///
    /// # Errors
    /// [`FaceError::OffSurface`] of one that is only partly there.
    fn parts_on_surface(
        &self,
        curve: &NurbsCurve,
        index: usize,
        distance: f64,
    ) -> Result<Vec<NurbsCurve>, GeomError> {
        let surface = &self.plane.surface;
        let mut cuts = Vec::new();
        for (number, edge) in surface.edges().iter().enumerate() {
            if !self.plane.is_closed[number / 2] && distance < edge.bounds().diagonal() {
                cuts.extend(meetings(curve, edge, distance)?);
            }
        }
        cuts.sort_by(f64::total_cmp);
        let mut kept = Vec::new();
        for part in curve.parts_at(&cuts)? {
            GeomError::go_on(1)?;
            if part.bounds().diagonal() <= distance {
                continue;
            }
            let places = COMPARED.map(|at| part.point_at(part.domain().at(at)));
            let gaps = places.map(|place| surface.closest(place).distance);
            let beside = (0..places.len()).find(|&i| distance < gaps[i]);
            match beside {
                None => kept.push(part),
                Some(_) if gaps.iter().all(|&gap| distance < gap) => {}
                Some(i) => {
                    let (point, distance, what) = (places[i], gaps[i], "cutter");
                    return Err(FaceError::OffSurface { what, index, point, distance }.into());
                }
            }
        }
        Ok(kept)
    }

    /// Whether any of its places is none of its border.
    pub(crate) fn has_inner_place(&self, places: &[DVec3], tolerance: Tolerance) -> bool {
        places.iter().any(|&place| {
            let parameters = self.plane.surface.closest(place).parameters;
            self.side_of_parameters(parameters, self.distance(tolerance)) == RegionSide::Inside
        })
    }

    /// Whether some places of it, of its inside among them, all lie on a cutter.
    pub(super) fn is_covered_by(&self, cutter: &Cutter, tolerance: Tolerance) -> bool {
        let distance = self.distance(tolerance);
        let is_on = |surface: &NurbsSurface, face: Option<&Self>, point: DVec3| {
            let foot = surface.closest(point);
            foot.distance <= distance
                && face.is_none_or(|face| face.has(foot.parameters, tolerance))
        };
        let is_covered = |&point: &DVec3| match cutter {
            Cutter::Curve(_) | Cutter::Plane(_) => false,
            Cutter::Surface(surface) => is_on(surface, None, point),
            Cutter::Face(face) => is_on(face.surface(), Some(face), point),
            Cutter::Faces(faces) => {
                faces.iter().any(|face| is_on(face.surface(), Some(face), point))
            }
        };
        self.some_places(tolerance).iter().all(is_covered)
    }
}

/// The parameters of a curve where it meets another, or begins or ends to run along it.
///
/// # Errors
/// [`IntersectionError::Tangled`].
fn meetings(curve: &NurbsCurve, other: &NurbsCurve, distance: f64) -> Result<Vec<f64>, GeomError> {
    let (mut found, mut rests, mut n_stretches) = (Vec::new(), vec![curve.domain()], 0);
    while let Some(rest) = rests.pop() {
        GeomError::go_on(1)?;
        let part = if rest == curve.domain() { curve.clone() } else { curve.trimmed(rest)? };
        match part.intersections(other, distance) {
            Ok(meetings) => found.extend(meetings.iter().map(|place| place.first)),
            Err(GeomError::Intersection(IntersectionError::RunTogether { start, end })) => {
                n_stretches += 1;
                if SHARED_STRETCHES < n_stretches {
                    return Err(IntersectionError::Tangled.into());
                }
                found.extend([start, end]);
                let beside = match end < start {
                    true => vec![[end, start]],
                    false => vec![[rest.start(), start], [end, rest.end()]],
                };
                let beside = beside.into_iter().filter_map(|[a, b]| Interval::new(a, b).ok());
                let is_long = |rest: &Interval| {
                    let from = curve.point_at(rest.start());
                    rest.steps(4).into_iter().any(|t| distance < norm(curve.point_at(t) - from))
                };
                rests.extend(beside.filter(|part| *part != rest && is_long(part)));
            }
            Err(other) => return Err(other),
        }
    }
    Ok(found)
}
