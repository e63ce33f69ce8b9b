//! IGES: exact B-spline curves (126) and surfaces (128), parts of surfaces (144), points (116), with names,
//! colours and layers, in the document's unit.
//!
//! US Product Data Association, *Initial Graphics Exchange Specification 5.3*, §2.2 (fixed
//! format), §4.23, §4.24, §4.4 (composite curve), §4.34, §4.36 (trimmed surface), §4.18, §4.72 (colour), §4.98 (properties).

mod record;

use std::io::Write;

use glam::DVec3;

use self::record::{Cards, Entity};
use super::{
    ExportError, Format, Item, Job, Subject, Summary,
    exact::{Exact, exact},
    options::TOLERANCE,
    unique_values::UniqueValues,
};
use crate::kernel::{Bounds, FaceEdge, FaceError, NurbsCurve, NurbsSurface};

pub(super) static FORMAT: Format = Format {
    ending: "igs",
    aliases: &["iges"],
    title: "IGES 5.3: exact curves and surfaces in the document's unit",
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
    let mut summary = Summary::default();
    let (mut cards, mut looks) = (Cards::default(), IgesPresentation::default());
    for item in &job.items {
        for part in exact(item, job)? {
            let entity = match part {
                Exact::Point(point) => {
                    let mut entity = Entity::new(116);
                    point.to_array().into_iter().for_each(|x| entity.real(x));
                    entity.int(0);
                    entity
                }
                Exact::Curve(curve) => curve_entity(&curve),
                Exact::Surface(surface) => surface_entity(&surface),
                Exact::Face(surface, parts) => {
                    let carrier = cards.add(dependent(surface_entity(&surface)));
                    for loops in parts {
                        if let Some(point) = touch(&surface, &loops, job.precision) {
                            return Err(touching(item, point));
                        }
                        looks.add(item, trimmed(carrier, &loops, &mut cards), &mut cards);
                    }
                    continue;
                }
            };
            looks.add(item, entity, &mut cards);
        }
        summary.count(&item.subject);
    }
    let bounds = super::whole(&job.items);
    cards.write(&global(job, bounds.map_or(0.0, Bounds::magnitude)), out)?;
    Ok(summary)
}

/// Colours, layers and names that have an entity already.
#[derive(Default)]
struct IgesPresentation {
    colors: UniqueValues<[u8; 3], usize>,
    layers: UniqueValues<String, ()>,
}

impl IgesPresentation {
    /// Adds an entity with the look and the name of its item.
    fn add(&mut self, item: &Item, mut entity: Entity, cards: &mut Cards) {
        if let Some(color) = item.color {
            entity.color = *self.colors.entry(&color, || definition(color, cards)).1;
        }
        if let Some(layer) = &item.layer {
            let n_before = self.layers.pairs().len();
            let (place, ()) = self.layers.entry(layer, || level(layer, n_before + 1, cards));
            entity.level = 1 + place;
        }
        let mut name = Entity::new(406);
        name.form = 15;
        name.status = "00010000";
        name.int(1);
        name.string(&item.name);
        let name = cards.add(name);
        // No associativity, one property.
        entity.int(0);
        entity.int(1);
        entity.int(name);
        entity.label = item.name.clone();
        cards.add(entity);
    }
}

fn curve_entity(curve: &NurbsCurve) -> Entity {
    let (points, knots) = (curve.points(), curve.knots().as_slice());
    let mut entity = Entity::new(126);
    entity.int(points.len() - 1);
    entity.int(curve.degree());
    // Not said to be planar; closed; polynomial; not periodic.
    entity.int(0);
    entity.int(usize::from(curve.start() == curve.end()));
    entity.int(usize::from(!curve.is_rational()));
    entity.int(0);
    knots.iter().for_each(|&knot| entity.real(knot));
    curve.weights().into_iter().for_each(|weight| entity.real(weight));
    points.iter().flat_map(glam::DVec3::to_array).for_each(|x| entity.real(x));
    let domain = curve.domain();
    [domain.start(), domain.end(), 0.0, 0.0, 1.0].into_iter().for_each(|x| entity.real(x));
    entity
}

fn surface_entity(surface: &NurbsSurface) -> Entity {
    let (points, weights) = (surface.points(), surface.weights());
    let mut entity = Entity::new(128);
    entity.int(points.n_rows() - 1);
    entity.int(points.n_columns() - 1);
    entity.int(surface.degree_u());
    entity.int(surface.degree_v());
    entity.int(usize::from(surface.is_closed_u(0.0)));
    entity.int(usize::from(surface.is_closed_v(0.0)));
    entity.int(usize::from(!surface.is_rational()));
    entity.int(0);
    entity.int(0);
    surface.knots_u().as_slice().iter().for_each(|&knot| entity.real(knot));
    surface.knots_v().as_slice().iter().for_each(|&knot| entity.real(knot));
    // The first index runs fastest.
    weights.transposed().iter().for_each(|&weight| entity.real(weight));
    points.transposed().iter().flat_map(glam::DVec3::to_array).for_each(|x| entity.real(x));
    for domain in [surface.domain_u(), surface.domain_v()] {
        entity.real(domain.start());
        entity.real(domain.end());
    }
    entity
}

/// The same as a part of another entity.
fn dependent(mut entity: Entity) -> Entity {
    entity.status = "00010000";
    entity
}

