//! The verbs that look at a script without making its files: `fmt`, `params`, `graph`; and the
//! options that choose and limit what a run does.

use std::{
    fs,
    io::Write as _,
    process::{Command, Stdio},
};

use crate::support::{Scratch, files_below, folder, programs, told, virote};
use serde_json::{Value as Json, json};
use virote::limits::Ceiling;

/// Runs the command in the folder; standard output, standard error, exit code.
fn run(scratch: &Scratch, args: &[&str]) -> (String, String, i32) {
    told(&virote(&scratch.0).args(args).output().expect("the command runs"))
}

/// Runs the command with `text` at its standard input.
fn piped(scratch: &Scratch, args: &[&str], text: &str) -> (String, String, i32) {
    let mut command: Command = virote(&scratch.0);
    command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the command runs");
    child.stdin.take().expect("a pipe").write_all(text.as_bytes()).expect("the script is taken");
    told(&child.wait_with_output().expect("the command ends"))
}

#[test]
fn formatting_rewrites_what_is_not_canonical() {
    let scratch = Scratch::new("fmt");
    let loose = scratch.file("loose.geo", "let a=1;let b   = [ 1,2 ] // two\n\n\n\nprint a\n");
    let tidy = scratch.file("tidy.geo", "let a = 1\n");
    let before = fs::metadata(&tidy).and_then(|data| data.modified()).expect("a time");

    let (out, err, code) = run(&scratch, &["fmt", "--check", "loose.geo", "tidy.geo"]);
    assert_eq!((out.as_str(), err.as_str(), code), ("would format loose.geo\n", "", 1));
    assert!(fs::read_to_string(&loose).expect("a script").starts_with("let a=1;"));

    let (out, err, code) = run(&scratch, &["fmt", "loose.geo", "tidy.geo"]);
    assert_eq!((out.as_str(), err.as_str(), code), ("formatted loose.geo\n", "", 0));
    let text = fs::read_to_string(&loose).expect("a script");
    assert_eq!(text, "let a = 1\nlet b = [1, 2] // two\n\nprint a\n");
    let after = fs::metadata(&tidy).and_then(|data| data.modified()).expect("a time");
    assert_eq!(before, after, "what is canonical is not touched");

    assert_eq!(run(&scratch, &["fmt", "--check", "loose.geo"]), (String::new(), String::new(), 0));
    assert_eq!(files_below(&scratch.0), ["loose.geo", "tidy.geo"], "nothing is left over");
}

#[test]
fn formatting_takes_standard_input() {
    let scratch = Scratch::new("fmt-stdin");
    let (out, err, code) = piped(&scratch, &["fmt", "-"], "let a=1");
    assert_eq!((out.as_str(), err.as_str(), code), ("let a = 1\n", "", 0));
    let (out, _, code) = piped(&scratch, &["fmt", "--check", "-"], "let a=1");
    assert_eq!((out.as_str(), code), ("would format <stdin>\n", 1));
    let (out, err, code) = piped(&scratch, &["fmt", "-"], "print (");
    assert_eq!((out.as_str(), code), ("", 2));
    assert!(err.contains("<stdin>:1:7"), "{err}");
}

#[test]
fn a_script_with_a_syntax_error_is_left_as_it_is() {
    let scratch = Scratch::new("fmt-broken");
    let broken = scratch.file("broken.geo", "let a=(1\n");
    let loose = scratch.file("loose.geo", "let a=1\n");
    let (_, err, code) = run(&scratch, &["fmt", "broken.geo", "loose.geo"]);
    assert_eq!(code, 2);
    assert!(err.contains("E0102"), "{err}");
    assert_eq!(fs::read_to_string(&broken).expect("a script"), "let a=(1\n");
    assert_eq!(fs::read_to_string(&loose).expect("a script"), "let a = 1\n", "the others go on");
    assert_eq!(run(&scratch, &["fmt", "missing.geo"]).2, 3);
    assert_eq!(run(&scratch, &["fmt"]).2, 3);
}

