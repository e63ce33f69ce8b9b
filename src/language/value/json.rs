//! Values as exact JSON, and back.
//!
//! Numbers, truths, texts, lists and records are JSON's own. Whatever JSON lacks is an object
//! with a `virote` member that names its kind; rational control points are kept homogeneous, so
//! that no division loses a bit.

use std::sync::Arc;

use glam::{DVec2, DVec3, DVec4};
use serde_json::{Map, Value as Json, json};

use super::{ENDED, Number, Range, Record, Value, in_document_unit};
use crate::{
    kernel::{
        Column, Curve, Face, FacePart, Frame, Grid, KnotVector, Mesh, MeshGroup, NamedColumn,
        NurbsCurve, NurbsSurface, Region, Solid, Surface, Table, Tolerance,
    },
    limits::work,
};

/// The value as exact JSON; functions as their signature, what is made of functions as its kind.
#[must_use]
pub fn to_json(value: &Value) -> Json {
    match value {
        Value::None => Json::Null,
        Value::Bool(truth) => json!(truth),
        Value::Number(number) => number_json(*number),
        Value::Text(text) => json!(**text),
        Value::Jet(_)
        | Value::JetPoint(_)
        | Value::JetRange(_)
        | Value::JetCurve(_)
        | Value::JetSurface(_)
        | Value::JetRegion(_)
        | Value::JetSolid(_) => to_json(&value.looked_at()),
        Value::Point(point) => json!({ "virote": "point", "xyz": point.to_array() }),
        Value::List(items) => Json::Array(items.iter().map(to_json).collect()),
        Value::Range(range) => json!({
            "virote": "range",
            "start": number_json(range.start),
            "end": number_json(range.end),
            "closed": range.closed,
        }),
        Value::Record(record) => Json::Object(
            record.iter().map(|(label, value)| (label.to_owned(), to_json(value))).collect(),
        ),
        Value::Function(function) => {
            json!({ "virote": "function", "signature": function.signature() })
        }
        Value::Curve(Curve::Parametric(_)) | Value::Surface(Surface::Parametric(_)) => {
            json!({ "virote": format!("parametric {}", value.kind()) })
        }
        Value::Curve(Curve::Nurbs(curve)) => curve_json(curve),
        Value::Surface(Surface::Nurbs(surface)) => surface_json(surface),
        Value::Region(region) => json!({
            "virote": "region",
            "origin": region.frame().origin().to_array(),
            "x": region.frame().x().to_array(),
            "z": region.frame().z().to_array(),
            "borders": region.arcs().map(|arcs| arcs.iter().map(curve_json).collect()).collect::<Vec<Json>>(),
        }),
        Value::Face(face) => face_json(face),
        Value::Solid(solid) => json!({
            "virote": "solid",
            "faces": solid.faces().iter().map(face_json).collect::<Json>(),
        }),
        Value::Mesh(mesh) => mesh_json(mesh),
        Value::Table(table) => {
            json!({ "virote": "table", "columns": table.columns().iter().map(column).collect::<Vec<_>>() })
        }
        Value::Frame(frame) => json!({
            "virote": if frame.is_of_curve() { "frame" } else { "plane" },
            "origin": frame.origin().to_array(),
            "x": frame.x().to_array(),
            "z": frame.z().to_array(),
        }),
    }
}

fn face_json(face: &Face) -> Json {
    let arcs = |arcs: &Vec<NurbsCurve>| arcs.iter().map(curve_json).collect::<Json>();
    let part = |part: FacePart| part.loops.iter().map(arcs).collect::<Json>();
    json!({
        "virote": "face",
        "surface": surface_json(face.surface()),
        "parts": face.parts().into_iter().map(part).collect::<Json>(),
    })
}

fn curve_json(curve: &NurbsCurve) -> Json {
    json!({
        "virote": "curve",
        "degree": curve.degree(),
        "knots": curve.knots().as_slice(),
        "homogeneous": homogeneous(curve.control_points()),
    })
}

