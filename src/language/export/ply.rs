//! PLY: vertices with normals and colours, faces, and the edges of polylines.
//!
//! Turk, *The PLY Polygon File Format*, 1994.

use std::io::Write;

use glam::DVec3;

use super::{
    ExportError, Format, Job, Subject, Summary,
    name::one_line,
    options::{ANGLE, BINARY, DECIMALS, TOLERANCE},
    shape::{MeshShape, ShapedItem, byte_color, shapes},
    text::TextBuffer,
};
use crate::kernel::Mesh;

pub(super) static FORMAT: Format = Format {
    ending: "ply",
    aliases: &[],
    title: "PLY: faces with normals and colours, polylines as edges; binary, or text with `binary = false`",
    options: &[&TOLERANCE, &ANGLE, &BINARY, &DECIMALS],
    takes: Subject::is_geometry,
    takes_data: false,
    is_of_meshes: true,
    wants: "points, curves, surfaces, regions, faces, solids and meshes",
    write,
};

/// Of items without a colour beside others.
const GREY: [u8; 3] = [200; 3];

/// What stands at a vertex besides its place.
#[derive(Clone, Copy)]
struct VertexLayout {
    with_normals: bool,
    with_colors: bool,
}

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let shapes = shapes(job)?;
    let summary = Summary::of(&shapes);
    let has_normals = |shaped: &ShapedItem<'_>| match &shaped.shape {
        MeshShape::Mesh(mesh) => !mesh.normals().is_empty(),
        _ => false,
    };
    let layout = VertexLayout {
        with_normals: shapes.iter().all(has_normals),
        with_colors: shapes.iter().any(ShapedItem::is_colored),
    };
    let is_binary = job.options.binary.unwrap_or(true);
    let mut text = TextBuffer::rounded(job.options.decimals);
    head(job, &shapes, layout, is_binary, &mut text);
    text.flush(out)?;
    let is_long = most_corners(&shapes) > u8::MAX.into();
    let mut body = PlyBody { is_binary, is_long, text, bytes: Vec::new() };
    for shaped in &shapes {
        body.vertices(shaped, layout, out)?;
    }
    let mut first = 0;
    for shaped in &shapes {
        if let MeshShape::Mesh(mesh) = &shaped.shape {
            for corners in mesh.faces() {
                body.face(&corners, first);
                body.flush_if_large(out)?;
            }
        }
        first += shaped.n_vertices() as u32;
    }
    let mut first = 0;
    for shaped in &shapes {
        if let MeshShape::Polyline(points) = &shaped.shape {
            for i in 1..points.len() as u32 {
                body.edge([first + i - 1, first + i]);
                body.flush_if_large(out)?;
            }
        }
        first += shaped.n_vertices() as u32;
    }
    body.flush(out)?;
    Ok(summary)
}

