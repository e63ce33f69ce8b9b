//! How faces of a solid meet along an edge.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;

use super::{Solid, SolidEdge};
use crate::{
    ConstructionReport, Face, NurbsCurve, ReportEntry, SurfaceCurve, Tolerance, frame::unit,
};

/// Places of an edge, its ends left out, at which the angle between its faces is looked at.
const N_PLACES: usize = 24;

/// The angles between the faces along an edge, through the inside: π where one goes on in the other, less where the
/// edge is convex.
///
/// ```
/// use virote_kernel::{NurbsCurve, Region, Solid, Tolerance, glam::DVec3};
///
/// let [o, x, y] = [DVec3::ZERO, DVec3::X, DVec3::Y];
/// let triangle = Region::new(&NurbsCurve::polyline(&[o, x, y, o])?, &[], Tolerance::DEFAULT)?;
/// let prism = Solid::extruded(&triangle, DVec3::Z, Tolerance::DEFAULT)?;
/// let edges = prism.topology(Tolerance::DEFAULT)?.edges;
/// let least = edges.iter().filter_map(|edge| edge.angles(prism.faces())).map(|angles| angles.least);
/// assert!((least.fold(f64::INFINITY, f64::min) - std::f64::consts::FRAC_PI_4).abs() < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeAngles {
    /// The least of those that were looked at, radians.
    pub least: f64,
    /// The largest.
    pub largest: f64,
}

impl EdgeAngles {
    /// Whether the faces turn toward one another all along the edge, by more than an angle.
    #[must_use]
    pub fn is_convex(self, angle: f64) -> bool {
        self.largest < PI - angle
    }

    /// The sharpest of them, inside or outside.
    #[must_use]
    pub fn sharpest(self) -> f64 {
        self.least.min(2.0 * PI - self.largest)
    }
}

impl SolidEdge {
    /// The angles between its faces, among those of its solid; none where no place of it has two tangent planes.
    #[must_use]
    pub fn angles(&self, faces: &[Face]) -> Option<EdgeAngles> {
        angles_along(&self.curve, self.faces.map(|face| &faces[face]))
    }
}

impl Solid {
    /// An edge of it as a curve with a report: what [`SurfaceCurve::reported`] tells, whether it is `convex`, the least
    /// `angle` between its `faces` through the inside, and its `length`.
    #[must_use]
    pub fn reported_edge(&self, edge: SolidEdge, tolerance: Tolerance) -> NurbsCurve {
        let faces = edge.faces.map(|face| self.faces[face].clone());
        let surfaces = faces.each_ref().map(|face| Arc::clone(face.surface()));
        let (curve, numbers) = (edge.curve, edge.faces);
        let asked = SurfaceCurve::reported(curve.clone(), surfaces, tolerance, "edges");
        let along = curve.clone();
        let ask = move || {
            let known = asked.report().cloned().unwrap_or_default();
            let angles = angles_along(&along, faces.each_ref());
            let angle = angles.map_or(ReportEntry::None, |found| ReportEntry::Angle(found.least));
            let is_convex = angles.is_some_and(|found| found.is_convex(tolerance.angle));
            known
                .with("convex", is_convex)
                .with("angle", angle)
                .with("faces", numbers.map(|face| face as f64).to_vec())
                .with("length", ReportEntry::Length(along.length(along.domain())))
        };
        curve.with_report(ConstructionReport::later(ask))
    }
}

/// The angles between two faces along a curve that one has to its left and the other to its right.
fn angles_along(curve: &NurbsCurve, faces: [&Face; 2]) -> Option<EdgeAngles> {
    let at = |k: usize| {
        let t = curve.domain().at((k as f64 + 0.5) / N_PLACES as f64);
        let derivatives = curve.derivatives_at(t, 1);
        angle_at(derivatives[0], derivatives[1], faces)
    };
    let mut found = (0..N_PLACES).filter_map(at);
    let first = found.next()?;
    let with = |known: EdgeAngles, angle: f64| EdgeAngles {
        least: known.least.min(angle),
        largest: known.largest.max(angle),
    };
    Some(found.fold(EdgeAngles { least: first, largest: first }, with))
}

/// The angle from one face to the other through the inside, behind both; none where one has no tangent plane.
fn angle_at(point: DVec3, way: DVec3, faces: [&Face; 2]) -> Option<f64> {
    let normal = |face: &Face| {
        let [u, v] = face.surface().closest(point).parameters;
        face.surface().normal_at(u, v).ok()
    };
    let [ahead, behind] = [normal(faces[0])?, normal(faces[1])?];
    let [into, across] = [unit(ahead.cross(way))?, unit(way.cross(behind))?];
    let angle = libm::atan2(-across.dot(ahead), across.dot(into));
    Some(if angle < 0.0 { angle + 2.0 * PI } else { angle })
}
