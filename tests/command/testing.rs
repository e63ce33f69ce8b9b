//! `virote test`: what it runs, how it tells how that came out, and how it ends.

use std::process::{Command, Stdio};

use crate::support::{Scratch, files_below, told, virote};
use serde_json::{Value as Json, json};

/// Runs `virote test` in the folder; standard output, standard error, exit code.
fn test(scratch: &Scratch, args: &[&str]) -> (String, String, i32) {
    told(&virote(&scratch.0).arg("test").args(args).output().expect("the command runs"))
}

/// Runs the tests of one script; what is told but for the pictures.
fn outcome(name: &str, script: &str) -> (String, String, i32) {
    let scratch = Scratch::new(&format!("testing-{name}"));
    scratch.file("a.geo", script);
    let found = test(&scratch, &["a.geo"]);
    assert_eq!(files_below(&scratch.0), ["a.geo"], "{name}: nothing is written");
    found
}

/// Whether `text` has all of `parts`.
#[track_caller]
fn has(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "`{part}` is missing in:\n{text}");
    }
}

#[test]
fn tests_see_the_file_and_depend_on_one_another_in_any_order() {
    let script = "\
fn twice(x) = 2 * x
param size = 3
test \"order\" {
    check sum == 7
    let sum = part + size
    let part = twice(2)
    let [a, b] = [even(4), odd(4)]
    check a and not b
    fn even(n) = if n == 0 then true else odd(n - 1)
    fn odd(n) = if n == 0 then false else even(n - 1)
    check map([1, 2], x => twice(x) + part) == [6, 8]
}
test \"the same names again\" {
    let part = 1
    check { fn twice_more(x) = twice(twice(x)); twice_more(part) } == 4
}
";
    let (out, err, code) = outcome("order", script);
    let expected = "\
passed   a.geo:3  order
passed   a.geo:13  the same names again
1 file, 2 tests (2 passed), 0 checks
";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
}

#[test]
fn a_failing_test_stops_no_other() {
    let script = "\
check 1 == 1
check 1 == 2 \"of the file\"
print \"not shown\"
test \"two claims fail\" {
    check 3 ~= 4 within 0.5
    check false
    print \"shown\"
}
test \"a mistake\" { let a = 1 / 0; check a == 1 }
test \"last\" { check true }
";
    let (out, err, code) = outcome("failing", script);
    let expected = "\
failed   a.geo  1 of 2 checks
failed   a.geo:4  two claims fail
shown
wrong    a.geo:9  a mistake
passed   a.geo:10  last
1 file, 3 tests (1 passed, 1 failed, 1 wrong), 2 checks (1 passed, 1 failed)
";
    assert_eq!((out.as_str(), code), (expected, 2));
    has(
        &err,
        &[
            "check failed: of the file",
            "check failed: 3 ~= 4 within 0.5",
            "apart by 1, limit 0.5, misses by 0.5",
            "this is 3",
            "check failed: false",
            "division by zero",
        ],
    );
}

#[test]
fn what_depends_on_a_mistake_of_the_file_is_skipped() {
    let script = "\
let broken = 1 / 0
test \"uses it\" { check broken == 1 }
test \"expects it\" { expect error \"E0501\" broken }
test \"takes all\" { export all to \"all.obj\" }
test \"does not\" { check true }
";
    let (out, err, code) = outcome("skipped", script);
    let expected = "\
skipped  a.geo:2  uses it
skipped  a.geo:3  expects it
skipped  a.geo:4  takes all
passed   a.geo:5  does not
wrong    a.geo  1 error
1 file (1 with errors), 4 tests (1 passed, 3 skipped), 0 checks
";
    assert_eq!((out.as_str(), code), (expected, 2));
    assert_eq!(err.matches("Error").count(), 1, "one cause: {err}");
}

#[test]
fn expected_errors_come_from_names_calls_and_values() {
    let script = "\
fn f(x) = 1 / x
let one = 1
test \"all of them come\" {
    expect error \"E0501\" f(0)
    expect error \"E0201\" nobody
    expect error \"E0201\" nobody + nobody_else
    expect error \"E0204\" { let a = b; let b = a; a }
    expect error \"E0202\" { let a = 1; let a = 2; a }
    expect error \"E0401\" f()
    expect error \"e0401\" circle(radios = 1)
    expect error \"E0303\" 10mm + 30deg
    expect error \"E0404\" assert(false, \"no\")
    expect error \"E0403\" { fn g(x) = g(x); g(1) }
    expect error \"E0901\" range(1, 1e9, 1)
    expect error \"E0602\" bspline((0, 0), (1, 1), degree = 1, knots = [0, 1])
}
";
    let (out, err, code) = outcome("expected", script);
    assert_eq!((err.as_str(), code), ("", 0), "{out}");
}

