//! Reader of Wavefront OBJ, through `tobj`.

use glam::{DVec2, DVec3};

use crate::{
    kernel::Mesh,
    value::{Ctx, IntoValue, Value},
};

/// All objects of a file as one mesh; polygons become triangles.
pub(super) fn read(bytes: &[u8], ctx: &Ctx<'_>) -> Result<Value, String> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        single_index: true,
    };
    let faces = without_lines(bytes);
    // Materials are of no interest here.
    let (models, _) = tobj::load_obj_buf(&mut &faces[..], &options, |_| Ok(Default::default()))
        .map_err(|err| match first_mistake(&String::from_utf8_lossy(bytes)) {
            Some((line, what)) => format!("line {line}: {what}"),
            None => err.to_string(),
        })?;
    let mut meshes = Vec::new();
    for model in &models {
        let mesh = &model.mesh;
        let vertices = vectors(&mesh.positions);
        let normals = if mesh.normals.len() == mesh.positions.len() {
            vectors(&mesh.normals)
        } else {
            Vec::new()
        };
        let uvs: Vec<DVec2> =
            mesh.texcoords.chunks_exact(2).map(|uv| DVec2::new(uv[0], uv[1])).collect();
        let uvs = if uvs.len() == vertices.len() { uvs } else { Vec::new() };
        let triangles = mesh
            .indices
            .chunks_exact(3)
            .map(|corners| [corners[0], corners[1], corners[2]])
            .collect();
        let normals = normals.into_iter().map(DVec3::normalize_or_zero).collect();
        meshes.push(
            Mesh::new(vertices, normals, uvs, triangles)
                .map_err(|err| format!("{}: {err}", model.name))?,
        );
    }
    let merged = Mesh::merged(&meshes, ctx.limits.mesh_vertices).map_err(|err| err.to_string())?;
    if merged.triangles().is_empty() {
        return Err("the file holds no triangles".to_owned());
    }
    Ok(merged.into_value())
}

/// The same text with its points and polylines emptied: the library takes a polyline of three
/// vertices or more for a polygon, whatever its options say.
fn without_lines(bytes: &[u8]) -> Vec<u8> {
    let is_face = |line: &&[u8]| {
        let line = line.trim_ascii_start();
        !matches!(line, [b'l' | b'p', rest @ ..] if rest.first().is_none_or(u8::is_ascii_whitespace))
    };
    let lines = bytes.split(|&byte| byte == b'\n');
    let kept: Vec<&[u8]> = lines.map(|line| if is_face(&line) { line } else { &[] }).collect();
    kept.join(&b'\n')
}

/// The first line that cannot be read, which the library does not tell, and what is wrong with it.
fn first_mistake(text: &str) -> Option<(usize, String)> {
    let mut n_vertices = 0;
    for (i, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        let mistake = match words.next() {
            Some(keyword @ ("v" | "vn" | "vt")) => {
                n_vertices += i64::from(keyword == "v");
                let is_short = words.clone().count() < if keyword == "vt" { 2 } else { 3 };
                let wrong = words.find(|word| word.parse::<f64>().is_err());
                wrong
                    .map(|word| format!("a coordinate must be a number, found `{word}`"))
                    .or_else(|| is_short.then(|| format!("`{keyword}` has too few coordinates")))
            }
            Some("f" | "l" | "p") => words.find_map(|corner| corner_mistake(corner, n_vertices)),
            _ => None,
        };
        if let Some(what) = mistake {
            return Some((i + 1, what));
        }
    }
    None
}

/// What is wrong with a corner such as `7/1/3` when so many vertices came before.
fn corner_mistake(corner: &str, n_vertices: i64) -> Option<String> {
    let first = corner.split('/').next().unwrap_or_default();
    match first.parse::<i64>() {
        Err(_) => Some(format!("a corner must be the number of a vertex, found `{corner}`")),
        Ok(idx) if idx == 0 || idx.abs() > n_vertices => {
            Some(format!("vertex {idx} does not exist; {n_vertices} came before"))
        }
        Ok(_) => None,
    }
}

fn vectors(numbers: &[f64]) -> Vec<DVec3> {
    numbers.chunks_exact(3).map(DVec3::from_slice).collect()
}
