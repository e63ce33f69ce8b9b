//! `virote study`: variants that the time limit ends, plans that change or cannot be meant, and Ctrl-C before the
//! first row.

use std::{
    fs,
    process::{Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use crate::support::{Scratch, files_below, told, virote};

#[track_caller]
fn study(scratch: &Scratch, args: &[&str]) -> (String, String, i32) {
    let output = virote(&scratch.0).args(["study", "a.geo"]).args(args).output();
    told(&output.expect("the command runs"))
}

fn read(scratch: &Scratch, name: &str) -> String {
    fs::read_to_string(scratch.0.join(name)).expect("a file")
}

/// A mistake that was found before says nothing of what was not done.
#[test]
fn a_variant_that_was_stopped_has_the_code_of_that_alone() {
    let scratch = Scratch::new("study-late");
    scratch.file(
        "a.geo",
        "param n = 1\nlet q = 1 / (n - 1)\nlet k = if n < 3 then sum([for i in 1..9000000: sin(i)]) else n\n",
    );
    let args = ["--vary", "n=1..3:3", "-o", "r.csv", "--time-limit", "100ms"];
    let (out, err, code) = study(&scratch, &args);
    assert_eq!(
        (out.as_str(), code),
        ("wrote r.csv: 3 rows, 2 with errors (2 of E0902)\n", 0),
        "{err}"
    );
    let rows = read(&scratch, "r.csv");
    assert_eq!(rows.matches("E0902,it takes more than 0.1 s").count(), 2, "{rows}");
    // A mistake in time is what it was.
    let args = ["--vary", "n=1", "-o", "s.csv", "--time-limit", "60s", "--set", "n=1"];
    scratch.file("a.geo", "param n = 1\nlet q = 1 / (n - 1)\n");
    assert_eq!(study(&scratch, &args).2, 0);
    assert!(read(&scratch, "s.csv").contains("E0501,division by zero"));
}

#[test]
fn a_mesh_that_is_too_fine_ends_at_the_time_limit() {
    let scratch = Scratch::new("study-fine");
    scratch.file(
        "a.geo",
        "param n = 1\nlet profile = bspline([(1, 0, 0), (2, 0, 1), (1, 0, 2), (3, 0, 3)])\n\
         let q = volume(tessellate(revolve(profile), tolerance = 1e-12)) * n\n",
    );
    let args = ["--vary", "n=1", "-o", "r.csv", "--time-limit", "20ms"];
    let (out, err, _) = study(&scratch, &args);
    assert_eq!(out, "wrote r.csv: 1 rows, 1 with errors (1 of E0902)\n", "{err}");
}

/// Its combinations are not looked at before they are evaluated, nor held.
#[test]
fn a_grid_without_an_end_in_sight_begins_at_once() {
    let scratch = Scratch::new("study-grid");
    scratch.file("a.geo", "param w = 1\nparam n = 1\nlet s = w + n\n");
    let grid = ["--vary", "w=1..10000000:10000000", "--vary", "n=1..90:90", "-o", "r.csv"];
    let mut child = virote(&scratch.0)
        .args(["study", "a.geo"])
        .args(grid)
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    let journal = scratch.0.join("r.csv.unfinished");
    let begin = Instant::now();
    while fs::read_to_string(&journal).map_or(0, |text| text.lines().count()) < 3 {
        assert!(begin.elapsed() < Duration::from_secs(60), "no row is there");
        thread::sleep(Duration::from_millis(2));
    }
    let status = fs::read_to_string(format!("/proc/{}/status", child.id()));
    if let Ok(status) = status {
        let most = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = most.and_then(|most| most.trim().trim_end_matches(" kB").parse().ok());
        assert!(kilobytes.is_none_or(|most: u64| most < 400_000), "{kilobytes:?} kB");
    }
    interrupt(child.id());
    assert_eq!(child.wait().expect("it ends").code(), Some(130));
    let text = read(&scratch, "r.csv.unfinished");
    let third = text.lines().nth(3).unwrap_or_default();
    assert!(third.starts_with(r#"[{"id":3,"w":1.0,"n":3.0,"s":4.0"#), "{third}");
}

/// A worker that waits for the row of another, which was stopped, ends too.
#[test]
fn ctrl_c_ends_workers_far_ahead_of_the_slowest() {
    let scratch = Scratch::new("study-ahead");
    scratch.file(
        "a.geo",
        "param n = 1\npoint p = (n, 0)\n\
         let s = if n < 2 then sum([for j in 1..60: sum([for i in 1..9000000: sin(i)])]) else n\n",
    );
    let mut child = virote(&scratch.0)
        .args(["study", "a.geo", "--vary", "n=1..1000:1000", "-o", "r.csv", "--threads", "2"])
        .args(["--render", "pictures", "--size", "16x16"])
        .stderr(Stdio::null())
        .spawn()
        .expect("it starts");
    // A picture of each variant is there before its row: of the 64 that may be ahead all but the slowest.
    let pictures = scratch.0.join("pictures");
    let begin = Instant::now();
    while fs::read_dir(&pictures).map_or(0, Iterator::count) < 63 {
        assert!(begin.elapsed() < Duration::from_secs(60), "the other worker does not get ahead");
        thread::sleep(Duration::from_millis(5));
    }
    assert!(!read(&scratch, "r.csv.unfinished").contains(r#""id":1,"#), "the first was to be slow");
    interrupt(child.id());
    let begin = Instant::now();
    let ended = loop {
        if let Some(status) = child.try_wait().expect("a child") {
            break status.code();
        }
        if begin.elapsed() > Duration::from_secs(60) {
            child.kill().expect("it is there");
            break None;
        }
        thread::sleep(Duration::from_millis(5));
    };
    assert_eq!(ended, Some(130));
}

fn interrupt(id: u32) {
    let id = id.to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("a signal").success());
}

#[test]
fn ctrl_c_ends_the_reading_of_a_plan() {
    let scratch = Scratch::new("study-long-plan");
    scratch.file("a.geo", "param n = 1\nlet s = n\n");
    scratch.file("plan.csv", "n\n".to_owned() + &"1\n".repeat(3_000_000));
    let mut child = virote(&scratch.0)
        .args(["study", "a.geo", "plan.csv", "-o", "r.csv"])
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    // Where the signal comes before anybody listens, the system ends the command.
    thread::sleep(Duration::from_millis(400));
    interrupt(child.id());
    let mut said = String::new();
    std::io::Read::read_to_string(&mut child.stderr.take().expect("a pipe"), &mut said)
        .expect("text");
    let code = child.wait().expect("it ends").code();
    assert!(code.is_none_or(|code| code == 130), "{code:?}");
    assert!(code.is_none() || said.contains("the study was stopped"), "{said}");
}

#[test]
fn a_plan_that_changes_meanwhile_ends_its_study() {
    let slow = "param n = 1\nlet s = sum([for i in 0..<60000: (i * n) % 7])\n";
    let plan = |n: u64| (1..=n).fold("n\n".to_owned(), |text, i| text + &format!("{i}\n"));
    // Longer than what is read at a time: what is changed lies behind that.
    for changed in [plan(50), plan(50) + "a,b\n", plan(2999) + "7\n"] {
        let scratch = Scratch::new("study-plan-changes");
        scratch.file("a.geo", slow);
        scratch.file("p.csv", plan(3000));
        let args = ["study", "a.geo", "p.csv", "-o", "r.csv", "--time-limit", "1ms"];
        let child = virote(&scratch.0)
            .args(args)
            .stderr(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        while !scratch.0.join("r.csv.unfinished").exists() {
            thread::sleep(Duration::from_millis(1));
        }
        scratch.file("p.csv", &changed);
        let (_, err, code) = told(&child.wait_with_output().expect("it ends"));
        assert!(err.contains("the plan was changed while the study ran") && code == 3, "{err}");
        // What is there may be of either, also where the plan is put back.
        if scratch.0.join("r.csv.unfinished").exists() {
            scratch.file("p.csv", plan(3000));
            let (_, err, code) = told(&virote(&scratch.0).args(args).output().expect("a run"));
            assert!(err.contains("which may be of either") && code == 3, "{err}");
        }
    }
}

#[test]
fn decimal_commas_are_told_once_with_what_to_write() {
    let scratch = Scratch::new("study-commas");
    scratch.file(
        "a.geo",
        "param neck = 1cm\nparam lean = 3deg\nparam n = 1\nparam name = \"x\"\nlet s = n\n",
    );
    for (plan, told_of) in [
        (
            "neck [cm];n\n1,2;3\n1,3;4\n",
            "p.csv:2: `neck` holds `1,2`, a number with a decimal comma; write `1.2`",
        ),
        (
            "n\tname\n1\ta\n-0,5\tb\n",
            "p.csv:3: `n` holds `-0,5`, a number with a decimal comma; write `-0.5`",
        ),
        (
            "neck,n\n\"1,2cm\",1\n",
            "`neck` holds `1,2cm`, a number with a decimal comma; write `1.2cm`",
        ),
        ("lean\n\"1,5deg\"\n", "write `1.5deg`"),
    ] {
        scratch.file("p.csv", plan);
        let (out, err, code) = study(&scratch, &["p.csv", "-o", "r.csv"]);
        assert!(err.contains(told_of), "{plan:?}: {err}");
        assert_eq!((out.as_str(), code, err.lines().count()), ("", 3, 1), "{plan:?}: {err}");
        assert_eq!(files_below(&scratch.0), ["a.geo", "p.csv"]);
    }
    // A text may hold what it likes.
    scratch.file("p.csv", "name;n\n1,2;3\n");
    assert_eq!(study(&scratch, &["p.csv", "-o", "r.csv"]).2, 0);
}

#[test]
fn lines_of_json_have_the_same_members() {
    let scratch = Scratch::new("study-members");
    scratch.file("a.geo", "param n = 1\nlet q = 1 / (n - 1)\nlet zero = -0 * n\ncheck n > 2\n");
    assert_eq!(study(&scratch, &["--vary", "n=1,2", "-o", "r.jsonl"]).2, 0);
    let text = read(&scratch, "r.jsonl");
    let rows: Vec<serde_json::Value> =
        text.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let members = |row: &serde_json::Value| -> Vec<String> {
        row.as_object().expect("an object").keys().cloned().collect()
    };
    assert_eq!(members(&rows[0]), members(&rows[1]));
    assert!(rows[0]["q"].is_null() && rows[0]["code"] == "E0501", "{text}");
    assert_eq!(rows[1]["margin 4: n > 2"], 0.0);
    assert!(!text.contains("-0.0"), "{text}");
}

#[test]
fn settings_that_no_parameter_takes_are_told_with_those_there_are() {
    let scratch = Scratch::new("study-settings");
    scratch.file("a.geo", "param size = 1\nparam n = 1\nlet s = n * size\n");
    for (setting, told_of) in [
        ("zz=3", "the script has no parameter `zz`; it has size, n"),
        ("sise=3", "the script has no parameter `sise`; did you mean `size`?"),
    ] {
        let args = ["-D", setting, "--vary", "n=1,2", "-o", "r.csv"];
        let (out, err, code) = study(&scratch, &args);
        assert_eq!((out.as_str(), code), ("", 3), "{err}");
        assert_eq!(err.trim_end(), format!("virote: {told_of}"));
    }
}

/// What it goes on from was left by any build of the same version: the sum of the plan is that of its meaning.
#[test]
fn the_sum_of_a_plan_is_the_same_in_every_build() {
    let scratch = Scratch::new("study-sum");
    scratch.file("a.geo", "param w = 1cm\nlet s = assert(w < 3cm, \"no\")\nlet t = sum([for i in 1..9000000: i * w])\n");
    scratch.file("plan.csv", "id,w [cm]\na,1\nb,2\n");
    let sum = |args: &[&str]| {
        let mut child = virote(&scratch.0)
            .args(["study", "a.geo", "-o", "r.csv", "--threads", "1"])
            .args(args)
            .stderr(Stdio::null())
            .stdout(Stdio::null())
            .spawn()
            .expect("it starts");
        let begin = Instant::now();
        let header = loop {
            let text = fs::read_to_string(scratch.0.join("r.csv.unfinished")).unwrap_or_default();
            if let Some((header, _)) = text.split_once('\n') {
                break header.to_owned();
            }
            assert!(begin.elapsed() < Duration::from_secs(60), "no journal is there");
            thread::sleep(Duration::from_millis(1));
        };
        child.kill().expect("it is there");
        child.wait().expect("it ends");
        fs::remove_file(scratch.0.join("r.csv.unfinished")).expect("it is there");
        let header: serde_json::Value = serde_json::from_str(&header).expect("JSON");
        header["plan"].as_str().expect("a sum").to_owned()
    };
    // FNV-1a of the cells of each row, then of the name, unit, kind of each column, as texts with their lengths.
    let of = |texts: &[&str]| {
        let bytes: Vec<u8> =
            texts.iter().flat_map(|text| format!("{}:{text}", text.len()).into_bytes()).collect();
        virote::study::checksum(&bytes)
    };
    let file = ["a", "1", "b", "2", "id", "", "the id of a variant", "", "w", "cm", "length", ""];
    assert_eq!(sum(&["plan.csv"]), of(&file));
    let grid = ["4", "1", "2.5", "cm", "w", "", "length", ""];
    assert_eq!(sum(&["--vary", "w=1cm..2.5cm:4"]), of(&grid));
    let list = ["2", "1cm", "2cm", "w", "", "length", ""];
    assert_eq!(sum(&["--vary", "w=1cm,2cm"]), of(&list));
}
