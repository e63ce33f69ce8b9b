//! `virote study`: a row for each variant, whatever happens to it, and to the study.

use std::{
    fs,
    process::{Command, Stdio},
    thread,
    time::Duration,
};

use crate::support::{Scratch, files_below, told, virote};

/// A script with a parameter of each kind, results of each kind, and a check.
const SCRIPT: &str = r#"unit mm
param width = 10mm in 1mm..30mm "Width"
param lean = 30deg
param n : integer = 2
param name = "flat" in ["flat", "round"]
param doubled = false
let area = width^2
let turned = 2 * lean
let label = "{name} {n}"
let is_wide = width > 15mm
let many = [1, 2]
let reciprocal = 1 / (n - 3)
check width < 20mm "narrow"
"#;

/// A study in a folder; what it says, and its exit code.
#[track_caller]
fn study(scratch: &Scratch, args: &[&str]) -> (String, String, i32) {
    let output = virote(&scratch.0).args(["study", "a.geo"]).args(args).output();
    told(&output.expect("the command runs"))
}

/// A file, without the last column of each row, which is a time.
fn without_times(scratch: &Scratch, name: &str) -> String {
    let text = fs::read_to_string(scratch.0.join(name)).expect("results");
    let cut = |line: &str| line.rsplit_once(',').map(|(row, _)| row.to_owned() + "\n");
    text.lines().filter_map(cut).collect()
}

#[test]
fn a_row_has_parameters_results_checks_and_errors() {
    let scratch = Scratch::new("study-rows");
    scratch.file("a.geo", SCRIPT);
    scratch.file(
        "plan.csv",
        "id,width [cm],lean [deg],n,name,doubled\na,1,45,1,round,True\n7,2.5,,3,,\n08,5,90,1,square,\n",
    );
    let (out, err, code) = study(&scratch, &["plan.csv", "-o", "r.csv"]);
    assert_eq!(out, "wrote r.csv: 3 rows, 2 with errors (1 of E0501, 1 of E0802)\n", "{err}");
    assert_eq!((err.as_str(), code), ("", 0));
    // An angle prints in degrees, a length in the document's unit; what is not there is empty.
    let expected = "\
id,width [mm],lean [deg],n,name,doubled,area [mm^2],turned [deg],label,is_wide,reciprocal,check 13: width < 20mm,margin 13: width < 20mm [mm],code,message
a,10,45,1,round,true,100,90,round 1,false,-0.5,true,10,,
7,25,30,3,flat,false,625,60,flat 3,true,,false,-5,E0501,division by zero (a.geo:12)
";
    let found = without_times(&scratch, "r.csv");
    let rows: Vec<&str> = found.lines().collect();
    assert!(found.starts_with(expected), "{found}");
    // A value that is refused stands as it was given.
    assert!(rows[3].starts_with("\"08\",50,90,1,square,false,"), "{found}");
    assert!(rows[3].contains("E0802,\"width=5cm is 50mm, outside 1mm..30mm"), "{found}");
    assert_eq!(files_below(&scratch.0), ["a.geo", "plan.csv", "r.csv"], "nothing else is left");
}

