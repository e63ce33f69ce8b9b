//! `virote watch`: what it carries out again when something is saved, and how it ends.
use std::{
    fs,
    io::{BufRead, BufReader},
    process::{Child, Command, Stdio},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{Receiver, channel},
    },
    thread,
    time::Duration,
};

use crate::support::{Scratch, files_below, told, virote};

/// A script that is watched, and the lines that are told of it.
struct Watch {
    child: Child,
    lines: Receiver<String>,
}

impl Watch {
    fn new(scratch: &Scratch, args: &[&str]) -> Self {
        let mut child = virote(&scratch.0)
            .arg("watch")
            .args(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let (sender, lines) = channel();
        let out = child.stdout.take().expect("a pipe");
        let err = child.stderr.take().expect("a pipe");
        let hear = |pipe: Box<dyn std::io::Read + Send>,
                    sender: std::sync::mpsc::Sender<String>| {
            thread::spawn(move || {
                for line in BufReader::new(pipe).lines().map_while(Result::ok) {
                    if sender.send(line).is_err() {
                        break;
                    }
                }
            })
        };
        hear(Box::new(out), sender.clone());
        hear(Box::new(err), sender);
        Self { child, lines }
    }

    /// Waits until each of these was in a line; the lines until then. What comes through the two pipes
    /// has no order between them.
    #[track_caller]
    fn sees(&self, parts: &[&str]) -> Vec<String> {
        let (mut seen, mut missing) = (Vec::<String>::new(), parts.to_vec());
        while !missing.is_empty() {
            let line = self.lines.recv_timeout(Duration::from_secs(120));
            assert!(line.is_ok(), "no {missing:?} in {seen:#?}");
            seen.extend(line);
            let newest = seen.last().map_or("", String::as_str);
            missing.retain(|part| !newest.contains(part));
        }
        seen
    }

    /// Presses Ctrl-C; the exit code.
    fn interrupted(mut self) -> Option<i32> {
        let id = self.child.id().to_string();
        let sent = Command::new("kill").args(["-INT", &id]).status().expect("a signal");
        assert!(sent.success());
        self.child.wait().expect("it ends").code()
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        // Where the test failed, it is still there.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn only_what_changed_is_evaluated_again() {
    let scratch = Scratch::new("watch-change");
    let script = |b: &str| {
        format!(
            "let a = 2\nlet b = {b}\nlet c = b + 1\nlet d = a * 10\nprint c\nexport table({{x: [c]}}) to \"t.csv\"\n"
        )
    };
    scratch.file("a.geo", script("a + 1"));
    let watch = Watch::new(&scratch, &["a.geo", "--out", "build"]);
    watch.sees(&["(evaluated 4: a, b, c, d; ", "c = 4"]);
    assert_eq!(fs::read_to_string(scratch.0.join("build/t.csv")).expect("written"), "x\n4\n");
    scratch.file("a.geo", script("a + 5"));
    watch.sees(&["a.geo changed", "(evaluated 2: b, c, kept 2; ", "c = 8"]);
    assert_eq!(fs::read_to_string(scratch.0.join("build/t.csv")).expect("written"), "x\n8\n");
    // A mistake leaves the files as they were, and what was evaluated before is kept.
    scratch.file("a.geo", script("a +"));
    watch.sees(&["[E01", "(evaluated "]);
    assert_eq!(fs::read_to_string(scratch.0.join("build/t.csv")).expect("written"), "x\n8\n");
    scratch.file("a.geo", script("a + 6"));
    watch.sees(&["(evaluated 2: b, c, kept 2; ", "c = 9"]);
    assert_eq!(watch.interrupted(), Some(0));
    assert_eq!(files_below(&scratch.0), ["a.geo", "build/t.csv"], "nothing else is left");
}

#[test]
fn a_script_that_vanishes_is_waited_for() {
    let scratch = Scratch::new("watch-gone");
    scratch.file("a.geo", "print 1 + 1\n");
    let watch = Watch::new(&scratch, &["a.geo"]);
    watch.sees(&["1 + 1 = 2"]);
    fs::rename(scratch.0.join("a.geo"), scratch.0.join("b.geo")).expect("moved");
    watch.sees(&["a.geo is gone; the script is waited for"]);
    fs::rename(scratch.0.join("b.geo"), scratch.0.join("a.geo")).expect("moved back");
    watch.sees(&["1 + 1 = 2"]);
    // An editor puts a new file into the place of the old one.
    scratch.file("new", "print 2 + 2\n");
    fs::rename(scratch.0.join("new"), scratch.0.join("a.geo")).expect("moved");
    watch.sees(&["2 + 2 = 4"]);
    fs::write(scratch.0.join("a.geo"), b"let a = \xff").expect("written");
    watch.sees(&["UTF-8"]);
    watch.sees(&["(evaluated nothing"]);
    scratch.file("a.geo", "");
    watch.sees(&["(evaluated nothing"]);
    assert_eq!(watch.interrupted(), Some(0));
}

#[test]
fn files_that_the_script_reads_are_watched_too() {
    let scratch = Scratch::new("watch-inputs");
    scratch.file("part.geo", "let size = 3\nlet other = 4\n");
    scratch.file("t.csv", "x\n1\n");
    scratch.file("a.geo", "import \"part.geo\"\nlet t = load(\"t.csv\")\nprint part.size, t.x\n");
    let watch = Watch::new(&scratch, &["a.geo", "--message-format", "json", "--check"]);
    watch.sees(&["\"text\":\"[1]\""]);
    watch.sees(&["\"type\":\"evaluated\""]);
    scratch.file("t.csv", "x\n1\n5\n");
    watch.sees(&["t.csv changed"]);
    watch.sees(&["\"text\":\"[1, 5]\""]);
    watch.sees(&["\"type\":\"evaluated\""]);
    scratch.file("part.geo", "let size = 30\nlet other = 4\n");
    watch.sees(&["part.geo changed"]);
    let seen = watch.sees(&["\"text\":\"30\""]);
    assert!(seen.iter().all(|line| line.starts_with('{')), "{seen:?}");
    assert_eq!(watch.interrupted(), Some(0));
}

#[test]
fn ctrl_c_stops_an_evaluation() {
    let scratch = Scratch::new("watch-stop");
    scratch.file("b.geo", "print 7\n");
    let long = "fold(0..9_000_000, 0, (x, y) => fold(0..1000, x, (p, q) => p + q))";
    scratch.file("a.geo", format!("let a = {long}\nprint a\n"));
    let watch = Watch::new(&scratch, &["a.geo", "--limit", "steps=9_000_000_000"]);
    // It is under way when another one, which was begun later, has been carried out.
    let other = Watch::new(&scratch, &["b.geo"]);
    other.sees(&["7 = 7"]);
    assert_eq!(other.interrupted(), Some(0));
    assert_eq!(watch.interrupted(), Some(0));
}

#[test]
fn a_change_ends_the_run_under_way() {
    let scratch = Scratch::new("watch-change-under-way");
    let long = "fold(0..9_000_000, 0, (x, y) => fold(0..1000, x, (p, q) => p + q))";
    let slow = format!("import \"part.geo\"\nlet a = {long}\nprint a\n");
    scratch.file("part.geo", "let size = 3\n");
    scratch.file("a.geo", format!("print 1 + 1\n{slow}"));
    let watch = Watch::new(&scratch, &["a.geo", "--limit", "steps=9_000_000_000"]);
    // So that it is under way: it was begun before another one that has been carried out.
    let other = |text: &str| {
        scratch.file("b.geo", format!("print {text}\n"));
        let other = Watch::new(&scratch, &["b.geo"]);
        other.sees(&[text]);
        assert_eq!(other.interrupted(), Some(0));
    };
    other("7");
    // What it read, too.
    scratch.file("part.geo", "let size = 30\n");
    watch.sees(&["part.geo changed"]);
    other("8");
    scratch.file("a.geo", "let b = 40 + 2\nprint b\n");
    let seen = watch.sees(&["a.geo changed", "b = 42", "(evaluated 1: b"]);
    assert!(!seen.iter().any(|line| line.contains("1 + 1") || line.contains("[E")), "{seen:?}");
    assert_eq!(watch.interrupted(), Some(0));
}

#[test]
fn data_that_grow_all_the_time_leave_a_run_its_time() {
    let scratch = Scratch::new("watch-growing");
    let row = "x\n1\n".to_owned();
    scratch.file("grow.csv", &row);
    let long = "fold(0..6000, len(t), (x, y) => fold(0..1000, x, (p, q) => p + q))";
    let text = format!("let t = load(\"grow.csv\")\nlet a = {long}\nprint 40 + 2, a\n");
    scratch.file("a.geo", text);
    let watch = Watch::new(&scratch, &["a.geo", "--limit", "steps=9_000_000_000"]);
    let is_over = Arc::new(AtomicBool::new(false));
    let (path, over) = (scratch.0.join("grow.csv"), Arc::clone(&is_over));
    let grows = thread::spawn(move || {
        let mut text = row;
        while !over.load(Ordering::SeqCst) {
            text.push_str("2\n");
            fs::write(&path, &text).expect("it is written");
            // Longer than a file is looked at until it rests.
            thread::sleep(Duration::from_millis(700));
        }
    });
    watch.sees(&["grow.csv changed", "40 + 2 = 42"]);
    is_over.store(true, Ordering::SeqCst);
    grows.join().expect("it ends");
    assert_eq!(watch.interrupted(), Some(0));
}

#[test]
fn ctrl_c_stops_the_writing_of_a_file_and_leaves_nothing_of_it() {
    let scratch = Scratch::new("watch-stop-writing");
    scratch.file("a.geo", "export sphere((0, 0), 1) to \"a.obj\" with (tolerance = 1e-8)\n");
    let watch = Watch::new(&scratch, &["a.geo", "--limit", "mesh-vertices=100_000_000"]);
    let is_under_way = || files_below(&scratch.0).iter().any(|name| name.ends_with(".tmp"));
    for _ in 0..6000 {
        if is_under_way() {
            break;
        }
        thread::sleep(Duration::from_millis(10));
    }
    assert!(is_under_way());
    assert_eq!(watch.interrupted(), Some(0));
    assert_eq!(files_below(&scratch.0), ["a.geo"]);
}

#[test]
fn what_cannot_be_watched_is_told() {
    let scratch = Scratch::new("watch-wrong");
    for (file, message) in [
        ("gone.geo", "cannot read `gone.geo`: there is no such file"),
        (".", "`.` is a folder, not a script"),
        ("-", "standard input cannot be watched"),
    ] {
        let output = virote(&scratch.0).args(["watch", file]).output().expect("it runs");
        let (out, err, code) = told(&output);
        assert_eq!((out.as_str(), err, code), ("", format!("virote: {message}\n"), 3));
    }
    let output = virote(&scratch.0).arg("watch").output().expect("it runs");
    assert_eq!(told(&output).2, 3);
}

#[test]
fn it_ends_when_nobody_reads() {
    let scratch = Scratch::new("watch-closed");
    scratch.file("a.geo", "print 1\n");
    let mut child = virote(&scratch.0)
        .args(["watch", "a.geo"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    drop(child.stdout.take());
    // If it has not said anything before the pipe was closed, it does so now.
    assert_eq!(child.wait().expect("it ends").code(), Some(0));
}
