//! `virote test` with golden folders: what is kept, what is compared, what a difference says, and
//! what becomes of folders that are not as they should be; and the results for other programs.

use std::fs;

use crate::support::{Scratch, files_below, told, virote};
use serde_json::{Value as Json, json};

/// Runs `virote test` in the folder; standard output, standard error, exit code.
fn test(scratch: &Scratch, args: &[&str]) -> (String, String, i32) {
    told(&virote(&scratch.0).arg("test").args(args).output().expect("the command runs"))
}

/// A folder with the script as `a.geo` and its golden folder.
fn blessed(name: &str, script: &str) -> Scratch {
    let scratch = Scratch::new(&format!("golden-{name}"));
    scratch.file("a.geo", script);
    let (out, err, code) = test(&scratch, &["--bless", "a.geo"]);
    assert_eq!((err.as_str(), code), ("", 0), "{out}");
    let (out, err, code) = test(&scratch, &["a.geo"]);
    assert_eq!((err.as_str(), code), ("", 0), "{out}");
    scratch
}

/// What the files of the folder say.
fn content(scratch: &Scratch, path: &str) -> String {
    fs::read_to_string(scratch.0.join(path)).expect("a golden file")
}

/// Puts `new` in the place of `old` in a file of the folder.
#[track_caller]
fn edit(scratch: &Scratch, path: &str, old: &str, new: &str) {
    let text = content(scratch, path);
    assert!(text.contains(old), "`{old}` is missing in:\n{text}");
    scratch.file(path, text.replacen(old, new, 1));
}

/// Runs the test of `a.geo`, which must fail with these differences.
#[track_caller]
fn differs(scratch: &Scratch, differences: &str) {
    let (out, err, code) = test(scratch, &["a.geo"]);
    assert_eq!((err.as_str(), code), ("", 1), "{out}");
    let told: String = out
        .lines()
        .filter(|line| line.starts_with("  "))
        .fold(String::new(), |told, line| told + line.strip_prefix("  ").unwrap_or(line) + "\n");
    assert_eq!(told, differences, "{out}");
}

/// Whether `text` has all of `parts`.
#[track_caller]
fn has(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "`{part}` is missing in:\n{text}");
    }
}

const DOOR: &str = "\
let a = 3
print a / 2, [a, -a]
check a == 3
curve c = polyline((0, 0), (1, 2), (4, 0))
export c to \"c.obj\"
export table({x: [1, 2, 3], y: [0.5, 0.25, -1]}) to \"below/t.csv\"
export c to \"c.json\"
";

#[test]
fn a_named_script_gets_its_golden_folder() {
    let scratch = Scratch::new("golden-made");
    scratch.file("a.geo", DOOR);
    scratch.file("says_nothing.geo", "let a = 1\ntest \"t\" { print 1 }\n");
    // Without a folder, nothing is compared.
    let (out, err, code) = test(&scratch, &["a.geo"]);
    let expected = "passed   a.geo  1 check\n1 file, 0 tests, 1 check (1 passed)\n";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    // Folders are made only of scripts that are named, and that say something.
    assert_eq!(test(&scratch, &["--bless"]).2, 0);
    assert_eq!(files_below(&scratch.0), ["a.geo", "says_nothing.geo"]);
    let (out, err, code) = test(&scratch, &["--bless", "a.geo", "says_nothing.geo"]);
    let expected = "\
passed   a.geo  1 check
blessed  a.geo  4 golden files, 4 changes
  a.golden/printed.txt: is new
  a.golden/files/c.obj.measures: is new
  a.golden/files/below/t.csv: is new
  a.golden/files/c.json: is new
1 = 1
passed   says_nothing.geo:2  t
2 files, 1 test (1 passed), 1 check (1 passed), 1 golden folder (1 blessed)
";
    let sorted = |text: &str| {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.sort();
        lines
    };
    assert_eq!((sorted(&out), err.as_str(), code), (sorted(expected), "", 0));
    assert_eq!(
        files_below(&scratch.0.join("a.golden")),
        ["files/below/t.csv", "files/c.json", "files/c.obj.measures", "golden.json", "printed.txt"]
    );
    assert_eq!(content(&scratch, "a.golden/printed.txt"), "a / 2 = 1.5\n[a, -a] = [3, -3]\n");
    assert_eq!(content(&scratch, "a.golden/files/below/t.csv"), "x,y\n1,0.5\n2,0.25\n3,-1\n");
    // Legs of lengths √5 and √13.
    let length = 5.0_f64.sqrt() + 13.0_f64.sqrt();
    let measures = format!(
        "c\n  polyline\n  3 vertices\n  bounds (0, 0, 0) to (4, 2, 0)\n  length {length}\nplaces of c\n  at 0 0 0\n  at 1 2 0\n  at 4 0 0\n"
    );
    assert_eq!(content(&scratch, "a.golden/files/c.obj.measures"), measures);
    let header: Json =
        serde_json::from_str(&content(&scratch, "a.golden/golden.json")).expect("JSON");
    assert_eq!(header, json!({ "edition": 2, "tolerance": 1e-9, "bytes": false }));

    let (out, err, code) = test(&scratch, &["a.geo"]);
    let expected = "\
passed   a.geo  1 check
passed   a.geo  4 golden files
1 file, 0 tests, 1 check (1 passed), 1 golden folder (1 passed)
";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    assert_eq!(test(&scratch, &["a.geo", "-q"]), (String::new(), String::new(), 0));
}