#[test]
fn all_formats_hold_the_same_rows() {
    let scratch = Scratch::new("study-formats");
    scratch.file("a.geo", SCRIPT);
    let grid = ["--vary", "width=10mm..20mm:3", "--vary", "n=1,3", "--want", "area"];
    for name in ["r.csv", "r.jsonl", "r.parquet"] {
        let (_, err, code) = study(&scratch, &[&grid[..], &["-o", name]].concat());
        assert_eq!(code, 0, "{err}");
    }
    let lines = fs::read_to_string(scratch.0.join("r.jsonl")).expect("results");
    let first = lines.lines().next().unwrap_or_default();
    assert!(first.starts_with(r#"{"id":1,"width [mm]":10.0,"lean [deg]":30.0,"n":1,"#), "{first}");
    assert_eq!(lines.lines().count(), 6);
    assert!(fs::read(scratch.0.join("r.parquet")).expect("results").starts_with(b"PAR1"));
    // Results are a plan again, once nothing but parameters is left.
    scratch.file("b.geo", "param width = 1mm\nparam n = 1\nparam id = \"\"\nlet a = width * n\n");
    let cut: String = without_times(&scratch, "r.csv")
        .lines()
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            format!("{},{}\n", cells[1], cells[3])
        })
        .collect();
    scratch.file("again.csv", cut);
    let args = ["study", "b.geo", "again.csv", "-o", "again.parquet"];
    let (out, err, code) = told(&virote(&scratch.0).args(args).output().expect("a run"));
    assert_eq!((out.as_str(), code), ("wrote again.parquet: 6 rows\n", 0), "{err}");
    // And a Parquet file is a plan, too.
    scratch.file("c.geo", "param id = 0\nparam n = 1\nparam code = \"\"\nparam message = \"\"\n");
    let args = ["study", "b.geo", "again.parquet", "-o", "x.csv"];
    let (_, err, code) = told(&virote(&scratch.0).args(args).output().expect("a run"));
    assert!(err.contains("the script has no parameter `a`") && code == 3, "{err}");
}

#[test]
fn the_number_of_workers_changes_nothing() {
    let scratch = Scratch::new("study-workers");
    scratch.file("a.geo", SCRIPT);
    let mut found = Vec::new();
    for threads in ["1", "2", "5"] {
        let name = format!("r{threads}.csv");
        let args = ["--vary", "n=1..300:300", "-o", &name, "--threads", threads];
        assert_eq!(study(&scratch, &args).2, 0);
        found.push(without_times(&scratch, &name));
    }
    assert_eq!(found[0], found[1]);
    assert_eq!(found[0], found[2]);
    assert_eq!(found[0].lines().count(), 301);
}

#[test]
fn memory_that_earlier_variants_left_does_not_count() {
    let scratch = Scratch::new("study-memory");
    scratch.file(
        "a.geo",
        "param n = 1\nlet big = [for i in 0..<600_000: [i * n]]\nlet n_big = len(big)\n",
    );
    let limit = ["--limit", "memory=90000000", "--threads", "1"];
    let args = [&["--vary", "n=1,2,3", "-o", "r.csv"][..], &limit].concat();
    let (out, err, code) = study(&scratch, &args);
    assert_eq!((out.as_str(), err.as_str(), code), ("wrote r.csv: 3 rows\n", "", 0));
}

/// What is called as a column of every study has a column of its own, and margins have their unit.
#[test]
fn names_and_margins_are_told_apart() {
    let scratch = Scratch::new("study-names");
    let script = "param id = 1\nparam code = 2\nparam tilt = 15deg\nlet message = \"all well\"\n\
                  check tilt ~= 15deg within 1deg\ncheck id < 4\n";
    scratch.file("a.geo", script);
    assert_eq!(study(&scratch, &["--vary", "id=3,5", "-o", "r.csv"]).2, 0);
    let expected = "id,id',code',tilt [deg],message',check 5: tilt ~= 15deg within 1deg,\
margin 5: tilt ~= 15deg within 1deg [deg],check 6: id < 4,margin 6: id < 4,code,message
1,3,2,15,all well,true,1,true,1,,
2,5,2,15,all well,true,1,false,-1,,
";
    assert_eq!(without_times(&scratch, "r.csv"), expected);
    // Where no row was made, nothing is left that would be in the way.
    scratch.file("b.geo", "param n = 1\npoint p = (n, 0)\n");
    let args = ["study", "b.geo", "--vary", "n=1,2", "--want", "p", "-o", "o.csv"];
    let (_, err, code) = told(&virote(&scratch.0).args(args).output().expect("a run"));
    assert!(code == 3 && err.contains("such as `let height = p.z`"), "{err}");
    assert_eq!(files_below(&scratch.0), ["a.geo", "b.geo", "r.csv"]);
    for (plan, told_of) in [
        ("id,n\na,1\nb,1\na,3\n", "p.csv:4: two variants are called \"a\""),
        ("id,n\n2,1\n,3\n", "p.csv:3: two variants are called 2"),
    ] {
        scratch.file("p.csv", plan);
        let args = ["study", "b.geo", "p.csv", "-o", "o.csv"];
        let (_, err, code) = told(&virote(&scratch.0).args(args).output().expect("a run"));
        assert!(code == 3 && err.contains(told_of), "{err}");
    }
}

