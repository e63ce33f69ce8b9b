//! `virote repl` evaluates of an entry what it concerns: it tells what it would if all were evaluated.

use proptest::{
    collection::vec,
    prelude::{ProptestConfig, any},
    proptest,
    sample::{Index, select},
};

use crate::{repl::piped, support::Scratch};

/// Entries: `#` is the number of a definition, `A` and `B` of others.
const ENTRIES: &[&str] = &[
    "let d# = 1",
    "let d# = dA + 2 * dB",
    "let d# = [dA, dB, 3mm]",
    "let d# = fA(2) + dB",
    "let d# = {v: dA, f: x => x + fB(dB)}",
    "let d# = dA.f(1) + dB.v",
    "let d# = map(0..3, x => fA(x) * dB)",
    "let d# = dA / 0",
    "let d# = \"{dA} and {fB(1)}\"",
    "let [d#, e#] = [dA, dB]",
    "let e# = dA",
    "let d# = e# + eA",
    "let d# = fA",
    "curve d# = line((0, 0), (dA, 2)) with (color = \"red\")",
    "let d# = dA(0.5)",
    "let d# = max(dA, dB) + abs(-#)",
    "fn f#(x) = x + dA",
    "fn f#(x) = if x < 1 then 2 else fA(x - 1)",
    "fn f#(x, y = dA) = fA(x) + y",
    "fn max(a, b) = a",
    "param d# = 3 in 0..10",
    "let d# = dA print d#, eB",
    "let d# = # let e# = d# + dA",
    "let d# = sin(90)",
    "check d# != 2 * dA",
    "unit cm",
    "tolerance 0.01mm",
    "dA + dB",
    "dA == fB",
    "let e# = dA == eB",
    "let d# = {v: fA}",
    "dA.v == fB",
    "fA(3)",
    "d#.v",
    "_ + 1",
    ":list",
    ":undo",
    "let d# = nothing",
    "let d# = dA + )",
    "",
    "// nothing",
];

/// A document in which most of what entries name is there.
fn document() -> String {
    let definition =
        |i: usize| format!("let d{i} = {i} + 0.5\nlet e{i} = d{i}\nfn f{i}(x) = x * d{i}\n");
    (0..N_NAMES).map(definition).collect()
}

/// Definitions that entries speak of.
const N_NAMES: usize = 6;

/// What was told, without how long it took, and without how much was evaluated: what was replaced is remembered for
/// a while, and may come back.
fn timeless(told: &str) -> String {
    let is_count =
        |line: &&str| line.starts_with("(evaluated ") || line.starts_with("(nothing else ");
    let lines = told.lines().filter(|line| !is_count(line));
    // What is gone is told in the order of what was evaluated.
    let without = |line: &'_ str| line.split(", without ").next().unwrap_or_default().to_owned();
    let lines = lines.map(|line| without(line.split(" (").next().unwrap_or_default()));
    lines.collect::<Vec<_>>().join("\n")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// A document that has read a file is evaluated as a whole, since the file may have changed.
    #[test]
    fn entries_come_to_what_they_do_in_a_whole_document(
        entries in vec((select(ENTRIES), [any::<Index>(), any::<Index>(), any::<Index>()]), 1..14),
    ) {
        let entry = |(text, numbers): &(&str, [Index; 3])| {
            let [own, a, b] = numbers.each_ref().map(|number| number.index(N_NAMES).to_string());
            text.replace('#', &own).replace("dA", &format!("d{a}")).replace("eA", &format!("e{a}"))
                .replace("fA", &format!("f{a}")).replace("dB", &format!("d{b}"))
                .replace("eB", &format!("e{b}")).replace("fB", &format!("f{b}"))
        };
        let scratch = Scratch::new("repl-in-part");
        scratch.file("data.json", "1000.25");
        scratch.file("plain.geo", document() + "let data = 1000.25\n");
        scratch.file("reading.geo", document() + "let data = load(\"data.json\")\n");
        let [plain, reading] = ["plain.geo", "reading.geo"].map(|file| {
            let mut input: String = entries.iter().map(|one| entry(one) + "\n\n").collect();
            input.push_str(":list\n:save! out.geo\n");
            let (out, err, code) = piped(&scratch, &[file], input);
            // What is replaced is listed in its place, and behind all others where all was evaluated.
            let mut lines: Vec<&str> = out.lines().collect();
            lines.sort_unstable();
            let out = lines.join("\n");
            let saved = std::fs::read_to_string(scratch.0.join("out.geo")).expect("a script");
            (out, timeless(&err).replace(file, "FILE"), code, saved.replace("load(\"data.json\")", "1000.25"))
        });
        assert_eq!(plain, reading, "{entries:?}");
    }
}

#[test]
fn what_an_entry_does_not_concern_is_counted_as_kept() {
    let scratch = Scratch::new("repl-kept");
    let definitions: String = (0..40).map(|i| format!("let d{i} = {i}\n")).collect();
    scratch.file("a.geo", definitions + "let sum = d3 + d4\nfn f(x) = x + sum\nlet g = f(d5)\n");
    let input =
        "let d3 = 100\nlet new = g\nlet d4 = 200\nnew\nfn f(x) = x\nnew\n:undo\n:undo\nnew\n";
    let (out, err, code) = piped(&scratch, &["a.geo"], input);
    assert_eq!(out, "d3 = 100\nnew = 109\nd4 = 200\n305\nf: function f(x)\n5\n109\n", "{err}");
    assert!(err.contains("(evaluated 3 again: sum, f, g, kept 39; "), "{err}");
    assert!(err.contains("(evaluated 4 again: sum, f, g, new, kept 39; "), "{err}");
    assert!(err.contains("(evaluated 2 again: g, new, kept 41; "), "{err}");
    assert_eq!(code, 0, "{err}");
}

/// A name that goes with what is replaced is known no more.
#[test]
fn what_goes_with_an_entry_is_missed() {
    let scratch = Scratch::new("repl-gone");
    let definitions: String = (0..40).map(|i| format!("let d{i} = {i}\n")).collect();
    scratch.file("a.geo", definitions + "let [a, b] = [1, 2]\nlet c = a + 1\n");
    let input = "let b = 7\nlet a = b\nlet c = 5\nlet b = 7\na\nlet a = b\nlet c = a\n";
    let (out, err, code) = piped(&scratch, &["a.geo"], input);
    assert_eq!(out, "c = 5\nb = 7\na = 7\nc = 7\n", "{err}");
    assert_eq!((err.matches("E0201").count(), code), (3, 2), "{err}");
}

/// Under other ceilings nothing is known of what was evaluated before.
#[test]
fn entries_under_other_ceilings_are_evaluated_with_all() {
    let scratch = Scratch::new("repl-ceilings");
    let definitions: String = (0..40).map(|i| format!("let d{i} = {i}\n")).collect();
    scratch.file("a.geo", definitions);
    let input = "let a = d1 + 1\n:set steps 100000\nlet b = a + d2\nlet a = 7\nb\n:undo\nb\n";
    let (out, err, _) = piped(&scratch, &["a.geo"], input);
    assert_eq!(out, "a = 2\nsteps 100000\nb = 4\na = 7\n9\n4\n", "{err}");
}