#[test]
fn printed_lines_may_differ_within_the_tolerance_of_the_header() {
    let scratch = blessed("tolerance", DOOR);
    edit(&scratch, "a.golden/printed.txt", "1.5", "1.5000001");
    differs(
        &scratch,
        "\
a.golden/printed.txt: line 1
  expected  a / 2 = 1.5000001
  found     a / 2 = 1.5
",
    );
    edit(&scratch, "a.golden/golden.json", "1e-9", "1e-7");
    assert_eq!(test(&scratch, &["a.geo"]).2, 0);
    edit(&scratch, "a.golden/printed.txt", "[a, -a]", "[a, a]");
    differs(
        &scratch,
        "\
a.golden/printed.txt: line 2
  expected  [a, a] = [3, -3]
  found     [a, -a] = [3, -3]
",
    );
    scratch.file("a.golden/printed.txt", "a / 2 = 1.5\n[a, -a] = [3, -3]\nb = 5\n");
    differs(
        &scratch,
        "a.golden/printed.txt: from line 3: 2 lines in all, 3 were expected\n  expected  b = 5\n",
    );
    // Texts that are no tables are compared in the same way.
    let scratch = blessed("text", DOOR);
    edit(&scratch, "a.golden/files/c.json", "2.0", "2.5");
    let (out, _, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 1);
    has(&out, &["a.golden/files/c.json: line "]);
}

#[test]
fn tables_are_compared_by_column() {
    let scratch = blessed("table", DOOR);
    let table = "a.golden/files/below/t.csv";
    scratch.file(table, "x,y\n1,0.5\n2,0.2500000000001\n3,-1\n");
    assert_eq!(test(&scratch, &["a.geo"]).2, 0, "within the tolerance");
    scratch.file(table, "x,y\n1,0.5\n2,0.75\n3,5\n");
    differs(
        &scratch,
        "\
a.golden/files/below/t.csv: column `y`, 2 rows, the first of them 2
  expected  0.75
  found     0.25
",
    );
    scratch.file(table, "x,y\n1,0.5\n");
    differs(
        &scratch,
        "a.golden/files/below/t.csv: the number of rows\n  expected  1\n  found     3\n",
    );
    scratch.file(table, "x,z\n1,0.5\n2,0.25\n3,-1\n");
    differs(
        &scratch,
        "a.golden/files/below/t.csv: the columns\n  expected  x, z\n  found     x, y\n",
    );
    for (text, message) in [
        ("", "the file is empty"),
        ("x,y\n1\n", "line 2 has 1 cell, the header has 2"),
        ("x,\"y\n", "line 1: the quotation mark is not closed"),
    ] {
        scratch.file(table, text);
        differs(&scratch, &format!("a.golden/files/below/t.csv: is no table: {message}\n"));
    }
}