/// One variant has room below the limit, and two have not.
#[test]
fn memory_that_other_workers_keep_does_not_count() {
    let scratch = Scratch::new("study-memory-beside");
    scratch.file(
        "a.geo",
        "param n = 1\nlet big = [for i in 0..<600_000: [i * n]]\nlet n_big = len(big)\n",
    );
    let limit = ["--limit", "memory=110000000", "--threads", "4"];
    let args = [&["--vary", "n=1..6:6", "-o", "r.csv"][..], &limit].concat();
    let (out, err, code) = study(&scratch, &args);
    assert_eq!((out.as_str(), err.as_str(), code), ("wrote r.csv: 6 rows\n", "", 0));
}

/// What stands behind it would be one cell with it.
#[test]
fn a_quote_that_is_not_closed_is_told() {
    let scratch = Scratch::new("study-quotes");
    scratch.file("a.geo", SCRIPT);
    for (plan, line) in [("n\n1\n\"2\n3\n", 3), ("\"n\n1\n", 1), ("n\n\"1\n", 2)] {
        scratch.file("p.csv", plan);
        let (out, err, code) = study(&scratch, &["p.csv", "-o", "r.csv"]);
        let told = format!("cannot read `p.csv`: the quote that line {line} opens is not closed");
        assert!(err.contains(&told), "{plan:?}: {err}");
        assert_eq!((out.as_str(), code), ("", 3), "{plan:?}");
    }
}

