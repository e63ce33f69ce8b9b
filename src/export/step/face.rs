//! Parts of surfaces. ISO 10303-42, §5.4.

use glam::DVec3;

use super::{
    super::{Item, Job, exact::FaceLoops},
    bound::{LoopStep, bounds},
    entity::{Id, Records},
    shape::{BorderEdges, carrier, face, shell},
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
        let mut steps = Vec::with_capacity(loops.len());
        for edges in loops {
            let curves = edges.iter().filter_map(|edge: &FaceEdge| edge.curve.as_ref());
            let of_loop: Vec<LoopStep> = curves.map(|curve| border.step(curve, file)).collect();
            steps.push(of_loop);
        }
        let bounds = bounds(&steps, &carrier, file);
        faces.push(face(&item.name, &bounds, &carrier, file));
    }
    (shell(&item.name, &faces, file), faces)
}

/// The edges that stand already.
struct FaceBorder {
    edges: BorderEdges,
    /// Where each begins, has its middle and ends.
    known: Vec<([DVec3; 3], LoopStep)>,
}

impl FaceBorder {
    /// An edge along a curve, or back along one that is known.
    fn step(&mut self, curve: &NurbsCurve, file: &mut Records) -> LoopStep {
        let domain = curve.domain();
        let places = [0.0, 0.5, 1.0].map(|at| curve.point_at(domain.at(at)));
        let same = 2.0 * self.edges.same;
        let are_same =
            |a: [DVec3; 3], b: [DVec3; 3]| a.iter().zip(b).all(|(a, b)| a.distance(b) <= same);
        let [start, middle, end] = places;
        for &(other, LoopStep { edge, ends: [from, to], .. }) in &self.known {
            if are_same(other, [end, middle, start]) {
                return LoopStep { edge, is_along: false, ends: [to, from] };
            }
        }
        let (edge, ends) = self.edges.edge(curve, file);
        let step = LoopStep { edge, is_along: true, ends };
        self.known.push((places, step));
        step
    }
}