#[test]
fn meshes_are_compared_by_measure() {
    let script = |middle: &str, corner: &str| {
        format!(
            "let m = grid_mesh(bilinear((0, 0), (0, 1), (2, 0), {corner}), 2, 2)
export m, polyline((0, 0), {middle}, (4, 0)) to \"m.ply\"\n"
        )
    };
    let scratch = blessed("mesh", &script("(1, 2)", "(2, 1)"));
    let kept = content(&scratch, "a.golden/files/m.ply.measures");
    has(&kept, &["m\n  mesh\n  9 vertices\n  8 triangles\n", "\n  area 2\n  encloses no volume\n"]);

    // Mirrored: counts, bounds and length are the same, but (1, 2) lies 4 / √13 from the leg.
    scratch.file("a.geo", script("(3, 2)", "(2, 1)"));
    let (out, err, code) = test(&scratch, &["a.geo"]);
    assert_eq!((err.as_str(), code), ("", 1), "{out}");
    let away = out.split(" is ").nth(1).and_then(|rest| rest.split(' ').next());
    let away: f64 = away.and_then(|text| text.parse().ok()).expect("a deviation");
    assert!((away - 4.0 / 13.0_f64.sqrt()).abs() < 1e-12, "{out}");
    has(&out, &["away from (1, 2, 0), where it was; the limit is ", "1 difference\n"]);

    // Another corner: bounds and area move too, the counts do not, and the old places lie in the
    // larger quadrilateral.
    scratch.file("a.geo", script("(1, 2)", "(2, 3)"));
    let (out, _, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 1);
    has(
        &out,
        &[
            "expected    bounds (0, 0, 0) to (2, 1, 0)",
            "found       bounds (0, 0, 0) to (2, 3, 0)",
            "expected    area 2\n",
            "found       area 4\n",
        ],
    );
    assert!(!out.contains("triangles") && !out.contains("away from"), "{out}");

    // A closed mesh encloses its volume: a sphere in eight triangles is a regular octahedron.
    let octahedron = "export grid_mesh(sphere((0, 0, 0), 1), 4, 2) to \"b.obj\"\n";
    let scratch = blessed("volume", octahedron);
    let kept = content(&scratch, "a.golden/files/b.obj.measures");
    for (what, value) in [("  area ", 4.0 * 3.0_f64.sqrt()), ("  volume ", 4.0 / 3.0)] {
        let found = kept.lines().find_map(|line| line.strip_prefix(what)).expect("a measure");
        let found: f64 = found.parse().expect("a number");
        assert!((found - value).abs() < 1e-12, "{kept}");
    }

    let scratch = blessed("measures", &script("(1, 2)", "(2, 1)"));
    edit(&scratch, "a.golden/files/m.ply.measures", "  at 0 0 0", "  at 0 0");
    let (out, _, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 1);
    has(&out, &["a place is three numbers"]);
}

/// A torus whose tube passes through itself, which is warned of, and another one in a test.
const PINCHED: &str = "\
surface s = torus((0, 0), 1, 2)
test \"t\" { check torus((0, 0), 2, 3)(0, 0) ~= (5, 0) }
";

#[test]
fn warnings_are_kept_and_compared() {
    let scratch = Scratch::new("golden-warnings");
    scratch.file("a.geo", PINCHED);
    let made = "blessed  a.geo  1 golden file, 1 change\n  a.golden/warnings.txt: is new\n";
    has(&test(&scratch, &["--bless", "a.geo"]).0, &[made]);
    let warning =
        "W0002 the minor radius is above the major one, so that the tube passes through itself\n";
    assert_eq!(content(&scratch, "a.golden/warnings.txt"), warning.repeat(2));
    has(&test(&scratch, &["a.geo"]).0, &["passed   a.geo  1 golden file\n"]);
    // Where it stands does not count, how often it comes does.
    scratch.file("a.geo", format!("\n\n{PINCHED}"));
    assert_eq!(test(&scratch, &["a.geo"]).2, 0);
    scratch.file("a.geo", PINCHED.replace("1, 2)", "2, 1)"));
    let (out, _, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 1);
    has(&out, &["a.golden/warnings.txt: from line 2: 1 lines in all, 2 were expected\n"]);
    scratch.file("a.geo", "print 1\n");
    let (out, err, code) = test(&scratch, &["a.geo"]);
    assert_eq!((err.as_str(), code), ("", 1));
    has(&out, &["a.golden/warnings.txt: nothing of the script makes this file any more\n"]);
    // Blessing takes the file away that nothing makes.
    assert_eq!(test(&scratch, &["--bless"]).2, 0);
    assert_eq!(files_below(&scratch.0.join("a.golden")), ["golden.json", "printed.txt"]);
}