#[test]
fn bad_plans_are_told_before_anything_is_evaluated() {
    let scratch = Scratch::new("study-plans");
    scratch.file("a.geo", SCRIPT);
    let deep = "0".repeat(10);
    for (plan, expected) in [
        ("", "the plan `p.csv` is empty"),
        ("\n\n", "the plan `p.csv` is empty"),
        ("width\n", "the plan has no rows"),
        ("widht\n1\n", "no parameter `widht`; did you mean `width`?"),
        ("width,width [mm]\n1,2\n", "two columns of the plan are called `width`"),
        ("width,n\n1,2\n3\n", "p.csv:3: the row has 1 cell, the header has 2"),
        (
            "lean\n30\n",
            "p.csv:2: `lean` is an angle, and 30 has no unit: call the column `lean [deg]`",
        ),
        (
            "width [deg]\n30\n",
            "column `width` of the plan is in deg, but the parameter is of the kind length",
        ),
        (
            "width [kg]\n30\n",
            "the unit `kg`, which is not known; write one of um, mm, cm, m, km, in, ft",
        ),
        ("n [mm]\n30\n", "in mm, but the parameter is of the kind integer"),
        ("PAR1", "cannot read `p.csv`"),
    ] {
        scratch.file("p.csv", plan);
        let (out, err, code) = study(&scratch, &["p.csv", "-o", "r.csv"]);
        assert!(err.contains(expected), "{plan:?}: {err}");
        assert_eq!((out.as_str(), code), ("", 3), "{plan:?}");
        assert_eq!(files_below(&scratch.0), ["a.geo", "p.csv"], "{plan:?}");
    }
    fs::write(scratch.0.join("p.csv"), b"name\n\xff\n").expect("written");
    let (_, err, _) = study(&scratch, &["p.csv", "-o", "r.csv"]);
    assert!(err.contains("p.csv:2: the row is not UTF-8"), "{err}");
    let too_many = format!("n=1..2:1{deep}");
    for (args, expected) in [
        (&["-o", "r.csv"][..], "PLAN"),
        (&["p.csv", "--vary", "n=1,2", "-o", "r.csv"], "cannot be used with"),
        (&["--vary", &too_many, "-o", "r.csv"], "is no count of values"),
        (&["--vary", "n=1,2", "--vary", "n=3", "-o", "r.csv"], "`n` varies twice"),
        (&["--vary", "m=1,2", "-o", "r.csv"], "the script has no parameter `m`"),
        (&["--vary", "lean=1,2", "-o", "r.csv"], "`lean` is an angle, and 1 has no unit"),
        (&["--vary", "n=1,2", "-o", "r.xlsx"], "results end in `.csv`, `.jsonl` or `.parquet`"),
        (&["--vary", "n=1,2", "-o", "r"], "in none of them"),
        (&["--vary", "n=1,2", "-o", "a.geo/r.csv"], "`a.geo` is a file, not a folder"),
        (&["--vary", "n=1,2", "-o", "/dev/null/r.csv"], "`/dev/null` is a file, not a folder"),
        (&["--vary", "n=1,2", "-o", "r.csv", "--want", "aera"], "did you mean `area`?"),
        (&["--vary", "n=1,2", "-o", "r.csv", "--want", "many"], "`many` is a list of 2 numbers"),
        (&["--vary", "n=1,2", "-o", "r.csv", "--set", "m=1"], "the script has no parameter `m`"),
        (&["--vary", "n=1,2", "-o", "r.csv", "--time-limit", "10"], "write a time such as 10s"),
        (&["nowhere.csv", "-o", "r.csv"], "cannot read `nowhere.csv`"),
        (&[".", "-o", "r.csv"], "`.` is no file"),
    ] {
        let (_, err, code) = study(&scratch, args);
        assert!(err.contains(expected), "{args:?}: {err}");
        assert!(code == 3 || code == 2, "{args:?}: {code}");
    }
    // The plan is not written over.
    scratch.file("p.csv", "n\n1\n");
    let (_, err, code) = study(&scratch, &["p.csv", "-o", "p.csv", "--fresh"]);
    assert!(err.contains("`p.csv` is the script or the plan") && code == 3, "{err}");
}

#[test]
fn a_script_that_cannot_run_has_no_study() {
    let scratch = Scratch::new("study-script");
    scratch.file("a.geo", "param n = 1\nlet a = (");
    let (_, err, code) = study(&scratch, &["--vary", "n=1,2", "-o", "r.csv"]);
    assert!(err.contains("[E01") && code == 2, "{err}");
}

#[test]
fn results_are_not_written_over_unless_that_is_asked() {
    let scratch = Scratch::new("study-fresh");
    scratch.file("a.geo", SCRIPT);
    scratch.file("r.csv", "mine");
    let args = ["--vary", "n=1,2", "-o", "r.csv"];
    let (_, err, code) = study(&scratch, &args);
    assert!(err.contains("`r.csv` is there already; `--fresh` replaces it") && code == 3, "{err}");
    assert_eq!(study(&scratch, &[&args[..], &["--fresh"]].concat()).2, 0);
    assert_eq!(without_times(&scratch, "r.csv").lines().count(), 3);
    // What is no journal is not touched, and neither is that of another study.
    scratch.file("s.csv.unfinished", "mine\n");
    let args = ["--vary", "n=1,2", "-o", "s.csv"];
    let (_, err, _) = study(&scratch, &args);
    assert!(err.contains("`s.csv.unfinished` is not what a study left"), "{err}");
    assert_eq!(fs::read(scratch.0.join("s.csv.unfinished")).expect("a file"), b"mine\n");
}

