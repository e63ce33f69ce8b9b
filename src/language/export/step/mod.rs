//! STEP: exact curves and surfaces, in the document's unit, with names, colours and layers.
//!
//! ISO 10303-214 (AP214), a part for each definition: surfaces as faces of open shells, whose edges
//! are their border lines, parts of surfaces as faces within their loops, solids as closed shells whose
//! faces share their edges, curves and points as a set. What is a line, circle, plane, cylinder, cone,
//! sphere or torus is written as that, all else as B-splines. `entity` writes records of
//! ISO 10303-21, `shape` those of topology and B-splines, `pcurve` edges by the parameters of their surfaces, `bound` what bounds faces, `face` parts of surfaces, `solid` bodies, `form` those of geometry with an equation
//! (both ISO 10303-42), `style` colours and layers (ISO 10303-46).

mod bound;
mod entity;
mod face;
mod form;
mod pcurve;
mod place;
mod shape;
mod solid;
mod style;

use std::io::Write;

use self::entity::{Id, Records};
use super::{
    ExportError, Format, Item, Job, Subject, Summary,
    exact::{Exact, exact},
    options::TOLERANCE,
};
use crate::kernel::Frame;

pub(super) static FORMAT: Format = Format {
    ending: "step",
    aliases: &["stp"],
    title: "STEP (AP214): exact curves and surfaces in the document's unit",
    options: &[&TOLERANCE],
    takes: |subject| {
        matches!(
            subject,
            Subject::Point(_)
                | Subject::Curve(_)
                | Subject::Surface(_)
                | Subject::Face(_)
                | Subject::Solid(_)
        )
    },
    takes_data: false,
    is_of_meshes: false,
    wants: "points, curves, surfaces, regions, faces and solids",
    write,
};

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let mut file = Records::new();
    let mut summary = Summary::default();
    head(job, &mut file);
    let document = StepDocument::new(job, &mut file);
    let mut looks = style::StepPresentation::default();
    let mut items = &job.items[..];
    while let Some(first) = items.first() {
        // What stands together under one name is one part.
        let n = items.iter().take_while(|item| item.group == first.group).count();
        let (members, rest) = items.split_at(n);
        document.part(members, job, &mut file, &mut looks, out)?;
        members.iter().for_each(|item| summary.count(&item.subject));
        items = rest;
    }
    looks.write(document.context, &mut file);
    file.text.push("ENDSEC;\nEND-ISO-10303-21;\n");
    file.text.flush(out)?;
    Ok(summary)
}

/// No date: the same script gives the same bytes.
fn head(job: &Job, file: &mut Records) {
    let name = job.items.first().map_or("", |item| &item.group);
    file.text.push("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('virote'),'2;1');\nFILE_NAME(");
    file.string(name);
    file.text.push(",'1970-01-01T00:00:00',(''),(''),'virote','virote','');\n");
    file.text
        .push("FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n");
}

/// What all parts share.
struct StepDocument {
    /// Of products, and of their definitions.
    product: Id,
    definition: Id,
    /// Units and precision.
    context: Id,
    /// The origin.
    placement: Id,
}

