//! The command as a process: exit codes, options, files that are whole or not at all.

use std::{
    fs,
    io::Write as _,
    process::{Command, Stdio},
};

use crate::support::{Scratch, files_below, told, virote};
use serde_json::Value as Json;

const CURVE: &str = "curve c = bezier((0, 0), (1, 2), (2, 0))\n";

/// Runs the command in the folder; standard output, standard error, exit code.
fn run(scratch: &Scratch, args: &[&str]) -> (String, String, i32) {
    told(&virote(&scratch.0).args(args).output().expect("the command runs"))
}

/// Runs the command with `text` at its standard input.
fn piped(scratch: &Scratch, args: &[&str], text: &[u8]) -> (String, String, i32) {
    let mut command = virote(&scratch.0);
    command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the command runs");
    child.stdin.take().expect("a pipe").write_all(text).expect("the script is taken");
    told(&child.wait_with_output().expect("the command ends"))
}

/// The exit code of `script`, with everything it said for the message when it is another.
#[track_caller]
fn check_code(script: &str, args: &[&str], expected: i32) {
    let scratch = Scratch::new(&format!("code-{expected}-{:x}", fingerprint(script, args)));
    scratch.file("a.geo", script);
    let (out, err, code) = run(&scratch, args);
    assert_eq!(code, expected, "{args:?}\n{out}{err}");
    assert!(!err.contains("virote failed"), "{err}");
}

/// A number that tells tests apart that run at the same time.
fn fingerprint(script: &str, args: &[&str]) -> u64 {
    let texts = std::iter::once(&script).chain(args);
    texts
        .flat_map(|text| text.bytes())
        .fold(7, |sum, byte| sum * 31 % 1_000_000_007 + u64::from(byte))
}

#[test]
fn exit_code_0_when_all_is_well() {
    check_code("check 1 + 1 == 2", &["run", "a.geo"], 0);
    check_code("check 1 + 1 == 2", &["check", "a.geo"], 0);
    check_code("", &["run", "a.geo"], 0);
    check_code("", &["--version"], 0);
    check_code("", &["--help"], 0);
    check_code("", &["run", "--help"], 0);
}

#[test]
fn exit_code_1_when_a_check_fails() {
    check_code("check 1 + 1 == 3", &["run", "a.geo"], 1);
    check_code("check 1 + 1 == 3", &["check", "a.geo"], 1);
    check_code("check 1 + 1 == 3", &["run", "a.geo", "--quiet"], 1);
}

#[test]
fn exit_code_2_when_the_script_is_wrong() {
    check_code("print 1 / 0", &["run", "a.geo"], 2);
    check_code("print (", &["check", "a.geo"], 2);
    check_code("check 1 == 2\nprint 1 / 0", &["run", "a.geo"], 2);
    check_code("param n = 3 in 1..5", &["run", "a.geo", "--set", "n=9"], 2);
    check_code("let m = load(\"missing.obj\")", &["run", "a.geo"], 2);
    check_code("export (0, 0) to \"../p.obj\"", &["check", "a.geo"], 2);
    check_code("export (0, 0) to \"p.xyz\"", &["check", "a.geo"], 2);
}

#[test]
fn exit_code_3_for_usage_and_files() {
    check_code("param n = 3", &["run", "a.geo", "--set", "m=3"], 3);
    check_code("param n = 3", &["run", "a.geo", "--set", "n"], 3);
    check_code("", &["run", "missing.geo"], 3);
    check_code("", &["run", "."], 3);
    check_code("", &[], 3);
    check_code("", &["run"], 3);
    check_code("", &["rnu", "a.geo"], 3);
    check_code("", &["run", "a.geo", "--colour"], 3);
    check_code("export (0, 0) to \"p.obj\"", &["run", "a.geo", "--out", "a.geo"], 3);
    check_code("export (0, 0) to \"a.geo/p.obj\"", &["run", "a.geo"], 3);
}

