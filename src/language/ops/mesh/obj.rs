//! Reader of Wavefront OBJ, through `tobj`.

use glam::{DVec2, DVec3};

use super::{
    obj_lines::{FacesWithoutArea, ObjLines, whole_lines},
    written_unit::compare_units,
};
use crate::{
    diag::{Code, Diagnostic},
    kernel::{GeomError, Mesh, split_polygon},
    limits::work,
    value::{Ctx, ENDED, IntoValue, Value},
};

/// All objects of a file as one mesh, polygons as faces.
pub(super) fn read(text: &str, ctx: &mut Ctx<'_>) -> Result<Value, String> {
    let told = |error: String| match first_mistake(text) {
        Some((line, what)) => format!("line {line}: {what}"),
        None => error,
    };
    let mut meshes = Vec::new();
    let (models, without_area) = models(text, &told)?;
    for model in models {
        let name = model.name;
        let mesh = mesh(model.mesh).ok_or(ENDED)?;
        meshes.push(mesh.map_err(|err| told(format!("{name}: {err}")))?);
    }
    let n_vertices: usize = meshes.iter().map(|mesh| mesh.vertices().len()).sum();
    let n_triangles: usize = meshes.iter().map(|mesh| mesh.triangles().len()).sum();
    let n_bytes = n_vertices * size_of::<[DVec3; 3]>() + n_triangles * size_of::<[u32; 3]>();
    if !work::has_room(n_bytes) {
        return Err(ENDED.to_owned());
    }
    let merged = Mesh::merged(&meshes, ctx.limits.mesh_vertices).map_err(|err| err.to_string())?;
    if merged.triangles().is_empty() {
        return Err("the file holds no triangles".to_owned());
    }
    if let Some(told) = without_area.message() {
        ctx.warn(Diagnostic::warning(Code::Unclean, ctx.span, told));
    }
    // As an export says it, above everything else.
    let unit = text.lines().next().and_then(|line| line.strip_prefix("# unit:"));
    if let Some(unit) = unit {
        compare_units(unit, ctx);
    }
    Ok(merged.into_value())
}

/// The objects of a file as the library makes them, and the faces that have none; `told` finds the line of its
/// mistakes.
fn models(
    text: &str,
    told: &dyn Fn(String) -> String,
) -> Result<(Vec<tobj::Model>, FacesWithoutArea), String> {
    let options = tobj::LoadOptions {
        triangulate: false,
        ignore_points: true,
        ignore_lines: true,
        single_index: true,
    };
    let mut lines = ObjLines::new(whole_lines(text));
    // Materials are of no interest here.
    match tobj::load_obj_buf(&mut lines, &options, |_| Ok(Default::default())) {
        Ok((models, _)) => Ok((models, lines.without_area)),
        Err(err) => Err(lines.mistake.unwrap_or_else(|| told(err.to_string()))),
    }
}

/// One object as a mesh; none when the work was ended.
fn mesh(mesh: tobj::Mesh) -> Option<Result<Mesh, GeomError>> {
    let vertices = vectors(&mesh.positions)?;
    let normals = if mesh.normals.len() == mesh.positions.len() {
        vectors(&mesh.normals)?
    } else {
        Vec::new()
    };
    let normals = normals.into_iter().map(DVec3::normalize_or_zero).collect();
    let uvs = work::collect(mesh.texcoords.chunks_exact(2).map(|uv| DVec2::new(uv[0], uv[1])))?;
    let uvs = if uvs.len() == vertices.len() { uvs } else { Vec::new() };
    if mesh.face_arities.is_empty() {
        let corners = mesh.indices.chunks_exact(3);
        let triangles = work::collect(corners.map(|corners| [corners[0], corners[1], corners[2]]))?;
        return Some(Mesh::new(vertices, normals, uvs, triangles));
    }
    let (triangles, sizes) = polygons(&vertices, &mesh)?;
    let made = Mesh::new(vertices, normals, uvs, triangles);
    Some(made.and_then(|mesh| mesh.with_faces(sizes)))
}

/// The triangles of polygons, and how many each has; one that cannot be split as it is becomes the
/// triangles from its first corner, of these the ones that have three. None when the work was ended.
fn polygons(vertices: &[DVec3], mesh: &tobj::Mesh) -> Option<(Vec<[u32; 3]>, Vec<u32>)> {
    let (mut triangles, mut sizes) = (Vec::new(), Vec::new());
    let mut left = &mesh.indices[..];
    for &n_corners in &mesh.face_arities {
        let (corners, behind) = left.split_at_checked(n_corners as usize)?;
        left = behind;
        let is_of_vertices = corners.iter().all(|&i| (i as usize) < vertices.len());
        if n_corners < 3 || !is_of_vertices {
            continue;
        }
        if !work::goes_on(1 + u64::from(n_corners)) {
            return None;
        }
        let (is_plain, n_before) = (all_differ(corners), triangles.len());
        match is_plain.then(|| split_polygon(vertices, corners)) {
            Some(Ok(split)) => {
                sizes.push(split.len() as u32);
                triangles.extend(split);
            }
            _ => {
                let sides = corners[1..].windows(2);
                let fan = sides.map(|side| [corners[0], side[0], side[1]]);
                triangles.extend(fan.filter(|triangle| all_differ(triangle)));
                sizes.resize(triangles.len() - n_before + sizes.len(), 1);
            }
        }
    }
    Some((triangles, sizes))
}

fn all_differ(corners: &[u32]) -> bool {
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).all(|pair| pair[0] != pair[1])
}

/// The first line that cannot be read, which the library does not tell, and what is wrong with it.
fn first_mistake(text: &str) -> Option<(usize, String)> {
    let n_all = ["v", "vt", "vn"].map(|kind| {
        whole_lines(text).filter(|(_, line)| line.split_whitespace().next() == Some(kind)).count()
    });
    for (number, line) in whole_lines(text) {
        let line = line.split('#').next().unwrap_or_default();
        let mut words = line.split_whitespace();
        let mistake = match words.next() {
            Some(keyword @ ("v" | "vt" | "vn")) => numbers_mistake(keyword, words),
            // Those of other kinds were looked at before.
            Some("f") => words.find_map(|corner| later_mistake(corner, n_all)),
            _ => None,
        };
        if let Some(what) = mistake {
            return Some((number, what));
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

/// What is wrong with a corner whose form is right, when the file has so many of all it may name.
fn later_mistake(corner: &str, n_all: [usize; 3]) -> Option<String> {
    let kinds = ["vertex", "texture coordinate", "normal"];
    corner.split('/').zip(kinds).zip(n_all).find_map(|((part, kind), n_all)| {
        let idx = part.parse::<usize>().ok().filter(|idx| n_all < *idx)?;
        Some(format!("{kind} {idx} does not exist; the file has {n_all}"))
    })
}

fn vectors(numbers: &[f64]) -> Option<Vec<DVec3>> {
    work::collect(numbers.chunks_exact(3).map(DVec3::from_slice))
}
