//! How far the vertices of one item are from others, for a map of the deviation: by the kernel's nearest
//! places, never by the pictures of the others.

use glam::DVec3;
use serde_json::Value as Json;

use super::{
    Known,
    ceilings::within_ceilings,
    keys_of,
    scene::{EncodedItem, Shape},
    threads::side_by_side,
};
use crate::{
    kernel::{DeviationReference, GeomError, MeshDistance, Surface},
    session::Session,
};

/// Vertices that one thread measures before it looks for more.
const PART: usize = 256;

/// For each vertex of `item` its distance from the nearest place of the items `from`;
/// negative behind surfaces, which is the side that their normals point away from. One of a place that
/// cannot be measured is not a number.
pub(crate) fn deviation(body: &Json, known: &Known, session: &Session) -> Result<Vec<f64>, String> {
    let item = body["item"].as_str().ok_or("`item` must be a key")?;
    let shape = |key: &str| {
        let (item, _) = known.item(key).ok_or("an item is not known any more")?;
        Ok::<_, String>((item.piece.shape.clone(), item.source.clone()))
    };
    let (shape_of_item, source) = shape(item)?;
    let from = keys_of(&body["from"])?;
    let from = from.into_iter().map(shape).collect::<Result<Vec<_>, _>>()?;
    let datums = within_ceilings(session, || datums(from.iter().map(|(shape, _)| shape)))?;
    if datums.is_empty() {
        return Err("a deviation is measured from a surface or a mesh".to_owned());
    }
    let parts = places(&shape_of_item, &source.item(session))?;
    let measured = side_by_side(&parts, session, |part| {
        let distance = |place: &MeasuredVertex| {
            let point = place.point(&shape_of_item)?;
            nearest(point, &datums)
        };
        let all = || part.iter().map(|place| Ok(distance(place).unwrap_or(f64::NAN)));
        within_ceilings(session, || all().collect::<Result<Vec<f64>, GeomError>>())
    });
    let measured = measured.ok_or("it was stopped")?;
    Ok(measured.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
}

/// A vertex of what is measured.
enum MeasuredVertex {
    Point(DVec3),
    /// Of a surface: its parameters, at which it is exact.
    Parameters([f64; 2]),
}

impl MeasuredVertex {
    fn point(&self, shape: &Shape) -> Result<DVec3, GeomError> {
        match (self, shape) {
            (Self::Point(point), _) => Ok(*point),
            (Self::Parameters([u, v]), shape) => {
                let Some(surface) = shape.parametrized() else {
                    unreachable!("only surfaces have parameters")
                };
                let u = surface.domain_u().clamp_inside(*u)?;
                surface.point_at(u, surface.domain_v().clamp_inside(*v)?)
            }
        }
    }
}

/// The vertices of an item in the order of its bytes, in parts.
fn places(shape: &Shape, encoded: &EncodedItem) -> Result<Vec<Vec<MeasuredVertex>>, String> {
    let all: Vec<MeasuredVertex> = match shape {
        Shape::Surface(_) | Shape::Face(_) => {
            let parameters = encoded.parameters().unwrap_or_default();
            parameters.into_iter().map(MeasuredVertex::Parameters).collect()
        }
        Shape::Mesh(mesh) | Shape::Region(_, mesh) => {
            mesh.vertices().iter().copied().map(MeasuredVertex::Point).collect()
        }
        shape => return Err(format!("the deviation of a {} is not measured", shape.kind())),
    };
    let mut parts = Vec::new();
    let mut rest = all.into_iter().peekable();
    while rest.peek().is_some() {
        parts.push(rest.by_ref().take(PART).collect());
    }
    Ok(parts)
}

/// What is measured from; of a surface with its normals.
type Datum<'a> = (DeviationReference<'a>, Option<&'a Surface>);

fn datums<'a>(shapes: impl Iterator<Item = &'a Shape>) -> Result<Vec<Datum<'a>>, GeomError> {
    let mut datums = Vec::new();
    for shape in shapes {
        for surface in shape.surfaces() {
            datums.push((DeviationReference::of_surface(surface)?, Some(surface)));
        }
        if let Shape::Mesh(mesh) | Shape::Region(_, mesh) = shape {
            let distance = MeshDistance::new(mesh).map(DeviationReference::Mesh);
            datums.extend(distance.map(|distance| (distance, None)));
        }
    }
    Ok(datums)
}

/// The distance of a point from the nearest of all, with the side of that surface.
fn nearest(point: DVec3, datums: &[Datum<'_>]) -> Result<f64, GeomError> {
    let mut best = f64::NAN;
    for (reference, surface) in datums {
        let foot = match reference {
            DeviationReference::Surface(surface) => Some(surface.closest(point)),
            DeviationReference::Function(places) => Some(places.closest(point)?),
            DeviationReference::Mesh(_) => None,
        };
        let distance = match &foot {
            Some(foot) => foot.distance,
            None => reference.distance(point)?,
        };
        if best.abs() <= distance {
            continue;
        }
        let normal = foot.zip(*surface).and_then(|(foot, surface)| {
            let [u, v] = foot.parameters;
            Some((foot.point, surface.normal_at(u, v).ok()?))
        });
        let is_behind = normal.is_some_and(|(foot, normal)| normal.dot(point - foot) < 0.0);
        best = if is_behind { -distance } else { distance };
    }
    Ok(best)
}
