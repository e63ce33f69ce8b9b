//! Parts of surfaces. ISO 10303-42, §5.4.

use glam::DVec3;

use super::{
    super::{Item, Job, exact::FaceLoops},
    entity::{Id, Records},
    shape::{BorderEdges, bound, carrier, face, oriented, shell},
};
use crate::kernel::{FaceEdge, NurbsCurve, NurbsSurface, Tolerance};

/// The parts of a surface as the faces of one open shell, each within its loops. An edge that is gone along twice,
/// as a seam is, stands once. The model, and its faces.
pub(super) fn model(
    item: &Item,
    geometry: &NurbsSurface,
    parts: &[FaceLoops],
    job: &Job,
    file: &mut Records,
) -> (Id, Vec<Id>) {
    let same = Tolerance::DEFAULT.with_distance(job.precision);
    let same = same.distance_for(geometry.bounds().diagonal());
    let carrier = carrier(&item.name, geometry, same, file);
    let edges = BorderEdges { same, vertices: Vec::new() };
    let mut border = FaceBorder { edges, known: Vec::new() };
    let mut faces = Vec::with_capacity(parts.len());
    for loops in parts {
        let mut bounds = Vec::with_capacity(loops.len());
        for edges in loops {
            let ids: Vec<Id> = edges
                .iter()
                .filter_map(|edge: &FaceEdge| edge.curve.as_ref())
                .map(|curve| border.oriented(curve, file))
                .collect();
            if !ids.is_empty() {
                bounds.push(bound(bounds.is_empty(), &ids, file));
            }
        }
        faces.push(face(&item.name, &bounds, &carrier, file));
    }
    (shell(&item.name, &faces, file), faces)
}

/// The edges that stand already.
struct FaceBorder {
    edges: BorderEdges,
    /// Where each begins, has its middle and ends.
    known: Vec<([DVec3; 3], Id)>,
}

impl FaceBorder {
    /// An edge along a curve, or back along one that is known.
    fn oriented(&mut self, curve: &NurbsCurve, file: &mut Records) -> Id {
        let domain = curve.domain();
        let places = [0.0, 0.5, 1.0].map(|at| curve.point_at(domain.at(at)));
        let same = 2.0 * self.edges.same;
        let are_same =
            |a: [DVec3; 3], b: [DVec3; 3]| a.iter().zip(b).all(|(a, b)| a.distance(b) <= same);
        let [start, middle, end] = places;
        for &(other, id) in &self.known {
            if are_same(other, [end, middle, start]) {
                return oriented(id, false, file);
            }
        }
        let id = self.edges.edge(curve, file);
        self.known.push((places, id));
        oriented(id, true, file)
    }
}