#[test]
fn numbers_in_warnings_are_compared_within_the_tolerance() {
    let script = "curve c = offset(bezier((0, 0), (1, 3), (3, -2), (4, 1)), 1)\n";
    let scratch = Scratch::new("golden-warned-numbers");
    scratch.file("a.geo", script);
    assert_eq!(test(&scratch, &["--bless", "a.geo"]).2, 0);
    let kept = content(&scratch, "a.golden/warnings.txt");
    has(&kept, &["W0002 the offset crosses itself at t = 0.0428", "W0002 the offset has a cusp"]);
    edit(&scratch, "a.golden/warnings.txt", "t = 0.0428", "t = 0.0429");
    let (out, _, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 1);
    has(&out, &["a.golden/warnings.txt: line 1\n", "expected  W0002 the offset crosses itself"]);
    edit(&scratch, "a.golden/golden.json", "1e-9", "1e-3");
    assert_eq!(test(&scratch, &["a.geo"]).2, 0);
}

#[test]
fn a_folder_of_the_first_edition_has_no_warnings_until_it_is_blessed() {
    let scratch = Scratch::new("golden-first-edition");
    scratch.file("a.geo", format!("{PINCHED}print s(0, 0)\n"));
    scratch.file("a.golden/golden.json", "{\"edition\": 1, \"tolerance\": 0.5}");
    scratch.file("a.golden/printed.txt", "s(0, 0) = (3, 0, 0)\n");
    has(&test(&scratch, &["a.geo"]).0, &["passed   a.geo  1 golden file\n"]);
    let changed = "blessed  a.geo  2 golden files, 1 change\n  a.golden/warnings.txt: is new\n";
    has(&test(&scratch, &["--bless"]).0, &[changed]);
    let header: Json =
        serde_json::from_str(&content(&scratch, "a.golden/golden.json")).expect("JSON");
    assert_eq!(header, json!({ "edition": 2, "tolerance": 0.5, "bytes": false }));
    assert_eq!(test(&scratch, &["a.geo"]).2, 0);
}

#[test]
fn the_header_may_ask_for_bytes() {
    let script = |n: usize| {
        format!(
            "export grid_mesh(sphere((0, 0, 0), 1), {n}, 4) to \"m.stl\"\nexport table({{x: [0.5]}}) to \"t.csv\"\n"
        )
    };
    let scratch = Scratch::new("golden-bytes");
    scratch.file("a.geo", script(4));
    scratch.file("a.golden/golden.json", "{\"edition\": 1, \"bytes\": true}");
    let (out, err, code) = test(&scratch, &["--bless"]);
    assert_eq!((err.as_str(), code), ("", 0), "{out}");
    assert_eq!(
        virote(&scratch.0).args(["run", "-q", "a.geo"]).status().expect("runs").code(),
        Some(0)
    );
    for file in ["m.stl", "t.csv"] {
        let kept = fs::read(scratch.0.join("a.golden/files").join(file)).expect("kept");
        assert!(kept == fs::read(scratch.0.join(file)).expect("written"), "{file}");
    }
    assert_eq!(test(&scratch, &["a.geo"]).2, 0);
    // The same number in other bytes.
    scratch.file("a.golden/files/t.csv", "x\n0.50\n");
    differs(
        &scratch,
        "a.golden/files/t.csv: byte 6\n  expected  0x30 of 7 bytes\n  found     0x0a of 6 bytes\n",
    );
    scratch.file("a.geo", script(5));
    has(&test(&scratch, &["a.geo"]).0, &["a.golden/files/m.stl: byte "]);
    // What the header says stays.
    assert_eq!(test(&scratch, &["--bless", "a.geo"]).2, 0);
    has(&content(&scratch, "a.golden/golden.json"), &["\"bytes\": true"]);
    assert_eq!(test(&scratch, &["a.geo"]).2, 0);
}

