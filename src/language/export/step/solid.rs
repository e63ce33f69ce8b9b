//! Solids. ISO 10303-42, §5.4 and §6.4.

use super::{
    super::{
        ExportError, Item, Job,
        exact::{ExactSolid, exact_solid},
    },
    bound::{LoopStep, bounds},
    entity::{Id, Records},
    pcurve::{EdgeSide, edge_curve},
    shape::{Carrier, carrier, face, vertex},
};
use crate::kernel::{NurbsSurface, Solid, SolidStep, SolidTopology, Tolerance};

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
    let same = |surface: &NurbsSurface| {
        let same = Tolerance::DEFAULT.with_distance(job.precision);
        same.distance_for(surface.bounds().diagonal())
    };
    let carriers = carriers.iter().map(|surface| carrier(&item.name, surface, same(surface), file));
    let carriers: Vec<Carrier<'_>> = carriers.collect();
    let edges = edge_curves(item, &topology, &carriers, &vertices, job.precision, file)?;
    let mut faces: Vec<Vec<Id>> = Vec::with_capacity(carriers.len());
    for (carrier, parts) in carriers.iter().zip(&topology.loops) {
        let mut of_face = Vec::with_capacity(parts.len());
        for loops in parts {
            let step = |&SolidStep { edge, is_along, .. }: &SolidStep| {
                let [from, to] = topology.edges[edge].vertices.map(|i| vertices[i]);
                let ends = if is_along { [from, to] } else { [to, from] };
                LoopStep { edge: edges[edge], is_along, ends }
            };
            let steps = loops.iter().map(|steps| steps.iter().map(step).collect());
            let steps: Vec<Vec<LoopStep>> = steps.collect();
            let bounds = bounds(&steps, carrier, file);
            of_face.push(face(&item.name, &bounds, carrier, file));
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

/// The edges with their curves of parameters on the faces beside them.
fn edge_curves(
    item: &Item,
    topology: &SolidTopology,
    carriers: &[Carrier<'_>],
    vertices: &[Id],
    precision: f64,
    file: &mut Records,
) -> Result<Vec<Id>, ExportError> {
    let mut sides: Vec<Vec<EdgeSide<'_>>> = topology.edges.iter().map(|_| Vec::new()).collect();
    for (carrier, parts) in carriers.iter().zip(&topology.loops) {
        for step in parts.iter().flatten().flatten() {
            let arc = &step.parameters;
            let arc = if step.is_along { arc.clone() } else { arc.reversed() };
            sides[step.edge].push(EdgeSide { carrier, arc });
        }
    }
    let written = topology.edges.iter().zip(&sides).map(|(edge, sides)| {
        let ends = edge.vertices.map(|i| vertices[i]);
        let blame = |source| ExportError::Geometry { name: item.name.clone(), source };
        edge_curve(&edge.curve, ends, sides, precision, file).map_err(blame)
    });
    written.collect()
}

fn closed_shell(faces: &[Id], file: &mut Records) -> Id {
    file.add(|r| {
        r.text("CLOSED_SHELL('',").ids(faces).text(")");
    })
}