#[cfg(unix)]
#[test]
fn formatting_keeps_permissions_and_links() {
    use std::os::unix::fs::{PermissionsExt as _, symlink};

    let scratch = Scratch::new("fmt-modes");
    let script = scratch.file("real.geo", "let a=1\n");
    fs::set_permissions(&script, fs::Permissions::from_mode(0o750)).expect("a mode");
    symlink("real.geo", scratch.0.join("link.geo")).expect("a link");
    assert_eq!(run(&scratch, &["fmt", "link.geo"]).2, 0);
    assert_eq!(fs::read_to_string(&script).expect("a script"), "let a = 1\n");
    assert_eq!(fs::metadata(&script).expect("a file").permissions().mode() & 0o777, 0o750);
    assert!(scratch.0.join("link.geo").is_symlink(), "the link stays a link");

    scratch.file("real.geo", "let a=1\n");
    fs::set_permissions(&script, fs::Permissions::from_mode(0o444)).expect("a mode");
    let (_, err, code) = run(&scratch, &["fmt", "real.geo"]);
    assert_eq!(code, 3, "{err}");
    assert_eq!(fs::read_to_string(&script).expect("a script"), "let a=1\n");
}

/// Their lines without a blank in front say the same; what they print is looked at elsewhere.
#[test]
fn the_examples_are_formatted_and_regain_their_form() {
    let scratch = Scratch::new("fmt-examples");
    let examples = folder("examples");
    for file in files_below(&examples).iter().filter(|file| !file.starts_with("golden/")) {
        scratch.file(file, fs::read(examples.join(file)).expect("an example"));
    }
    for name in programs(&examples) {
        let file = format!("{name}.geo");
        assert_eq!(run(&scratch, &["fmt", "--check", &file]).2, 0, "{file} is not formatted");
        let text = fs::read_to_string(examples.join(&file)).expect("an example");
        let flat: String = text.lines().map(|line| line.trim_start().to_owned() + "\n").collect();
        scratch.file(&file, flat);
        let (_, err, formatted) = run(&scratch, &["fmt", &file]);
        assert_eq!(formatted, 0, "{file}: {err}");
        assert_eq!(fs::read_to_string(scratch.0.join(&file)).expect("a script"), text, "{file}");
    }
}

const PLATE: &str = "\
unit cm
/// How wide the plate is,
/// from edge to edge.
param width   = 40mm in 10mm..100mm \"Width of the plate\"
param pitch   = 5mm in 5mm..50mm step 5mm
param teeth: integer = 24 in 8..<200
param tilt    = 0.25turn in 0deg..width / 1cm * 45deg
param finish  = \"matt\" in [\"matt\", \"gloss\"]
param mirror  = false
print 1 / 0
";

#[test]
fn parameters_stand_in_a_table() {
    let scratch = Scratch::new("params");
    scratch.file("plate.geo", PLATE);
    let (out, err, code) = run(&scratch, &["params", "plate.geo"]);
    let expected = "\
name    kind     default  allowed          step   label
width   length   4cm      1cm..10cm               Width of the plate
  How wide the plate is,
  from edge to edge.
pitch   length   0.5cm    0.5cm..5cm       0.5cm
teeth   integer  24       8..<200
tilt    angle    90deg    0deg..180deg
finish  string   \"matt\"   \"matt\", \"gloss\"
mirror  bool     false
";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    let (out, err, code) = piped(&scratch, &["params", "-"], "print 1 / 0");
    assert_eq!((out.as_str(), code), ("", 0));
    assert!(err.contains("`<stdin>` has no parameters"), "{err}");
}

#[test]
fn parameters_are_data() {
    let scratch = Scratch::new("params-json");
    scratch.file("plate.geo", PLATE);
    let (out, _, code) = run(&scratch, &["params", "plate.geo", "--json"]);
    assert_eq!(code, 0);
    let schema: Json = serde_json::from_str(&out).expect("JSON");
    assert_eq!((&schema["file"], &schema["unit"]), (&json!("plate.geo"), &json!("cm")));
    let members = ["name", "kind", "unit", "default", "range", "step", "choices", "label", "docs"];
    for parameter in schema["parameters"].as_array().expect("a list") {
        let found: Vec<&String> = parameter.as_object().expect("an object").keys().collect();
        assert_eq!(found, members);
    }
    let width = &schema["parameters"][0];
    assert_eq!(width["default"], json!(4));
    assert_eq!(width["range"], json!({ "start": 1, "end": 10, "closed": true }));
    assert_eq!(width["docs"], json!("How wide the plate is,\nfrom edge to edge."));
    assert_eq!(schema["parameters"][1]["step"], json!(0.5));
    let tilt = &schema["parameters"][3];
    assert_eq!((&tilt["unit"], &tilt["default"]), (&json!("deg"), &json!(90)));
    assert_eq!(tilt["range"]["end"], json!(180));
    assert_eq!(schema["parameters"][4]["choices"], json!(["matt", "gloss"]));
}