fn surface_json(surface: &NurbsSurface) -> Json {
    let net = surface.control_points();
    let rows: Vec<Json> = (0..net.n_rows()).map(|i| homogeneous(net.row(i))).collect();
    json!({
        "virote": "surface",
        "degree_u": surface.degree_u(),
        "degree_v": surface.degree_v(),
        "knots_u": surface.knots_u().as_slice(),
        "knots_v": surface.knots_v().as_slice(),
        "homogeneous": rows,
    })
}

fn mesh_json(mesh: &Mesh) -> Json {
    let mut json = json!({
        "virote": "mesh",
        "vertices": arrays(mesh.vertices()),
        "normals": arrays(mesh.normals()),
        "uvs": mesh.uvs().iter().map(|uv| json!(uv.to_array())).collect::<Vec<_>>(),
        "triangles": mesh.triangles(),
    });
    if !mesh.colors().is_empty() {
        json["colors"] = arrays(mesh.colors());
    }
    if !mesh.face_sizes().is_empty() {
        json["face_sizes"] = json!(mesh.face_sizes());
    }
    if !mesh.groups().is_empty() {
        let group =
            |group: &MeshGroup| json!({ "name": group.name, "triangles": group.n_triangles });
        json["groups"] = mesh.groups().iter().map(group).collect();
    }
    json
}

fn number_json(number: Number) -> Json {
    if number.dim.is_angle() {
        json!({ "virote": "angle", "radians": number.value })
    } else {
        json!(number.value)
    }
}

fn homogeneous(points: &[DVec4]) -> Json {
    Json::Array(points.iter().map(|point| json!(point.to_array())).collect())
}

fn arrays(points: &[DVec3]) -> Json {
    Json::Array(points.iter().map(|point| json!(point.to_array())).collect())
}

fn column(column: &NamedColumn) -> Json {
    let values = match &column.column {
        Column::Numbers(values) => json!(values),
        Column::Texts(values) => json!(values),
    };
    json!({ "name": column.name, "unit": column.unit, "values": values })
}

/// The value that exact JSON stands for; of a whole document the record of its values.
///
/// Columns of tables that state their unit are brought into that of the document, `length`.
///
/// # Errors
/// A sentence on the member that does not fit.
pub fn from_json(json: &Json, length: &str) -> Result<Value, String> {
    Ok(match json {
        Json::Null => Value::None,
        Json::Bool(truth) => Value::Bool(*truth),
        Json::Number(number) => {
            let value = number.as_f64().filter(|value| value.is_finite());
            let value = value.ok_or_else(|| format!("the number {number} is out of range"))?;
            Value::Number(Number::open(value))
        }
        Json::String(text) => Value::text(text),
        Json::Array(items) => {
            let mut values = Vec::new();
            for item in items {
                if !work::push(&mut values, from_json(item, length)?) {
                    return Err(ENDED.to_owned());
                }
            }
            // A list is a copy.
            if !work::has_room(values.len() * size_of::<Value>()) {
                return Err(ENDED.to_owned());
            }
            Value::list(values)
        }
        Json::Object(members) => match members.get("virote").and_then(Json::as_str) {
            Some(kind) => Object { kind, members, length }.value()?,
            None => record(members, length)?,
        },
    })
}

fn record(members: &Map<String, Json>, length: &str) -> Result<Value, String> {
    let mut fields = Vec::with_capacity(members.len());
    for (label, member) in members {
        fields.push((Arc::from(label.as_str()), from_json(member, length)?));
    }
    Ok(Value::Record(Arc::new(Record::new(fields))))
}

/// An object that stands for a value of a named kind.
struct Object<'j> {
    kind: &'j str,
    members: &'j Map<String, Json>,
    /// The document's unit of length.
    length: &'j str,
}

