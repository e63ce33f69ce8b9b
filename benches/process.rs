//! How long the whole process takes: start, script, end.

use std::{
    io::Write,
    process::{Command, Stdio},
};

fn main() {
    divan::main();
}

/// Runs the command with a script on standard input.
fn run(script: &str) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_virote"))
        .args(["run", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .expect("the command starts");
    child.stdin.take().expect("piped").write_all(script.as_bytes()).expect("it reads");
    assert!(child.wait().expect("it ends").success());
}

/// The floor: a process that does nothing but start and end.
#[divan::bench]
fn an_empty_process() {
    assert!(Command::new("true").status().expect("it starts").success());
}

#[divan::bench]
fn a_trivial_script() {
    run("print 1 + 1");
}

const SIZES: [usize; 3] = [1_000, 10_000, 100_000];

/// Each definition uses the one before it.
#[divan::bench(args = SIZES, sample_count = 5, sample_size = 1)]
fn definitions_in_a_chain(n: usize) {
    let chain: String = (1..n).map(|i| format!("let a{i} = a{} + 1\n", i - 1)).collect();
    run(&format!("let a0 = 1\n{chain}print a{}", n - 1));
}

/// No definition uses another.
#[divan::bench(args = SIZES, sample_count = 5, sample_size = 1)]
fn definitions_side_by_side(n: usize) {
    let all: String = (0..n).map(|i| format!("let a{i} = {i} + 1\n")).collect();
    run(&format!("{all}print a0"));
}

#[divan::bench(sample_count = 5, sample_size = 1)]
fn a_million_numbers_of_five_operations() {
    run("let xs = [for i in 0..<1000000: (i * 2 + 1) / 3 - i * 0.5]\nprint len(xs)");
}

/// What cannot be computed in lanes: a list for each number.
#[divan::bench(sample_count = 5, sample_size = 1)]
fn a_million_lists_of_five_operations() {
    run("let xs = [for i in 0..<1000000: [(i * 2 + 1) / 3 - i * 0.5]]\nprint len(xs)");
}