#[test]
fn parameters_of_a_wrong_script_are_not_told() {
    let scratch = Scratch::new("params-wrong");
    for (script, code) in [
        ("param a = 3 in 1..2", "E0802"),
        ("param a = (", "E0102"),
        ("param a = b", "E0201"),
        ("param a = 1 / 0", "E0501"),
        ("param a = 1 \"{nobody}\"", "E0201"),
    ] {
        let (out, err, ending) = piped(&scratch, &["params", "-"], script);
        assert_eq!((out.as_str(), ending), ("", 2), "{script}");
        assert!(err.contains(code), "{script}: {err}");
    }
    scratch.file("part.geo", "let good = 2mm\nlet bad = nobody\n");
    let asked = |script: &str| piped(&scratch, &["params", "-"], script);
    let (out, err, ending) = asked("import \"part.geo\"\nparam a = part.bad\nparam b = 1\n");
    assert_eq!((out.as_str(), ending), ("", 2));
    assert!(err.contains("E0201"), "{err}");
    // What fails elsewhere in an imported file takes nothing away.
    let (out, err, ending) = asked("import \"part.geo\"\nparam a = part.good in 1mm..3mm\n");
    assert_eq!((err.as_str(), ending), ("", 0));
    assert!(out.contains("2mm") && out.contains("1mm..3mm"), "{out}");
    assert_eq!(run(&scratch, &["params", "missing.geo"]).2, 3);
    assert_eq!(run(&scratch, &["graph", "missing.geo"]).2, 3);
}

#[test]
fn the_graph_has_every_definition_and_effect() {
    let scratch = Scratch::new("graph");
    scratch.file("lib.geo", "let one = 1\nlet two = 2\n");
    let script = "\
import \"lib.geo\" (one, two)
param size = 3
fn area(r) = size * r^2
let [a, b] = [one, area(two)]
curves lines = [line((0, 0), (a, b))]
curve line((0, 0), (1, 0)); curve line((0, 0), (2, 0))
check a == 1
export all to \"all-{size}.obj\"
print \"a \\\"b\\\"\", b
";
    let (out, err, code) = piped(&scratch, &["graph", "-"], script);
    let expected = r#"digraph "<stdin>" {
  rankdir = RL

  "one" [label = "one", shape = component]
  "two" [label = "two", shape = component]
  "size" [label = "size", shape = invhouse]
  "area" [label = "area", shape = hexagon]
  "a" [label = "a", shape = box]
  "b" [label = "b", shape = box]
  "lines" [label = "lines", shape = ellipse, peripheries = 2]
  "curve@6" [label = "curve@6", shape = ellipse]
  "curve@6#2" [label = "curve@6#2", shape = ellipse]
  "check@7" [label = "check@7\na == 1", shape = diamond]
  "export@8" [label = "export@8\n\"all-{size}.obj\"", shape = folder]
  "print@9" [label = "print@9\n\"a \\\"b\\\"\", b", shape = note]

  "area" -> "size"
  "a" -> "one"
  "a" -> "two"
  "a" -> "area"
  "b" -> "one"
  "b" -> "two"
  "b" -> "area"
  "lines" -> "a"
  "lines" -> "b"
  "check@7" -> "a"
  "export@8" -> "size"
  "export@8" -> "lines"
  "export@8" -> "curve@6"
  "export@8" -> "curve@6#2"
  "print@9" -> "b"
}
"#;
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));

    let (out, _, code) = piped(&scratch, &["graph", "-", "--json"], script);
    assert_eq!(code, 0);
    let graph: Json = serde_json::from_str(&out).expect("JSON");
    assert_eq!(graph["nodes"].as_array().map(Vec::len), Some(12));
    let area = json!({ "name": "area", "kind": "fn", "line": 3, "uses": ["size"] });
    assert_eq!(graph["nodes"][3], area);
    let check =
        json!({ "name": "check@7", "kind": "check", "line": 7, "text": "a == 1", "uses": ["a"] });
    assert_eq!(graph["nodes"][9], check);
}

