//! How large something is: exact integrals of the kernel; of meshes sums over their triangles.

use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::{
    Answer, Known,
    answers::{Units, with_unit},
    ceilings::within_ceilings,
    keys_of,
    scene::Shape,
};
use crate::{
    kernel::{Curve, Face, Mesh, Surface, Tolerance, signed_volume},
    limits::stack,
    session::{Report, Session},
};

/// The length of curves, the area of surfaces and meshes, the volume that they enclose.
pub(crate) fn measure(body: &Json, known: &Known, session: &Session) -> Answer {
    let keys = keys_of(&body["items"])?;
    let (mut shapes, mut report) = (Vec::new(), None);
    for key in keys {
        let (item, its) = known.item(key).ok_or("an item is not known any more")?;
        shapes.push(item.piece.shape.clone());
        report = report.or(its);
    }
    let report = report.ok_or("there is no model yet")?;
    let sizes = Sizes { session, tolerance: report.document.1 };
    let kind = body["kind"].as_str().unwrap_or_default();
    // Functions of the script need the stack of an evaluation.
    let value = stack::with(session.limits().stack_bytes, |_| match kind {
        "length" => sizes.length(&shapes),
        "area" => sizes.area(&shapes),
        "volume" => sizes.volume(&shapes),
        _ => Err("`kind` must be \"length\", \"area\" or \"volume\"".to_owned()),
    })?;
    Ok(json!({ "value": value, "text": with_unit(value, &unit(kind, report)) }))
}

fn unit(kind: &str, report: &Report) -> String {
    let units = Units::of(report);
    match kind {
        "area" => units.area(),
        "volume" => units.volume(),
        _ => units.length(),
    }
}

struct Sizes<'a> {
    session: &'a Session,
    tolerance: Tolerance,
}

impl Sizes<'_> {
    fn length(&self, shapes: &[Shape]) -> Result<f64, String> {
        let length = |curve: &Curve| within_ceilings(self.session, || curve.length(curve.domain()));
        let border =
            |face: &Face| within_ceilings(self.session, || face.border_length(self.tolerance));
        let lengths = shapes.iter().map(|shape| match shape {
            Shape::Curve(curve) => length(curve),
            Shape::Curves(curves) => curves.iter().map(length).sum(),
            Shape::Face(face) => border(face),
            shape => Err(format!("a {} has no length", shape.kind())),
        });
        lengths.sum()
    }

    fn area(&self, shapes: &[Shape]) -> Result<f64, String> {
        let session = self.session;
        let area =
            |surface: &Surface| within_ceilings(session, || surface.area()).map(|(area, _)| area);
        let areas = shapes.iter().map(|shape| match shape {
            Shape::Surface(surface) => area(surface),
            Shape::Surfaces(surfaces) => surfaces.iter().map(area).sum(),
            Shape::Face(face) => within_ceilings(session, || face.mass()).map(|mass| mass.amount),
            Shape::Mesh(mesh) => within_ceilings(session, || mesh.measured_area()),
            Shape::Region(region, _) => Ok(region.mass().amount),
            shape => Err(format!("a {} has no area", shape.kind())),
        });
        areas.sum()
    }

    /// The volume of all surfaces together, or of all meshes.
    fn volume(&self, shapes: &[Shape]) -> Result<f64, String> {
        let session = self.session;
        if let Some(shape) = shapes.iter().find(|shape| {
            !matches!(shape, Shape::Mesh(_) | Shape::Face(_)) && shape.surfaces().is_empty()
        }) {
            let what = if let Shape::Region(..) = shape { "region" } else { shape.kind() };
            return Err(format!("a {what} encloses no volume"));
        }
        let surfaces: Vec<Surface> = shapes.iter().flat_map(Shape::surfaces).cloned().collect();
        let meshes: Vec<&Mesh> = shapes
            .iter()
            .filter_map(|shape| if let Shape::Mesh(mesh) = shape { Some(&**mesh) } else { None })
            .collect();
        let faces = shapes.iter().filter_map(Shape::face);
        let mut faces: Vec<Face> = faces.cloned().collect();
        let are_parts = !faces.is_empty();
        if (!surfaces.is_empty() || are_parts) && !meshes.is_empty() {
            return Err("surfaces and meshes enclose no volume together".to_owned());
        }
        if are_parts {
            return within_ceilings(session, || {
                for surface in &surfaces {
                    faces.push(Face::whole(Arc::clone(surface.nurbs()?), self.tolerance)?);
                }
                Face::enclosed_volume(&faces, self.tolerance)
            })
            .map(|(volume, _)| volume);
        }
        if meshes.is_empty() {
            return within_ceilings(session, || signed_volume(&surfaces, self.tolerance))
                .map(|found| found.amount);
        }
        let volume = |mesh: &&Mesh| {
            within_ceilings(session, || {
                mesh.check_solid(self.tolerance)?;
                mesh.measured_volume()
            })
        };
        meshes.iter().map(volume).sum()
    }
}
