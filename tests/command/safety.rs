//! Files of a run that does not end well: what stood there before stays, or the whole new file is
//! there, and nothing else.

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
    thread,
    time::Instant,
};

use crate::support::{Scratch, told, virote};

/// Every form of file that geometry and tables have.
const ALL_FORMATS: &str = r#"
curves rings = [for h in 0..8: circle((0, 0, h), 2 + h / 4)]
surface wall = skin(rings) with (color = "steelblue", layer = "hull")
mesh net = tessellate(wall, tolerance = 0.05)
table places = curvature_table(rings[0], samples = 20)
export rings, wall, net to "a.obj"
export rings, wall to "b.obj" with (free_form = true)
export wall, net to "c.stl"
export rings, wall, net to "d.ply"
export rings, wall, net to "e.glb"
export rings, wall, net to "f.gltf"
export rings, wall, net to "g.svg" with (view = "isometric")
export rings, wall, net to "h.dxf"
export rings, wall to "i.step"
export rings, wall to "j.igs"
export places to "k.csv"
export rings, wall, net, places to "l.json"
print places
export report to "m.html"
export report to "n.md" with (view = "front")
"#;

/// The files of a folder with their content, by name.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry"));
    let mut files: Vec<_> = entries
        .map(|entry| {
            let content = fs::read(entry.path()).expect("a file");
            (entry.file_name().to_string_lossy().into_owned(), content)
        })
        .collect();
    files.sort();
    files
}

#[test]
fn files_are_the_same_bytes_for_any_number_of_threads() {
    let scratch = Scratch::new("threads");
    let script = scratch.file("all.geo", ALL_FORMATS);
    let mut before: Option<Vec<(String, Vec<u8>)>> = None;
    for n_threads in ["1", "2", "7"] {
        let out = scratch.0.join(n_threads);
        let (said, err, code) = told(
            &virote(&scratch.0)
                .args(["run", "--threads", n_threads, "--out"])
                .arg(&out)
                .arg(&script)
                .output()
                .expect("it starts"),
        );
        assert_eq!(code, 0, "{said}{err}");
        let now = files(&out);
        assert_eq!(now.len(), 14);
        assert!(before.as_ref().is_none_or(|before| *before == now), "{n_threads} threads");
        before = Some(now);
    }
}

/// A script that takes a while to write one file.
const LONG: &str = r#"
mesh net = grid_mesh(torus((0, 0, 0), 5, 2), 120, 250)
export net to "net.obj"
"#;

#[test]
fn a_killed_run_leaves_the_old_file_or_the_new_one() {
    let scratch = Scratch::new("killed");
    let script = scratch.file("long.geo", LONG);
    let begin = || {
        virote(&scratch.0)
            .arg("run")
            .arg(&script)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("it starts")
    };
    let path = scratch.0.join("net.obj");
    let started = Instant::now();
    assert!(begin().wait().expect("it ends").success());
    let whole = started.elapsed();
    let new = fs::read(&path).expect("written");

    let old = b"what stood here before".as_slice();
    // The same fifty moments each time, spread over the run: a generator of Lehmer's.
    let mut random = 20_u64;
    let mut n_old = 0;
    for _ in 0..50 {
        fs::write(&path, old).expect("a file");
        let mut run = begin();
        random = random * 48_271 % 2_147_483_647;
        thread::sleep(whole.mul_f64(random as f64 / 2_147_483_647.0));
        // It may have ended already.
        let _ = run.kill();
        run.wait().expect("it ends");
        let found = fs::read(&path).expect("a file");
        assert!(found == old || found == new, "a torn file of {} bytes", found.len());
        n_old += usize::from(found == old);
    }
    assert!(0 < n_old, "no run was killed before its end");
}

#[test]
fn a_disk_without_room_leaves_the_old_file_and_nothing_else() {
    let scratch = Scratch::new("full");
    let script = scratch.file("long.geo", LONG);
    let out = scratch.0.join("out");
    fs::create_dir_all(&out).expect("a folder");
    fs::write(out.join("net.obj"), "old").expect("a file");
    // No file may grow beyond some blocks; without the signal a write fails as on a full disk.
    let shell = "trap '' XFSZ; ulimit -f 64; exec \"$@\"";
    let run = Command::new("sh")
        .args(["-c", shell, "sh", env!("CARGO_BIN_EXE_virote"), "run", "--out"])
        .arg(&out)
        .arg(&script)
        .output();
    let (_, err, code) = told(&run.expect("it starts"));
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("cannot write `net.obj`"), "{err}");
    assert_eq!(files(&out), [("net.obj".to_owned(), b"old".to_vec())]);
}

#[test]
fn a_device_is_replaced_by_no_file() {
    let scratch = Scratch::new("device");
    let script = scratch.file("a.geo", "export line((0, 0), (1, 0)) to \"full/a.obj\"\n");
    let run = virote(&scratch.0).args(["run", "--out", "/dev"]).arg(script).output();
    let (_, err, code) = told(&run.expect("it starts"));
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("cannot write"), "{err}");
}

#[test]
fn a_folder_that_cannot_be_written_is_told() {
    let scratch = Scratch::new("read-only");
    let script = scratch.file("a.geo", "export line((0, 0), (1, 0)) to \"a.obj\"\n");
    let out = scratch.0.join("out");
    fs::create_dir_all(&out).expect("a folder");
    let mut permissions = fs::metadata(&out).expect("a folder").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&out, permissions).expect("our folder");
    if fs::write(out.join("probe"), "").is_ok() {
        // The one who may write everywhere.
        return;
    }
    let run = virote(&scratch.0).args(["run", "--out"]).arg(&out).arg(script).output();
    let (_, err, code) = told(&run.expect("it starts"));
    assert_eq!(code, 3, "{err}");
    assert!(err.contains("cannot write `a.obj`"), "{err}");
    assert!(files(&out).is_empty());
}

#[test]
fn an_error_half_way_writes_no_file_of_the_run() {
    let scratch = Scratch::new("half-way");
    let script = scratch.file(
        "a.geo",
        "mesh m = grid_mesh(sphere((0, 0), 1), 9, 9)\n\
         surface s = bilinear((0, 0), (0, 1e40), (1e40, 0), (1e40, 1e40))\n\
         export m to \"a.stl\"\nexport m, s to \"b.stl\"\n",
    );
    let out = scratch.0.join("out");
    let run = virote(&scratch.0).args(["run", "--out"]).arg(&out).arg(script).output();
    let (_, err, code) = told(&run.expect("it starts"));
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("nothing was written"), "{err}");
    assert!(!out.exists(), "the folder was made for nothing");
}

#[test]
fn nothing_but_messages_goes_to_a_standard_error_that_is_no_terminal() {
    let scratch = Scratch::new("silent");
    let script = scratch.file("long.geo", LONG);
    let (_, err, code) =
        told(&virote(&scratch.0).arg("run").arg(script).output().expect("it starts"));
    assert_eq!((code, err.as_str()), (0, ""));
}
