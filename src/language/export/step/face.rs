//! Parts of surfaces. ISO 10303-42, §5.4.

use glam::DVec3;

use super::{
    super::{ExportError, Item, Job, exact::FaceLoops},
    bound::{LoopStep, bounds},
    entity::{Id, Records},
    pcurve::{EdgeSide, edge_curve},
    shape::{BorderEdges, carrier, face, shell},
};
use crate::kernel::{FaceEdge, NurbsCurve, NurbsSurface, ParameterArc, Tolerance};

/// The parts of a surface as the faces of one open shell, each within its loops. An edge that is gone along twice,
/// as a seam is, stands once. The model, and its faces.
pub(super) fn model(
    item: &Item,
    geometry: &NurbsSurface,
    parts: &[FaceLoops],
    job: &Job,
    file: &mut Records,
) -> Result<(Id, Vec<Id>), ExportError> {
    let same = Tolerance::DEFAULT.with_distance(job.precision);
    let same = same.distance_for(geometry.bounds().diagonal());
    let carrier = carrier(&item.name, geometry, same, file);
    let vertices = BorderEdges { same, vertices: Vec::new() };
    let mut border = FaceBorder { vertices, edges: Vec::new() };
    let mut ways: Vec<Vec<Vec<(usize, bool)>>> = Vec::with_capacity(parts.len());
    for loops in parts {
        let of_loop = |edges: &Vec<FaceEdge>| {
            let steps = edges.iter().filter_map(|edge| border.step(edge, file));
            steps.collect()
        };
        ways.push(loops.iter().map(of_loop).collect());
    }
    let mut edges = Vec::with_capacity(border.edges.len());
    for edge in border.edges {
        let side = |arc| EdgeSide { carrier: &carrier, arc };
        let sides: Vec<EdgeSide<'_>> = edge.arcs.into_iter().map(side).collect();
        let blame = |source| ExportError::Geometry { name: item.name.clone(), source };
        let id = edge_curve(&edge.curve, edge.ends, &sides, job.precision, file).map_err(blame)?;
        edges.push((id, edge.ends));
    }
    let step = |&(edge, is_along): &(usize, bool)| {
        let (edge, [from, to]) = edges[edge];
        LoopStep { edge, is_along, ends: if is_along { [from, to] } else { [to, from] } }
    };
    let mut faces = Vec::with_capacity(parts.len());
    for loops in &ways {
        let steps: Vec<Vec<LoopStep>> =
            loops.iter().map(|steps| steps.iter().map(step).collect()).collect();
        let bounds = bounds(&steps, &carrier, file);
        faces.push(face(&item.name, &bounds, &carrier, file));
    }
    Ok((shell(&item.name, &faces, file), faces))
}

/// The edges that loops go along, each once.
struct FaceBorder {
    vertices: BorderEdges,
    edges: Vec<BorderEdge>,
}

/// An edge before it is written.
struct BorderEdge {
    curve: NurbsCurve,
    ends: [Id; 2],
    /// Where it begins, has its middle and ends.
    places: [DVec3; 3],
    /// The ways along it, by parameters.
    arcs: Vec<ParameterArc>,
}

impl FaceBorder {
    /// Along a curve, or back along one that is known: its number, and whether along. None along a point.
    fn step(&mut self, edge: &FaceEdge, file: &mut Records) -> Option<(usize, bool)> {
        let curve = edge.curve.as_ref()?;
        let arc = ParameterArc::whole(edge.parameters.clone());
        let places = [0.0, 0.5, 1.0].map(|at| curve.point_at(curve.domain().at(at)));
        let same = 2.0 * self.vertices.same;
        let are_same =
            |a: [DVec3; 3], b: [DVec3; 3]| a.iter().zip(b).all(|(a, b)| a.distance(b) <= same);
        let [start, middle, end] = places;
        for (number, known) in self.edges.iter_mut().enumerate() {
            if are_same(known.places, [end, middle, start]) {
                known.arcs.push(arc.reversed());
                return Some((number, false));
            }
        }
        let ends = self.vertices.ends(curve, file);
        self.edges.push(BorderEdge { curve: curve.clone(), ends, places, arcs: vec![arc] });
        Some((self.edges.len() - 1, true))
    }
}