#[test]
fn an_expected_error_that_does_not_come_tells_what_did() {
    for (subject, parts) in [
        ("1 / 2", ["error E0501 was expected, but there is none", "this is 0.5"]),
        (
            "sqrt(-1)",
            [
                "error E0501 was expected, found E0502: a negative number (-1)",
                "E0502 comes from here",
            ],
        ),
        (
            "nobody",
            [
                "error E0501 was expected, found E0201: nothing is called `nobody`",
                "this fails with E0201",
            ],
        ),
        ("f(1)", ["error E0501 was expected, found E0502: ", "fn f(x) = sqrt(-x)"]),
    ] {
        let script = format!(
            "fn f(x) = sqrt(-x)\ntest \"expects\" {{ expect error \"E0501\" {subject} }}\n"
        );
        let (out, err, code) = outcome("missed", &script);
        assert_eq!(code, 1, "{subject}: {out}{err}");
        has(&err, &["E1003"]);
        has(&err, &parts);
        has(&out, &["failed   a.geo:2  expects"]);
    }
}

#[test]
fn files_of_tests_are_planned_and_not_written() {
    let geometry = "curve c = line((0, 0), (1, 0))\n";
    let good = "test \"t\" { mesh m = grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 2, 2)
        export c, m to \"a.obj\"; export all to \"b.obj\" }";
    assert_eq!(outcome("export", &format!("{geometry}{good}")).2, 0);
    for (path, code) in [("a.xyz", "E0703"), ("../a.obj", "E0704"), ("a.stl", "E0705")] {
        let script = format!("{geometry}test \"t\" {{ export c to \"{path}\" }}");
        let (out, err, ending) = outcome("bad-export", &script);
        assert_eq!(ending, 2, "{path}");
        has(&err, &[code]);
        has(&out, &["wrong    a.geo:2  t"]);
    }
}

#[test]
fn tests_import_and_take_parameters() {
    let scratch = Scratch::new("testing-import");
    scratch.file("lib.geo", "param size = 1\nlet area = size^2\ntest \"fails\" { check false }\n");
    let script = "\
param side = 2
test \"imports\" {
    import \"lib.geo\" with (size = side)
    import \"lib.geo\" (area)
    check lib.area == 9 and area == 1
}
import \"lib.geo\" as outside
check outside.area == 1
";
    scratch.file("a.geo", script);
    scratch.file("p.json", "{\"side\": 3}");
    assert_eq!(test(&scratch, &["a.geo", "--set", "side=3"]).2, 0);
    assert_eq!(test(&scratch, &["a.geo", "--params", "p.json"]).2, 0);
    assert_eq!(test(&scratch, &["a.geo"]).2, 1);
    let (_, err, code) = test(&scratch, &["a.geo", "--set", "sied=3"]);
    assert_eq!(code, 3);
    has(&err, &["did you mean `side`?"]);
}

#[test]
fn folders_are_searched_in_order() {
    let scratch = Scratch::new("testing-folders");
    let script = |name: &str| format!("test \"{name}\" {{ check true }}");
    for name in ["b.geo", "a/z.geo", "a/deep/y.geo", "c.txt", ".hidden/x.geo", "a.geo"] {
        scratch.file(name, script(name));
    }
    let (out, err, code) = test(&scratch, &[]);
    let expected = "\
passed   a/deep/y.geo:1  a/deep/y.geo
passed   a/z.geo:1  a/z.geo
passed   a.geo:1  a.geo
passed   b.geo:1  b.geo
4 files, 4 tests (4 passed), 0 checks
";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    let (out, ..) = test(&scratch, &["b.geo", "a"]);
    has(&out, &["passed   b.geo:1  b.geo\npassed   a/deep/y.geo:1", "3 files"]);
    scratch.file("empty/readme.txt", "");
    let (_, err, code) = test(&scratch, &["empty"]);
    assert_eq!((err.as_str(), code), ("virote: there is no script in the folder `empty`\n", 3));
    let (out, err, code) = test(&scratch, &["missing.geo", "b.geo"]);
    assert_eq!(code, 3, "{out}");
    has(&err, &["cannot read `missing.geo`: there is no such file"]);
    has(&out, &["passed   b.geo:1", "1 file, 1 test"]);
}

