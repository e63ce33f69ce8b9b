//! Where the command reads and writes: links, pipes, full disks, folders that take nothing, and names
//! that no format was made for.

use std::{
    fs::{self, File},
    os::unix::fs::symlink,
    process::Command,
    time::{Duration, SystemTime},
};

use crate::support::{Scratch, files_below, told, virote};

const SCRIPT: &str =
    "param n = 3\nprint 1\ncurve c = line((0, 0), (1, 1))\nexport c to \"deep/er/c.obj\"\n";

/// Runs a line of the shell in the folder, where `$virote` is the command.
fn shell(scratch: &Scratch, line: &str) -> (String, String, i32) {
    let mut command = Command::new("sh");
    command.args(["-c", line]).current_dir(&scratch.0).env("NO_COLOR", "1");
    told(&command.env("virote", env!("CARGO_BIN_EXE_virote")).output().expect("a shell"))
}

#[test]
fn a_full_standard_output_is_told_by_every_command() {
    let scratch = Scratch::new("full-output");
    scratch.file("a.geo", SCRIPT);
    for line in [
        "run a.geo",
        "run a.geo --message-format json",
        "run a.geo --dry-run",
        "check a.geo --message-format json",
        "test a.geo",
        "graph a.geo",
        "params a.geo",
        "params a.geo --json",
        "doc",
        "doc line",
        "explain",
        "explain E0001",
        "fmt - < a.geo",
        "completions bash",
        "man",
        "man run",
        "--help",
        "--version",
        "run --help",
        "render a.geo -o a.svg",
        "repl < a.geo",
        "watch a.geo",
    ] {
        let (_, err, code) = shell(&scratch, &format!("\"$virote\" {line} > /dev/full"));
        assert_eq!(code, 3, "{line}: {err}");
        assert!(err.contains("cannot write to standard output"), "{line}: {err}");
        let (_, err, code) =
            shell(&scratch, &format!("(\"$virote\" {line}; echo $? > code) | true"));
        assert!(!err.contains("standard output"), "{line}: {code}: {err}");
    }
}

#[test]
fn a_pipe_that_nobody_writes_to_is_refused_and_one_that_the_shell_opened_is_read() {
    let scratch = Scratch::new("pipes");
    scratch.file("a.geo", SCRIPT);
    assert_eq!(shell(&scratch, "mkfifo p.geo").2, 0);
    for line in [
        "run p.geo",
        "check p.geo",
        "fmt p.geo",
        "test p.geo",
        "params p.geo",
        "run a.geo --params p.geo",
    ] {
        let (out, err, code) = shell(&scratch, &format!("timeout 20 \"$virote\" {line}"));
        assert_eq!(code, 3, "{line}: {out}{err}");
        assert!(format!("{out}{err}").contains("is a pipe"), "{line}: {out}{err}");
    }
    for line in ["cat a.geo | \"$virote\" check -", "cat a.geo | \"$virote\" check /dev/stdin"] {
        assert_eq!(shell(&scratch, line).2, 0, "{line}");
    }
}

#[test]
fn a_dry_run_says_what_the_run_would_where_nothing_can_be_written() {
    let scratch = Scratch::new("dry");
    scratch.file("a.geo", "export line((0, 0), (1, 1)) to \"c.obj\"");
    scratch.file("b.geo", SCRIPT);
    let run = |args: &[&str]| told(&virote(&scratch.0).args(args).output().expect("it runs"));
    for out in ["/proc", "a.geo"] {
        let (dry, wet) = (
            run(&["run", "a.geo", "--out", out, "--dry-run"]),
            run(&["run", "a.geo", "--out", out]),
        );
        assert_eq!(dry, wet);
        assert_eq!(dry.2, 3);
    }
    let (out, err, code) = run(&["run", "b.geo", "--out", "new", "--dry-run"]);
    assert_eq!(code, 0, "{out}{err}");
    assert_eq!(files_below(&scratch.0), ["a.geo", "b.geo"]);
    assert!(!scratch.0.join("new").exists());
}

#[test]
fn a_dry_run_warns_of_what_is_turned_as_the_run_does() {
    let scratch = Scratch::new("dry-turned");
    scratch.file(
        "a.geo",
        "mesh m = tessellate(sphere((0, 0), 1), tolerance = 0.1)\n\
         surface ball = flip(sphere((0, 0), 1))\n\
         export ball to \"ball.stl\" with (tolerance = 0.1)\n",
    );
    let [dry, real] = ["--dry-run", "--out o"].map(|how| {
        let (_, err, code) = shell(&scratch, &format!("\"$virote\" run a.geo {how}"));
        assert_eq!(code, 0, "{err}");
        err
    });
    assert!(dry.contains("turned `ball` in the file"), "{dry}");
    assert_eq!(dry, real);
}