#[test]
fn missing_and_strange_files_are_told_and_blessing_mends_them() {
    let scratch = blessed("strays", DOOR);
    fs::remove_file(scratch.0.join("a.golden/printed.txt")).expect("removed");
    fs::remove_file(scratch.0.join("a.golden/files/c.json")).expect("removed");
    scratch.file("a.golden/files/below/old.csv", "x\n1\n");
    scratch.file("a.golden/notes.txt", "mine");
    scratch.file("a.golden/.hidden", "of the system");
    differs(
        &scratch,
        "\
a.golden/printed.txt: is missing
a.golden/files/c.json: is missing
a.golden/files/below/old.csv: nothing of the script makes this file any more
a.golden/notes.txt: nothing of the script makes this file any more
",
    );
    let (out, err, code) = test(&scratch, &["--bless"]);
    assert_eq!((err.as_str(), code), ("", 0), "{out}");
    has(&out, &["blessed  a.geo  4 golden files, 4 changes\n", "printed.txt: is new"]);
    // What is not of our making stays.
    assert_eq!(
        files_below(&scratch.0.join("a.golden")),
        [
            ".hidden",
            "files/below/t.csv",
            "files/c.json",
            "files/c.obj.measures",
            "golden.json",
            "notes.txt",
            "printed.txt"
        ]
    );
    differs(&scratch, "a.golden/notes.txt: nothing of the script makes this file any more\n");
    fs::remove_file(scratch.0.join("a.golden/notes.txt")).expect("removed");
    let (out, ..) = test(&scratch, &["--bless"]);
    has(&out, &["blessed  a.geo  4 golden files, nothing changed\n"]);
}

#[test]
fn a_folder_that_is_not_as_it_should_be_is_told() {
    for (name, header, message) in [
        ("malformed", "{\"edition\": 1", "`a.golden/golden.json` EOF while parsing"),
        ("later", "{\"edition\": 3}", "is of edition 3; this program reads editions 1 to 2"),
        ("odd", "{\"edition\": 1, \"tolerence\": 1}", "did you mean `tolerance`?"),
        ("binary", "\u{0}\u{1}", "`a.golden/golden.json` expected value"),
    ] {
        let scratch = blessed(name, DOOR);
        scratch.file("a.golden/golden.json", header);
        // Blessing does not guess what the header was meant to say.
        for args in [&["a.geo"][..], &["--bless", "a.geo"]] {
            let (out, err, code) = test(&scratch, args);
            assert_eq!(code, 3, "{out}");
            has(&err, &[message]);
            has(&out, &["failed   a.geo  golden folder\n", "1 golden folder (1 failed)"]);
        }
        assert_eq!(content(&scratch, "a.golden/golden.json"), header);
    }
    let scratch = blessed("headless", DOOR);
    fs::remove_file(scratch.0.join("a.golden/golden.json")).expect("removed");
    let (_, err, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 3);
    has(&err, &["`a.golden` has no `golden.json`; `virote test --bless` writes it"]);
    assert_eq!(test(&scratch, &["--bless"]).2, 0);
    assert_eq!(test(&scratch, &["a.geo"]).2, 0);

    let scratch = Scratch::new("golden-no-folder");
    scratch.file("a.geo", DOOR);
    scratch.file("a.golden", "a file");
    for args in [&["a.geo"][..], &["--bless", "a.geo"]] {
        let (_, err, code) = test(&scratch, args);
        assert_eq!((err.as_str(), code), ("virote: `a.golden` must be a folder\n", 3));
    }
    let scratch = blessed("no-text", DOOR);
    fs::write(scratch.0.join("a.golden/printed.txt"), b"a = \xff\n").expect("written");
    differs(&scratch, "a.golden/printed.txt: byte 5 is not UTF-8 text\n");
}