/// Starts a study of slow variants, waits until it has some rows, and kills it.
fn killed(scratch: &Scratch, args: &[&str], n_rows: usize) {
    let mut child = virote(&scratch.0)
        .args(["study", "a.geo"])
        .args(args)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    let journal = scratch.0.join("r.csv.unfinished");
    while fs::read_to_string(&journal).map_or(0, |text| text.lines().count()) < n_rows {
        thread::sleep(Duration::from_millis(2));
    }
    child.kill().expect("it is killed");
    child.wait().expect("it ends");
}

/// A script whose variants take some milliseconds each.
const SLOW: &str = "param n = 1\nlet s = sum([for i in 0..<60000: (i * n) % 7])\n";

#[test]
fn a_study_that_is_killed_twice_goes_on_and_ends_as_if_it_had_not_been() {
    let scratch = Scratch::new("study-killed");
    scratch.file("a.geo", SLOW);
    let args = ["--vary", "n=1..120:120", "-o", "r.csv"];
    killed(&scratch, &args, 20);
    // The last line may be cut.
    let journal = scratch.0.join("r.csv.unfinished");
    let text = fs::read(&journal).expect("a journal");
    fs::write(&journal, &text[..text.len() - 3]).expect("cut");
    killed(&scratch, &args, 60);
    let kept = fs::read_to_string(&journal).expect("a journal");
    let (_, err, code) = study(&scratch, &args);
    assert!(err.contains("of 120 rows are there already") && code == 0, "{err}");
    // What was finished was not done again: its times are those of the journal.
    let results = fs::read_to_string(scratch.0.join("r.csv")).expect("results");
    let row = kept.lines().nth(40).unwrap_or_default();
    let time = row.rsplit_once(':').map_or("", |(_, time)| time.trim_end_matches([']', '}']));
    assert!(results.lines().nth(40).unwrap_or_default().ends_with(time), "{row}");
    let whole = without_times(&scratch, "r.csv");
    assert_eq!(study(&scratch, &["--vary", "n=1..120:120", "-o", "whole.csv"]).2, 0);
    assert_eq!(whole, without_times(&scratch, "whole.csv"));
    assert_eq!(files_below(&scratch.0), ["a.geo", "r.csv", "whole.csv"]);
}

#[test]
fn rows_of_another_study_are_not_mixed_in() {
    let scratch = Scratch::new("study-other");
    scratch.file("a.geo", SLOW);
    let args = ["--vary", "n=1..120:120", "-o", "r.csv"];
    killed(&scratch, &args, 20);
    scratch.file("a.geo", format!("{SLOW}// changed\n"));
    let (_, err, code) = study(&scratch, &args);
    assert!(
        err.contains("was left by a study with another script; `--fresh` gives up") && code == 3,
        "{err}"
    );
    scratch.file("a.geo", SLOW);
    let (_, err, _) = study(&scratch, &["--vary", "n=1..121:121", "-o", "r.csv", "--want", "s"]);
    assert!(err.contains("with another plan and another `--want`"), "{err}");
    let (_, err, code) = study(&scratch, &["--vary", "n=1,2", "-o", "r.csv", "--fresh"]);
    assert_eq!(code, 0, "{err}");
}

/// Under another header the cells are other values, though they are the same texts.
#[test]
fn a_plan_with_another_header_is_another_plan() {
    let scratch = Scratch::new("study-header");
    let slow = SLOW.replace("param n = 1", "param n = 1mm").replace("i * n", "i * n / 1mm");
    scratch.file("a.geo", slow);
    let rows = (1..=120).fold(String::new(), |text, i| text + &format!("{i}\n"));
    scratch.file("p.csv", format!("n [mm]\n{rows}"));
    let args = ["p.csv", "-o", "r.csv"];
    killed(&scratch, &args, 20);
    for header in ["n [cm]", "n"] {
        scratch.file("p.csv", format!("{header}\n{rows}"));
        let (_, err, code) = study(&scratch, &args);
        assert!(err.contains("a study with another plan") && code == 3, "{header}: {err}");
    }
    scratch.file("p.csv", format!("n [mm]\n{rows}"));
    assert_eq!(study(&scratch, &args).2, 0);
}

