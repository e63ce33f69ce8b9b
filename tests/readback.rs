//! Files that we write, read by programs that we did not write.

mod support;

use std::fs;

use support::{Scratch, folder, virote};

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
