//! Hints that are edits: what was found is gone when the edit is made.

use std::{fs, path::Path};

use virote::{
    diag::Diagnostic,
    ide,
    limits::Limits,
    session::{Report, Session},
    value::MemoryFiles,
};

/// What takes longer has no fix.
const LIMITS: Limits = Limits { steps: 100_000, ..Limits::DEFAULT };

fn run(text: &str, files: &MemoryFiles) -> Report {
    Session::new(LIMITS).run("main.geo", text.as_bytes(), files, &[])
}

/// The text after the first fix of a run.
fn mended(text: &str, report: &Report) -> String {
    let mut fixes = report.diagnostics.iter().flat_map(|found| ide::fixes(&report.sources, found));
    let fix = fixes.next();
    assert!(fix.is_some(), "{text}: no fix: {:?}", report.diagnostics);
    ide::applied(text, &fix.expect("there is one").1)
}

#[track_caller]
fn check(wrong: &str, right: &str) {
    let report = run(wrong, &MemoryFiles::default());
    assert_eq!(mended(wrong, &report), right);
    let after = run(right, &MemoryFiles::default());
    assert!(after.diagnostics.is_empty(), "{right}: {:?}", after.diagnostics);
}

#[test]
fn slips_are_mended() {
    check("let width = 2  print widht", "let width = 2  print width");
    check("let on = True", "let on = true");
    check("let x = None", "let x = none");
    check("print sqrt(2", "print sqrt(2)");
    check("print sqrt(2))", "print sqrt(2)");
    check("print [1, 2)", "print [1, 2]");
    check("print [1 2]", "print [1, 2]");
    check("let r = 2  print pi r", "let r = 2  print pi * r");
    check("print 10 mm", "print 10mm");
    check("print 10millimeters", "print 10mm");
    check("a = 3", "let a = 3");
    check("var a = 3", "let a = 3");
    check("let a 3", "let a = 3");
    check("point c = line((0, 0), (1, 0))", "curve c = line((0, 0), (1, 0))");
    check(
        "print circle((0, 0), 1, nromal = (0, 0, 1))",
        "print circle((0, 0), 1, normal = (0, 0, 1))",
    );
    check(
        "print interpolate([(0, 0), (1, 2), (3, 0)], ends = \"natral\")",
        "print interpolate([(0, 0), (1, 2), (3, 0)], ends = \"natural\")",
    );
    check("print {a = 1}", "print {a: 1}");
    check("print 1 < 2 < 3", "print 1 < 2 and 2 < 3");
    check("let p = {width: 2}  print p.widht", "let p = {width: 2}  print p.width");
    check(
        "curve c = line((0, 0), (1, 0)) with (colour = \"red\")",
        "curve c = line((0, 0), (1, 0)) with (color = \"red\")",
    );
}

#[test]
fn what_is_missing_is_inserted() {
    check("print 2sin(3)", "print 2 * sin(3)");
    check("print max([1, 2, 3)", "print max([1, 2, 3])");
    check("print [1, 2, (3, 4], 5]", "print [1, 2, (3, 4), 5]");
    check(
        "print circle((0, 0, 0), 3mm, (0, 0, 1))",
        "print circle((0, 0, 0), 3mm, normal = (0, 0, 1))",
    );
    check("print rotate(circle((0, 0), 1), 90)", "print rotate(circle((0, 0), 1), 90deg)");
    check("print if true 1 else 2", "print if true then 1 else 2");
    check("print if true then 1 2", "print if true then 1 else 2");
    check("print if true then 1", "print if true then 1 else none");
    check("let a = 1\ngeo 1\nprint a", "geo 1\nlet a = 1\nprint a");
    check("unit mm\nunit mm\nprint 1", "unit mm\nprint 1");
    check(
        "print arc((0, 0, 0), 3mm, start = 0deg, to = 90deg)",
        "print arc((0, 0, 0), 3mm, from = 0deg, to = 90deg)",
    );
    check("param a: angle = 3mm  print a", "param a: length = 3mm  print a");
    let two_letters = run("print zz", &MemoryFiles::default());
    assert!(two_letters.diagnostics[0].fixes.is_empty(), "half of it is another letter");
}