#[test]
fn what_is_rewritten_is_written_through_its_links() {
    let scratch = Scratch::new("links");
    scratch.file("real/a.geo", "print   1\n");
    symlink("real/a.geo", scratch.0.join("a.geo")).expect("a link");
    symlink("a.geo", scratch.0.join("b.geo")).expect("a link");
    symlink("real/new.geo", scratch.0.join("c.geo")).expect("a link");
    symlink("real/printed.txt", scratch.0.join("printed.txt")).expect("a link");
    let is_link =
        |name: &str| scratch.0.join(name).symlink_metadata().expect("it is there").is_symlink();
    let read = |name: &str| fs::read_to_string(scratch.0.join(name)).expect("it is there");

    assert_eq!(shell(&scratch, "\"$virote\" fmt b.geo").2, 0);
    assert!(is_link("a.geo") && is_link("b.geo"));
    assert_eq!(read("real/a.geo"), "print 1\n");

    let typed = "printf 'let x = 2\\n:save! b.geo\\n:save c.geo\\n' | \"$virote\" repl";
    assert_eq!(shell(&scratch, typed).2, 0);
    assert!(is_link("a.geo") && is_link("b.geo") && is_link("c.geo"));
    assert!(read("real/a.geo").contains("x = 2") && read("real/new.geo").contains("x = 2"));

    scratch.file("t.geo", "print 7\n");
    assert_eq!(shell(&scratch, "\"$virote\" test --bless t.geo").2, 0);
    let page = scratch.0.join("t.golden/printed.txt");
    let page = if page.exists() { page } else { scratch.0.join("t.golden/golden.json") };
    let kept = scratch.0.join("real/kept");
    fs::rename(&page, &kept).expect("it moves");
    symlink(&kept, &page).expect("a link");
    scratch.file("t.geo", "print 8\n");
    assert_eq!(shell(&scratch, "\"$virote\" test --bless t.geo").2, 0);
    assert!(page.symlink_metadata().expect("it is there").is_symlink());
    assert!(fs::read_to_string(&kept).expect("it is there").len() > 1);

    symlink("round.geo", scratch.0.join("round.geo")).expect("a link");
    let (_, err, _) =
        shell(&scratch, "printf 'let x = 2\\n:save! round.geo\\n' | \"$virote\" repl");
    assert!(err.contains("circle") && is_link("round.geo"), "{err}");
}

#[test]
fn what_cannot_be_written_whole_leaves_nothing_behind() {
    let scratch = Scratch::new("no-room");
    scratch.file("a.geo", SCRIPT);
    // No file may have a byte; the signal that tells so is not wanted.
    for line in [
        "test --bless a.geo",
        "run a.geo",
        "run a.geo --out new/folder",
        "render a.geo -o new/a.svg",
    ] {
        let (out, err, code) =
            shell(&scratch, &format!("trap '' XFSZ; ulimit -f 0; \"$virote\" {line}"));
        assert_ne!(code, 0, "{line}: {out}{err}");
        assert!(format!("{out}{err}").contains("cannot write"), "{line}: {out}{err}");
        let left: Vec<_> = fs::read_dir(&scratch.0)
            .expect("a folder")
            .flatten()
            .map(|entry| entry.file_name())
            .collect();
        assert_eq!(left, ["a.geo"], "{line}");
    }
}

#[test]
fn temporary_files_of_runs_that_were_killed_long_ago_are_cleared() {
    let scratch = Scratch::new("killed");
    scratch.file("a.geo", "export line((0, 0), (1, 1)) to \"c.obj\"");
    let old = |name: &str| {
        let file = File::options().write(true).open(scratch.file(name, "x")).expect("a file");
        let then = SystemTime::now() - Duration::from_secs(3 * 24 * 60 * 60);
        file.set_modified(then).expect("its time is set");
    };
    old(".c.obj.123-0.tmp");
    old(".c.obj.mine.tmp");
    old(".d.obj.123-0.tmp");
    scratch.file(".c.obj.124-0.tmp", "x");
    assert_eq!(shell(&scratch, "\"$virote\" run a.geo").2, 0);
    let left = [".c.obj.124-0.tmp", ".c.obj.mine.tmp", ".d.obj.123-0.tmp", "a.geo", "c.obj"];
    assert_eq!(files_below(&scratch.0), left);
}

