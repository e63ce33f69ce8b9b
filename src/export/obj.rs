//! Wavefront OBJ: positions, normals, texture coordinates, a group for each name.

use std::io::Write;

use super::{
    ExportError, Format, Job, Subject, Summary,
    shape::{Shape, shape, tolerance},
    text::Text,
};
use crate::kernel::Mesh;

pub(super) static FORMAT: Format = Format {
    ending: "obj",
    title: "Wavefront OBJ: meshes with normals, polylines and points, a group for each name",
    options: &["tolerance"],
    takes: Subject::is_geometry,
    takes_data: false,
    wants: "points, curves, surfaces and meshes",
    write,
};

/// Numbers of vertices, normals and texture coordinates written so far.
#[derive(Default)]
struct Written {
    vertices: usize,
    normals: usize,
    uvs: usize,
}

fn write(job: &Job, out: &mut dyn Write) -> Result<Summary, ExportError> {
    let tolerance = tolerance(job);
    let mut text = Text::default();
    text.push("# unit: ").push(job.unit).push("\n");
    let (mut written, mut summary) = (Written::default(), Summary::default());
    for item in &job.items {
        text.push("g ").push(&group_name(&item.name)).push("\n");
        match shape(item, tolerance, job)? {
            Some(Shape::Mesh(mesh)) => {
                write_mesh(&mesh, &mut written, &mut text, out)?;
                summary.vertices += mesh.vertices().len();
                summary.triangles += mesh.triangles().len();
            }
            Some(Shape::Polyline(points)) => {
                points.iter().for_each(|point| vector(&mut text, "v", &point.to_array()));
                text.push("l");
                for idx in 1..=points.len() {
                    text.push(" ").count(written.vertices + idx);
                }
                text.push("\n");
                written.vertices += points.len();
                summary.polylines += 1;
            }
            Some(Shape::Point(point)) => {
                vector(&mut text, "v", &point.to_array());
                written.vertices += 1;
                text.push("p ").count(written.vertices).push("\n");
                summary.points += 1;
            }
            None => {}
        }
        text.flush_if_large(out)?;
    }
    text.flush(out)?;
    Ok(summary)
}

fn vector(text: &mut Text, keyword: &str, coordinates: &[f64]) {
    text.push(keyword);
    for &coordinate in coordinates {
        text.push(" ").number(coordinate);
    }
    text.push("\n");
}

fn write_mesh(
    mesh: &Mesh,
    written: &mut Written,
    text: &mut Text,
    out: &mut dyn Write,
) -> Result<(), ExportError> {
    for vertex in mesh.vertices() {
        vector(text, "v", &vertex.to_array());
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
    for triangle in mesh.triangles() {
        text.push("f");
        for &corner in triangle {
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

/// A group's name is one word.
fn group_name(name: &str) -> String {
    let word: String = name.chars().map(|c| if c.is_whitespace() { '_' } else { c }).collect();
    if word.is_empty() { "unnamed".to_owned() } else { word }
}
