//! The library as other programs use it: on ordinary threads, with files in memory, and with values that
//! outlive the run.

#![expect(clippy::panic, reason = "a test fails by a panic")]

use std::io::{self, Write};

use virote::{
    diag::{Code, Severity},
    kernel::{Curve, Tolerance},
    limits::{Ceiling, Limits, work::StopToken},
    session::{Arguments, Event, Report, Session},
    syntax::ast::Unit,
    value::{MemoryFiles, NoFiles, Value},
};

fn run(script: &str) -> Report {
    Session::default().run("a.geo", script.as_bytes(), &NoFiles, &[])
}

#[track_caller]
fn printed(report: &Report) -> String {
    match &report.events[..] {
        [Event::Printed(line)] => line.value.to_string(),
        _ => panic!("{:?}", report.diagnostics),
    }
}

const RECURSION: &str = "fn down(n) = if n == 0 then 0 else 1 + down(n - 1)\n";

#[test]
fn a_deep_recursion_ends_well_on_an_ordinary_thread() {
    // A test's thread has two megabytes.
    assert_eq!(printed(&run(&format!("{RECURSION}print down(5000)"))), "5000");
    let report = run(&format!("{RECURSION}print down(50000)"));
    assert_eq!(report.diagnostics[0].code, Code::RecursionTooDeep);
}

#[test]
fn brackets_as_deep_as_the_ceiling_are_read_on_an_ordinary_thread() {
    let limits = Limits { nesting: 10_000, chain: 10_000, ..Limits::DEFAULT };
    let (open, closed) = ("(".repeat(9_000), ")".repeat(9_000));
    let session = Session::new(limits);
    let report = session.run("a.geo", format!("print {open}1{closed}").as_bytes(), &NoFiles, &[]);
    assert_eq!(printed(&report), "1");
}

fn curve(report: &Report, name: &str) -> Curve {
    match report.value(name) {
        Some(Value::Curve(curve)) => curve,
        _ => panic!("{:?}", report.diagnostics),
    }
}

#[test]
fn a_function_that_is_asked_outside_of_the_run_keeps_to_the_stack_that_there_is() {
    let report = run(&format!("{RECURSION}curve c = parametric(t => (t, 0 * down(10)), 0..1)"));
    assert_eq!(curve(&report, "c").point_at(0.5).map(|point| point.x), Ok(0.5));
    // Two hundred calls fit into any stack, four thousand do not: an error, and no abort.
    let script = "curve c = parametric(t => (t, 0 * down(if t == 0.123 then 4000 else 1)), 0..1)";
    let report = run(&format!("{RECURSION}{script}"));
    let told = curve(&report, "c").point_at(0.123).map_err(|err| err.to_string());
    assert!(told.is_err(), "{told:?}");
}

#[test]
fn values_answer_when_the_report_is_gone() {
    let report = run("let k = 3\ncurve c = parametric(t => (t, k * t), 0..1)\nlet broken = 1 / 0");
    assert!(report.value("broken").is_none() && report.value("nothing").is_none());
    let value = report.value("c").expect("it is defined");
    drop(report);
    let Value::Curve(curve) = value else { panic!("{value:?}") };
    assert_eq!(curve.point_at(1.0).map(|point| point.y), Ok(3.0));
}