#[test]
fn the_graph_of_a_wrong_script_is_not_told() {
    let scratch = Scratch::new("graph-wrong");
    for (script, code) in [("let a = (", "E0102"), ("let a = b", "E0201"), ("let a = a", "E0204")] {
        let (out, err, ending) = piped(&scratch, &["graph", "-"], script);
        assert_eq!((out.as_str(), ending), ("", 2), "{script}");
        assert!(err.contains(code), "{script}: {err}");
    }
    assert_eq!(piped(&scratch, &["graph", "-"], "let a = 1 / 0").2, 0, "nothing is evaluated");
}

const NECK: &str = "param neck = 13mm in 8mm..20mm\nparam n = 1\nparam finish = \"matt\"\nparam open = false\n\
    print neck, n, finish, open\n";

#[test]
fn a_file_gives_parameters() {
    let scratch = Scratch::new("params-file");
    scratch.file("a.geo", NECK);
    let json =
        "{ \"neck\": \"1.5cm\",\n  \"n\": -2.5e-1, \"finish\": \"a \\\"b\\\"\", \"open\": true }\n";
    scratch.file("p.json", json);
    let (out, err, code) = run(&scratch, &["run", "a.geo", "--params", "p.json"]);
    let expected = "neck = 15mm\nn = -0.25\nfinish = \"a \\\"b\\\"\"\nopen = true\n";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    let args = ["run", "a.geo", "--set", "neck=9mm", "--params", "p.json"];
    assert!(run(&scratch, &args).0.starts_with("neck = 9mm\n"), "`--set` wins");
    assert_eq!(run(&scratch, &["check", "a.geo", "--params", "p.json"]).2, 0);
}

#[test]
fn mistakes_in_a_file_of_parameters_are_told_with_their_place() {
    let scratch = Scratch::new("params-mistakes");
    scratch.file("a.geo", NECK);
    for (json, code, text) in [
        ("{\"nekc\": 1}", 3, "did you mean `neck`?"),
        ("{\"n\": 1,\n \"neck\": 9, \"n\": 2}", 3, "p.json:2:13: `n` is given twice"),
        ("{\"n\": 1,\n  \"neck\" 9}", 3, "p.json:2:10: expected `:`"),
        ("{\"n\": 1", 3, "p.json:1:7: EOF"),
        ("", 3, "p.json:1:1: EOF"),
        ("[1]", 3, "p.json:1:1: parameters are an object"),
        ("{\"n\": [1]}", 3, "p.json:1:2: `n` must be a number"),
        ("{\"n\": 1} x", 3, "p.json:1:10: trailing characters"),
        ("{\"neck\": 25}", 2, "`neck` of `p.json` is 25"),
        ("{\"neck\": \"1 +\"}", 2, "`neck` of `p.json` is \"1 +\", which is not a value"),
    ] {
        scratch.file("p.json", json);
        let (out, err, found) = run(&scratch, &["run", "a.geo", "--params", "p.json"]);
        assert_eq!(found, code, "{json}: {out}{err}");
        assert!(err.contains(text), "{json}: {err}");
    }
    let (_, err, code) = run(&scratch, &["run", "a.geo", "--params", "missing.json"]);
    assert_eq!(code, 3);
    assert!(err.contains("cannot read `missing.json`: there is no such file"), "{err}");
}

#[test]
fn an_export_never_overwrites_the_file_of_parameters() {
    let scratch = Scratch::new("params-input");
    scratch.file("a.geo", "param n = 1\nexport n to \"p.json\"");
    scratch.file("p.json", "{\"n\": 2}");
    let (_, err, code) = run(&scratch, &["run", "a.geo", "--params", "p.json"]);
    assert_eq!(code, 2, "{err}");
    assert_eq!(fs::read_to_string(scratch.0.join("p.json")).expect("a file"), "{\"n\": 2}");
}

