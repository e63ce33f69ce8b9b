//! Whatever is edited, an incremental session tells what a fresh one tells, to the byte.

use std::fmt::Write as _;

use proptest::{collection::vec, prelude::ProptestConfig, proptest};
use virote::{
    eval::{Setting, Work},
    limits::Limits,
    render::picture,
    session::{Event, Report, Session},
};

use super::harness::Shelf;

/// Statements of a document: `#` is the number of the new one, `A` and `B` of others.
const STATEMENTS: &[&str] = &[
    "let d# = 1",
    "let d# = dA + 2 * dB",
    "let d# = [dA, dB, 3mm]",
    "let d# = fA(2) + dB",
    "let d# = map(0..3, x => fA(x) * dB)",
    "let d# = [for x in 0..dA if x > 1: x / dB]",
    "let d# = {v: dA, f: x => x + dB}",
    "let d# = dA.f(1) + dB.v",
    "let d# = { let t = dA fn g(x) = if x < 1 then t else h(x - 1) fn h(x) = g(x) g(3) }",
    "let d# = dA / 0",
    "let d# = load(\"data.json\")",
    "let d# = load(\"{if dA > 1 then \"data\" else \"none\"}.json\")",
    "let [d#, e#] = [dA, dB]",
    "curve d# = line((0, 0), (dA, 2))",
    "mesh d# = grid_mesh(bilinear((0, 0), (dA, 0), (0, 1), (1, dB)), 1, 1) with (layer = \"{dA}\")",
    "let d# = dA(0.5)",
    "let d# = fA",
    "fn f#(x) = x + 1",
    "fn f#(x, y = 2) = if x < 1 then y else fA(x - 1) + dB",
    "param d# = 3 in 0..10",
    "param d#: length = dA step 0.5",
    "import \"lib.geo\" as d# with (k = dA)",
    "import \"lib.geo\" (f0)",
    "let d# = dA.one + dA.two(dB)",
    "let d# = script(\"middle.geo\", k = dA).y",
    "let d# = script(\"middle.geo\").y + sin(90)",
    "let d# = sin(9e1) + cos(90.0) + dA",
    "surface parametric((u, v) => (u, v, dA * u), 0..1, 0..1) export parametric((u, v) => (u, v, u * v), 0..1, 0..1) to \"p#.stl\"",
    "print dA, dB",
    "check dA == dB \"of {dB}\"",
    "check fA(1) > 0",
    "export dA to \"out#.json\"",
    "export all to \"all.obj\"",
    "test \"#\" { let t = dA check t == dB }",
    // Broken ones.
    "let d# = (dA + ",
    "let d# = nothing",
    "fn f#(x = ",
    "}",
];

/// What the data file holds, one after another.
const DATA: &[&str] = &["2", "{\"v\": 1, \"f\": 2}", "[1, 2, 3]", "[", "3"];

/// What the imported file says, one after another.
const LIBRARIES: &[&str] = &[
    "param k = 2\nlet one = k + 1\nfn two(x) = x * one\nfn f0(x) = x + 5",
    "// moved\nparam k = 2\nlet one = k + 1\nfn two(x) = x * one\nfn f0(x) = x + 5",
    "param k = 2\nlet one = k + 1\nfn two(x) = one * x\nfn f0(x) = x + load(\"data.json\")",
    "let one = 1 / 0",
    "param k = 2\nlet one = load(\"data.json\")\nfn two(x) = x\nfn f0(x) = 1",
    "let one = (",
    "param k = 2\nlet one = sin(90)\nfn two(x) = x\nfn f0(x) = x",
    "param k = 2\nlet one = k\nlet more = 1 / 0\nfn two(x) = x + more\nfn f0(x) = x",
];

/// What the file between says, one after another.
const MIDDLES: &[&str] = &[
    "import \"lib.geo\" as lib\nparam k = 1\nlet y = lib.one + k",
    "import \"lib.geo\" as lib\nparam k = 1\nlet y = lib.one + k\nlet q = = 3",
    "import \"lib.geo\" as lib\nparam k = 1\nlet y = lib.one + k\nprint nothing",
    "import \"lib.geo\" (one)\nlet k = load(\"data.json\")\nlet y = one",
];