#[test]
fn a_filter_chooses_by_name() {
    let scratch = Scratch::new("testing-filter");
    let script =
        "check false\ntest \"the neck\" { check true }\ntest \"the body\" { check false }\n";
    scratch.file("a.geo", script);
    let (out, err, code) = test(&scratch, &["a.geo", "--filter", "neck"]);
    let expected = "passed   a.geo:2  the neck\n1 file, 1 test (1 passed), 0 checks\n";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    assert_eq!(test(&scratch, &["a.geo", "--filter", "the"]).2, 1);
    let (_, err, code) = test(&scratch, &["a.geo", "--filter", "nekc"]);
    assert_eq!((err.as_str(), code), ("virote: no test has a name that contains `nekc`\n", 3));
    // A name that is a part of another one chooses itself alone.
    scratch.file("b.geo", "test \"a\" { check true }\ntest \"ab\" { check false }\n");
    assert_eq!(test(&scratch, &["b.geo", "--filter", "a"]).2, 1);
    let (out, err, code) = test(&scratch, &["b.geo", "--filter", "a", "--exact"]);
    let expected = "passed   b.geo:1  a\n1 file, 1 test (1 passed), 0 checks\n";
    assert_eq!((out.as_str(), err.as_str(), code), (expected, "", 0));
    let (_, err, code) = test(&scratch, &["b.geo", "--filter", "b", "--exact"]);
    assert_eq!((err.as_str(), code), ("virote: no test is called `b`\n", 3));
    assert_eq!(test(&scratch, &["b.geo", "--exact"]).2, 3);
}

#[test]
fn standard_input_is_tested() {
    let scratch = Scratch::new("testing-stdin");
    let mut command: Command = virote(&scratch.0);
    command.args(["test", "-"]).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.spawn().expect("the command runs");
    let script = b"test \"t\" { check 1 < 2 }";
    std::io::Write::write_all(&mut child.stdin.take().expect("a pipe"), script).expect("taken");
    let (out, _, code) = told(&child.wait_with_output().expect("the command ends"));
    has(&out, &["passed   <stdin>:1  t"]);
    assert_eq!(code, 0);
}

#[test]
fn results_are_data() {
    let scratch = Scratch::new("testing-json");
    let script = "\
check 1 == 1
test \"good\" { print 1 + 1; expect error \"E0501\" 1 / 0 }
test \"bad\" { check 2 == 3; expect error \"E0501\" 4 }
";
    scratch.file("a.geo", script);
    let (out, err, code) = test(&scratch, &["a.geo", "--message-format", "json"]);
    assert_eq!((err.as_str(), code), ("", 1));
    let lines: Vec<Json> =
        out.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let of = |kind: &str| lines.iter().filter(|line| line["type"] == kind).collect::<Vec<_>>();
    let results: Vec<[&Json; 3]> =
        of("test").iter().map(|line| [&line["name"], &line["result"], &line["line"]]).collect();
    assert_eq!(
        results,
        [
            [&json!("good"), &json!("passed"), &json!(2)],
            [&json!("bad"), &json!("failed"), &json!(3)]
        ]
    );
    assert_eq!(of("check")[1]["test"], json!("bad"));
    assert!(of("check")[0].get("test").is_none(), "the check of the file is of no test");
    assert_eq!(of("print")[0]["test"], json!("good"));
    assert_eq!(of("expect")[0]["found"]["code"], json!("E0501"));
    assert_eq!(of("expect")[1]["found"]["value"], json!("4"));
    assert_eq!(of("diagnostic").len(), 2);
    let total = json!({ "type": "total", "files": 1, "wrong_files": 0,
        "tests": { "passed": 1, "failed": 1, "wrong": 0, "skipped": 0 },
        "checks": { "passed": 1, "failed": 0 },
        "golden": { "passed": 0, "failed": 0, "blessed": 0, "skipped": 0 } });
    assert_eq!(of("total"), [&total]);
}

#[test]
fn quiet_leaves_out_what_passed() {
    let scratch = Scratch::new("testing-quiet");
    scratch.file("a.geo", "check true\ntest \"good\" { print 5 }\ntest \"bad\" { check false }\n");
    let (out, _, code) = test(&scratch, &["a.geo", "-q"]);
    assert_eq!((out.as_str(), code), ("5 = 5\nfailed   a.geo:3  bad\n", 1));
}

#[test]
fn results_depend_on_no_number_of_threads() {
    let scratch = Scratch::new("testing-threads");
    let definitions: String = (0..50).map(|i| format!("let a{i} = {i}\n")).collect();
    let tests: String =
        (0..50).map(|i| format!("test \"t{i}\" {{ let b = a{i}; check b < 30 }}\n")).collect();
    scratch.file("a.geo", definitions + &tests);
    let one = test(&scratch, &["a.geo", "--threads", "1"]);
    assert_eq!(one, test(&scratch, &["a.geo", "--threads", "8"]));
    has(&one.0, &["50 tests (30 passed, 20 failed)"]);
}