#[test]
fn only_chooses_exports() {
    let scratch = Scratch::new("only");
    scratch.file(
        "a.geo",
        "curve wall = line((0, 0), (1, 0))\ncurve roof = line((0, 1), (1, 1))\nlet rise = 3\n\
         print rise\nexport wall to \"wall.obj\"\nexport translate(roof, (0, 0, rise)), roof to \"roof.obj\"\n\
         export rise to \"rise-{rise}.json\"\nexport all to \"all.obj\"\n",
    );
    let only = |names: &[&str]| {
        let mut args = vec!["run", "a.geo", "--dry-run"];
        names.iter().for_each(|name| args.extend(["--only", name]));
        run(&scratch, &args)
    };
    let told = |files: &[&str]| {
        let lines: String = files.iter().map(|file| format!("would write {file}\n")).collect();
        (format!("rise = 3\n{lines}"), String::new(), 0)
    };
    assert_eq!(only(&["wall"]), told(&["wall.obj", "all.obj"]));
    assert_eq!(only(&["roof"]), told(&["roof.obj", "all.obj"]));
    assert_eq!(only(&["rise"]), told(&["roof.obj", "rise-3.json"]), "the path does not count");
    assert_eq!(only(&["rise", "wall"]), told(&["wall.obj", "roof.obj", "rise-3.json", "all.obj"]));

    let (out, err, code) = only(&["wal"]);
    assert_eq!((out.as_str(), code), ("", 3));
    assert!(err.contains("the script defines no `wal`; did you mean `wall`?"), "{err}");
    let (_, err, code) = run(&scratch, &["run", "a.geo", "--only", "elephant"]);
    assert_eq!(code, 3);
    assert!(err.contains("defines no `elephant`; its exports name rise, roof, wall"), "{err}");
    assert_eq!(files_below(&scratch.0), ["a.geo"], "nothing is written");

    let script = "let a = 1\nlet b = 2\nexport b to \"b.json\"";
    let (_, err, code) = piped(&scratch, &["run", "-", "--only", "a"], script);
    assert_eq!(code, 3);
    assert!(err.contains("no export of the script names `a`"), "{err}");
}

/// Runs `script` with a ceiling moved; it must be crossed, and the message must name the flag.
#[track_caller]
fn check_crossed(name: &str, value: &str, script: &str) {
    let scratch = Scratch::new(&format!("limit-{name}"));
    scratch.file("data.json", "[1, 2, 3]");
    scratch.file("one.geo", "import \"two.geo\"");
    scratch.file("two.geo", "let two = 2");
    scratch.file("a.geo", script);
    let flag = format!("{name}={value}");
    let (_, err, code) = run(&scratch, &["run", "a.geo", "--limit", &flag]);
    assert_eq!(code, 2, "{name}: {err}");
    assert!(err.contains(&format!("`--limit {name}=N` moves this ceiling")), "{name}: {err}");
    let plain = value.replace('_', "");
    assert!(err.contains(&plain), "{name}: the message tells the ceiling: {err}");
    let (_, err, code) = run(&scratch, &["run", "a.geo"]);
    assert_eq!(code, 0, "{name}: {err}");
}

#[test]
fn every_ceiling_can_be_crossed_and_names_its_flag() {
    check_crossed("source-bytes", "1_0", "print 1 + 1");
    check_crossed("input-bytes", "8", "print load(\"data.json\")");
    check_crossed("nesting", "3", "print ((((1))))");
    check_crossed("chain", "3", "print 1 + 1 + 1 + 1 + 1");
    check_crossed("call-depth", "5", "fn f(n) = if n == 0 then 0 else f(n - 1)\nprint f(9)");
    check_crossed("evaluation-depth", "9", "fn f(n) = if n == 0 then 0 else f(n - 1)\nprint f(9)");
    check_crossed("value-depth", "3", "print [[[[1]]]]");
    check_crossed("list-length", "4", "print range(1, 9, 1)");
    check_crossed("list-length", "4", "print [for i in 1..9: i]");
    check_crossed("list-length", "4", "print map(1..9, i => i)");
    check_crossed("steps", "4", "print [for i in 1..9: i]");
    check_crossed(
        "mesh-vertices",
        "4",
        "print grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 9, 9)",
    );
    check_crossed("import-nesting", "1", "import \"one.geo\"");
    check_crossed("output-bytes", "100", "export range(1, 100, 1) to \"a.json\"");
    check_crossed("control-points", "3", "curve c = polyline((0, 0), (1, 0), (2, 0), (3, 0))");
    check_crossed("control-points", "3", "surface s = bilinear((0, 0), (0, 1), (1, 0), (1, 1))");
    check_crossed("degree", "2", "curve c = bezier((0, 0), (1, 0), (2, 0), (3, 0))");
    check_crossed("value-size", "9", "let five = [1, 2, 3, 4]\nprint [five, five]");
    check_crossed("text-bytes", "9", "let six = \"abcdef\"\nprint \"{six}{six}\"");
}