/// A document under edit.
struct Document {
    is_in_metres: bool,
    statements: Vec<String>,
    files: Shelf,
    settings: Vec<Setting>,
    n_added: usize,
}

impl Document {
    fn new() -> Self {
        let mut document = Self {
            is_in_metres: false,
            statements: Vec::new(),
            files: Shelf::default(),
            settings: Vec::new(),
            n_added: 0,
        };
        document.hold("data.json", DATA[0]);
        document.hold("lib.geo", LIBRARIES[0]);
        document.hold("middle.geo", MIDDLES[0]);
        let start = ["let d0 = 4", "fn f0(x) = x + d0", "let d1 = f0(d0)", "param d2 = 3 in 0..10"];
        document.statements.extend(start.map(str::to_owned));
        document.n_added = 3;
        document
    }

    fn hold(&mut self, path: &str, text: &str) {
        self.files.0.insert(path.to_owned(), text.to_owned());
    }

    /// A statement that uses others by their numbers.
    fn statement(&self, choice: usize, place: usize) -> String {
        let other = |n: usize| ((place + n * choice) % (self.n_added + 1)).to_string();
        STATEMENTS[choice % STATEMENTS.len()]
            .replace('#', &self.n_added.to_string())
            .replace('A', &other(1))
            .replace('B', &other(3))
    }

    fn edit(&mut self, kind: u8, place: usize, choice: usize) {
        let n = self.statements.len();
        match kind {
            0..4 => {
                self.n_added += 1;
                let new = self.statement(choice, place);
                self.statements.insert(place % (n + 1), new);
            }
            4 if n > 0 => drop(self.statements.remove(place % n)),
            5 if n > 0 => self.statements.swap(place % n, choice % n),
            6 if n > 0 => {
                let statement = &mut self.statements[place % n];
                *statement = statement.replacen(['1', '2', '3'], &(choice % 5).to_string(), 1);
            }
            7 => self.statements.insert(place % (n + 1), format!("// {}", "-".repeat(choice))),
            8 if n > 0 => {
                let statement = &mut self.statements[place % n];
                *statement =
                    format!("\n{}", statement.replace(" + ", "  +\n  ")).replace(", ", ",");
            }
            9 => {
                let (old, new) = (format!("d{}", place % 9), format!("d{}", 900 + choice));
                for statement in &mut self.statements {
                    *statement = statement.replace(&old, &new);
                }
            }
            10 => {
                let text = ["1", "5", "11", "no"][choice % 4].to_owned();
                let setting =
                    Setting { name: format!("d{}", place % 9), text, called: String::new() };
                self.settings = if choice < 8 { Vec::new() } else { vec![setting] };
            }
            11 => self.hold("data.json", DATA[choice % DATA.len()]),
            12 => self.hold("lib.geo", LIBRARIES[choice % LIBRARIES.len()]),
            13 => self.is_in_metres = !self.is_in_metres,
            14 => self.hold("middle.geo", MIDDLES[choice % MIDDLES.len()]),
            _ => {}
        }
    }

    fn text(&self) -> String {
        let unit = if self.is_in_metres { "unit m\n" } else { "" };
        format!("{unit}{}", self.statements.join("\n"))
    }

    fn run(&self, session: &Session) -> Report {
        session.test("document.geo", self.text().as_bytes(), &self.files, &self.settings, None)
    }
}

/// Everything that a report tells; values as they are inside, with the places that functions hold.
fn told(report: &Report) -> String {
    let mut told = String::new();
    for defined in &report.definitions {
        let (name, span) = (&defined.name, defined.span);
        let _ = writeln!(told, "{name} {span:?} {} {:?}", defined.look.is_hidden, defined.value);
    }
    for event in &report.events {
        let _ = match event {
            Event::File(file) => {
                let mut bytes = Vec::new();
                let written = (file.format.write)(&file.job, &mut bytes);
                writeln!(told, "{} {:?} {written:?} {bytes:?}", file.path, file.span)
            }
            other => writeln!(told, "{other:?}"),
        };
    }
    for diagnostic in &report.diagnostics {
        told += &picture(diagnostic, &report.sources, false);
    }
    let _ = writeln!(told, "{:?} {:?}", report.tests, report.unknown_settings);
    told
}