#[test]
fn names_that_no_format_was_made_for_stay_names() {
    let scratch = Scratch::new("names");
    let layer = "a\\\"b'c\\n0\\u{d}\\nSECTION\\t<&>]]>\\u{0}\\u{85}\\u{2028}\\u{fffe}\\u{ffff}\\u{1f986}^J\\\\U+0041#;\\\\";
    let endings = ["obj", "stl", "ply", "gltf", "svg", "dxf", "step", "igs", "json"];
    let mut script = String::from(
        "curve c = line((0, 0), (1, 1))\nsurface s = bilinear((0, 0), (1, 0), (0, 1), (1, 1))\n",
    );
    let look = format!("with (layer = \"{layer}\", color = \"red\")");
    script = script.replace("(1, 1))\n", &format!("(1, 1)) {look}\n"));
    for ending in endings {
        let what = if ending == "stl" { "s" } else { "c, s" };
        let text = if matches!(ending, "stl" | "ply") { " with (binary = false)" } else { "" };
        script += &format!("export {what} to \"a.{ending}\"{text}\n");
    }
    scratch.file("a.geo", &script);
    let (out, err, code) = shell(&scratch, "\"$virote\" run a.geo");
    assert_eq!(code, 0, "{out}{err}");
    let read =
        |ending: &str| fs::read_to_string(scratch.0.join(format!("a.{ending}"))).expect("text");

    for ending in ["gltf", "json"] {
        let json: serde_json::Value = serde_json::from_str(&read(ending)).expect("it is JSON");
        assert!(json.to_string().contains("SECTION"));
    }
    let svg = read("svg");
    let is_allowed = |c: char| c == '\n' || (' ' <= c && !matches!(c, '\u{fffe}' | '\u{ffff}'));
    assert!(svg.chars().all(is_allowed), "{svg}");
    assert_eq!(svg.matches("<g").count(), svg.matches("</g>").count(), "{svg}");
    assert!(svg.contains("a&quot;b'c 0  SECTION &lt;&amp;&gt;]]&gt;"), "{svg}");

    let dxf = read("dxf");
    let lines: Vec<&str> = dxf.lines().collect();
    assert!(dxf.is_ascii() && lines.len().is_multiple_of(2), "a code and a value, again and again");
    assert!(lines.chunks(2).all(|pair| pair[0].trim().parse::<u16>().is_ok()), "{dxf}");
    let is_layer = |pair: &&[&str]| pair[0].trim() == "8";
    for pair in lines.chunks(2).filter(is_layer) {
        // Those of others by their number.
        let name = pair[1].replace("\\U+", "");
        assert!(!name.contains(|c| "<>/\\\":;?*|=`,^".contains(c)), "{name}");
    }

    let step = read("step");
    assert!(step.is_ascii());
    let quoted: Vec<&str> = step.split('\'').collect();
    assert!(quoted.len() % 2 == 1, "every string is closed");
    let layer =
        step.lines().find(|line| line.contains("PRESENTATION_LAYER_ASSIGNMENT")).expect("a layer");
    assert!(layer.contains("'a\"b''c 0") && layer.contains("\\\\U+0041#;\\\\'"), "{layer}");

    let igs = read("igs");
    assert!(igs.is_ascii() && igs.lines().all(|line| line.len() == 80), "{igs}");
    for ending in ["obj", "stl", "ply"] {
        assert!(!read(ending).contains("\nSECTION"), "{ending}");
    }
}

#[test]
fn a_dry_run_refuses_a_file_that_would_be_a_folder_too() {
    let scratch = Scratch::new("dry-folder");
    let exports = "export c to \"q.svg\"\nexport c to \"q.svg/a.svg\"\n";
    scratch.file("a.geo", format!("curve c = line((0, 0), (1, 0))\n{exports}"));
    for args in [&["run", "a.geo"][..], &["run", "a.geo", "--dry-run"]] {
        let (_, err, code) = told(&virote(&scratch.0).args(args).output().expect("it runs"));
        assert!(err.contains("E0707") && code == 2, "{args:?}: {code}, {err}");
    }
    assert_eq!(files_below(&scratch.0), ["a.geo"]);
}

#[cfg(unix)]
#[test]
fn a_device_is_no_script_to_import() {
    let scratch = Scratch::new("device");
    std::os::unix::fs::symlink("/dev/zero", scratch.0.join("zero.geo")).expect("a link");
    scratch.file("a.geo", "import \"zero.geo\" as z\nprint z.a\n");
    let (out, err, code) =
        told(&virote(&scratch.0).args(["run", "a.geo"]).output().expect("it runs"));
    assert_eq!((out.as_str(), code), ("", 2), "{err}");
    assert!(err.contains("not a file with an end"), "{err}");
}

#[cfg(unix)]
#[test]
fn escape_sequences_of_file_names_reach_no_terminal() {
    let scratch = Scratch::new("escapes-of-names");
    scratch.file("a\u{1b}[31m.geo", "print x\n");
    for verb in ["run", "check", "test", "fmt", "params"] {
        let args = [verb, "a\u{1b}[31m.geo"];
        let (out, err, _) = told(&virote(&scratch.0).args(args).output().expect("it runs"));
        assert!(!out.contains('\u{1b}') && !err.contains('\u{1b}'), "{verb}: {out}{err}");
    }
}