#[test]
fn an_unknown_setting_is_told_with_the_nearest_name() {
    let scratch = Scratch::new("setting");
    scratch.file("a.geo", "param neck = 13mm\nprint neck\nexport (0, 0) to \"p.obj\"");
    let (out, err, code) = run(&scratch, &["run", "a.geo", "--set", "nekc=15mm"]);
    assert_eq!((out.as_str(), code), ("", 3));
    assert!(err.contains("`nekc`") && err.contains("did you mean `neck`?"), "{err}");
    assert_eq!(files_below(&scratch.0), ["a.geo"], "nothing is written");
}

#[test]
fn settings_take_units_strings_and_bools() {
    let scratch = Scratch::new("settings");
    scratch.file(
        "a.geo",
        "param neck = 13mm in 8mm..20mm\nparam tilt = 30deg\nparam n: integer = 5\nparam finish = \"gloss\"\nparam closed = false\n\
         print neck, tilt, n, finish, closed",
    );
    let args = [
        "run",
        "a.geo",
        "-D",
        "neck=1.5cm",
        "--set",
        "tilt=0.25turn",
        "--set",
        "n=7",
        "--set",
        "finish=a b",
        "-D",
        "closed=true",
    ];
    let (out, err, code) = run(&scratch, &args);
    assert_eq!(
        (out.as_str(), err.as_str(), code),
        ("neck = 15mm\ntilt = 90deg\nn = 7\nfinish = \"a b\"\nclosed = true\n", "", 0)
    );
    // The last one counts.
    let (out, ..) = run(&scratch, &["run", "a.geo", "-D", "n=7", "-D", "n=8"]);
    assert!(out.contains("n = 8"), "{out}");
    let (_, err, code) = run(&scratch, &["check", "a.geo", "-D", "neck=2m"]);
    assert_eq!(code, 2);
    assert!(err.contains("--set neck=2m"), "{err}");
}

#[test]
fn a_dash_is_standard_input() {
    let scratch = Scratch::new("stdin");
    assert_eq!(
        piped(&scratch, &["run", "-"], b"print 1 + 1"),
        ("1 + 1 = 2\n".to_owned(), String::new(), 0)
    );
    let (_, err, code) = piped(&scratch, &["check", "-"], b"print 1 / 0");
    assert_eq!(code, 2);
    assert!(err.contains("<stdin>:1:7"), "{err}");
    // Paths are relative to the current folder.
    scratch.file("points.json", "[1, 2, 3]");
    let (out, ..) = piped(
        &scratch,
        &["run", "-"],
        b"print sum(load(\"points.json\"))\nexport (0, 0) to \"p.obj\"",
    );
    assert!(out.starts_with("sum(load(\"points.json\")) = 6\n"), "{out}");
    assert_eq!(files_below(&scratch.0), ["p.obj", "points.json"]);
}

#[test]
fn a_byte_order_mark_is_allowed() {
    let scratch = Scratch::new("mark");
    assert_eq!(piped(&scratch, &["run", "-"], b"\xef\xbb\xbfprint 2").0, "2 = 2\n");
}

#[test]
fn files_go_to_the_scripts_folder_or_to_out() {
    let scratch = Scratch::new("out");
    scratch.file("below/a.geo", format!("{CURVE}export c to \"deep/c.json\""));
    assert_eq!(run(&scratch, &["run", "below/a.geo"]).2, 0);
    assert_eq!(run(&scratch, &["run", "below/a.geo", "--out", "new/folder"]).2, 0);
    assert_eq!(
        files_below(&scratch.0),
        ["below/a.geo", "below/deep/c.json", "new/folder/deep/c.json"]
    );
}

#[test]
fn a_dry_run_and_a_check_write_nothing() {
    let scratch = Scratch::new("dry");
    scratch.file("a.geo", format!("{CURVE}export c to \"c.json\"\nprint 1"));
    let (out, err, code) = run(&scratch, &["run", "a.geo", "--out", "build", "--dry-run"]);
    assert_eq!((out.as_str(), err.as_str(), code), ("would write c.json\n1 = 1\n", "", 0));
    assert_eq!(run(&scratch, &["check", "a.geo"]).2, 0);
    assert_eq!(files_below(&scratch.0), ["a.geo"]);
    assert!(!scratch.0.join("build").exists(), "not even a folder");
}