#[test]
fn habits_from_elsewhere_are_mended() {
    check("print 7 mod 3", "print 7 % 3");
    check("let f = |x| x  print f(2)", "let f = x => x  print f(2)");
    check("print fold([1, 2], 0, |a, b| a + b)", "print fold([1, 2], 0, (a, b) => a + b)");
    check("print true | false", "print true or false");
    check("print [1, 2] | sum()", "print [1, 2] |> sum()");
    check("fn f(r) -> 2 * r  print f(1)", "fn f(r) = 2 * r  print f(1)");
    check("let f = x -> x  print f(1)", "let f = x => x  print f(1)");
    check("print 1 <> 2", "print 1 != 2");
    check("print true && false", "print true and false");
    check("print !true", "print not true");
    check("print 1 == 1&&true", "print 1 == 1 and true");
    check("print (1 < 2)||(2 < 1)", "print (1 < 2) or (2 < 1)");
    check("print 0x1F", "print 31");
    check("print 0b101", "print 5");
    check("param a = 3 between 1..5  print a", "param a = 3 in 1..5  print a");
    check("print 3 × 4", "print 3 * 4");
    check("print sin(30°)", "print sin(30deg)");
    check("print sin(30 °)", "print sin(30deg)");
    check("# a note\nprint 1", "// a note\nprint 1");
    check(
        "curve c = line((0, 0), (1, 0)) with (color = #cc3333)",
        "curve c = line((0, 0), (1, 0)) with (color = \"#cc3333\")",
    );
    check("print 1 + \\\n  2", "print 1 + \n  2");
    check("print \"a\nprint 1", "print \"a\"\nprint 1");
    check("/* a /* b */\nprint 1", "/* a /* b */\nprint 1 */");
    check("let a = 3 in 1..5  print a", "param a = 3 in 1..5  print a");
    check("geo 7\nprint 1", "geo 1\nprint 1");
    check("let a = 2  print a(3)", "let a = 2  print a * (3)");
    check("let a = 2  print a (3)", "let a = 2  print a * (3)");
    check("print 2(3)", "print 2 * (3)");
    check("let r = 2  print 3(r)", "let r = 2  print 3 * (r)");
    check("print sin(90)", "print sin(90deg)");
    check("check 0.1 + 0.2 == 0.3", "check 0.1 + 0.2 ~= 0.3");
    check("param a = 3 in 5..1", "param a = 3 in 1..5");
    check(
        "curves all = [line((0, 0), (1, 0)), (2, 3)]",
        "let all = [line((0, 0), (1, 0)), (2, 3)]",
    );
    check(
        "curve c = line((0, 0), (1, 0))  export c to \"c.stepp\"",
        "curve c = line((0, 0), (1, 0))  export c to \"c.step\"",
    );
}

#[test]
fn files_are_mended() {
    let files = MemoryFiles::from([("my-part.geo", "let size = 3\n"), ("a.csv", "x,y\n1,2\n")]);
    for (wrong, right) in [
        ("import \"my-prat.geo\" as part", "import \"my-part.geo\" as part"),
        ("print load(\"b.csv\")", "print load(\"a.csv\")"),
        ("import \"my-part.geo\"", "import \"my-part.geo\" as my_part"),
        ("print load(\"a.cvs\")", "print load(\"a.csv\")"),
    ] {
        assert_eq!(mended(wrong, &run(wrong, &files)), right);
        assert!(run(right, &files).diagnostics.is_empty(), "{right}");
    }
}

/// Of every mistake of the collection that has fixes: each of them makes it go away.
#[test]
fn what_was_found_is_gone_after_its_fix() {
    let folder = Path::new("tests/errors");
    let mut files = MemoryFiles::default();
    let mut scripts = Vec::new();
    for entry in fs::read_dir(folder).expect("the mistakes") {
        let path = entry.expect("an entry").path();
        let Ok(bytes) = fs::read(&path) else { continue };
        let text = String::from_utf8(bytes.clone());
        if let (true, Ok(text)) = (path.extension().is_some_and(|ending| ending == "geo"), text) {
            scripts.push((path.clone(), text));
        }
        files.insert(path.file_name().and_then(|name| name.to_str()).expect("a name"), bytes);
    }
    let (mut n_fixes, mut left) = (0, Vec::new());
    for (path, text) in &scripts {
        let count = |report: &Report, found: &Diagnostic| {
            let is_it =
                |other: &&Diagnostic| (other.code, &other.message) == (found.code, &found.message);
            report.diagnostics.iter().filter(is_it).count()
        };
        let before = run(text, &files);
        for found in &before.diagnostics {
            for (_, edits) in ide::fixes(&before.sources, found) {
                n_fixes += 1;
                let after = run(&ide::applied(text, &edits), &files);
                if count(&before, found) <= count(&after, found) {
                    left.push(format!("{}: {} {edits:?}", path.display(), found.message));
                }
            }
        }
    }
    assert!(left.is_empty(), "{}", left.join("\n"));
    assert!(40 < n_fixes, "only {n_fixes} fixes were tried");
}
