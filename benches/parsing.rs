//! How fast text becomes a tree: a generated script of 10 MB, in one thread.

use std::fmt::Write;

use divan::{Bencher, counter::BytesCount};
use virote::{limits::Limits, syntax};

fn main() {
    divan::main();
}

/// Bytes of the generated script.
const SIZE: usize = 10_000_000;

/// A script of every common kind of statement, `size` bytes long or a little more.
fn script(size: usize) -> String {
    let mut text = String::from("geo 1\nunit mm\n");
    let mut i = 0;
    while text.len() < size {
        // Writing into a string cannot fail.
        let _ = write!(
            text,
            "/// The width at frame {i}.\n\
             let width_{i} = {i}mm + 2.5 * max([1mm, {}mm, 3mm]) - 0.25mm\n\
             fn radius_{i}(h, k = 2) = if h < {i} then h * k else [for j in 0..3 if j != 1: j + h][0]\n\
             curve rib_{i} = nurbs([(0, 0, {i}), (1, width_{i}, 0), (2, 0, -1)], degree = 2, weights = [1, 0.5, 1])\n\
             check length(rib_{i}) ~= 12.5 within 1e-3 \"rib {i}\" // a remark\n",
            i % 7,
        );
        i += 1;
    }
    text
}

#[divan::bench(sample_count = 5, sample_size = 1)]
fn parse_10_mb(bencher: Bencher<'_, '_>) {
    let text = script(SIZE);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench_local(|| syntax::parse(divan::black_box(&text), &Limits::DEFAULT));
}

/// A script of lists with names, `size` bytes long or a little more.
fn lists(size: usize) -> String {
    let mut text = String::from("geo 1\n");
    let mut i = 0;
    while text.len() < size {
        // Writing into a string cannot fail.
        let _ = writeln!(text, "let list_{i} = [{i}, {i} + 0.5, 2.25, -{i}, 1e-3, {i} * 2]");
        i += 1;
    }
    text
}

#[divan::bench(sample_count = 5, sample_size = 1)]
fn parse_10_mb_of_lists(bencher: Bencher<'_, '_>) {
    let text = lists(SIZE);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench_local(|| syntax::parse(divan::black_box(&text), &Limits::DEFAULT));
}

#[divan::bench]
fn parse_50_lines(bencher: Bencher<'_, '_>) {
    let text = script(4_000);
    bencher
        .counter(BytesCount::of_str(&text))
        .bench_local(|| syntax::parse(divan::black_box(&text), &Limits::DEFAULT));
}
