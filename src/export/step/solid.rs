//! Solids. ISO 10303-42, §5.4 and §6.4.

use super::{
    super::{
        ExportError, Item, Job,
        exact::{ExactSolid, exact_solid},
    },
    bound::{LoopStep, bounds},
    entity::{Id, Records},
    shape::{carrier, edge_curve, face, vertex},
};
use crate::kernel::{Solid, Tolerance};

/// The bodies of a solid, each a closed shell with its voids; an edge that two faces have in common stands once. The
/// models, each with its faces.
pub(super) fn models(
    item: &Item,
    solid: &Solid,
    job: &Job,
    file: &mut Records,
) -> Result<Vec<(Id, Vec<Id>)>, ExportError> {
    let ExactSolid { carriers, topology, bodies } = exact_solid(item, solid, job)?;
    let vertices: Vec<Id> = topology.vertices.iter().map(|&at| vertex(at, file)).collect();
    let edges = topology.edges.iter();
    let edges = edges.map(|edge| edge_curve(&edge.curve, edge.vertices.map(|i| vertices[i]), file));
    let edges: Vec<Id> = edges.collect();
    let mut faces: Vec<Vec<Id>> = Vec::with_capacity(carriers.len());
    for (surface, parts) in carriers.iter().zip(&topology.loops) {
        let same = Tolerance::DEFAULT.with_distance(job.precision);
        let same = same.distance_for(surface.bounds().diagonal());
        let carrier = carrier(&item.name, surface, same, file);
        let mut of_face = Vec::with_capacity(parts.len());
        for loops in parts {
            let step = |&(edge, is_along): &(usize, bool)| {
                let [from, to] = topology.edges[edge].vertices.map(|i| vertices[i]);
                let ends = if is_along { [from, to] } else { [to, from] };
                LoopStep { edge: edges[edge], is_along, ends }
            };
            let steps = loops.iter().map(|steps| steps.iter().map(step).collect());
            let steps: Vec<Vec<LoopStep>> = steps.collect();
            let bounds = bounds(&steps, &carrier, file);
            of_face.push(face(&item.name, &bounds, &carrier, file));
        }
        faces.push(of_face);
    }
    let mut models = Vec::with_capacity(bodies.len());
    for body in bodies {
        let of_shell = |shell: &[usize]| -> Vec<Id> {
            shell.iter().flat_map(|&face| faces[face].iter().copied()).collect()
        };
        let outer = closed_shell(&of_shell(&body.outer), file);
        let mut of_body = of_shell(&body.outer);
        let mut voids = Vec::with_capacity(body.voids.len());
        for void in &body.voids {
            let shell = closed_shell(&of_shell(void), file);
            voids.push(file.add(|r| {
                r.text("ORIENTED_CLOSED_SHELL('',*,").id(shell).text(",.T.)");
            }));
            of_body.extend(of_shell(void));
        }
        let model = file.add(|r| {
            let kind = if voids.is_empty() { "MANIFOLD_SOLID_BREP" } else { "BREP_WITH_VOIDS" };
            r.text(kind).text("(").string(&item.name).text(",").id(outer);
            if !voids.is_empty() {
                r.text(",").ids(&voids);
            }
            r.text(")");
        });
        models.push((model, of_body));
    }
    Ok(models)
}

fn closed_shell(faces: &[Id], file: &mut Records) -> Id {
    file.add(|r| {
        r.text("CLOSED_SHELL('',").ids(faces).text(")");
    })
}