fn head(
    job: &Job,
    shapes: &[ShapedItem<'_>],
    layout: VertexLayout,
    is_binary: bool,
    text: &mut TextBuffer,
) {
    let n_vertices: usize = shapes.iter().map(ShapedItem::n_vertices).sum();
    let n_edges: usize = shapes.iter().map(ShapedItem::n_legs).sum();
    let n_faces: usize = shapes.iter().filter_map(ShapedItem::mesh).map(Mesh::n_faces).sum();
    let form = if is_binary { "binary_little_endian" } else { "ascii" };
    text.push("ply\nformat ").push(form).push(" 1.0\ncomment unit: ").push(job.unit);
    for shaped in shapes {
        let name = one_line(&shaped.item.name);
        text.push("\ncomment ").count(shaped.n_vertices()).push(" vertices of ").push(&name);
    }
    text.push("\nelement vertex ").count(n_vertices);
    for name in ["x", "y", "z"] {
        text.push("\nproperty double ").push(name);
    }
    if layout.with_normals {
        text.push("\nproperty float nx\nproperty float ny\nproperty float nz");
    }
    if layout.with_colors {
        text.push("\nproperty uchar red\nproperty uchar green\nproperty uchar blue");
    }
    text.push("\nelement face ").count(n_faces);
    let count = if most_corners(shapes) > u8::MAX.into() { "uint" } else { "uchar" };
    text.push("\nproperty list ").push(count).push(" int vertex_indices");
    if n_edges != 0 {
        text.push("\nelement edge ").count(n_edges);
        text.push("\nproperty int vertex1\nproperty int vertex2");
    }
    text.push("\nend_header\n");
}

/// The corners of the face that has the most.
fn most_corners(shapes: &[ShapedItem<'_>]) -> u32 {
    let sizes = shapes.iter().filter_map(ShapedItem::mesh).flat_map(Mesh::face_sizes);
    sizes.max().map_or(3, |size| size + 2)
}

/// What follows the header, as bytes or as lines.
struct PlyBody {
    is_binary: bool,
    /// Whether the corners of faces are counted in four bytes, else in one.
    is_long: bool,
    text: TextBuffer,
    bytes: Vec<u8>,
}

impl PlyBody {
    fn vertices(
        &mut self,
        shaped: &ShapedItem<'_>,
        layout: VertexLayout,
        out: &mut dyn Write,
    ) -> Result<(), ExportError> {
        let (points, normals, paint): (&[DVec3], &[DVec3], &[DVec3]) = match &shaped.shape {
            MeshShape::Mesh(mesh) => (mesh.vertices(), mesh.normals(), mesh.colors()),
            MeshShape::Polyline(points) => (points, &[], &[]),
            MeshShape::Point(point) => (std::slice::from_ref(point), &[], &[]),
        };
        for (i, point) in points.iter().enumerate() {
            point.to_array().into_iter().for_each(|x| self.double(x));
            if let Some(normal) = normals.get(i).filter(|_| layout.with_normals) {
                normal.to_array().into_iter().for_each(|x| self.float(x as f32));
            }
            if layout.with_colors {
                let own = paint.get(i).map(|&color| byte_color(color));
                let color = own.or(shaped.item.color).unwrap_or(GREY);
                color.into_iter().for_each(|level| self.byte(level));
            }
            self.end_line();
            self.flush_if_large(out)?;
        }
        Ok(())
    }

    fn face(&mut self, corners: &[u32], first: u32) {
        match self.is_long {
            true => self.int(corners.len() as u32),
            false => self.byte(corners.len() as u8),
        }
        corners.iter().for_each(|corner| self.int(corner + first));
        self.end_line();
    }

    fn edge(&mut self, ends: [u32; 2]) {
        ends.into_iter().for_each(|end| self.int(end));
        self.end_line();
    }

    fn double(&mut self, x: f64) {
        if self.is_binary {
            self.bytes.extend_from_slice(&x.to_le_bytes());
        } else {
            self.text.number(x).push(" ");
        }
    }

    fn float(&mut self, x: f32) {
        if self.is_binary {
            self.bytes.extend_from_slice(&x.to_le_bytes());
        } else {
            self.text.number(f64::from(x)).push(" ");
        }
    }

    fn int(&mut self, n: u32) {
        if self.is_binary {
            self.bytes.extend_from_slice(&n.to_le_bytes());
        } else {
            self.text.count(n as usize).push(" ");
        }
    }

    fn byte(&mut self, n: u8) {
        if self.is_binary {
            self.bytes.push(n);
        } else {
            self.text.count(usize::from(n)).push(" ");
        }
    }

    fn end_line(&mut self) {
        if !self.is_binary {
            self.text.end_line();
        }
    }

    fn flush_if_large(&mut self, out: &mut dyn Write) -> Result<(), ExportError> {
        if self.bytes.len() < LARGE { Ok(self.text.flush_if_large(out)?) } else { self.flush(out) }
    }

    fn flush(&mut self, out: &mut dyn Write) -> Result<(), ExportError> {
        out.write_all(&self.bytes)?;
        self.bytes.clear();
        Ok(self.text.flush(out)?)
    }
}

/// Bytes that make a write worth while.
const LARGE: usize = 1 << 16;