/// Many values of a moderate size: in a list, in calls inside one another, one inside the other,
/// as points, as meshes.
const HOARDS: [&str; 5] = [
    "let all = [for i in 1..30: linspace(0, i, 1e5)]",
    "fn f(n) = { let a = linspace(0, 1, 1e5); if n == 0 then a[0] else f(n - 1) + a[1] }\nprint f(30)",
    "let all = fold(1..30, {}, (found, i) => { before: found, list: linspace(0, i, 1e5) })",
    "let all = [for i in 1..30: sample(line((0, 0), (1, i)), 100000)]",
    "let all = [for i in 1..30: grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 300, 300)]",
];

#[test]
fn memory_runs_out_with_a_message() {
    let definitions: String =
        (0..30).map(|i| format!("let a{i} = linspace(0, 1, 1e5)\n")).collect();
    let copies: String = (0..30).map(|i| format!("let a{i} = [...b, {i}]\n")).collect();
    let copies = format!("{copies}let b = linspace(0, 1, 1e5)\n");
    let block = format!("let all = {{\n{copies}0 }}\n");
    for script in HOARDS.into_iter().chain([&*definitions, &*copies, &*block]) {
        check_crossed(Ceiling::MEMORY, "20_000_000", script);
    }
    let scratch = Scratch::new("limit-memory");
    scratch.file("a.geo", format!("print 1\n{definitions}print len(a0)"));
    let told = |threads: &str| {
        let limit = ["run", "a.geo", "--limit", "memory=20_000_000", "--threads", threads];
        run(&scratch, &limit)
    };
    let (out, err, code) = told("1");
    assert_eq!((out.as_str(), code), ("", 2), "{err}");
    assert_eq!(err.matches("of memory").count(), 1, "told once: {err}");
    assert_eq!(told("1"), told("4"), "the number of threads does not show");
}

#[test]
fn a_file_beyond_its_ceiling_leaves_nothing() {
    let scratch = Scratch::new("limit-output");
    scratch.file("out/b.json", "before");
    scratch.file(
        "a.geo",
        "export range(1, 3, 1) to \"a.json\"\nexport range(1, 999, 1) to \"b.json\"",
    );
    let args = ["run", "a.geo", "--out", "out", "--limit", "output-bytes=400"];
    let (out, err, code) = run(&scratch, &args);
    assert_eq!((out.as_str(), code), ("", 2));
    assert!(err.contains("`b.json` would be a file of more than 400 bytes"), "{err}");
    assert!(err.contains("nothing was written"), "{err}");
    assert_eq!(files_below(&scratch.0), ["a.geo", "out/b.json"]);
    assert_eq!(fs::read_to_string(scratch.0.join("out/b.json")).expect("a file"), "before");
}

#[cfg(target_os = "linux")]
#[test]
fn a_small_address_space_is_enough() {
    let scratch = Scratch::new("limit-address-space");
    scratch.file(
        "a.geo",
        "fn f(n) = if n == 0 then 0 else 1 + f(n - 1)\nprint f(depth)\nparam depth = 1000\n",
    );
    for (kilobytes, setting, expected) in
        [("400000", "depth=1000", 0), ("400000", "depth=1e9", 2), ("150000", "depth=100", 0)]
    {
        let command = format!(
            "ulimit -v {kilobytes}; '{}' run a.geo --threads 1 --set {setting}",
            env!("CARGO_BIN_EXE_virote")
        );
        let shell = Command::new("sh").args(["-c", &command]).current_dir(&scratch.0).output();
        let (out, err, code) = told(&shell.expect("a shell"));
        assert_eq!(code, expected, "{kilobytes} {setting}: {out}{err}");
    }
}

