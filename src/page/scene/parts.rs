//! What of a definition is seen: its value, taken apart into pieces of geometry.

use std::sync::Arc;

use glam::DVec3;

use crate::{
    kernel::{
        Bounds, Curve, Face, GeomError, Mesh, Region, Surface, Tolerance,
        tolerance::DEFAULT_CHORD_RELATIVE,
    },
    limits::Limits,
    value::Value,
};

/// Pieces of one definition that are items of their own; more are put together.
const MOST_PIECES: usize = 1000;

/// Geometry that is drawn as one item.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    Surface(Surface),
    Face(Arc<Face>),
    Curve(Curve),
    Mesh(Arc<Mesh>),
    /// A region, and the triangles by which it is drawn.
    Region(Arc<Region>, Arc<Mesh>),
    Points(Vec<DVec3>),
    /// Many surfaces of a list.
    Surfaces(Vec<Surface>),
    /// Many curves of a list.
    Curves(Vec<Curve>),
}

/// A piece of a definition.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    /// Its path from the definition on, such as `[2]`; empty for all of it.
    pub(crate) path: String,
    pub(crate) shape: Shape,
    /// The region or solid that it is a part of.
    pub(crate) owner: Option<Owner>,
}

impl Piece {
    fn alone(path: String, shape: Shape) -> Self {
        Self { path, shape, owner: None }
    }
}

/// What the pieces of a region, or of a solid, belong to.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Owner {
    /// Its path from the definition on.
    pub(crate) path: String,
    /// What the language calls its kind.
    pub(crate) kind: &'static str,
}

/// The pieces of a value, in its order.
pub(crate) fn pieces(value: &Value) -> Vec<Piece> {
    let mut found = Vec::new();
    gather(value, "", &mut found);
    if MOST_PIECES < found.len() { together(found) } else { found }
}

fn gather(value: &Value, path: &str, found: &mut Vec<Piece>) {
    let shape = match value {
        Value::Surface(surface) => Shape::Surface(surface.clone()),
        Value::Curve(curve) => Shape::Curve(curve.clone()),
        Value::Region(region) => {
            gather_region(region, path, found);
            return;
        }
        Value::Face(face) => Shape::Face(Arc::clone(face)),
        Value::Solid(solid) => {
            for (i, face) in solid.faces().iter().enumerate() {
                let shape = Shape::Face(Arc::new(face.clone()));
                let owner = Some(Owner { path: path.to_owned(), kind: "solid" });
                found.push(Piece { path: format!("{path}.faces[{i}]"), shape, owner });
            }
            return;
        }
        Value::Mesh(mesh) => Shape::Mesh(Arc::clone(mesh)),
        Value::Point(point) => Shape::Points(vec![*point]),
        Value::List(items) => {
            if let Some(points) = points_of(value) {
                found.push(Piece::alone(path.to_owned(), Shape::Points(points)));
                return;
            }
            for (i, item) in items.values().enumerate() {
                gather(&item, &format!("{path}[{i}]"), found);
            }
            return;
        }
        Value::Record(record) => {
            for (label, member) in record.iter().filter(|(_, member)| has_shape(member)) {
                gather(member, &format!("{path}.{label}"), found);
            }
            return;
        }
        _ => return,
    };
    found.push(Piece::alone(path.to_owned(), shape));
}

/// Part of the usual distance of chords that the triangles of a region keep from its borders, which are drawn smooth.
const FILL_SHARE: f64 = 0.1;

/// The area of a region, and its borders.
fn gather_region(region: &Arc<Region>, path: &str, found: &mut Vec<Piece>) {
    let chord = FILL_SHARE * DEFAULT_CHORD_RELATIVE * region.bounds().diagonal();
    let Ok(mesh) = region.mesh(chord, Tolerance::DEFAULT.distance, Limits::DEFAULT.mesh_vertices)
    else {
        return;
    };
    let owner = || Some(Owner { path: path.to_owned(), kind: "region" });
    let shape = Shape::Region(Arc::clone(region), Arc::new(mesh));
    found.push(Piece { path: path.to_owned(), shape, owner: owner() });
    for (i, border) in region.borders().unwrap_or_default().into_iter().enumerate() {
        let place = match i {
            0 => format!("{path}.outer"),
            _ => format!("{path}.holes[{}]", i - 1),
        };
        found.push(Piece { path: place, shape: Shape::Curve(border.into()), owner: owner() });
    }
}