/// A part of a surface within loops, the outer one first (144), each a curve on the surface (142) by its parameters
/// and in space.
fn trimmed(carrier: usize, loops: &[Vec<FaceEdge>], cards: &mut Cards) -> Entity {
    let boundary = |edges: &Vec<FaceEdge>, cards: &mut Cards| {
        let by_parameters = edges.iter().map(|edge| &edge.parameters).collect::<Vec<_>>();
        let in_space = edges.iter().filter_map(|edge| edge.curve.as_ref()).collect::<Vec<_>>();
        let by_parameters = composite(&by_parameters, "00010500", cards);
        let in_space = composite(&in_space, "00010000", cards);
        let mut boundary = dependent(Entity::new(142));
        // How it was made is not said; both representations are as good.
        [0, carrier, by_parameters, in_space, 3].into_iter().for_each(|n| boundary.int(n));
        cards.add(boundary)
    };
    let loops: Vec<usize> = loops.iter().map(|edges| boundary(edges, cards)).collect();
    let mut entity = Entity::new(144);
    entity.int(carrier);
    entity.int(1);
    entity.int(loops.len() - 1);
    loops.into_iter().for_each(|boundary| entity.int(boundary));
    entity
}

/// A place in which two loops touch: both have a vertex there, on the same side of a seam.
fn touch(surface: &NurbsSurface, loops: &[Vec<FaceEdge>], precision: f64) -> Option<DVec3> {
    let vertices = loops.iter().enumerate().flat_map(|(number, edges)| {
        let with_place = edges.iter().filter(|edge| edge.curve.is_some());
        with_place.map(move |edge| {
            let place = edge.parameters.start();
            (surface.point_at(place.x, place.y), place, number)
        })
    });
    let mut vertices: Vec<(DVec3, DVec3, usize)> = vertices.collect();
    vertices.sort_by(|a, b| a.0.x.total_cmp(&b.0.x));
    let half = [surface.domain_u(), surface.domain_v()].map(|domain| 0.5 * domain.length());
    vertices.iter().enumerate().find_map(|(i, &(point, place, number))| {
        let mut beside =
            vertices[i + 1..].iter().take_while(|other| other.0.x <= point.x + precision);
        let is_touch = |&(other, its, its_number): &(DVec3, DVec3, usize)| {
            let apart = (its - place).abs();
            its_number != number
                && other.distance(point) <= precision
                && apart.x < half[0]
                && apart.y < half[1]
        };
        beside.any(is_touch).then_some(point)
    })
}

/// The format keeps loops apart: each has vertices of its own, so that those that touch would cross for whoever reads them.
fn touching(item: &Item, point: DVec3) -> ExportError {
    let touches = FaceError::TouchesItself { point };
    let problem = format!(
        "cannot be written as .igs: {touches}, where it would cross itself; write .step, or move one of its loops by more than the tolerance"
    );
    ExportError::Unfit { name: item.name.clone(), problem }
}

/// Curves that follow one another, as one (102).
fn composite(curves: &[&NurbsCurve], status: &'static str, cards: &mut Cards) -> usize {
    let mut add = |curve: &NurbsCurve| {
        let mut entity = curve_entity(curve);
        entity.status = status;
        cards.add(entity)
    };
    if let [curve] = curves {
        return add(curve);
    }
    let parts: Vec<usize> = curves.iter().map(|curve| add(curve)).collect();
    let mut entity = Entity::new(102);
    entity.status = status;
    entity.int(parts.len());
    parts.into_iter().for_each(|part| entity.int(part));
    cards.add(entity)
}

/// The parameters of the global section. No date: the same script gives the same bytes.
fn global(job: &Job, magnitude: f64) -> Entity {
    let (flag, unit) = match job.unit {
        "in" => (1, "IN"),
        "ft" => (4, "FT"),
        "m" => (6, "M"),
        "km" => (7, "KM"),
        "um" => (9, "UM"),
        "cm" => (10, "CM"),
        _ => (2, "MM"),
    };
    let name = job.items.first().map_or("virote", |item| &item.group);
    let mut global = Entity::new(0);
    global.string(",");
    global.string(";");
    global.string(name);
    global.string(&format!("{name}.igs"));
    global.string("virote");
    global.string("virote");
    // Bits of an integer, and decimal powers and digits of single and double precision.
    [32, 38, 6, 308, 15].into_iter().for_each(|n| global.int(n));
    global.string(name);
    global.real(1.0);
    global.int(flag);
    global.string(unit);
    global.int(1);
    global.real(job.precision);
    global.string("19700101.000000");
    global.real(job.precision);
    global.real(magnitude);
    global.string("");
    global.string("");
    // Version 5.3, no drafting standard.
    global.int(11);
    global.int(0);
    global.string("19700101.000000");
    global
}

/// The definition of a colour, in hundredths.
fn definition(color: [u8; 3], cards: &mut Cards) -> usize {
    let mut definition = Entity::new(314);
    color.into_iter().for_each(|level| definition.real(f64::from(level) / 2.55));
    definition.status = "00000200";
    cards.add(definition)
}

/// The name of a level.
fn level(name: &str, number: usize, cards: &mut Cards) {
    let mut property = Entity::new(406);
    property.form = 3;
    property.int(2);
    property.int(number);
    property.string(name);
    cards.add(property);
}
