//! What files say of meshes, read back number by number.

#![expect(clippy::float_cmp, reason = "what is written reads back to the same bits")]

use virote::{
    kernel::Mesh,
    session::{Event, Session},
    value::{NoFiles, Value},
};

/// The bytes of the file that a script exports, and the meshes among its definitions.
fn exported(script: &str) -> (Vec<u8>, Vec<std::sync::Arc<Mesh>>) {
    let report = Session::default().run("formats.geo", script.as_bytes(), &NoFiles, &[]);
    assert!(report.diagnostics.is_empty(), "{:?}", report.diagnostics);
    let mut bytes = Vec::new();
    for event in &report.events {
        let Event::File(file) = event else { unreachable!("{event:?}") };
        (file.format.write)(&file.job, &mut bytes).expect("it can be written");
    }
    let meshes = report.definitions.iter().filter_map(|defined| match &defined.value {
        Some(Value::Mesh(mesh)) => Some(mesh.clone()),
        _ => None,
    });
    (bytes, meshes.collect())
}

/// The lines that begin with a keyword, as numbers.
fn records(text: &str, keyword: &str) -> Vec<Vec<f64>> {
    let rows = text.lines().filter_map(|line| line.strip_prefix(keyword)?.strip_prefix(' '));
    rows.map(|row| row.split(' ').map(|part| part.parse().expect("a number")).collect()).collect()
}

/// Items without texture coordinates, or without normals, stand before and between those with
/// them, so that no count is that of another kind.
#[test]
fn corners_in_obj_name_their_own_place_texture_and_normal() {
    let script = "curve c = polyline((9, 9), (8, 8), (9, 8))\n\
        mesh plain = mesh([(0, 0, 7), (1, 0, 7), (0, 1, 7)], [[0, 1, 2]])\n\
        surface low = bilinear((0, 0, 0), (0, 2, 0), (4, 0, 0), (4, 2, 0))\n\
        point p = (5, 5, 5)\n\
        surface high = reparametrize(bilinear((0, 0, 1), (0, 4, 1), (2, 0, 1), (2, 4, 1)), u = 0..3)\n\
        mesh last = mesh([(0, 0, 8), (1, 0, 8), (0, 1, 8)], [[0, 1, 2]])\n\
        export c, plain, low, p, high, last to \"all.obj\"\n";
    let (bytes, _) = exported(script);
    let text = String::from_utf8(bytes).expect("text");
    let [places, textures, normals] = ["v", "vt", "vn"].map(|keyword| records(&text, keyword));
    assert_eq!((places.len(), textures.len()), (3 + 3 + 4 + 1 + 4 + 3, 8));
    let faces: Vec<Vec<Vec<Option<usize>>>> = text
        .lines()
        .filter_map(|line| line.strip_prefix("f "))
        .map(|face| {
            let number = |part: &str| part.parse().ok();
            face.split(' ').map(|corner| corner.split('/').map(number).collect()).collect()
        })
        .collect();
    assert_eq!(faces.len(), 6);
    for corner in faces.iter().flatten() {
        let place = &places[corner[0].expect("a place") - 1];
        let texture = corner.get(1).copied().flatten().map(|idx| &textures[idx - 1]);
        let normal = corner.get(2).copied().flatten().map(|idx| &normals[idx - 1]);
        match place[2] as i32 {
            z @ (0 | 1) => {
                let ([u, v], size) =
                    [([1.0, 1.0], [4.0, 2.0]), ([3.0, 1.0], [2.0, 4.0])][z as usize];
                let expected = vec![u * place[0] / size[0], v * place[1] / size[1]];
                assert_eq!(texture, Some(&expected), "{place:?}");
                assert_eq!(normal, Some(&vec![0.0, 0.0, 1.0]), "{place:?}");
            }
            _ => assert_eq!(texture, None, "{place:?}"),
        }
    }
    // The line has its own places, and the point its.
    assert_eq!(records(&text, "l"), [[1.0, 2.0, 3.0]]);
    assert_eq!(records(&text, "p"), [[11.0]]);
    assert_eq!(places[10], [5.0, 5.0, 5.0]);
}

/// The level of light of a colour's level, both from 0 to 255: IEC 61966-2-1.
fn light(level: f64) -> f64 {
    let level = (level * 255.0).round() / 255.0;
    let light =
        if level <= 0.04045 { level / 12.92 } else { libm::pow((level + 0.055) / 1.055, 2.4) };
    (light * 255.0).round()
}

#[test]
fn vertices_in_glb_have_their_own_colours_as_light() {
    let script = "mesh painted = curvature_map(torus((0, 0), 3, 1), \"gaussian\").mesh with (color = \"red\")\n\
        export painted to \"painted.glb\"\n";
    let (bytes, meshes) = exported(script);
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four")) as usize;
    let n_text = word(12);
    let text: serde_json::Value = serde_json::from_slice(&bytes[20..20 + n_text]).expect("JSON");
    let binary = &bytes[28 + n_text..];
    let number = |json: &serde_json::Value| json.as_u64().expect("a number") as usize;

    let primitive = &text["meshes"][0]["primitives"][0];
    let accessor = &text["accessors"][number(&primitive["attributes"]["COLOR_0"])];
    // Bytes from 0 to 255 for 0 to 1: Khronos Group, glTF 2.0, 3.7.2.1.
    assert_eq!(accessor["componentType"], 5121);
    assert_eq!((&accessor["type"], &accessor["normalized"]), (&"VEC4".into(), &true.into()));
    let first = number(&text["bufferViews"][number(&accessor["bufferView"])]["byteOffset"]);
    // They are multiplied with the material's, which is white then.
    let factor = &text["materials"][number(&primitive["material"])]["pbrMetallicRoughness"];
    assert_eq!(factor["baseColorFactor"], serde_json::json!([1.0, 1.0, 1.0, 1.0]));

    let colors = meshes[0].colors();
    assert_eq!(number(&accessor["count"]), colors.len());
    let mut seen = std::collections::BTreeSet::new();
    for (found, color) in binary[first..].chunks_exact(4).zip(colors) {
        let expected = color.to_array().map(light);
        assert_eq!([0, 1, 2].map(|i| f64::from(found[i])), expected, "{color}");
        assert_eq!(found[3], 255, "nothing shows through");
        seen.insert(found.to_vec());
    }
    assert!(seen.len() > 20 && seen.iter().any(|color| color[0] != color[2]), "{}", seen.len());
}