impl<'j> Object<'j> {
    fn member(&self, name: &str) -> Result<&'j Json, String> {
        self.members.get(name).ok_or_else(|| format!("the {} has no `{name}`", self.kind))
    }

    /// What `read` makes of a member; else that the member is wrong.
    fn read<T>(&self, name: &str, read: impl Fn(&Json) -> Option<T>) -> Result<T, String> {
        read(self.member(name)?)
            .ok_or_else(|| format!("`{name}` of the {} is not what it should be", self.kind))
    }

    fn number(&self, name: &str) -> Result<Number, String> {
        self.read(name, |json| match from_json(json, self.length) {
            Ok(Value::Number(number)) => Some(number),
            _ => None,
        })
    }

    fn point(&self, name: &str) -> Result<DVec3, String> {
        self.read(name, |json| <[f64; 3]>::try_from(numbers(json)?).ok().map(DVec3::from))
    }

    fn knots(&self, degree: &str, knots: &str) -> Result<KnotVector, String> {
        let degree = self.read(degree, |json| usize::try_from(json.as_u64()?).ok())?;
        KnotVector::new(degree, self.read(knots, numbers)?).map_err(|err| err.to_string())
    }

    fn curve(&self) -> Result<NurbsCurve, String> {
        let points = self.read("homogeneous", homogeneous_points)?;
        NurbsCurve::new(self.knots("degree", "knots")?, points).map_err(|err| err.to_string())
    }

    fn surface(&self) -> Result<NurbsSurface, String> {
        let rows = self.read("homogeneous", |json| each(json, homogeneous_points))?;
        let net = Grid::from_rows(rows).map_err(|err| err.to_string())?;
        let knots_u = self.knots("degree_u", "knots_u")?;
        let knots_v = self.knots("degree_v", "knots_v")?;
        NurbsSurface::new(knots_u, knots_v, net).map_err(|err| err.to_string())
    }

    /// The arcs of borders: lists of lists of curves.
    fn borders(&self, json: &Json) -> Option<Vec<Vec<NurbsCurve>>> {
        let arc = |json: &Json| match from_json(json, self.length) {
            Ok(Value::Curve(Curve::Nurbs(curve))) => Some((*curve).clone()),
            _ => None,
        };
        each(json, |arcs| each(arcs, arc))
    }

    fn face(&self) -> Result<Face, String> {
        let surface = self.read("surface", |json| match from_json(json, self.length) {
            Ok(Value::Surface(Surface::Nurbs(surface))) => Some(surface),
            _ => None,
        })?;
        let part = |json: &Json| self.borders(json).map(|loops| FacePart { loops });
        let parts = self.read("parts", |json| each(json, part))?;
        Face::of_parts(surface, &parts, Tolerance::DEFAULT).map_err(|err| err.to_string())
    }

    fn solid(&self) -> Result<Solid, String> {
        let face = |json: &Json| match from_json(json, self.length) {
            Ok(Value::Face(face)) => Some((*face).clone()),
            _ => None,
        };
        let faces: Vec<Face> = self.read("faces", |json| each(json, face))?;
        Solid::new(&faces, Tolerance::DEFAULT).map_err(|err| err.to_string())
    }

    fn region(&self) -> Result<Region, String> {
        let borders = self.read("borders", |json| self.borders(json))?;
        Region::of_arcs(self.plane()?, borders).map_err(|err| err.to_string())
    }

    fn mesh(&self) -> Result<Mesh, String> {
        let places = |name| -> Result<Vec<DVec3>, String> {
            Ok(self.read(name, vectors)?.into_iter().map(DVec3::from).collect())
        };
        let uvs = self.read("uvs", vectors)?.into_iter().map(DVec2::from).collect();
        let triangles = self.read("triangles", corners)?;
        // Meshes without them, as most are, do not name them.
        let has = |name| self.member(name).is_ok();
        let colors = if has("colors") { places("colors")? } else { Vec::new() };
        let count = |json: &Json| json.as_u64().and_then(|n| u32::try_from(n).ok());
        let sizes = match has("face_sizes") {
            true => Some(self.read("face_sizes", |json| each(json, count))?),
            false => None,
        };
        let groups = if has("groups") { self.read("groups", groups)? } else { Vec::new() };
        Mesh::new(places("vertices")?, places("normals")?, uvs, triangles)
            .and_then(|mesh| match sizes {
                Some(sizes) => mesh.with_faces(sizes),
                None => Ok(mesh),
            })
            .and_then(|mesh| mesh.with_colors(colors)?.with_groups(groups))
            .map_err(|err| err.to_string())
    }

    fn table(&self) -> Result<Table, String> {
        let columns = self.read("columns", |json| each(json, read_column))?;
        let columns: Vec<NamedColumn> = columns;
        let columns = columns.into_iter().map(|column| in_document_unit(column, self.length));
        Table::new(columns.collect::<Result<_, _>>()?).map_err(|err| err.to_string())
    }

    fn plane(&self) -> Result<Frame, String> {
        let (origin, normal, x) = (self.point("origin")?, self.point("z")?, self.point("x")?);
        Frame::from_normal(origin, normal, Some(x)).map_err(|err| err.to_string())
    }

    fn curve_frame(&self) -> Result<Frame, String> {
        let plane = self.plane()?;
        Frame::of_curve(plane.origin(), plane.x(), plane.y()).map_err(|err| err.to_string())
    }

    fn value(&self) -> Result<Value, String> {
        Ok(match self.kind {
            "document" => from_json(self.member("values")?, self.length)?,
            "angle" => Value::Number(Number::angle(self.number("radians")?.value)),
            "point" => Value::Point(self.point("xyz")?),
            "range" => Value::Range(Range {
                start: self.number("start")?,
                end: self.number("end")?,
                closed: self.read("closed", Json::as_bool)?,
            }),
            "curve" => Value::Curve(self.curve()?.into()),
            "surface" => Value::Surface(self.surface()?.into()),
            "region" => Value::Region(Arc::new(self.region()?)),
            "face" => Value::Face(Arc::new(self.face()?)),
            "solid" => Value::Solid(Arc::new(self.solid()?)),
            "mesh" => Value::Mesh(Arc::new(self.mesh()?)),
            "table" => Value::Table(Arc::new(self.table()?)),
            "plane" => Value::Frame(Arc::new(self.plane()?)),
            "frame" => Value::Frame(Arc::new(self.curve_frame()?)),
            other => return Err(format!("there is no kind of value called `{other}`")),
        })
    }
}

