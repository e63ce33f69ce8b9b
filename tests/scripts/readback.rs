//! Files that we write, read by programs that we did not write.

use std::fs;

use crate::support::{Scratch, folder, virote};

/// The number before `word` in what a run printed of `file`.
fn printed(said: &str, file: &str, word: &str) -> usize {
    let line =
        said.lines().find(|line| line.starts_with(&format!("wrote {file}:"))).expect("written");
    let before = line.split(&format!(" {word}")).next().expect("the word is there");
    before.rsplit(' ').next().expect("a number").parse().expect("a number")
}

#[test]
fn the_teapots_mesh_has_the_counts_that_the_run_printed() {
    let scratch = Scratch::new("readback");
    let output = virote(&folder("examples"))
        .args(["run", "teapot.geo", "--out"])
        .arg(&scratch.0)
        .output()
        .expect("it starts");
    assert_eq!(output.status.code(), Some(0));
    let said = String::from_utf8(output.stdout).expect("text");

    let options = tobj::LoadOptions::default();
    let (models, _) = tobj::load_obj(scratch.0.join("teapot.obj"), &options).expect("an OBJ file");
    let n_vertices: usize = models.iter().map(|model| model.mesh.positions.len() / 3).sum();
    let n_triangles: usize = models.iter().map(|model| model.mesh.indices.len() / 3).sum();
    assert_eq!(n_vertices, printed(&said, "teapot.obj", "vertices"));
    assert_eq!(n_triangles, printed(&said, "teapot.obj", "triangles"));
    assert!(models.iter().all(|model| model.mesh.face_arities.is_empty()), "triangles only");

    // A unit normal a vertex, facing out of the triangles that use it.
    for model in &models {
        let mesh = &model.mesh;
        assert_eq!(mesh.normals.len(), mesh.positions.len());
        for normal in mesh.normals.chunks_exact(3) {
            let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!((length - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn a_binary_stl_has_a_record_for_each_triangle() {
    let scratch = Scratch::new("readback-stl");
    let script = scratch.file(
        "box.geo",
        "surface s = bilinear((0, 0), (0, 3), (2, 0), (2, 3))\nexport s to \"s.stl\"\n",
    );
    assert!(virote(&scratch.0).arg("run").arg(script).status().expect("it starts").success());
    let bytes = fs::read(scratch.0.join("s.stl")).expect("written");
    assert_eq!(bytes.len(), 80 + 4 + 2 * 50);
    assert_eq!(u32::from_le_bytes(bytes[80..84].try_into().expect("four bytes")), 2);
    let number = |i: usize| {
        let at = 84 + 4 * i;
        f32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"))
    };
    // The facet's normal points along Su × Sv.
    assert!((number(2) - 1.0).abs() < 1e-6 && number(0).abs() < 1e-6);
    assert!(!bytes.starts_with(b"solid"), "readers would take it for the text form");
}

#[test]
fn lines_and_points_of_our_own_files_do_not_become_triangles() {
    let scratch = Scratch::new("readback-mixed");
    let out = scratch.file(
        "out.geo",
        "surface s = bilinear((0, 0), (0, 1), (1, 0), (1, 1))\ncurve c = polyline((0, 0), (1, 2), (3, 3), (4, 0))\npoint p = (9, 9)\nexport all to \"all.obj\"\n",
    );
    assert!(virote(&scratch.0).arg("run").arg(out).status().expect("it starts").success());
    let back = scratch.file(
        "back.geo",
        "mesh m = load(\"all.obj\")\ncheck len(m.triangles) == 2\ncheck len(m.vertices) == 4\n",
    );
    let output = virote(&scratch.0).arg("run").arg(back).output().expect("it starts");
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn surfaces_side_by_side_in_a_file_share_the_vertices_of_their_edges() {
    let scratch = Scratch::new("readback-body");
    let script = scratch.file(
        "body.geo",
        "surface side = cone((0, 0, 0), 2, 1, 3)\n\
         surface low = reverse_u(revolve(line((2, 0, 0), (0, 0, 0))))\n\
         surface high = revolve(line((1, 0, 3), (0, 0, 3)))\n\
         export side, low, high to \"body.obj\"\n",
    );
    let output = virote(&scratch.0).arg("run").arg(script).output().expect("it starts");
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let options = tobj::LoadOptions::default();
    let (models, _) = tobj::load_obj(scratch.0.join("body.obj"), &options).expect("an OBJ file");
    assert_eq!(models.len(), 3);

    // Every side of a triangle between two places is one of the other way round, bit for bit.
    let mut sides: Vec<[[u64; 3]; 2]> = Vec::new();
    for model in &models {
        let place = |corner: u32| {
            let first = 3 * corner as usize;
            let place = &model.mesh.positions[first..first + 3];
            [0, 1, 2].map(|axis| (place[axis] + 0.0).to_bits())
        };
        for corners in model.mesh.indices.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|i| place(corners[i]));
            sides.extend([[a, b], [b, c], [c, a]]);
        }
    }
    sides.sort_unstable();
    assert!(sides.iter().all(|&[a, b]| sides.binary_search(&[b, a]).is_ok()));
}

/// A script with a surface, a curve and a point, exported to one file of this ending.
fn exported(scratch: &Scratch, ending: &str) -> Vec<u8> {
    let script = scratch.file(
        "s.geo",
        format!(
            "surface s = torus((1, 2, 3), 4, 1) with (color = \"#102030\", layer = \"hull\")\n\
             curve c = circle((0, 0, 9), 2)\npoint p = (7, 8, 9)\nexport all to \"s.{ending}\"\n"
        ),
    );
    assert!(virote(&scratch.0).arg("run").arg(script).status().expect("it starts").success());
    fs::read(scratch.0.join(format!("s.{ending}"))).expect("written")
}

/// A number of four bytes.
fn word(bytes: &[u8], at: usize) -> usize {
    u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize
}

#[test]
fn the_parts_of_a_glb_are_where_its_text_says_and_what_it_says() {
    let scratch = Scratch::new("readback-glb");
    let bytes = exported(&scratch, "glb");
    assert_eq!(
        (&bytes[..4], word(&bytes, 4), word(&bytes, 8)),
        (b"glTF".as_slice(), 2, bytes.len())
    );
    let n_text = word(&bytes, 12);
    let text: serde_json::Value = serde_json::from_slice(&bytes[20..20 + n_text]).expect("JSON");
    let binary = &bytes[28 + n_text..];
    assert_eq!(binary.len(), word(&bytes, 20 + n_text));
    assert_eq!(text["buffers"][0]["byteLength"], binary.len());
    assert_eq!(text["materials"][0]["name"], "hull");

    let number = |json: &serde_json::Value| json.as_u64().expect("a number") as usize;
    let mut next = 0;
    for accessor in text["accessors"].as_array().expect("a list") {
        let view = &text["bufferViews"][number(&accessor["bufferView"])];
        let (first, n_bytes) = (number(&view["byteOffset"]), number(&view["byteLength"]));
        assert_eq!((first, first % 4), (next, 0));
        next = first + n_bytes;
        let count = number(&accessor["count"]);
        if accessor["type"] == "SCALAR" {
            assert_eq!(n_bytes, 4 * count);
            continue;
        }
        assert_eq!(n_bytes, 12 * count);
        let read = |i: usize| {
            let at = first + 4 * i;
            f32::from_le_bytes(binary[at..at + 4].try_into().expect("four bytes"))
        };
        for axis in 0..3 {
            let of_axis = (0..count).map(|i| read(3 * i + axis));
            let (low, high) =
                (of_axis.clone().fold(f32::MAX, f32::min), of_axis.fold(f32::MIN, f32::max));
            if let Some(least) = accessor["min"].get(axis) {
                assert_eq!(least.as_f64(), Some(f64::from(low)));
                assert_eq!(accessor["max"][axis].as_f64(), Some(f64::from(high)));
            }
        }
    }
    assert_eq!(next, binary.len());
    // The point in metres, y upward.
    let places = text["accessors"].as_array().expect("a list").last().expect("the point's");
    for (found, expected) in
        places["min"].as_array().expect("three").iter().zip([0.007, 0.009, -0.008])
    {
        assert!((found.as_f64().expect("a number") - expected).abs() < 1e-9);
    }
}

#[test]
fn every_record_of_a_step_file_that_is_named_exists_once() {
    let scratch = Scratch::new("readback-step");
    let text = String::from_utf8(exported(&scratch, "step")).expect("ASCII");
    assert!(
        text.is_ascii()
            && text.starts_with("ISO-10303-21;")
            && text.ends_with("END-ISO-10303-21;\n")
    );
    let records: Vec<&str> = text.lines().filter(|line| line.starts_with('#')).collect();
    for (i, record) in records.iter().enumerate() {
        let (name, body) = record.split_once('=').expect("a record");
        assert_eq!(name, format!("#{}", i + 1));
        for reference in body.split('#').skip(1) {
            let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
            let number: usize = digits.parse().expect("a number");
            assert!((1..=records.len()).contains(&number) && number != i + 1, "{record}");
        }
        assert_eq!(body.matches('(').count(), body.matches(')').count(), "{record}");
    }
}

#[test]
fn cards_of_iges_have_eighty_columns_and_numbers_in_order() {
    let scratch = Scratch::new("readback-iges");
    let text = String::from_utf8(exported(&scratch, "igs")).expect("ASCII");
    let mut counts = std::collections::BTreeMap::<char, usize>::new();
    for card in text.lines() {
        assert_eq!(card.len(), 80, "{card}");
        let section = card.as_bytes()[72] as char;
        let count = counts.entry(section).or_default();
        *count += 1;
        assert_eq!(card[73..].trim().parse(), Ok(*count), "{card}");
    }
    let last = text.lines().last().expect("a card");
    for (i, section) in ['S', 'G', 'D', 'P'].into_iter().enumerate() {
        let told = format!("{section}{:>7}", counts[&section]);
        assert_eq!(&last[8 * i..8 * (i + 1)], told);
    }
}
