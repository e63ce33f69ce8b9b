//! Binary STL: triangles with facet normals, as single-precision numbers.

use std::{io::Write, sync::Arc};

use super::{
    ExportError, Format, Job, Subject, Summary,
    shape::{Shape, shape, tolerance},
};
use crate::kernel::Mesh;

pub(super) static FORMAT: Format = Format {
    ending: "stl",
    title: "binary STL: triangles",
    options: &["tolerance"],
    takes: |subject| matches!(subject, Subject::Surface(_) | Subject::Mesh(_)),
    takes_data: false,
    wants: "surfaces and meshes",
    write,
};

/// Bytes of the header, which no reader interprets. It must not begin with `solid`, which marks
/// the text form.
const HEADER_BYTES: usize = 80;

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let tolerance = tolerance(job);
    let mut meshes: Vec<Arc<Mesh>> = Vec::new();
    for item in &job.items {
        if let Some(Shape::Mesh(mesh)) = shape(item, tolerance, job)? {
            meshes.push(mesh);
        }
    }
    let mut summary = Summary::default();
    for mesh in &meshes {
        summary.vertices += mesh.vertices().len();
        summary.triangles += mesh.triangles().len();
    }
    let n_triangles = u32::try_from(summary.triangles)
        .map_err(|_| std::io::Error::other("binary STL holds at most 4294967295 triangles"))?;
    let mut header = [b' '; HEADER_BYTES];
    let title = format!("binary STL, unit {}", job.unit);
    header[..title.len()].copy_from_slice(title.as_bytes());
    out.write_all(&header)?;
    out.write_all(&n_triangles.to_le_bytes())?;
    for mesh in &meshes {
        write_triangles(mesh, out)?;
    }
    Ok(summary)
}

fn write_triangles(mesh: &Mesh, out: &mut dyn Write) -> Result<(), ExportError> {
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|corner| mesh.vertices()[corner as usize]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let mut record = [0u8; 50];
        let numbers = [normal, a, b, c].into_iter().flat_map(|vector| vector.to_array());
        for (slot, number) in record.chunks_exact_mut(4).zip(numbers) {
            // Zero has no sign.
            slot.copy_from_slice(&(number as f32 + 0.0).to_le_bytes());
        }
        out.write_all(&record)?;
    }
    Ok(())
}
