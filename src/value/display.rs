//! Values as text: what `print` shows. Whatever can be written in a script reads back.

use std::fmt;

use glam::DVec3;

use super::{Value, shortest};
use crate::{
    diag::{is_hidden, shown},
    kernel::{Curve, Frame, Interval, Surface},
};

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Bool(truth) => write!(f, "{truth}"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Text(text) => f.write_str(&quoted(text)),
            Self::Jet(number) => write!(f, "{}", number.looked_at()),
            Self::JetPoint(_) | Self::JetRange(_) => self.looked_at().fmt(f),
            Self::Point(point) => f.write_str(&point_text(*point)),
            Self::List(items) => {
                f.write_str("[")?;
                for (i, item) in items.iter().enumerate() {
                    write!(f, "{}{item}", if i == 0 { "" } else { ", " })?;
                }
                f.write_str("]")
            }
            Self::Range(range) => write!(f, "{range}"),
            Self::Record(record) => {
                f.write_str("{")?;
                for (i, (label, value)) in record.iter().enumerate() {
                    write!(f, "{}{}: {value}", if i == 0 { "" } else { ", " }, shown(label))?;
                }
                f.write_str("}")
            }
            Self::Function(function) => f.write_str(&function.signature()),
            Self::Curve(curve) => write_curve(f, curve),
            Self::Surface(surface) => write_surface(f, surface),
            Self::Region(region) => {
                f.write_str("region")?;
                match region.n_holes() {
                    0 => {}
                    1 => f.write_str(" with a hole")?,
                    n => write!(f, " with {n} holes")?,
                }
                let n: usize = region.arcs().map(<[_]>::len).sum();
                write!(f, ", {n} {}", if n == 1 { "arc" } else { "arcs" })
            }
            Self::Mesh(mesh) => {
                let faces = match mesh.face_sizes() {
                    [] => "triangles",
                    [_] => "face",
                    _ => "faces",
                };
                write!(f, "mesh of {} vertices and {} {faces}", mesh.n_vertices(), mesh.n_faces())
            }
            Self::Table(table) => {
                let names: Vec<&str> =
                    table.columns().iter().map(|column| column.name.as_str()).collect();
                let rows = if table.n_rows() == 1 { "row" } else { "rows" };
                let names = names.join(", ");
                write!(f, "table of {} {rows}: {}", table.n_rows(), shown(&names))
            }
            Self::Frame(frame) => f.write_str(&frame_text(**frame)),
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
