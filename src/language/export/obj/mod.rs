//! Wavefront OBJ: positions, normals, texture coordinates, a group for each name; with
//! `free_form = true` curves and surfaces exactly.

mod free_form;

use std::io::Write;

use super::{
    ExportError, Format, Item, Job, Subject, Summary,
    exact::{Exact, exact},
    name::word,
    options::{ANGLE, DECIMALS, FREE_FORM, TOLERANCE},
    shape::{MeshShape, ShapedItem, shape, shapes, tolerance},
    text::TextBuffer,
};
use crate::kernel::Mesh;

pub(super) static FORMAT: Format = Format {
    ending: "obj",
    aliases: &[],
    title: "Wavefront OBJ: meshes with normals, polylines and points, a group for each name; exact curves and surfaces with `free_form = true`",
    options: &[&TOLERANCE, &ANGLE, &DECIMALS, &FREE_FORM],
    takes: Subject::is_geometry,
    takes_data: false,
    is_of_meshes: true,
    wants: "points, curves, surfaces, regions, faces, solids and meshes",
    write,
};

/// Numbers of vertices, normals and texture coordinates written so far.
#[derive(Default)]
struct WrittenCounts {
    vertices: usize,
    normals: usize,
    uvs: usize,
}

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let tolerance = tolerance(job)?;
    let mut text = TextBuffer::rounded(job.options.decimals);
    text.push("# unit: ").push(job.unit).push("\n");
    let (mut written, mut summary) = (WrittenCounts::default(), Summary::default());
    let mut shapes = if job.options.free_form { Vec::new() } else { shapes(job)? }.into_iter();
    for item in &job.items {
        text.push("g ").push(&word(&item.name)).push("\n");
        let is_exact = matches!(item.subject, Subject::Curve(_) | Subject::Surface(_));
        if job.options.free_form && is_exact {
            write_exact(item, job, &mut written, &mut text)?;
            summary.count(&item.subject);
        } else {
            let shape = match shapes.next() {
                Some(shaped) => Some(shaped),
                None => shape(item, tolerance, job)?.map(|shape| ShapedItem {
                    item,
                    shape,
                    is_turned: false,
                }),
            };
            if let Some(shaped) = shape {
                summary.add(&shaped);
                write_shape(&shaped.shape, &mut written, &mut text, out)?;
            }
        }
        text.flush_if_large(out)?;
    }
    text.flush(out)?;
    Ok(summary)
}

fn write_exact(
    item: &Item,
    job: &Job,
    written: &mut WrittenCounts,
    text: &mut TextBuffer,
) -> Result<(), ExportError> {
    for part in exact(item, job)? {
        match part {
            Exact::Point(point) => {
                vector(text, "v", &point.to_array());
                written.vertices += 1;
                text.push("p ").count(written.vertices).push("\n");
            }
            Exact::Curve(curve) => free_form::curve(&curve, written, text),
            Exact::Surface(surface) => free_form::surface(&surface, written, text),
            Exact::Face(..) => unreachable!("faces are written as their triangles"),
        }
    }
    Ok(())
}

fn write_shape(
    shape: &MeshShape,
    written: &mut WrittenCounts,
    text: &mut TextBuffer,
    out: &mut dyn Write,
) -> Result<(), ExportError> {
    match shape {
        MeshShape::Mesh(mesh) => write_mesh(mesh, written, text, out)?,
        MeshShape::Polyline(points) => {
            points.iter().for_each(|point| vector(text, "v", &point.to_array()));
            text.push("l");
            for idx in 1..=points.len() {
                text.push(" ").count(written.vertices + idx);
            }
            text.push("\n");
            written.vertices += points.len();
        }
        MeshShape::Point(point) => {
            vector(text, "v", &point.to_array());
            written.vertices += 1;
            text.push("p ").count(written.vertices).push("\n");
        }
    }
    Ok(())
}

fn vector(text: &mut TextBuffer, keyword: &str, coordinates: &[f64]) {
    text.push(keyword);
    for &coordinate in coordinates {
        text.push(" ").number(coordinate);
    }
    text.push("\n");
}

fn write_mesh(
    mesh: &Mesh,
    written: &mut WrittenCounts,
    text: &mut TextBuffer,
    out: &mut dyn Write,
) -> Result<(), ExportError> {
    let paint = mesh.colors();
    for (i, vertex) in mesh.vertices().iter().enumerate() {
        match paint.get(i) {
            // The colour of a vertex stands behind its place: no standard, but read widely.
            Some(color) => {
                let [x, y, z] = vertex.to_array();
                vector(text, "v", &[x, y, z, color.x, color.y, color.z]);
            }
            None => vector(text, "v", &vertex.to_array()),
        }
        text.flush_if_large(out)?;
    }
    for uv in mesh.uvs() {
        vector(text, "vt", &uv.to_array());
        text.flush_if_large(out)?;
    }
    for normal in mesh.normals() {
        vector(text, "vn", &normal.to_array());
        text.flush_if_large(out)?;
    }
    let (has_uvs, has_normals) = (!mesh.uvs().is_empty(), !mesh.normals().is_empty());
    let mut groups = mesh.groups().iter();
    let mut n_left = 0;
    for corners in mesh.faces() {
        while n_left == 0 {
            let Some(group) = groups.next() else { break };
            text.push("g ").push(&word(&group.name)).push("\n");
            n_left = group.n_triangles;
        }
        n_left = n_left.saturating_sub(corners.len() - 2);
        text.push("f");
        for corner in corners {
            let corner = corner as usize + 1;
            text.push(" ").count(written.vertices + corner);
            match (has_uvs, has_normals) {
                (false, false) => {}
                (true, false) => {
                    text.push("/").count(written.uvs + corner);
                }
                (false, true) => {
                    text.push("//").count(written.normals + corner);
                }
                (true, true) => {
                    text.push("/")
                        .count(written.uvs + corner)
                        .push("/")
                        .count(written.normals + corner);
                }
            }
        }
        text.push("\n");
        text.flush_if_large(out)?;
    }
    written.vertices += mesh.vertices().len();
    written.uvs += mesh.uvs().len();
    written.normals += mesh.normals().len();
    Ok(())
}