#[test]
fn data_that_changed_is_told_and_two_studies_do_not_write_one_file() {
    let scratch = Scratch::new("study-data");
    scratch.file("a.geo", format!("{SLOW}let d = load(\"d.csv\").x[0] + n\n"));
    scratch.file("d.csv", "x\n1\n");
    let args = ["--vary", "n=1..120:120", "-o", "r.csv"];
    killed(&scratch, &args, 20);
    scratch.file("d.csv", "x\n2\n");
    let (_, err, code) = study(&scratch, &args);
    assert!(
        err.contains("`d.csv` is not what it was for the rows that are there") && code == 3,
        "{err}"
    );
    scratch.file("d.csv", "x\n1\n");
    let mut first =
        virote(&scratch.0).args(["study", "a.geo"]).args(args).spawn().expect("it starts");
    let journal =
        || fs::read_to_string(scratch.0.join("r.csv.unfinished")).map_or(0, |text| text.len());
    let before = journal();
    while journal() == before {
        thread::sleep(Duration::from_millis(1));
    }
    let said = study(&scratch, &args);
    assert!(said.1.contains("`r.csv.unfinished` now; wait until it is done"), "{}", said.1);
    assert!(first.wait().expect("it ends").success());
}

#[test]
fn variants_without_end_and_without_measure_are_rows() {
    let scratch = Scratch::new("study-limits");
    let endless = "param n = 1\nlet s = if n == 2 then sum([for i in 0..<9000000: i % 7]) else n\n";
    scratch.file("a.geo", endless);
    let args = ["--vary", "n=1..4:4", "-o", "r.csv", "--time-limit", "50ms"];
    let (out, err, code) = study(&scratch, &args);
    assert_eq!(
        (out.as_str(), code),
        ("wrote r.csv: 4 rows, 1 with errors (1 of E0902)\n", 0),
        "{err}"
    );
    let found = without_times(&scratch, "r.csv");
    assert_eq!(
        found,
        "id,n,s,code,message\n1,1,1,,\n2,2,,E0902,it takes more than 0.05 s\n3,3,3,,\n4,4,4,,\n"
    );
    scratch.file(
        "a.geo",
        "param n = 1\nlet s = if n == 2 then len([for i in 0..<3000000: [i]]) else n\n",
    );
    let args = ["--vary", "n=1..4:4", "-o", "m.csv", "--limit", "memory=100_000_000"];
    let (out, err, code) = study(&scratch, &args);
    assert_eq!(
        (out.as_str(), code),
        ("wrote m.csv: 4 rows, 1 with errors (1 of E0901)\n", 0),
        "{err}"
    );
}

#[test]
fn a_full_disk_keeps_what_was_written() {
    let scratch = Scratch::new("study-full");
    scratch.file("a.geo", "param n = 1\nlet s = n\n");
    let binary = env!("CARGO_BIN_EXE_virote");
    let args = "study a.geo --vary n=1..400:400 -o r.csv";
    // No file may be larger than 8 kB: the system refuses the rest, as a full disk does.
    let shell = format!("trap '' XFSZ; ulimit -f 8; exec {binary} {args}");
    let output = Command::new("bash").args(["-c", &shell]).current_dir(&scratch.0).output();
    let (_, err, code) = told(&output.expect("a shell"));
    assert!(
        err.contains("cannot write `r.csv.unfinished`") && err.contains("rows are kept in"),
        "{err}"
    );
    assert_eq!(code, 3);
    let (_, err, code) = study(&scratch, &["--vary", "n=1..400:400", "-o", "r.csv"]);
    assert!(err.contains("of 400 rows are there already") && code == 0, "{err}");
    let found = without_times(&scratch, "r.csv");
    assert!(
        found.lines().skip(1).enumerate().all(|(i, row)| row.starts_with(&format!("{},", i + 1)))
    );
    assert_eq!(found.lines().count(), 401);
}