#[test]
fn a_script_with_errors_is_not_compared() {
    let scratch = blessed("wrong", DOOR);
    scratch.file("a.geo", format!("{DOOR}print 1 / 0\n"));
    for args in [&["a.geo"][..], &["--bless", "a.geo"]] {
        let (out, err, code) = test(&scratch, args);
        assert_eq!(code, 2, "{out}");
        has(&out, &["skipped  a.geo  golden folder: the script has errors\n"]);
        assert_eq!(err.matches("Error").count(), 1, "{err}");
    }
    assert_eq!(content(&scratch, "a.golden/printed.txt"), "a / 2 = 1.5\n[a, -a] = [3, -3]\n");
    // A failed check is no error of the script.
    scratch.file("a.geo", format!("{DOOR}check a == 4\n"));
    let (out, _, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 1);
    has(&out, &["failed   a.geo  1 of 2 checks\n", "passed   a.geo  4 golden files\n"]);
    // What cannot be written is an error at its place.
    scratch.file("a.geo", format!("{DOOR}export (1e300, 0, 0) to \"far.glb\"\nprint 5\n"));
    edit(&scratch, "a.golden/golden.json", "false", "true");
    let (out, err, code) = test(&scratch, &["a.geo"]);
    assert_eq!(code, 2, "{out}");
    has(&err, &["E0705", "a.geo:8:", "single precision"]);
}

#[test]
fn a_filter_leaves_golden_folders_alone() {
    let scratch = blessed("filter", &format!("{DOOR}test \"t\" {{ check true }}\n"));
    scratch.file("a.golden/printed.txt", "other");
    let (out, _, code) = test(&scratch, &["--filter", "t"]);
    assert_eq!((out.contains("golden"), code), (false, 0), "{out}");
    let (_, err, code) = test(&scratch, &["--filter", "t", "--bless"]);
    assert_eq!(code, 3);
    has(&err, &["cannot be used with"]);
}

#[cfg(unix)]
#[test]
fn nothing_is_written_through_links() {
    let scratch = Scratch::new("golden-links");
    scratch.file("a.geo", DOOR);
    fs::create_dir_all(scratch.0.join("a.golden")).expect("a folder");
    fs::create_dir_all(scratch.0.join("elsewhere")).expect("a folder");
    std::os::unix::fs::symlink("../elsewhere", scratch.0.join("a.golden/files")).expect("a link");
    let (_, err, code) = test(&scratch, &["--bless", "a.geo"]);
    assert_eq!(code, 3);
    has(&err, &["leads out of the output folder through a link"]);
    assert_eq!(files_below(&scratch.0), ["a.geo"]);
}

#[test]
fn results_are_data() {
    let scratch = blessed("json", DOOR);
    edit(&scratch, "a.golden/printed.txt", "1.5", "2.5");
    let (out, err, code) = test(&scratch, &["a.geo", "--message-format", "json"]);
    assert_eq!((err.as_str(), code), ("", 1));
    let lines: Vec<Json> =
        out.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let of = |kind: &str| lines.iter().filter(|line| line["type"] == kind).collect::<Vec<_>>();
    let golden = json!({ "type": "golden", "file": "a.geo", "result": "failed", "differences": [
        { "file": "a.golden/printed.txt", "place": "line 1",
            "expected": "a / 2 = 2.5", "found": "a / 2 = 1.5" }] });
    assert_eq!(of("golden"), [&golden]);
    assert_eq!(
        of("total")[0]["golden"],
        json!({ "passed": 0, "failed": 1, "blessed": 0, "skipped": 0 })
    );
}

/// What stands in the file for the first script of the test below, but for the times.
const JUNIT: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="virote" tests="7" failures="2" errors="2" skipped="0">
  <testsuite name="a.geo" tests="5" failures="2" errors="1" skipped="0">
    <testcase name="checks" classname="a.geo" file="a.geo"/>
    <testcase name="a &lt; b &amp; &quot;c&quot;" classname="a.geo" file="a.geo" line="3">
      <failure message="check failed: two">check failed: two</failure>
    </testcase>
    <testcase name="wrong" classname="a.geo" file="a.geo" line="4">
      <error message="division by zero"></error>
    </testcase>
    <testcase name="good" classname="a.geo" file="a.geo" line="5"/>
    <testcase name="golden folder" classname="a.geo" file="a.geo">