fn sessions(n_threads: usize) -> [Session; 2] {
    let fresh = || Session::new(Limits::DEFAULT).on_threads(n_threads);
    [fresh(), fresh().incremental()]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..Default::default() })]

    #[test]
    fn an_incremental_run_is_a_fresh_run(
        edits in vec((0..15u8, 0..40usize, 0..40usize), 1..40),
        n_threads in 1..=4usize,
    ) {
        let [fresh, incremental] = sessions(n_threads);
        let mut document = Document::new();
        let alone = Session::default().incremental();
        for (kind, place, choice) in edits {
            document.edit(kind, place, choice);
            let report = document.run(&incremental);
            assert_eq!(told(&report), told(&document.run(&fresh)), "{}", document.text());
            // What is told of the work does not depend on threads either.
            let of = |report: &Report| report.definitions.iter().map(|one| one.work).collect();
            let (here, there): (Vec<Work>, Vec<Work>) = (of(&report), of(&document.run(&alone)));
            assert_eq!(here, there, "{}", document.text());
        }
    }
}

/// A document and its files, one state after another, told by a fresh and by an incremental session.
fn told_alike(states: &[(&str, &[(&str, &str)])]) {
    let [fresh, incremental] = sessions(2);
    for (text, files) in states {
        let mut shelf = Shelf::default();
        shelf.0.extend(files.iter().map(|&(path, text)| (path.to_owned(), text.to_owned())));
        let run = |session: &Session| told(&session.run("d.geo", text.as_bytes(), &shelf, &[]));
        assert_eq!(run(&incremental), run(&fresh), "{text}\n{files:?}");
    }
}

#[test]
fn what_lies_below_a_called_script_counts() {
    let (outer, middle) =
        ("let a = script(\"x.geo\").y\nprint a", "import \"z.geo\" as z\nlet y = z.t");
    let state =
        |z: &'static str, data: &'static str| [("x.geo", middle), ("z.geo", z), ("d.csv", data)];
    let load = "let t = load(\"d.csv\").v[0]";
    let [one, two] = ["v\n1", "v\n2"].map(|data| state(load, data));
    told_alike(&[(outer, &one), (outer, &two), (outer, &two[..2]), (outer, &one)]);
    let doubtful = state("let t = sin(90)", "");
    told_alike(&[(outer, &doubtful), (outer, &doubtful), (outer, &one)]);
    let broken = |more: &str| format!("let y = 1\n{more}");
    for more in [
        "let q = = 3",
        "print nope",
        "check 1 ==",
        "tolerance -1",
        "geo 2",
        "test \"t\" { print nope }",
    ] {
        let (whole, broken) = (broken(""), broken(more));
        let files = [&whole, &broken, &whole].map(|text| [("x.geo", text.as_str())]);
        told_alike(&files.each_ref().map(|files| (outer, files.as_slice())));
    }
}

#[test]
fn a_number_warns_however_it_is_spelled() {
    let states = ["let a = sin(9e1)", "let a = sin(90)", "let b = sin(90.0)\nlet a = sin(90)"];
    told_alike(&[0, 1, 0, 2, 2].map(|i| (states[i], [].as_slice())));
}

#[test]
fn an_exported_expression_is_not_what_stands_on_its_line() {
    let text = "surface parametric((u, v) => (u, v, sin(u * 1rad)), 0..1, 0..1) export parametric((u, v) => (u, v, u * v), 0..1, 0..1) to \"b.stl\" export all to \"a.stl\"";
    told_alike(&[(text, &[]), (text, &[])]);
}

