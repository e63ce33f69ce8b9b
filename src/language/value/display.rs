//! Values as text: what `print` shows. Whatever can be written in a script reads back.

use std::fmt;

use glam::DVec3;

use super::{Value, shortest};
use crate::{
    diag::{is_hidden, shown},
    kernel::{Curve, Face, Frame, Interval, Region, Solid, Surface},
};

/// Numbers in document units, without their unit.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        ToldValue { value: self, unit: None }.fmt(f)
    }
}

impl Value {
    /// The text of the value with the units of its numbers, in a document whose unit of length is `unit`:
    /// what `print` shows.
    #[must_use]
    pub fn in_unit(&self, unit: &'static str) -> impl fmt::Display + '_ {
        ToldValue { value: self, unit: Some(unit) }
    }
}

/// A value and the unit of length that its numbers are told in; without one they are told without units.
struct ToldValue<'v> {
    value: &'v Value,
    unit: Option<&'static str>,
}

impl fmt::Display for ToldValue<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = self.unit;
        let inner = |value| ToldValue { value, unit };
        match self.value {
            Value::None => f.write_str("none"),
            Value::Bool(truth) => write!(f, "{truth}"),
            Value::Number(number) => f.write_str(&number.text(unit)),
            Value::Text(text) => f.write_str(&quoted(text)),
            Value::Jet(number) => f.write_str(&number.looked_at().text(unit)),
            Value::JetPoint(_)
            | Value::JetRange(_)
            | Value::JetCurve(_)
            | Value::JetSurface(_)
            | Value::JetRegion(_)
            | Value::JetSolid(_) => inner(&self.value.looked_at()).fmt(f),
            Value::Point(point) => f.write_str(&point_text(*point)),
            Value::List(items) => {
                f.write_str("[")?;
                for (i, item) in items.iter().enumerate() {
                    write!(f, "{}{}", if i == 0 { "" } else { ", " }, inner(item))?;
                }
                f.write_str("]")
            }
            Value::Range(range) => f.write_str(&range.text(unit)),
            Value::Record(record) => {
                f.write_str("{")?;
                for (i, (label, value)) in record.iter().enumerate() {
                    let comma = if i == 0 { "" } else { ", " };
                    write!(f, "{comma}{}: {}", shown(label), inner(value))?;
                }
                f.write_str("}")
            }
            Value::Function(function) => f.write_str(&function.signature()),
            Value::Curve(curve) => write_curve(f, curve),
            Value::Surface(surface) => write_surface(f, surface),
            Value::Region(region) => write_region(f, region),
            Value::Face(face) => write_face(f, face),
            Value::Solid(solid) => write_solid(f, solid),
            Value::Mesh(mesh) => {
                let faces = match (mesh.face_sizes(), mesh.n_faces()) {
                    ([], 1) => "triangle",
                    ([], _) => "triangles",
                    (_, 1) => "face",
                    _ => "faces",
                };
                write!(f, "mesh of {} vertices and {} {faces}", mesh.n_vertices(), mesh.n_faces())
            }
            Value::Table(table) => {
                let names: Vec<&str> =
                    table.columns().iter().map(|column| column.name.as_str()).collect();
                let rows = if table.n_rows() == 1 { "row" } else { "rows" };
                let names = names.join(", ");
                write!(f, "table of {} {rows}: {}", table.n_rows(), shown(&names))
            }
            Value::Frame(frame) => f.write_str(&frame_text(**frame)),
        }
    }
}

fn write_curve(f: &mut fmt::Formatter<'_>, curve: &Curve) -> fmt::Result {
    let domain = domain_text(curve.domain());
    match curve {
        Curve::Parametric(_) => write!(f, "parametric curve on {domain}"),
        Curve::Nurbs(curve) => {
            let (degree, n_points) = (curve.degree(), curve.control_points().len());
            write!(f, "curve of degree {degree} with {n_points} control points on {domain}")
        }
    }
}

/// `region with 2 holes, 6 arcs`
fn write_region(f: &mut fmt::Formatter<'_>, region: &Region) -> fmt::Result {
    f.write_str("region")?;
    match region.n_holes() {
        0 => {}
        1 => f.write_str(" with a hole")?,
        n => write!(f, " with {n} holes")?,
    }
    let n: usize = region.arcs().map(<[_]>::len).sum();
    write!(f, ", {n} {}", if n == 1 { "arc" } else { "arcs" })
}

/// `solid of 4 faces, 2 shells`
fn write_solid(f: &mut fmt::Formatter<'_>, solid: &Solid) -> fmt::Result {
    let n = solid.faces().len();
    write!(f, "solid of {n} {}", if n == 1 { "face" } else { "faces" })?;
    match solid.shells().count() {
        1 => Ok(()),
        n => write!(f, ", {n} shells"),
    }
}

/// `face of a surface of degree 1 x 1, 2 arcs`
fn write_face(f: &mut fmt::Formatter<'_>, face: &Face) -> fmt::Result {
    let surface = face.surface();
    write!(f, "face of a surface of degree {} x {}", surface.degree_u(), surface.degree_v())?;
    if face.is_whole() {
        return f.write_str(", all of it");
    }
    let arcs: usize = face.parts().iter().flat_map(|part| &part.loops).map(Vec::len).sum();
    write!(f, ", {arcs} {}", if arcs == 1 { "arc" } else { "arcs" })
}

fn write_surface(f: &mut fmt::Formatter<'_>, surface: &Surface) -> fmt::Result {
    match surface {
        Surface::Parametric(surface) => {
            let domains = [surface.domain_u(), surface.domain_v()].map(domain_text);
            write!(f, "parametric surface on {} x {}", domains[0], domains[1])
        }
        Surface::Nurbs(surface) => {
            let net = surface.control_points();
            let degrees = format!("{} x {}", surface.degree_u(), surface.degree_v());
            let (n_rows, n_columns) = (net.n_rows(), net.n_columns());
            write!(f, "surface of degree {degrees} with {n_rows} x {n_columns} control points")
        }
    }
}

/// `start..end`, each in the shortest form.
fn domain_text(domain: Interval) -> String {
    format!("{}..{}", shortest(domain.start()), shortest(domain.end()))
}

/// A plane by its normal, the frame of a curve by its directions.
fn frame_text(frame: Frame) -> String {
    let [origin, x, y, z] = [frame.origin(), frame.x(), frame.y(), frame.z()].map(point_text);
    if frame.is_of_curve() {
        format!("frame at {origin} with tangent {x} and normal {y}")
    } else {
        format!("plane at {origin} with normal {z}")
    }
}

/// `(x, y, z)`, each in the shortest form.
fn point_text(point: DVec3) -> String {
    format!("({}, {}, {})", shortest(point.x), shortest(point.y), shortest(point.z))
}

/// A string literal that reads back as `text`.
fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            '"' | '\\' | '{' | '}' => out.extend(['\\', c]),
            c if is_hidden(c) => out.push_str(&format!("\\u{{{:x}}}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
