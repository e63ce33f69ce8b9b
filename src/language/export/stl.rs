//! STL: triangles with facet normals, binary with single-precision numbers, or as text.

use std::io::Write;

use glam::DVec3;

use super::{
    ExportError, Format, Job, Summary,
    name::one_line,
    options::{ANGLE, BINARY, DECIMALS, TOLERANCE},
    shape::{MeshShape, ShapedItem, is_solid, shapes},
    text::TextBuffer,
};
use crate::kernel::Mesh;

pub(super) static FORMAT: Format = Format {
    ending: "stl",
    aliases: &[],
    title: "STL: triangles; binary, or text with `binary = false`",
    options: &[&TOLERANCE, &ANGLE, &BINARY, &DECIMALS],
    takes: is_solid,
    takes_data: false,
    is_of_meshes: true,
    wants: "surfaces, regions, faces, solids and meshes",
    write,
};

/// Bytes of the header, which no reader interprets. It must not begin with `solid`, which marks
/// the text form.
const HEADER_BYTES: usize = 80;
/// Triangles that make a write worth while.
const MANY: usize = 1 << 10;
/// Bytes of a triangle.
const RECORD_BYTES: usize = 50;

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let shapes = shapes(job)?;
    if job.options.binary.unwrap_or(true) {
        write_binary(job, &shapes, out)?;
        return Ok(Summary::of_single(job, &shapes));
    }
    write_text(job, &shapes, out)?;
    Ok(Summary::of(&shapes))
}

fn facet_normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

fn write_binary(
    job: &Job,
    shapes: &[ShapedItem<'_>],
    out: &mut dyn Write,
) -> Result<(), ExportError> {
    let n_triangles: usize = shapes.iter().map(ShapedItem::n_triangles).sum();
    let n_triangles = u32::try_from(n_triangles)
        .map_err(|_| std::io::Error::other("binary STL holds at most 4294967295 triangles"))?;
    let mut header = [b' '; HEADER_BYTES];
    let title = format!("binary STL, unit {}", job.unit);
    header[..title.len()].copy_from_slice(title.as_bytes());
    out.write_all(&header)?;
    out.write_all(&n_triangles.to_le_bytes())?;
    for shaped in shapes {
        if let MeshShape::Mesh(mesh) = &shaped.shape {
            if shaped.points().iter().any(|point| !point.as_vec3().is_finite()) {
                return Err(shaped.beyond_single_precision());
            }
            write_triangles(mesh, out)?;
        }
    }
    Ok(())
}

fn write_triangles(mesh: &Mesh, out: &mut dyn Write) -> Result<(), ExportError> {
    let mut bytes = Vec::with_capacity(MANY * RECORD_BYTES);
    for corners in mesh.corners() {
        let [a, b, c] = corners;
        for vector in [facet_normal(corners), a, b, c] {
            for number in vector.to_array() {
                // Zero has no sign.
                bytes.extend_from_slice(&(number as f32 + 0.0).to_le_bytes());
            }
        }
        bytes.extend_from_slice(&[0; 2]);
        if MANY * RECORD_BYTES <= bytes.len() {
            out.write_all(&bytes)?;
            bytes.clear();
        }
    }
    Ok(out.write_all(&bytes)?)
}

fn write_text(
    job: &Job,
    shapes: &[ShapedItem<'_>],
    out: &mut dyn Write,
) -> Result<(), ExportError> {
    let mut text = TextBuffer::rounded(job.options.decimals);
    for shaped in shapes {
        let MeshShape::Mesh(mesh) = &shaped.shape else { continue };
        let name = one_line(&shaped.item.name);
        text.push("solid ").push(&name).push("\n");
        let vector = |text: &mut TextBuffer, keyword: &str, vector: DVec3| {
            text.push(keyword);
            for number in vector.to_array() {
                text.push(" ").number(number);
            }
            text.push("\n");
        };
        for corners in mesh.corners() {
            vector(&mut text, "facet normal", facet_normal(corners));
            text.push("outer loop\n");
            for corner in corners {
                vector(&mut text, "vertex", corner);
            }
            text.push("endloop\nendfacet\n");
            text.flush_if_large(out)?;
        }
        text.push("endsolid ").push(&name).push("\n");
    }
    Ok(text.flush(out)?)
}
