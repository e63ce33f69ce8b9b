//! The same work in other languages, whole processes: comprehensions of a million numbers, with five
//! operations each, with built-in functions, with vectors, and with a function of the script's own, in virote, in OpenSCAD and in CPython.
//!
//! Each of them runs in turn, so that a busy machine burdens all alike; medians and their ratios
//! are printed. A language that is not installed is said to be missing.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::{
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::{Duration, Instant},
};

const N_ROUNDS: usize = 9;

/// What is done with a million numbers.
const WORK: [&str; 4] = [
    "five operations each",
    "two built-in functions and four operations each",
    "the length of a vector and a scalar product each",
    "a function of the script's own each, of three built-in functions",
];

/// A language: its name, a script for each work and how a script is run.
struct Language {
    name: &'static str,
    scripts: [&'static str; WORK.len()],
    ending: &'static str,
    command: fn(&Path) -> Command,
}

/// All make the whole list, and print its length and its last number.
const LANGUAGES: &[Language] = &[
    Language {
        name: "virote",
        scripts: [
            "let xs = [for i in 0..<1000000: (i * 2 + 1) / 3 - i * 0.5]\nprint len(xs), xs[-1]\n",
            "let xs = [for i in 0..<1000000: sqrt(i) * 2 + floor(i / 3) - 1]\nprint len(xs), xs[-1]\n",
            "let xs = [for i in 0..<1000000: norm((i, 1, 2)) + dot((i, 2), (3, i))]\nprint len(xs), xs[-1]\n",
            "fn f(x) = sqrt(x) * sin(x) + floor(x / 3)\n\
             let xs = [for i in 0..<1000000: f(i)]\nprint len(xs), xs[-1]\n",
        ],
        ending: "geo",
        command: |script| {
            let mut command = Command::new(env!("CARGO_BIN_EXE_virote"));
            command.arg("run").arg(script);
            command
        },
    },
    Language {
        name: "OpenSCAD",
        // A loop goes over less than a million numbers, so two share the work.
        scripts: [
            "xs = [for (i = [0:499999]) (i * 2 + 1) / 3 - i * 0.5,\n\
             for (i = [500000:999999]) (i * 2 + 1) / 3 - i * 0.5];\n\
             echo(len(xs), xs[999999]);\n",
            "xs = [for (i = [0:499999]) sqrt(i) * 2 + floor(i / 3) - 1,\n\
             for (i = [500000:999999]) sqrt(i) * 2 + floor(i / 3) - 1];\n\
             echo(len(xs), xs[999999]);\n",
            "xs = [for (i = [0:499999]) norm([i, 1, 2]) + [i, 2] * [3, i],\n\
             for (i = [500000:999999]) norm([i, 1, 2]) + [i, 2] * [3, i]];\n\
             echo(len(xs), xs[999999]);\n",
            "function f(x) = sqrt(x) * sin(x * 180 / PI) + floor(x / 3);\n\
             xs = [for (i = [0:499999]) f(i), for (i = [500000:999999]) f(i)];\n\
             echo(len(xs), xs[999999]);\n",
        ],
        ending: "scad",
        command: |script| {
            let mut command = Command::new("openscad");
            command.arg("-o").arg(script.with_extension("echo")).arg(script);
            command
        },
    },
    Language {
        name: "CPython",
        scripts: [
            "xs = [(i * 2 + 1) / 3 - i * 0.5 for i in range(1000000)]\nprint(len(xs), xs[-1])\n",
            "from math import floor, sqrt\n\
             xs = [sqrt(i) * 2 + floor(i / 3) - 1 for i in range(1000000)]\nprint(len(xs), xs[-1])\n",
            "from math import hypot\n\
             def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]\n\
             xs = [hypot(i, 1, 2) + dot((i, 2, 0), (3, i, 0)) for i in range(1000000)]\n\
             print(len(xs), xs[-1])\n",
            "from math import floor, sin, sqrt\n\
             def f(x): return sqrt(x) * sin(x) + floor(x / 3)\n\
             xs = [f(i) for i in range(1000000)]\nprint(len(xs), xs[-1])\n",
        ],
        ending: "py",
        command: |script| {
            let mut command = Command::new("python3");
            command.arg("-I").arg(script);
            command
        },
    },
];

fn main() {
    for (k, work) in WORK.iter().enumerate() {
        println!("a million numbers of {work}, whole process, median of {N_ROUNDS}");
        compare(k);
    }
}

/// Runs the scripts of one work in turn, and prints their times.
fn compare(work: usize) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let scripts: Vec<PathBuf> = LANGUAGES
        .iter()
        .map(|language| {
            let path = folder.join(format!("million.{}", language.ending));
            std::fs::write(&path, language.scripts[work])
                .expect("the folder of temporary files is there");
            path
        })
        .collect();
    let mut times = vec![Some(Vec::new()); LANGUAGES.len()];
    for _ in 0..N_ROUNDS {
        for ((language, script), times) in LANGUAGES.iter().zip(&scripts).zip(&mut times) {
            if let Some(taken) = times {
                match run(language, script) {
                    Some(time) => taken.push(time),
                    None => *times = None,
                }
            }
        }
    }
    let medians: Vec<Option<Duration>> = times.into_iter().map(|times| times.map(median)).collect();
    for (language, time) in LANGUAGES.iter().zip(&medians) {
        match (time, medians[0]) {
            (Some(time), Some(ours)) => println!(
                "{:10} {:7.0} ms   {:6.1} times virote",
                language.name,
                time.as_secs_f64() * 1e3,
                time.as_secs_f64() / ours.as_secs_f64()
            ),
            _ => println!("{:10} is not installed, or its script failed", language.name),
        }
    }
}

/// How long one run takes; `None` if it cannot be run or fails.
fn run(language: &Language, script: &Path) -> Option<Duration> {
    let start = Instant::now();
    let status =
        (language.command)(script).stdout(Stdio::null()).stderr(Stdio::null()).status().ok()?;
    status.success().then(|| start.elapsed())
}

fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    times[times.len() / 2]
}
