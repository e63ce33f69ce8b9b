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
    let told = |error: String| match first_mistake(&String::from_utf8_lossy(bytes)) {
        Some((line, what)) => format!("line {line}: {what}"),
        None => error,
    };
    let (models, _) = tobj::load_obj_buf(&mut &faces[..], &options, |_| Ok(Default::default()))
        .map_err(|err| told(err.to_string()))?;
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
                .map_err(|err| told(format!("{}: {err}", model.name)))?,
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
    let mut n_before = [0; 3];
    for (i, line) in text.lines().enumerate() {
        let mut words = line.split_whitespace();
        let mistake = match words.next() {
            Some(keyword)
                if let Some(kind) = ["v", "vt", "vn"].iter().position(|k| *k == keyword) =>
            {
                n_before[kind] += 1;
                numbers_mistake(keyword, words)
            }
            Some("f" | "l" | "p") => words.find_map(|corner| corner_mistake(corner, n_before)),
            _ => None,
        };
        if let Some(what) = mistake {
            return Some((i + 1, what));
        }
    }
    None
}

/// What is wrong with the numbers after `v`, `vt` or `vn`.
fn numbers_mistake<'w>(
    keyword: &str,
    mut words: impl Iterator<Item = &'w str> + Clone,
) -> Option<String> {
    let n_words = words.clone().count();
    let is_number = |word: &str| word.parse::<f64>().is_ok_and(f64::is_finite);
    if let Some(word) = words.find(|word| !is_number(word)) {
        return Some(format!("a coordinate must be a number, found `{word}`"));
    }
    if n_words < if keyword == "vt" { 2 } else { 3 } {
        return Some(format!("`{keyword}` has too few coordinates"));
    }
    let is_odd = keyword == "v" && !matches!(n_words, 3 | 4 | 6 | 7);
    is_odd.then(|| {
        format!("`v` has {n_words} numbers; it takes 3, with a weight 4, with a colour 3 more")
    })
}

/// What is wrong with a corner such as `7/1/3` when so many vertices, texture coordinates and
/// normals came before.
fn corner_mistake(corner: &str, n_before: [i64; 3]) -> Option<String> {
    let kinds = ["vertex", "texture coordinate", "normal"];
    for ((part, kind), n_before) in corner.split('/').zip(kinds).zip(n_before) {
        if part.is_empty() && kind != "vertex" {
            continue;
        }
        match part.parse::<i64>() {
            Err(_) => {
                return Some(format!("a corner must be the number of a {kind}, found `{corner}`"));
            }
            Ok(idx) if idx == 0 || idx.unsigned_abs() > n_before.unsigned_abs() => {
                return Some(format!("{kind} {idx} does not exist; {n_before} came before"));
            }
            Ok(_) => {}
        }
    }
    None
}

fn vectors(numbers: &[f64]) -> Vec<DVec3> {
    numbers.chunks_exact(3).map(DVec3::from_slice).collect()
}