#[test]
fn quiet_leaves_what_the_script_prints() {
    let scratch = Scratch::new("quiet");
    scratch.file("a.geo", format!("{CURVE}export c to \"c.json\"\nprint 1\ncheck true"));
    assert_eq!(
        run(&scratch, &["run", "a.geo", "--quiet"]),
        ("1 = 1\n".to_owned(), String::new(), 0)
    );
    assert_eq!(
        run(&scratch, &["run", "a.geo"]).0,
        "wrote c.json: 1 value\n1 = 1\n1 check passed\n"
    );
    scratch.file("b.geo", "print 1 / 0");
    assert!(
        run(&scratch, &["run", "b.geo", "--quiet"]).1.contains("E0501"),
        "errors are not silenced"
    );
}

/// The lines of standard output as JSON objects.
#[track_caller]
fn objects(out: &str) -> Vec<Json> {
    let objects = out.lines().map(|line| serde_json::from_str(line).expect("a line is JSON"));
    let objects: Vec<Json> = objects.collect();
    assert!(objects.iter().all(Json::is_object), "{out}");
    objects
}

#[test]
fn json_is_an_object_a_line() {
    let scratch = Scratch::new("json");
    let script = format!(
        "{CURVE}print c(0.5), \"a\\nb\"\ncheck 1 == 2 \"no\"\ncheck true\nexport c to \"c.json\"\nlet ä = 1 / 0\n"
    );
    scratch.file("a.geo", &script);
    let (out, err, code) = run(&scratch, &["check", "a.geo", "--message-format", "json"]);
    assert_eq!((err.as_str(), code), ("", 2));
    let objects = objects(&out);
    let of = |kind: &str| {
        objects.iter().filter(|object| object["type"] == kind).cloned().collect::<Vec<_>>()
    };
    let errors: Vec<Json> =
        of("diagnostic").into_iter().filter(|found| found["severity"] == "error").collect();
    assert_eq!(errors.len(), 1, "{out}");
    assert_eq!(errors[0]["code"], "E0501");
    assert_eq!(errors[0]["labels"][0]["file"], "a.geo");
    assert_eq!(
        (&errors[0]["labels"][0]["line"], &errors[0]["labels"][0]["column"]),
        (&Json::from(6), &Json::from(9))
    );
    let bytes = errors[0]["labels"][0]["start_byte"].as_u64().expect("a byte") as usize;
    assert_eq!(&script[bytes..bytes + 5], "1 / 0", "bytes index the text");
    assert_eq!(of("print").len(), 2);
    assert_eq!(of("print")[0]["source"], "c(0.5)");
    assert_eq!(of("print")[0]["text"], "(1, 1, 0)");
    assert_eq!(of("check").len(), 2);
    assert_eq!(
        (&of("check")[0]["holds"], &of("check")[0]["message"]),
        (&Json::from(false), &Json::from("no"))
    );
    // Trouble with files is an object too.
    let (out, err, code) = run(&scratch, &["check", "missing.geo", "--message-format", "json"]);
    assert_eq!((err.as_str(), code), ("", 3));
    assert_eq!(self::objects(&out).len(), 1);
}

#[test]
fn json_tells_of_every_error() {
    let scratch = Scratch::new("json-200");
    let script: String = (0..200).map(|i| format!("let a{i} = missing_{i}\n")).collect();
    scratch.file("a.geo", script);
    let (out, ..) = run(&scratch, &["check", "a.geo", "--message-format", "json"]);
    assert_eq!(objects(&out).len(), 200);
}

#[test]
fn the_worst_of_several_scripts_counts() {
    let scratch = Scratch::new("several");
    scratch.file("well.geo", "check true");
    scratch.file("failed.geo", "check false");
    scratch.file("wrong.geo", "print 1 / 0");
    let code = |files: &[&str]| run(&scratch, &[&["check"], files].concat()).2;
    assert_eq!(code(&["well.geo", "well.geo"]), 0);
    assert_eq!(code(&["failed.geo", "well.geo"]), 1);
    assert_eq!(code(&["failed.geo", "wrong.geo", "well.geo"]), 2);
    assert_eq!(code(&["missing.geo", "wrong.geo"]), 3);
    let (_, err, _) = run(&scratch, &["check", "failed.geo", "wrong.geo"]);
    assert!(err.contains("failed.geo") && err.contains("wrong.geo"), "{err}");
}

