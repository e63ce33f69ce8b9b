//! Comprehensions that are computed many elements at a time say what the machine says element by
//! element: the same bits, the same errors.

use proptest::{prelude::*, proptest, sample::select};
use virote::{
    diag::Diagnostic,
    ops,
    session::{Event, Report, Session},
    value::{NoFiles, OnNumbers},
};

const DEFINITIONS: &str = "let k = 7\nlet near = 3mm\nfn f(x) = x * 0.5 - k\nfn g(x, y) = if x < y then f(y) else x / (y - 3)\n";

/// Every operation on numbers that lanes know, with how many arguments it takes.
fn operations() -> Vec<(&'static str, usize)> {
    let n_args: fn(OnNumbers) -> &'static [usize] = |function| match function {
        OnNumbers::One(..) | OnNumbers::OfAngle(_) => &[1],
        OnNumbers::OneOrTwo { .. } => &[1, 2],
        OnNumbers::Two(..) => &[2],
        OnNumbers::Fold(..) | OnNumbers::Three(..) => &[3],
    };
    let registry = ops::registry();
    let known = registry.iter().filter_map(|op| Some((op.name, n_args(op.on_numbers?))));
    known.flat_map(|(name, counts)| counts.iter().map(move |&n| (name, n))).collect()
}

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
            2 => (select(operations()), inner.clone(), inner.clone(), inner.clone()).prop_map(
                |((name, n), a, b, c)| format!("{name}({})", [a, b, c][..n].join(", "))
            ),
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

pub(super) fn run(comprehension: &str) -> Report {
    let script = format!("{DEFINITIONS}print {comprehension}");
    Session::default().run("law", script.as_bytes(), &NoFiles, &[])
}

/// What was printed, and all that was found, by code, text and place.
pub(super) fn outcome(report: &Report) -> (Option<String>, Vec<String>) {
    let printed = match report.events.first() {
        Some(Event::Printed(line)) => Some(line.value.to_string()),
        _ => None,
    };
    let found = report.diagnostics.iter();
    let told = |found: &Diagnostic| {
        format!("{:?} {} at {:?}", found.code, found.message, found.primary.span)
    };
    (printed, found.map(told).collect())
}

/// As numbers in lanes, and as lists of one number, which the machine makes one by one; written
/// so that everything stands at the same place.
pub(super) fn agree(source: &str, expr: &str) {
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

#[test]
fn built_in_functions_are_those_of_the_machine() {
    let operations = operations();
    assert!(20 < operations.len());
    for (name, n) in operations {
        for args in [
            ["i / 7 - 3", "2 - i", "3 + i"],
            ["(i - 40) * 1deg", "30deg", "i * 1rad"],
            ["i * 1mm", "i * i * 0.1mm", "50mm"],
            ["(i * 1mm)^2", "2", "(3mm)^2"],
            ["(i, i^2).y / 90", "(1 / i, 2).y", "i"],
            ["i * 100", "0", "-0.0"],
            ["30", "i", "45"],
            ["-45", "-i", "near"],
            ["k * 15", "(30deg)", "30"],
        ] {
            agree("i in 1..90", &format!("{name}({})", args[..n].join(", ")));
        }
    }
    agree("i in 0..99", "sin(i * 1rad) + max(i, 3) * sqrt(abs(i - 50)) - round(i / 3, 2)");
    agree(
        "i in 0..99 if floor(i / 2) % 3 == 1",
        "atan2(i, 5) / 1deg + (if sign(i - 7) > 0 then ln(i) else 0)",
    );
    agree("i in 0..2000", "(cos(i * 3deg), sin(i * 3deg), clamp(i, 5, 1000))");
    agree("i in 0..99", "sqrt(50 - i)");
    agree("i in 0..99", "exp(10 * i)");
}