#[test]
fn no_ceiling_is_without_a_test() {
    let own = include_str!("commands.rs");
    for ceiling in Ceiling::ALL.iter().filter(|ceiling| ceiling.name != "diagnostics") {
        let is_crossed = own.split("check_crossed(").any(|call| {
            let call = call.trim_start();
            call.starts_with(&format!("\"{}\"", ceiling.name))
                || (ceiling.name == Ceiling::MEMORY && call.starts_with("Ceiling::MEMORY"))
        });
        assert!(is_crossed, "`{}` is crossed by no script", ceiling.name);
    }
}

#[test]
fn fewer_messages_are_shown_by_request() {
    let scratch = Scratch::new("limit-diagnostics");
    scratch.file("a.geo", "print x1\nprint x2\nprint x3\n");
    let (_, err, code) = run(&scratch, &["check", "a.geo", "--limit", "diagnostics=1"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("`x1`") && !err.contains("`x2`") && err.contains("... and 2 more"),
        "{err}"
    );
}

#[test]
fn a_ceiling_out_of_bounds_is_refused() {
    let scratch = Scratch::new("limit-usage");
    scratch.file("a.geo", "print 1");
    for (flag, text) in [
        ("nestig=3", "did you mean `nesting`?"),
        ("x=3", "no ceiling is called `x`; there are source-bytes,"),
        ("nesting", "write NAME=VALUE"),
        ("nesting=0", "a whole number from 1 to 10000"),
        ("nesting=10_001", "a whole number from 1 to 10000"),
        ("steps=-1", "a whole number from 1"),
        ("steps=2e9", "a whole number from 1"),
    ] {
        let (_, err, code) = run(&scratch, &["run", "a.geo", "--limit", flag]);
        assert_eq!(code, 3, "{flag}");
        assert!(err.contains(text), "{flag}: {err}");
    }
}

#[test]
fn the_highest_ceilings_are_within_the_stack() {
    let scratch = Scratch::new("limit-most");
    let n = 9_990;
    let nested = |open: &str, close: &str| format!("print {}1{}", open.repeat(n), close.repeat(n));
    let scripts = [
        nested("(", ")"),
        nested("[", "]") + " == 1",
        nested("abs(", ")"),
        nested("{ ", " }"),
        nested("\"{", "}\""),
        nested("if true then 1 else ", ""),
        nested("", " + 1"),
        nested("", "^1"),
        "fn f(n) = if n == 0 then 0 else 1 + f(n - 1)\nprint f(40000)".to_owned(),
        "fn f(n) = if n == 0 then 0 else fold([n - 1], 0, (a, b) => f(b))\nprint f(40000)"
            .to_owned(),
        format!(
            "let a = fold(range(1, {n}, 1), 0, (a, i) => {{a}})\nprint a\nexport a to \"a.json\""
        ),
    ];
    for script in scripts {
        let mut args = vec!["run", "-"];
        for limit in ["nesting=10_000", "chain=10_000", "call-depth=50_000", "value-depth=10_000"] {
            args.extend(["--limit", limit]);
        }
        let (_, err, code) = piped(&scratch, &args, &script);
        let start: String = script.chars().take(60).collect();
        assert!(code == 0 || code == 2, "{start} ends with {code}: {err}");
    }
}

#[test]
fn built_ins_are_found_by_chapter_and_by_words() {
    let scratch = Scratch::new("doc-search");
    let doc = |args: &[&str]| run(&scratch, &[&["doc"], args].concat());
    let (out, err, code) = doc(&["surfaces"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.starts_with("Surfaces\n") && out.contains("\n  ruled "), "{out}");
    assert!(!out.contains("  circle "), "{out}");
    assert_eq!(doc(&["Questions", "about", "geometry"]).2, 0);
    // Of several words all count, in names more than in texts.
    let (out, err, code) = doc(&["curvature", "table"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.trim_start().starts_with("curvature_table "), "{out}");
    assert!(!out.contains("\n  torsion "), "{out}");
    let names = |text: &str| -> Vec<String> {
        text.lines().filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect()
    };
    assert_eq!(names(&out), names(&doc(&["TABLE", "Curvature"]).0), "order and case do not count");
    // Of a word of another language the advice comes first, then what this one says of the word.
    let (out, err, code) = doc(&["move"]);
    assert_eq!((err.as_str(), code), ("", 0));
    let advice = "nothing built in is called `move`: write `translate(g, vector)`\n\n";
    assert!(out.starts_with(advice) && advice.len() < out.len(), "{out}");
    for own in ["unit", "deg", "turn", "param"] {
        assert!(!doc(&[own]).0.starts_with("nothing"), "{own}");
    }
    // A name is explained, unless a search is asked for.
    let (entry, ..) = doc(&["length"]);
    assert!(entry.starts_with("length("), "{entry}");
    let (out, err, code) = doc(&["--search", "length"]);
    assert_eq!((err.as_str(), code), ("", 0));
    assert!(out.trim_start().starts_with("length ") && 3 < out.lines().count(), "{out}");
    // A word within a word is none.
    assert!(!names(&doc(&["--search", "arc"]).0).contains(&"search".to_owned()));

    for (args, message) in [
        (&["bezeir"][..], "virote: nothing built in is called `bezeir`; did you mean `bezier`?\n"),
        (
            &["surfaecs"],
            "virote: nothing built in is called `surfaecs`; did you mean `Surfaces`?\n",
        ),
        (&["zzz", "qqq"], "virote: nothing built in is about `zzz qqq`\n"),
        (&["--search", "zzz"], "virote: nothing built in is about `zzz`\n"),
        (&["--search", "..."], "virote: nothing built in is about `...`\n"),
    ] {
        assert_eq!(doc(args), (String::new(), message.to_owned(), 3));
    }
    assert_eq!(doc(&["--search"]).2, 3);
}

#[test]
fn shells_get_completions_of_every_verb() {
    let scratch = Scratch::new("completions");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let (out, err, code) = run(&scratch, &["completions", shell]);
        assert_eq!((err.as_str(), code), ("", 0), "{shell}");
        for word in ["explain", "params", "watch", "filter", "only"] {
            assert!(out.contains(word), "`{word}` is missing for {shell}");
        }
    }
    let (out, err, code) = run(&scratch, &["completions", "bsh"]);
    assert_eq!((out.as_str(), code), ("", 3));
    assert!(err.contains("'bash'"), "{err}");
}

/// Asks bash itself what it would complete.
#[cfg(unix)]
#[test]
fn bash_completes_verbs_and_options() {
    let scratch = Scratch::new("completions-bash");
    let (script, ..) = run(&scratch, &["completions", "bash"]);
    scratch.file("completions", script);
    let asked = "source ./completions
        COMP_WORDS=(virote ex); COMP_CWORD=1; _virote virote ex virote; echo \"${COMPREPLY[@]}\"
        COMP_WORDS=(virote test --fil); COMP_CWORD=2; _virote virote --fil test; echo \"${COMPREPLY[@]}\"";
    let Ok(output) = Command::new("bash").args(["-c", asked]).current_dir(&scratch.0).output()
    else {
        return;
    };
    let (out, err, _) = told(&output);
    assert_eq!((out.as_str(), err.as_str()), ("explain\n--filter\n", ""));
}

#[test]
fn the_manual_has_a_page_for_the_command_and_each_verb() {
    let scratch = Scratch::new("man");
    let (page, err, code) = run(&scratch, &["man"]);
    assert_eq!((err.as_str(), code), ("", 0));
    for part in [".TH virote 1", ".SH NAME", "Exit codes", "explain"] {
        assert!(page.contains(part), "`{part}` is missing in:\n{page}");
    }
    let (out, ..) = run(&scratch, &["help"]);
    let verbs: Vec<&str> = out
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  ")?.split(' ').next())
        .filter(|verb| !verb.is_empty() && *verb != "help")
        .collect();
    assert!(verbs.contains(&"run") && verbs.contains(&"man"), "{out}");
    for verb in verbs {
        let (page, err, code) = run(&scratch, &["man", verb]);
        assert_eq!((err.as_str(), code), ("", 0), "{verb}");
        assert!(page.contains(&format!(".TH virote-{verb} 1")), "{verb}:\n{page}");
    }
    let (out, err, code) = run(&scratch, &["man", "tset"]);
    let message = "virote: there is no verb `tset`; did you mean `test`?\n";
    assert_eq!((out.as_str(), err.as_str(), code), ("", message, 3));
}