#[test]
fn built_ins_are_explained() {
    let scratch = Scratch::new("doc");
    let (out, err, code) = run(&scratch, &["doc"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.contains("bezier") && out.contains("Surfaces") && out.contains("tau"), "{out}");
    let (out, err, code) = run(&scratch, &["doc", "bezier"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.contains("bezier(points") && out.contains("weights"), "{out}");
    let (out, err, code) = run(&scratch, &["doc", "bezeir"]);
    assert_eq!((out.as_str(), code), ("", 3));
    assert!(err.contains("did you mean `bezier`?"), "{err}");
    assert_eq!(run(&scratch, &["doc", "pi"]).2, 0);
    for word in ["let", "param", "check", "import", "golden", "mm", "ranges"] {
        let (out, err, code) = run(&scratch, &["doc", word]);
        assert_eq!((err.as_str(), code), ("", 0), "{word}");
        assert!(out.contains(word.trim_end_matches('s')), "{word}: {out}");
    }
}

#[test]
fn codes_are_explained() {
    let scratch = Scratch::new("explain");
    let (out, err, code) = run(&scratch, &["explain", "E0602"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.starts_with("E0602: "), "{out}");
    assert_eq!(run(&scratch, &["explain", "e0602"]).0, out);
    let (out, err, code) = run(&scratch, &["explain"]);
    assert_eq!((err.as_str(), code), ("", 0));
    for code in virote::diag::Code::ALL {
        assert!(out.contains(code.id()), "{} is not listed", code.id());
    }
    // A code that no mistake has any more is told what holds instead.
    let (out, err, code) = run(&scratch, &["explain", "e0203"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.starts_with("E0203: ") && out.contains("no mistake any more"), "{out}");
    let (out, err, code) = run(&scratch, &["explain", "E9999"]);
    assert_eq!((out.as_str(), code), ("", 3));
    assert!(err.contains("E9999"), "{err}");
}

#[test]
fn help_has_examples_and_exit_codes() {
    let scratch = Scratch::new("help");
    let (out, err, code) = run(&scratch, &["--help"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(
        out.contains("Examples:") && out.contains("virote run") && out.contains("Exit codes:"),
        "{out}"
    );
    for verb in ["run", "check", "test", "params", "graph", "fmt", "doc", "explain"] {
        let (out, ..) = run(&scratch, &[verb, "--help"]);
        let has_example =
            ["Example: virote", "Examples:\n  virote"].iter().any(|s| out.contains(s));
        assert!(has_example, "{verb}: {out}");
    }
}

#[test]
fn without_a_terminal_there_is_no_colour() {
    let scratch = Scratch::new("colour");
    scratch.file("a.geo", "check 1 == 2\nprint 1 / 0");
    let (out, err, _) = run(&scratch, &["run", "a.geo"]);
    assert!(!out.contains('\x1b') && !err.contains('\x1b'), "{err:?}");
    assert!(run(&scratch, &["run", "a.geo", "--color", "always"]).1.contains('\x1b'));
}

#[test]
fn what_no_error_touches_is_printed_drawn_and_written() {
    let scratch = Scratch::new("untouched");
    let script = "curve good = line((0, 0), (1, 0)) with (color = \"red\")\n\
                  curve bad = circle((0, 0), -1)\ncurve worse = offset(bad, 1)\n\
                  print good.end\nprint worse\nexport good to \"good.json\"\n\
                  export bad to \"bad.json\"\nexport good, worse to \"both.json\"\n\
                  export all to \"all.obj\"\n";
    scratch.file("a.geo", script);
    let (out, err, code) = run(&scratch, &["run", "a.geo"]);
    assert_eq!(code, 2, "{err}");
    assert_eq!(out, "good.end = (1, 0, 0)\nwrote good.json: 1 value\n");
    assert_eq!(err.matches("Error").count(), 1, "one cause: {err}");
    assert!(err.contains("what an error touches was not written"), "{err}");
    assert_eq!(files_below(&scratch.0), ["a.geo", "good.json"]);
    // One definition by name, and a picture.
    let (out, _, code) = run(&scratch, &["run", "a.geo", "--only", "good", "--out", "only"]);
    assert_eq!((out.contains("wrote good.json"), code), (true, 2), "{out}");
    let (_, err, code) = run(&scratch, &["render", "a.geo", "-o", "a.svg"]);
    assert!(code == 2 && err.contains("what an error touches was not drawn"), "{err}");
    let picture = fs::read_to_string(scratch.0.join("a.svg")).expect("a picture");
    assert!(picture.contains("#ff0000"), "{picture}");
    let (_, err, code) = run(&scratch, &["render", "a.geo", "-o", "b.svg", "--only", "bad"]);
    assert!(code == 2 && err.contains("`bad` has an error, and cannot be drawn"), "{err}");
    // Of a text with mistakes nobody knows all, and of two exports to one path nobody knows which.
    scratch.file("b.geo", "curve a = line((0, 0), (1, 0))\ncurve = 3\nexport all to \"b.obj\"\nexport a to \"b.json\"\nexport a to \"b.json\"");
    let (out, err, code) = run(&scratch, &["run", "b.geo", "--out", "b"]);
    assert_eq!((out.as_str(), code), ("", 2), "{err}");
    assert!(!scratch.0.join("b").exists());
}

#[test]
fn a_strict_run_of_a_failing_script_leaves_an_existing_file_as_it_was() {
    let scratch = Scratch::new("survive");
    scratch.file("c.json", "precious");
    scratch.file("a.geo", format!("{CURVE}export c to \"c.json\"\nprint 1 / 0"));
    let (_, err, code) = run(&scratch, &["run", "a.geo", "--strict"]);
    assert!(
        code == 2 && err.contains("nothing was written, because the script has errors"),
        "{err}"
    );
    let (_, err, code) = run(&scratch, &["render", "a.geo", "-o", "a.svg", "--strict"]);
    assert!(code == 2 && err.contains("nothing was drawn, because the script has errors"), "{err}");
    assert_eq!(fs::read_to_string(scratch.0.join("c.json")).expect("a file"), "precious");
    assert_eq!(files_below(&scratch.0), ["a.geo", "c.json"], "nothing else is left over");
}

#[test]
fn a_failed_check_does_not_keep_files_back() {
    let scratch = Scratch::new("failed-check");
    scratch.file("a.geo", format!("{CURVE}check 1 == 2\nexport c to \"c.json\""));
    assert_eq!(run(&scratch, &["run", "a.geo"]).2, 1);
    assert_eq!(files_below(&scratch.0), ["a.geo", "c.json"]);
}

#[cfg(unix)]
#[test]
fn a_folder_without_permission_is_told() {
    use std::os::unix::fs::PermissionsExt as _;
    let scratch = Scratch::new("permission");
    scratch.file("a.geo", format!("{CURVE}export c to \"locked/c.json\""));
    let locked = scratch.file("locked/c.json", "precious");
    let folder = locked.parent().expect("a folder");
    fs::set_permissions(folder, fs::Permissions::from_mode(0o555)).expect("permissions");
    // Root may write everywhere.
    let may_write = fs::write(folder.join("probe"), "").is_ok();
    let (_, err, code) = run(&scratch, &["run", "a.geo"]);
    fs::set_permissions(folder, fs::Permissions::from_mode(0o755)).expect("permissions");
    if !may_write {
        assert_eq!(code, 3, "{err}");
        assert!(err.contains("permission denied"), "{err}");
        assert_eq!(fs::read_to_string(&locked).expect("a file"), "precious");
    }
}

#[test]
fn two_runs_write_the_same_bytes() {
    let scratch = Scratch::new("same");
    let script = format!(
        "{CURVE}surface s = bezier([[(0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1)]])\n\
         table t = table([for x in random(5): {{ x: x }}])\n\
         export all to \"all.obj\"\nexport s to \"s.stl\"\nexport c, s, t to \"all.json\"\nexport t to \"t.csv\"\nprint s, t"
    );
    scratch.file("a.geo", script);
    let first = run(&scratch, &["run", "a.geo", "--out", "1"]);
    let second = run(&scratch, &["run", "a.geo", "--out", "2"]);
    assert_eq!((first.2, &first), (0, &second));
    let files = files_below(&scratch.0.join("1"));
    assert_eq!(files, ["all.json", "all.obj", "s.stl", "t.csv"]);
    for file in files {
        let bytes = |folder: &str| fs::read(scratch.0.join(folder).join(&file)).expect("a file");
        assert!(bytes("1") == bytes("2"), "{file} differs");
    }
}

#[cfg(unix)]
#[test]
fn a_link_out_of_the_folder_is_refused() {
    let scratch = Scratch::new("link");
    scratch.file("outside/keep.json", "precious");
    scratch.file("inside/a.geo", format!("{CURVE}export c to \"link/keep.json\""));
    std::os::unix::fs::symlink("../outside", scratch.0.join("inside/link")).expect("a link");
    let (_, err, code) = run(&scratch, &["run", "inside/a.geo"]);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("E0704"), "{err}");
    // A link in place of the file itself is replaced, not followed.
    scratch.file("inside/b.geo", format!("{CURVE}export c to \"file.json\""));
    std::os::unix::fs::symlink("../outside/keep.json", scratch.0.join("inside/file.json"))
        .expect("a link");
    run(&scratch, &["run", "inside/b.geo"]);
    assert_eq!(
        fs::read_to_string(scratch.0.join("outside/keep.json")).expect("a file"),
        "precious"
    );
}

#[test]
fn the_script_and_its_inputs_are_never_overwritten() {
    let scratch = Scratch::new("inputs");
    let script = format!("{CURVE}export c to \"a.json\"");
    scratch.file("a.json", &script);
    let (_, err, code) = run(&scratch, &["run", "a.json"]);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("E0704"), "{err}");
    assert_eq!(fs::read_to_string(scratch.0.join("a.json")).expect("a file"), script);

    scratch.file("data/xs.json", "[1, 2]");
    scratch.file("b.geo", "let xs = load(\"data/xs.json\")\nexport xs to \"data/../data/xs.json\"");
    for verb in ["run", "check"] {
        let (_, err, code) = run(&scratch, &[verb, "b.geo"]);
        assert_eq!(code, 2, "{verb}: {err}");
        assert!(err.contains("E0704"), "{err}");
    }
    assert_eq!(fs::read_to_string(scratch.0.join("data/xs.json")).expect("a file"), "[1, 2]");
}

#[test]
fn exact_data_reads_back_to_the_same_bits() {
    let scratch = Scratch::new("round-trip");
    let script = "curve c = circle((0.1, 1/3), 0.7)\nsurface s = bezier([[(0, 0), (0, 1/3)], [(1, 0.1), (1, 1)]])\n\
                  export c, s, [1/3, \"x\", none, true, (0.1, 0.2)] to \"one.json\"\n";
    scratch.file("a.geo", script);
    assert_eq!(run(&scratch, &["run", "a.geo"]).2, 0);
    scratch.file(
        "b.geo",
        "let d = load(\"one.json\")\nlet c = circle((0.1, 1/3), 0.7)\n\
         check d.c.points == c.points\ncheck d.c.knots == c.knots\ncheck d.c.weights == c.weights\ncheck d.s(0.3, 0.4) == bezier([[(0, 0), (0, 1/3)], [(1, 0.1), (1, 1)]])(0.3, 0.4)\n",
    );
    let (out, err, code) = run(&scratch, &["run", "b.geo"]);
    assert_eq!(code, 0, "{out}{err}");
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_panic() {
    let scratch = Scratch::new("pipe");
    scratch.file("a.geo", (0..20_000).map(|i| format!("print {i}\n")).collect::<String>());
    let script = format!("'{}' run a.geo 2>err | head -n 1", env!("CARGO_BIN_EXE_virote"));
    let output =
        Command::new("sh").current_dir(&scratch.0).args(["-c", &script]).output().expect("a shell");
    assert_eq!(told(&output), ("0 = 0\n".to_owned(), String::new(), 0));
    assert_eq!(fs::read_to_string(scratch.0.join("err")).expect("a file"), "");
}

/// A monstrous script ends with an error and no crash.
#[track_caller]
fn check_monster(name: &str, script: &str, code_of_error: &str) {
    let scratch = Scratch::new(&format!("monster-{name}"));
    scratch.file("a.geo", script);
    let (_, err, code) = run(&scratch, &["run", "a.geo"]);
    let start: String = err.chars().take(2000).collect();
    assert_eq!(code, 2, "{name}: {start}");
    assert!(err.contains(code_of_error) && !err.contains("virote failed"), "{name}: {start}");
    assert!(err.len() < 20_000, "{name}: {} bytes of message", err.len());
}

#[test]
fn deep_nesting_is_an_error_and_no_crash() {
    let n = 100_000;
    check_monster("parentheses", &format!("let a = {}1{}", "(".repeat(n), ")".repeat(n)), "E0104");
    check_monster("open-parentheses", &format!("let a = {}", "(".repeat(n)), "E010");
    check_monster("brackets", &format!("let a = {}{}", "[".repeat(n), "]".repeat(n)), "E0104");
    check_monster("blocks", &format!("let a = {}1{}", "{".repeat(n), "}".repeat(n)), "E0104");
    check_monster("ifs", &format!("let a = {}1", "if true then 1 else ".repeat(n)), "E0104");
    check_monster("lambdas", &format!("let a = {}1", "x => ".repeat(n)), "E0");
    check_monster("minuses", &format!("let a = {}1", "- ".repeat(n)), "E0104");
    check_monster("nots", &format!("let a = {}true", "not ".repeat(n)), "E0104");
    check_monster("powers", &format!("let a = {}1", "1 ^ ".repeat(n)), "E0104");
    check_monster("comments", &format!("{} let a = 1", "/* ".repeat(n)), "E0003");
}

#[test]
fn long_chains_are_an_error_and_no_crash() {
    check_monster("sum", &format!("let a = 1{}", " + 1".repeat(1_000_000)), "E0104");
    check_monster("calls", &format!("let a = f{}", "(1)".repeat(100_000)), "E0104");
    check_monster("indices", &format!("let a = f{}", "[0]".repeat(100_000)), "E0104");
    check_monster("fields", &format!("let a = f{}", ".x".repeat(100_000)), "E0104");
    check_monster("pipes", &format!("let a = 1{}", " |> abs".repeat(100_000)), "E0104");
}

#[test]
fn deep_recursion_is_an_error_and_no_crash() {
    check_monster("plain", "fn f(n) = f(n + 1)\nprint f(0)", "E0403");
    check_monster("sum", "fn f(n) = 1 + (2 * (3 - f(n + 1)))\nprint f(0)", "E0403");
    check_monster("block", "fn f(n) = { let a = { let b = f(n + 1) b } a }\nprint f(0)", "E0403");
    check_monster("list", "fn f(n) = [for i in 0..0: [f(n + 1)]]\nprint f(0)", "E0403");
    check_monster("built-in", "fn f(n) = sum(map([n], f))\nprint f(0)", "E0403");
    check_monster("fold", "fn f(n) = fold([1, 2], 0, (a, x) => f(n + 1))\nprint f(0)", "E0403");
    check_monster("lambda", "let f = g => g(g)\nprint f(f)", "E0403");
    let wide = format!("fn f(n) = {}f(n + 1){}\nprint f(0)", "(1 + ".repeat(200), ")".repeat(200));
    check_monster("wide", &wide, "E0403");
}

#[test]
fn deep_values_are_no_crash() {
    // A list in a list, ten thousand deep, is built, compared, printed and thrown away.
    let scratch = Scratch::new("deep-value");
    scratch.file("a.geo", "let deep = fold(0..100000, [], (list, i) => [list])\nprint len(deep), deep == deep, deep\nexport deep to \"deep.json\"");
    let (out, err, code) = run(&scratch, &["run", "a.geo"]);
    let start: String = err.chars().take(2000).collect();
    assert!(
        (code == 0 || code == 2) && !err.contains("virote failed"),
        "{code}: {} {start}",
        out.len()
    );
}

#[test]
fn strange_bytes_are_no_crash() {
    let scratch = Scratch::new("bytes");
    for bytes in [
        &b"\0"[..],
        b"\xff\xfe",
        b"print \"\\u{110000}\"",
        b"print \"{",
        b"print \"{{{\"",
        b"\r\r\r",
        b"let \xf0\x9f\x98\x80 = 1",
        b"export all to \"\0.obj\"",
    ] {
        let (_, err, code) = piped(&scratch, &["check", "-"], bytes);
        assert!((0..=3).contains(&code) && !err.contains("virote failed"), "{bytes:?}: {err}");
    }
}

/// A device on which there is never any room.
#[cfg(target_os = "linux")]
#[test]
fn output_that_cannot_be_written_is_told_by_every_verb() {
    let scratch = Scratch::new("full-device");
    scratch.file("a.geo", "param p = 1\nprint p\ntest \"t\" { check p == 1 }\n");
    scratch.file("b.geo", "print  1\n");
    for args in [
        "run a.geo",
        "params a.geo",
        "params a.geo --json",
        "graph a.geo",
        "graph a.geo --json",
        "test a.geo",
        "run a.geo --message-format json",
        "doc",
        "explain",
        "completions bash",
        "man",
        "--help",
        "--version",
    ] {
        let full = fs::File::options().write(true).open("/dev/full").expect("the device");
        let done = virote(&scratch.0).args(args.split(' ')).stdout(full).output().expect("a run");
        assert_eq!(done.status.code(), Some(3), "{args}");
        let said = String::from_utf8_lossy(&done.stderr);
        assert!(said.contains("cannot write to standard output"), "{args}: {said}");
    }
}

#[test]
fn escape_sequences_of_data_reach_no_terminal() {
    let scratch = Scratch::new("escapes");
    scratch.file("d.json", "{\"a\\u001b[2J\": \"\\u001b[31mred\\u202e\"}");
    let script = "let d = load(\"d.json\")\nprint d\ncheck 1 == 2 \"m\\u{1b}[2J\" // \x1b[2J raw\nprint nothing // \x1b[1m raw\n";
    scratch.file("a.geo", script);
    for color in ["always", "never"] {
        let (said, err, _) = run(&scratch, &["run", "a.geo", "--color", color]);
        assert!(!said.contains('\x1b'), "{said:?}");
        assert!(!err.contains("\x1b[2J") && !err.contains("\x1b[1m raw"), "{err:?}");
        assert!(err.contains("\\u{1b}[2J") || err.contains("\\u{1b}[1m raw"), "{err:?}");
    }
}

#[test]
fn paths_that_other_systems_take_for_one_clash() {
    for (first, second) in
        [("ä.json", "Ä.json"), ("q.json", "q.json/a.json"), ("q.json/a.json", "Q.json")]
    {
        check_code(&format!("export 1 to {first:?}\nexport 2 to {second:?}"), &["run", "a.geo"], 2);
    }
    let scratch = Scratch::new("devices");
    scratch.file("a.geo", "export 1 to \"aux.json\"\n");
    let (_, err, code) = run(&scratch, &["run", "a.geo"]);
    assert!(err.contains("`aux.json` is the name of a device") && code == 0, "{err}");
}

#[test]
fn tables_read_back_from_csv_as_they_were() {
    let table =
        "table t = table({x: [1, 2], s: [\"\", \"1\"]})\ntable u = table({s: [\"\", \" a;\"]})\n";
    let scratch = Scratch::new("tables");
    scratch.file("a.geo", format!("{table}export t to \"t.csv\"\nexport u to \"u.csv\"\n"));
    scratch.file("mac.csv", "x,y\r1,2\r3,4\r");
    scratch.file("marked.json", "\u{feff}[1]");
    scratch.file(
        "b.geo",
        format!(
            "{table}check load(\"t.csv\") == t\ncheck load(\"u.csv\") == u\ncheck load(\"mac.csv\").y == [2, 4]\ncheck load(\"marked.json\") == [1]\n"
        ),
    );
    assert_eq!(run(&scratch, &["run", "a.geo"]).2, 0);
    let (_, err, code) = run(&scratch, &["run", "b.geo"]);
    assert_eq!(code, 0, "{err}");
}
