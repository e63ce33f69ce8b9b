//! Comprehensions that are computed many elements at a time say what the machine says element by
//! element: the same bits, the same errors.

use proptest::{prelude::*, proptest, sample::select};
use virote::{
    session::{Event, Report, Session},
    value::NoFiles,
};

const DEFINITIONS: &str = "let k = 7\nlet near = 3mm\nfn f(x) = x * 0.5 - k\nfn g(x, y) = if x < y then f(y) else x / (y - 3)\n";

fn number() -> impl Strategy<Value = String> {
    let leaf = select(vec!["i", "i", "i", "k", "near", "0", "3", "0.1", "1e308", "2mm", "30deg"])
        .prop_map(str::to_owned);
    leaf.prop_recursive(5, 40, 3, |inner| {
        let operator = select(vec!["+", "-", "*", "/", "%", "^"]);
        let condition =
            (inner.clone(), select(vec!["<", "<=", ">", ">=", "==", "!="]), inner.clone())
                .prop_map(|(a, op, b)| format!("({a} {op} {b})"));
        let conditions =
            (condition.clone(), select(vec!["and", "or", "and not"]), condition.clone())
                .prop_map(|(a, op, b)| format!("({a} {op} {b})"));
        let condition = prop_oneof![condition, conditions];
        prop_oneof![
            4 => (inner.clone(), operator, inner.clone())
                .prop_map(|(a, op, b)| format!("({a} {op} {b})")),
            1 => inner.clone().prop_map(|a| format!("(-{a})")),
            1 => inner.clone().prop_map(|a| format!("f({a})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("g({a}, {b})")),
            1 => (inner.clone(), inner.clone())
                .prop_map(|(a, b)| format!("{{ let m = {a}; m * m + {b} }}")),
            2 => (condition, inner.clone(), inner)
                .prop_map(|(c, a, b)| format!("(if {c} then {a} else {b})")),
        ]
    })
}

fn run(comprehension: &str) -> Report {
    let script = format!("{DEFINITIONS}print {comprehension}");
    Session::default().run("law", script.as_bytes(), &NoFiles, &[])
}

/// What was printed, or the errors by code, text and place.
fn outcome(report: &Report) -> Result<String, Vec<String>> {
    match report.events.first() {
        Some(Event::Printed(line)) => Ok(line.value.to_string()),
        _ => Err(report
            .diagnostics
            .iter()
            .map(|found| format!("{:?} {} at {:?}", found.code, found.message, found.primary.span))
            .collect()),
    }
}

/// As numbers in lanes, and as lists of one number, which the machine makes one by one; written
/// so that everything stands at the same place.
fn agree(source: &str, expr: &str) {
    let lanes = run(&format!("flatten([[for {source}:  {expr} ]])"));
    let one_by_one = run(&format!("flatten([ for {source}: [{expr}]])"));
    assert_eq!(outcome(&lanes), outcome(&one_by_one), "[for {source}: {expr}]");
}

proptest! {
    #[test]
    fn lanes_say_what_the_machine_says(expr in number()) {
        agree("i in -20..79", &expr);
    }

    #[test]
    fn lanes_filter_as_the_machine_does(expr in number(), condition in number()) {
        agree(&format!("i in 0..99 if {condition} < 10"), &expr);
    }

    #[test]
    fn lanes_run_through_numbers_with_units(expr in number()) {
        agree("i in [for n in 1..50: n * 2mm]", &expr);
    }
}

/// More elements than a block has, and two generators.
#[test]
fn lanes_go_on_from_block_to_block() {
    agree("i in 0..5000", "(if i == 3000 then 0 else 1 / (i - 3000))");
    agree("j in 0..3, i in 0..1500 if i % 2 == j", "i * j - k");
    agree("i in 0..5000", "1 / (i - 3000)");
    agree("i in 0..5000", "1e308 * (i - 2000)");
}

#[test]
fn points_are_made_in_lanes() {
    agree("i in 0..2000", "(i, i^2, -i / 3)");
    agree("i in 0..2000", "(i, 1 / (i - 1999))");
    agree("i in 0..2000", "(i * 1deg, 0)");
}