fn homogeneous_points(json: &Json) -> Option<Vec<DVec4>> {
    Some(vectors(json)?.into_iter().map(DVec4::from).collect())
}

fn numbers(json: &Json) -> Option<Vec<f64>> {
    each(json, Json::as_f64)
}

/// What `read` makes of each element, counted.
fn each<T>(json: &Json, read: impl Fn(&Json) -> Option<T>) -> Option<Vec<T>> {
    let mut items = Vec::new();
    let mut elements = json.as_array()?.iter();
    elements
        .all(|item| read(item).is_some_and(|item| work::push(&mut items, item)))
        .then_some(items)
}

fn vectors<const N: usize>(json: &Json) -> Option<Vec<[f64; N]>> {
    each(json, |item| <[f64; N]>::try_from(numbers(item)?).ok())
}

fn corners(json: &Json) -> Option<Vec<[u32; 3]>> {
    let corner = |item: &Json| item.as_u64().and_then(|n| u32::try_from(n).ok());
    each(json, |item| <[u32; 3]>::try_from(each(item, corner)?).ok())
}

fn groups(json: &Json) -> Option<Vec<MeshGroup>> {
    let group = |json: &Json| {
        let name = json.get("name")?.as_str()?.to_owned();
        let n_triangles = usize::try_from(json.get("triangles")?.as_u64()?).ok()?;
        Some(MeshGroup { name, n_triangles })
    };
    each(json, group)
}

fn read_column(json: &Json) -> Option<NamedColumn> {
    let name = json.get("name")?.as_str()?.to_owned();
    let unit = json.get("unit").and_then(Json::as_str).map(str::to_owned);
    let values = json.get("values")?;
    let cell = |json: &Json| json.as_f64().or(json.is_null().then_some(f64::NAN));
    let column = match each(values, cell) {
        Some(values) => Column::Numbers(values),
        None => Column::Texts(each(values, |text| text.as_str().map(str::to_owned))?),
    };
    Some(NamedColumn { name, unit, column })
}