/// The points of a list of nothing else.
fn points_of(value: &Value) -> Option<Vec<DVec3>> {
    let Value::List(items) = value else { return None };
    let point = |item: Value| if let Value::Point(point) = item { Some(point) } else { None };
    items.values().map(point).collect::<Option<Vec<_>>>().filter(|points| !points.is_empty())
}

/// Whether a member of a record is drawn with it: a point of a record is as often a direction.
fn has_shape(value: &Value) -> bool {
    match value {
        Value::Surface(_)
        | Value::Curve(_)
        | Value::Region(_)
        | Value::Face(_)
        | Value::Solid(_)
        | Value::Mesh(_) => true,
        Value::List(items) => items.values().next().is_some_and(|first| has_shape(&first)),
        _ => false,
    }
}

/// All pieces of a kind as one.
fn together(found: Vec<Piece>) -> Vec<Piece> {
    let (mut points, mut curves, mut surfaces) = (Vec::new(), Vec::new(), Vec::new());
    let mut all = Vec::new();
    for piece in found {
        match piece.shape {
            Shape::Points(more) => points.extend(more),
            Shape::Curve(curve) => curves.push(curve),
            Shape::Surface(surface) => surfaces.push(surface),
            shape => all.push(Piece { shape, ..piece }),
        }
    }
    // Of meshes there is no more than one item can hold either.
    all.truncate(MOST_PIECES);
    let mut add = |is_empty: bool, shape: Shape| {
        if !is_empty {
            all.push(Piece::alone(String::new(), shape));
        }
    };
    add(points.is_empty(), Shape::Points(points));
    add(curves.is_empty(), Shape::Curves(curves));
    add(surfaces.is_empty(), Shape::Surfaces(surfaces));
    all
}

impl Shape {
    /// What the page calls its kind.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Surface(_) | Self::Face(_) => "surface",
            Self::Curve(_) => "curve",
            Self::Mesh(_) | Self::Region(..) | Self::Surfaces(_) => "mesh",
            Self::Points(_) => "points",
            Self::Curves(_) => "polyline",
        }
    }

    /// What the language calls its kind.
    pub(crate) fn form(&self) -> &'static str {
        match self {
            Self::Surface(_) => "surface",
            Self::Surfaces(_) => "surfaces",
            Self::Face(_) => "face",
            Self::Curve(_) => "curve",
            Self::Curves(_) => "curves",
            Self::Mesh(_) => "mesh",
            Self::Region(..) => "region",
            Self::Points(points) if points.len() == 1 => "point",
            Self::Points(_) => "points",
        }
    }

    /// Whether triangles are made of it.
    pub(crate) fn is_tessellated(&self) -> bool {
        matches!(self, Self::Face(_)) || !self.surfaces().is_empty()
    }

    /// The part of a surface that it is.
    pub(crate) fn face(&self) -> Option<&Face> {
        if let Self::Face(face) = self { Some(face) } else { None }
    }

    /// The surface on which it has parameters.
    pub(crate) fn parametrized(&self) -> Option<Surface> {
        match self {
            Self::Surface(surface) => Some(surface.clone()),
            Self::Face(face) => Some(Surface::Nurbs(Arc::clone(face.surface()))),
            _ => None,
        }
    }

    /// The surfaces of it.
    pub(crate) fn surfaces(&self) -> &[Surface] {
        match self {
            Self::Surface(surface) => std::slice::from_ref(surface),
            Self::Surfaces(surfaces) => surfaces,
            _ => &[],
        }
    }

    /// The box around it, if it has an end.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        let whole = |all: &mut dyn Iterator<Item = Result<Bounds, GeomError>>| {
            all.filter_map(Result::ok).reduce(Bounds::union)
        };
        let bounds = match self {
            Self::Surface(_) | Self::Surfaces(_) => {
                whole(&mut self.surfaces().iter().map(Surface::bounds))
            }
            Self::Face(face) => face.bounds(Tolerance::DEFAULT).ok(),
            Self::Curve(curve) => curve.bounds().ok(),
            Self::Curves(curves) => whole(&mut curves.iter().map(Curve::bounds)),
            Self::Mesh(mesh) | Self::Region(_, mesh) => mesh.bounds(),
            Self::Points(points) => Bounds::of(points.iter().copied()),
        };
        bounds.filter(|bounds| bounds.diagonal().is_finite())
    }
}