#[test]
fn ceilings_are_crossed_whatever_is_remembered() {
    let heavy = |name: &str| format!("let {name} = sum([for i in 0..<3000: sqrt(i)])");
    let script = ["a", "b", "c", "y"].map(heavy).join("\n");
    let shelf = Shelf([("x.geo".to_owned(), script)].into());
    let session = || Session::new(Limits { steps: 15_000, ..Limits::DEFAULT });
    let remembering = session().incremental();
    for q in 1..4 {
        let text = format!("let q = {q}\nlet a = script(\"x.geo\").y + q\nprint a");
        let run = |session: &Session| told(&session.run("d.geo", text.as_bytes(), &shelf, &[]));
        let (here, there) = (run(&remembering), run(&session()));
        assert!(there.contains("steps"), "{there}");
        assert_eq!(here, there);
    }
}

#[test]
fn the_edits_try_everything() {
    let [_, incremental] = sessions(1);
    let mut document = Document::new();
    let mut seen = [0; 4];
    let mut seed = 1_u64;
    let mut next = |n: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) % n) as usize
    };
    for _ in 0..500 {
        if next(40) == 0 {
            document = Document::new();
        }
        document.edit(next(15) as u8, next(40), next(40));
        let report = document.run(&incremental);
        let works = [Work::Evaluated, Work::Renewed, Work::Reused, Work::Failed];
        seen.iter_mut().zip(works).for_each(|(seen, work)| *seen += report.n_with(work));
    }
    assert!(seen.iter().all(|&n| n > 100), "{seen:?}");
}

/// Whatever of an expression is edited, what was remembered of it is not taken for it.
#[test]
fn every_part_of_an_expression_counts() {
    let forms: &[&[&str]] = &[
        &["{ let t = 1 t }", "{ let t = 2 t }", "{ let t = 1 2 * t }", "{ let t = 1 let s = 2 s }"],
        &["\"one {k}\"", "\"two {k}\"", "\"one {k + 1}\"", "\"one {k:.2}\"", "\"one {k:.3}\""],
        &["[1, 2]", "[1, 3]", "[1, 2, 2]", "[...[1, 2]]", "[[1, 2]]", "(1, 2)"],
        &["[for i in 0..3: i]", "[for i in 0..4: i]", "[for i in 0..3: -i]"],
        &["[for i in 0..3 if i > 1: i]", "[for i in 0..3 if i > 2: i]"],
        &["[for [i, j] in [[1, 2]]: i]", "[for [i, j] in [[1, 2]]: j]"],
        &["{a: 1, b: 2}", "{a: 2, b: 2}", "{a: 1, c: 2}"],
        &["{a: 1, b: 2}.a", "{a: 1, b: 2}.b"],
        &["[1, 2][0]", "[1, 2][1]", "[1, 2][-1]"],
        &["if k > 0 then 1 else 2", "if k < 0 then 1 else 2", "if k > 0 then 2 else 2"],
        &["k + 1", "k - 1", "1 - k", "-k", "not (k > 0)", "k > 0"],
        &["k == 2 and k > 3", "k == 2 or k > 3"],
        &["map([1, 2], x => x)", "map([1, 2], x => k)", "map([1, 2], x => 2 * x)"],
        &["f(1, b = 2)", "f(2, b = 1)", "f(b = 1, a = 2)", "f(1)", "f(1, b = 3)"],
        &["g(1)", "g(2)", "1mm", "1cm", "1deg"],
        &["0..3", "0..<3", "0..4", "1..3"],
    ];
    for form in forms {
        let text = |expr: &str| {
            format!(
                "let k = 2\nfn f(a, b = 5) = 10 * a + b\nlet g = f(_, b = 7)\nlet d = {expr}\n\
                 print d, [d]"
            )
        };
        let texts: Vec<String> =
            form.iter().chain(form.iter().rev()).map(|expr| text(expr)).collect();
        let states: Vec<_> = texts.iter().map(|text| (text.as_str(), [].as_slice())).collect();
        told_alike(&states);
    }
}