#[test]
fn whatever_leaves_a_run_owns_what_it_needs() {
    let script = "let k = 3\nfn twice(x) = 2 * k * x\ncurve c = parametric(t => (t, twice(t)), 0..1)\n\
        let all = [{ curve: c, own: twice, later: x => twice(x) + k, part: twice(_) }]\nprint all\n\
        surface s = parametric((u, v) => (u, v, twice(u)), 0..1, 0..1)\nprint c";
    let report = run(script);
    let value = |name| report.value(name).unwrap_or_else(|| panic!("{:?}", report.diagnostics));
    let (surface, all) = (value("s"), value("all"));
    let printed: Vec<Value> = report
        .events
        .iter()
        .filter_map(|event| match event {
            Event::Printed(printed) => Some(printed.value.clone()),
            _ => None,
        })
        .collect();
    drop(report);

    let answers = |curve: &Curve| {
        // What is made of it owns the same.
        let part = curve.split(0.25).map(|[_, behind]| behind);
        assert_eq!(part.and_then(|part| part.point_at(0.5)).map(|point| point.y), Ok(3.0));
    };
    let Value::Surface(surface) = surface else { panic!("{surface:?}") };
    let isocurve = surface.isocurve_v(0.5).expect("an isocurve");
    drop(surface);
    assert_eq!(isocurve.point_at(0.5).map(|point| point.z), Ok(3.0));

    let members = |value: &Value| match value {
        Value::List(items) => match items.first() {
            Some(Value::Record(record)) => record.clone(),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    };
    let session = Session::default();
    for record in [members(&all), members(&printed[0])] {
        let Some(Value::Curve(curve)) = record.get("curve") else { panic!("{record:?}") };
        answers(curve);
        for (name, expected) in [("own", 12.0), ("later", 15.0), ("part", 12.0)] {
            let function = record.get(name).expect("a field").clone();
            let arguments = Arguments { positional: vec![Value::number(2.0)], named: Vec::new() };
            let (answer, _) =
                session.call(&function, arguments, (Unit::Mm, Tolerance::DEFAULT), &NoFiles);
            assert_eq!(answer.expect("an answer").to_string(), expected.to_string());
        }
    }
    let Value::Curve(curve) = &printed[1] else { panic!("{printed:?}") };
    answers(curve);
}

#[test]
fn what_a_function_answers_owns_what_it_needs() {
    let report = run(
        "let k = 3\nfn line_of(a) = parametric(t => (t, k * a * t), 0..1)\nfn later(a) = x => k * a * x",
    );
    let session = Session::default();
    let call = |function: &Value, number: f64| {
        let arguments = Arguments { positional: vec![Value::number(number)], named: Vec::new() };
        session
            .call(function, arguments, (Unit::Mm, Tolerance::DEFAULT), &NoFiles)
            .0
            .expect("an answer")
    };
    let [line_of, later] = ["line_of", "later"].map(|name| report.value(name).expect("defined"));
    drop(report);
    let (line, made) = (call(&line_of, 2.0), call(&later, 2.0));
    drop((line_of, later));
    let Value::Curve(line) = line else { panic!("{line:?}") };
    assert_eq!(line.point_at(0.5).map(|point| point.y), Ok(3.0));
    assert_eq!(call(&made, 0.5).to_string(), "3");
}

#[test]
fn files_are_written_after_the_report_is_gone() {
    let mut report =
        run("let k = 3\ncurve c = parametric(t => (t, k * t), 0..1)\nexport c to \"c.svg\"");
    let Event::File(file) = report.events.remove(0) else { panic!("{:?}", report.diagnostics) };
    drop(report);
    let mut bytes = Vec::new();
    file.write(&mut bytes).expect("a vector takes everything");
    assert!(String::from_utf8_lossy(&bytes).contains("<path"));
}

struct Full;

impl Write for Full {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(io::ErrorKind::StorageFull.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn what_cannot_be_written_is_told_by_its_code_and_place() {
    let script = "curve c = circle((0, 0), 1)\nexport c to \"c.svg\"";
    let report = run(script);
    let Event::File(file) = &report.events[0] else { panic!("{:?}", report.diagnostics) };
    let found = file.write(&mut Full).expect_err("there is no room");
    assert_eq!((found.code, found.severity), (Code::CannotWrite, Severity::Error));
    assert_eq!(found.primary.span.start as usize, script.find("\"c.svg\"").expect("it is there"));

    let session = Session::new(Limits { output_bytes: 20, ..Limits::DEFAULT });
    let report = session.run("a.geo", script.as_bytes(), &NoFiles, &[]);
    let Event::File(file) = &report.events[0] else { panic!("{:?}", report.diagnostics) };
    assert_eq!(file.write(&mut Vec::new()).map_err(|found| found.code), Err(Code::TooLarge));
}

#[test]
fn files_in_memory_are_imported_and_loaded() {
    let mut files =
        MemoryFiles::from([("parts/ring.geo", "let size = len(load(\"points.csv\").x)")]);
    files.insert("parts/points.csv", "x,y\n0,0\n1,2\n");
    let script = b"import \"parts/ring.geo\"\nprint ring.size";
    let report = Session::default().run("a.geo", script, &files, &[]);
    assert_eq!(printed(&report), "2");
    let report = run("import \"ring.geo\"");
    assert!(report.diagnostics[0].message.contains("there is no `ring.geo`"));
}

#[test]
fn a_run_is_stopped_from_another_thread() {
    let stop = StopToken::default();
    let session = Session::default().stopped_by(stop.clone());
    let stopper = std::thread::spawn(move || stop.stop());
    let report = session.run("a.geo", b"print sum([for i in 0..<9999999: i])", &NoFiles, &[]);
    stopper.join().expect("it ends");
    assert_eq!(report.diagnostics.first().map(|found| found.code), Some(Code::Stopped));
}

#[test]
fn the_writing_of_a_file_keeps_to_the_ceilings_and_can_be_stopped() {
    let script = b"surface s = sphere((0, 0), 1)\nexport s to \"s.svg\"";
    let written = |limits: Limits, is_stopped: bool| {
        let stop = StopToken::default();
        let session = Session::new(limits).stopped_by(stop.clone());
        let report = session.run("a.geo", script, &NoFiles, &[]);
        let Some(Event::File(file)) = report.events.first() else { return None };
        if is_stopped {
            stop.stop();
        }
        file.write(&mut Vec::new()).err().map(|found| (found.code, found.ceiling))
    };
    assert_eq!(written(Limits::DEFAULT, false), None);
    assert_eq!(written(Limits::DEFAULT, true), Some((Code::Stopped, None)));
    let few = Limits { steps: 500, ..Limits::DEFAULT };
    assert_eq!(written(few, false), Some((Code::TooLarge, Some(Ceiling::STEPS))));
}

#[test]
fn copying_comparing_and_adding_up_counts_as_work() {
    // Each takes a few thousand steps of evaluation, and a million parts or more that are passed.
    let scripts = [
        "print len(fold(1..2_000, [], (items, x) => [x, ...items]))",
        "print len(fold(1..2_000, \"\", (text, x) => \"{text}0123456789abcdef0123456789abcdef\"))",
        "let xs = [for i in 1..2_000: i]\nprint len([for i in 1..1_000: reverse(xs)])",
        "let xs = [for i in 1..2_000: i]\nprint sum([for i in 1..1_000: sum(xs)])",
        "let xs = [for i in 1..2_000: i]\nprint len([for i in 1..1_000: xs == xs])",
        "let xs = [for i in 1..2_000: (i, i % 2)]\nprint len([for i in 1..400: polyline(xs)])",
    ];
    let few = Limits { steps: 40_000, ..Limits::DEFAULT };
    for script in scripts {
        let report = Session::new(few).run("a.geo", script.as_bytes(), &NoFiles, &[]);
        let found = report.diagnostics.first().map(|found| found.ceiling);
        assert_eq!(found, Some(Some(Ceiling::STEPS)), "{script}");
    }
}