#[test]
fn ctrl_c_ends_a_study_and_keeps_its_rows() {
    let scratch = Scratch::new("study-interrupt");
    scratch.file("a.geo", SLOW);
    let mut child = virote(&scratch.0)
        .args(["study", "a.geo", "--vary", "n=1..500:500", "-o", "r.csv"])
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let journal = scratch.0.join("r.csv.unfinished");
    while fs::read_to_string(&journal).map_or(0, |text| text.lines().count()) < 10 {
        thread::sleep(Duration::from_millis(2));
    }
    let id = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("a signal").success());
    let mut said = String::new();
    std::io::Read::read_to_string(&mut child.stderr.take().expect("a pipe"), &mut said)
        .expect("text");
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    assert!(
        said.contains("the study was stopped") && said.contains("the same command goes on"),
        "{said}"
    );
}

#[test]
fn a_script_that_changes_meanwhile_is_told() {
    let scratch = Scratch::new("study-changed");
    scratch.file("a.geo", SLOW);
    let child = virote(&scratch.0)
        .args(["study", "a.geo", "--vary", "n=1..200:200", "-o", "r.csv"])
        .stderr(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    while !scratch.0.join("r.csv.unfinished").exists() {
        thread::sleep(Duration::from_millis(2));
    }
    scratch.file("a.geo", "param n = 1\nlet s = -1\n");
    let (out, err, code) = told(&child.wait_with_output().expect("it ends"));
    assert!(err.contains("all rows are of the text as it was at its start"), "{err}");
    assert_eq!((out.as_str(), code), ("wrote r.csv: 200 rows\n", 0));
    assert!(!without_times(&scratch, "r.csv").contains(",-1,"), "no row is of the new text");
}

#[test]
fn each_variant_has_a_picture_and_all_a_sheet() {
    let scratch = Scratch::new("study-pictures");
    scratch.file("a.geo", "param r = 1mm in 1mm..3mm\ncurve c = circle((0, 0), r)\n");
    let args = ["--vary", "r=1mm..4mm:4", "-o", "r.csv", "--render", "p", "--size", "80x60"];
    let (_, err, code) = study(&scratch, &args);
    assert!(err.contains("drew p/contact-1.png") && code == 0, "{err}");
    let found = files_below(&scratch.0);
    assert_eq!(found, ["a.geo", "p/1.png", "p/2.png", "p/3.png", "p/contact-1.png", "r.csv"]);
    let results = fs::read_to_string(scratch.0.join("r.csv")).expect("results");
    assert!(results.lines().nth(1).unwrap_or_default().ends_with(",1.png"), "{results}");
}

#[test]
fn a_text_is_what_stands_there() {
    let scratch = Scratch::new("study-texts");
    scratch.file("a.geo", "param name = \"x\"\nparam n = 1\nlet told = \"[{name}]{n}\"\n");
    scratch.file("plan.csv", "name, n\n c , 2\n\"\",\"\"\n,3\n\" d\",\n");
    let told_of = |args: &[&str]| {
        let (_, err, code) =
            study(&scratch, &[args, &["-o", "r.csv", "--want", "told", "--fresh"]].concat());
        assert_eq!(code, 0, "{err}");
        let results = fs::read_to_string(scratch.0.join("r.csv")).expect("results");
        let cell = |line: &str| {
            let (_, rest) = line.split_once('[')?;
            rest.split(',').next().map(str::to_owned)
        };
        results.lines().filter_map(cell).collect::<Vec<_>>()
    };
    assert_eq!(told_of(&["plan.csv"]), [" c ]2", "]1", "x]3", " d]1"]);
    assert_eq!(told_of(&["--vary", "name= c "]), [" c ]1"]);
    assert_eq!(told_of(&["--vary", "name=a, b"]), ["a]1", "b]1"]);
}