"#;

#[test]
fn junit_has_a_case_for_each_test_and_folder() {
    let script = "\
check 1 == 1
print 1 / 4
test \"a < b & \\\"c\\\"\" { check 2 == 3 \"two\" }
test \"wrong\" { let a = 1 / 0; check a == 1 }
test \"good\" { check true }
";
    let scratch = Scratch::new("golden-junit");
    scratch.file("a.geo", script);
    scratch.file("a.golden/golden.json", "{\"edition\": 1}");
    scratch.file("a.golden/printed.txt", "1 / 4 = 0.5\n");
    scratch.file("b.geo", "check true\n");
    let (_, _, code) = test(&scratch, &["a.geo", "b.geo", "gone.geo", "--junit", "out.xml"]);
    assert_eq!(code, 3);
    let text = content(&scratch, "out.xml");
    let without_times: Vec<String> = text
        .lines()
        .map(|line| match line.split_once(" time=\"") {
            Some((before, rest)) => {
                let (seconds, after) = rest.split_once('"').expect("the end of the attribute");
                assert!(seconds.parse::<f64>().is_ok_and(|seconds| 0.0 <= seconds), "{line}");
                format!("{before}{after}")
            }
            None => line.split("<system-err>").next().expect("a part").to_owned(),
        })
        .collect();
    let found = without_times.join("\n");
    assert!(found.starts_with(JUNIT), "{found}\n---\n{JUNIT}");
    has(
        &text,
        &["division by zero", "    <testcase name=\"checks\" classname=\"b.geo\" file=\"b.geo\"/>"],
    );
    has(&text, &["<error message=\"cannot read `gone.geo`: there is no such file\"></error>"]);
}

#[test]
fn junit_has_the_differences_of_a_golden_folder() {
    let scratch = Scratch::new("golden-junit-differences");
    scratch.file("a.golden/golden.json", "{\"edition\": 1}");
    scratch.file("a.golden/printed.txt", "1 / 4 = 0.5\n");
    scratch.file("b.geo", "check true\n");
    scratch.file("a.geo", "print 1 / 4\n");
    let (_, _, code) = test(&scratch, &["a.geo", "--junit", "out.xml"]);
    assert_eq!(code, 1);
    has(
        &content(&scratch, "out.xml"),
        &[
            "<failure message=\"1 difference\">a.golden/printed.txt: line 1&#10;    expected  1 / 4 = 0.5",
        ],
    );
    let (_, err, code) = test(&scratch, &["b.geo", "--junit", "no/such/out.xml"]);
    assert_eq!(code, 3);
    has(&err, &["cannot write `no/such/out.xml`: there is no such file"]);
}

#[test]
fn results_are_the_same_however_many_scripts_run_at_a_time() {
    let scratch = Scratch::new("golden-jobs");
    for i in 0..12 {
        let script = format!("print {i} / 3\ncheck {i} < 9\ntest \"t{i}\" {{ check {i} != 4 }}\n");
        scratch.file(&format!("{i}.geo"), script);
        scratch.file(&format!("{i}.golden/golden.json"), "{\"edition\": 1}");
        scratch.file(
            &format!("{i}.golden/printed.txt"),
            format!("{i} / 3 = {}\n", f64::from(i) / 3.0),
        );
    }
    let one = test(&scratch, &["--jobs", "1"]);
    assert_eq!(one.2, 1);
    has(&one.0, &["12 files, 12 tests (11 passed, 1 failed)", "12 golden folders (12 passed)"]);
    for n in ["2", "5", "40"] {
        assert_eq!(one, test(&scratch, &["--jobs", n]));
    }
    // Where memory ends depends on no script beside.
    scratch.file("5.geo", "let a = [for i in 0..<3000000: i]\nprint a[7] / 21\n");
    let limited = |jobs: &str| test(&scratch, &["--jobs", jobs, "--limit", "memory=20_000_000"]);
    let one = limited("1");
    assert_eq!(one.2, 2, "{}{}", one.0, one.1);
    assert_eq!(one, limited("4"));
    assert_eq!(test(&scratch, &["--jobs", "0"]).2, 3);
}