impl StepDocument {
    fn new(job: &Job, file: &mut Records) -> Self {
        let application = file.add(|r| {
            r.text("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        });
        file.add(|r| {
            r.text("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,")
                .id(application)
                .text(")");
        });
        let product = file.add(|r| {
            r.text("PRODUCT_CONTEXT('',").id(application).text(",'mechanical')");
        });
        let definition = file.add(|r| {
            r.text("PRODUCT_DEFINITION_CONTEXT('part definition',")
                .id(application)
                .text(",'design')");
        });
        let context = context(job, file);
        let placement = place::placement(Frame::XY, file);
        Self { product, definition, context, placement }
    }

    /// A part under the name of a definition.
    fn part(
        &self,
        members: &[Item],
        job: &Job,
        file: &mut Records,
        looks: &mut style::StepPresentation,
        out: &mut dyn Write,
    ) -> Result<(), ExportError> {
        let (mut models, mut solids, mut set) = (Vec::new(), Vec::new(), Vec::new());
        for item in members {
            if let Subject::Solid(given) = &item.subject {
                for (model, faces) in solid::models(item, given, job, file)? {
                    looks.surface(item, &faces, model, file);
                    solids.push(model);
                }
                file.text.flush_if_large(out)?;
                continue;
            }
            for part in exact(item, job)? {
                match part {
                    Exact::Surface(surface) => {
                        let (model, face) = shape::model(item, &surface, job, file)?;
                        looks.surface(item, &[face], model, file);
                        models.push(model);
                    }
                    Exact::Face(surface, parts) => {
                        let (model, faces) = face::model(item, &surface, &parts, job, file)?;
                        looks.surface(item, &faces, model, file);
                        models.push(model);
                    }
                    Exact::Curve(curve) => {
                        let id = shape::curve(&item.name, &curve, file);
                        looks.curve(item, id, file);
                        set.push(id);
                    }
                    Exact::Point(point) => {
                        let id = place::point(&item.name, point, file);
                        looks.layer(item, id);
                        set.push(id);
                    }
                }
            }
            file.text.flush_if_large(out)?;
        }
        let name = &members[0].group;
        if !models.is_empty() {
            models.insert(0, self.placement);
            self.product(name, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION", &models, file);
        }
        if !solids.is_empty() {
            solids.insert(0, self.placement);
            self.product(name, "ADVANCED_BREP_SHAPE_REPRESENTATION", &solids, file);
        }
        if !set.is_empty() {
            let set = file.add(|r| {
                r.text("GEOMETRIC_CURVE_SET(").string(name).text(",").ids(&set).text(")");
            });
            let items = [self.placement, set];
            let kind = "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION";
            self.product(name, kind, &items, file);
        }
        Ok(())
    }

    fn product(&self, name: &str, kind: &str, items: &[Id], file: &mut Records) {
        let product = file.add(|r| {
            r.text("PRODUCT(").string(name).text(",").string(name).text(",'',(").id(self.product);
            r.text("))");
        });
        file.add(|r| {
            r.text("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(").id(product).text("))");
        });
        let formation = file.add(|r| {
            r.text("PRODUCT_DEFINITION_FORMATION('','',").id(product).text(")");
        });
        let definition = file.add(|r| {
            r.text("PRODUCT_DEFINITION('design','',").id(formation).text(",").id(self.definition);
            r.text(")");
        });
        let shape = file.add(|r| {
            r.text("PRODUCT_DEFINITION_SHAPE('','',").id(definition).text(")");
        });
        let representation = file.add(|r| {
            r.text(kind).text("(").string(name).text(",").ids(items).text(",").id(self.context);
            r.text(")");
        });
        file.add(|r| {
            r.text("SHAPE_DEFINITION_REPRESENTATION(").id(shape).text(",").id(representation);
            r.text(")");
        });
    }
}

/// Units and precision. ISO 10303-41.
fn context(job: &Job, file: &mut Records) -> Id {
    let length = unit(job, file);
    let angle = file.add(|r| {
        r.text("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    });
    let solid_angle = file.add(|r| {
        r.text("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    });
    let precision = file.add(|r| {
        r.text("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(").real(job.precision).text("),");
        r.id(length).text(",'distance_accuracy_value','confusion accuracy')");
    });
    file.add(|r| {
        r.text("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((")
            .id(precision)
            .text("))GLOBAL_UNIT_ASSIGNED_CONTEXT(")
            .ids(&[length, angle, solid_angle])
            .text(")REPRESENTATION_CONTEXT('',''))");
    })
}

/// The document's unit: one of the metre, or by its millimetres.
fn unit(job: &Job, file: &mut Records) -> Id {
    let metric = |prefix: &str| format!("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({prefix},.METRE.))");
    let (prefix, name) = match job.unit {
        "um" => (".MICRO.", None),
        "cm" => (".CENTI.", None),
        "m" => ("$", None),
        "km" => (".KILO.", None),
        "in" => (".MILLI.", Some("INCH")),
        "ft" => (".MILLI.", Some("FOOT")),
        _ => (".MILLI.", None),
    };
    let base = file.add(|r| {
        r.text(&metric(prefix));
    });
    let Some(name) = name else { return base };
    let measure = file.add(|r| {
        r.text("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(").real(job.millimetres).text("),");
        r.id(base).text(")");
    });
    let dimensions = file.add(|r| {
        r.text("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
    });
    file.add(|r| {
        r.text("(CONVERSION_BASED_UNIT(").string(name).text(",").id(measure);
        r.text(")LENGTH_UNIT()NAMED_UNIT(").id(dimensions).text("))");
    })
}
