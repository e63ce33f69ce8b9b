//! Points that are computed many at a time, or at once by built-in functions of plain vectors, are those of the machine
//! and of the operations themselves: the same bits, the same errors.

use proptest::{prelude::*, proptest, sample::select};
use virote::{ops, value::OnVectors};

use super::lanes::{agree, outcome, run};

/// Every operation on vectors that lanes know.
fn operations() -> Vec<(&'static str, OnVectors, Vec<&'static str>)> {
    let registry = ops::registry();
    let known = registry.iter().filter_map(|op| {
        Some((op.name, op.on_vectors?, op.params.iter().map(|param| param.name).collect()))
    });
    known.collect()
}

fn number() -> impl Strategy<Value = String> {
    select(vec!["p.x", "p.y", "p.z", "k", "near", "2", "0", "(p.x * p.y)", "(1 / p.z)", "1e300"])
        .prop_map(str::to_owned)
}

fn point() -> impl Strategy<Value = String> {
    let leaf = select(vec!["p", "p", "(1, -2, 0.5)", "(p.y, 3)", "(0, 0)", "(1e200, p.x, near)"])
        .prop_map(str::to_owned);
    leaf.prop_recursive(5, 30, 3, |inner| {
        prop_oneof![
            2 => (inner.clone(), select(vec!["+", "-"]), inner.clone())
                .prop_map(|(a, op, b)| format!("({a} {op} {b})")),
            2 => (inner.clone(), select(vec!["*", "/"]), number())
                .prop_map(|(a, op, x)| format!("({a} {op} {x})")),
            1 => (number(), inner.clone()).prop_map(|(x, a)| format!("({x} * {a})")),
            1 => inner.clone().prop_map(|a| format!("(-{a})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("cross({a}, {b})")),
            1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| format!("midpoint({a}, {b})")),
            1 => inner.clone().prop_map(|a| format!("unit_vector({a})")),
            1 => (number(), number()).prop_map(|(x, y)| format!("polar({x}, {y} * 1deg)")),
            1 => (inner.clone(), inner.clone())
                .prop_map(|(a, b)| format!("{{ let m = {a}; m + {b} * m.x }}")),
            1 => (inner.clone(), inner.clone(), inner.clone()).prop_map(|(a, b, c)| {
                format!("(dot({a}, {b}), norm({c}), distance({a}, {c}))")
            }),
            1 => (inner.clone(), inner)
                .prop_map(|(a, b)| format!("(angle_between({a}, {b}) / 1deg, 1, f({a}.x))")),
        ]
    })
}

proptest! {
    #[test]
    fn points_in_lanes_are_those_of_the_machine(expr in point()) {
        agree("p in [for n in 1..50: (n * 0.7 - 9, 3 - n, n^2 / 7)]", &expr);
    }

    #[test]
    fn numbers_of_points_in_lanes_are_those_of_the_machine(a in point(), b in point()) {
        let source = "p in [for n in 1..50: (n * 0.7 - 9, 3 - n, n^2 / 7)]";
        agree(source, &format!("dot({a}, {b}) + {a}.y"));
    }
}

/// With names they stand for, arguments go to the operation itself.
#[test]
fn functions_of_plain_vectors_are_the_operations() {
    let operations = operations();
    assert_eq!(operations.len(), 8);
    let vectors = [
        "(i / 3, 2 - i, i^2)",
        "(0.1 * i, -7)",
        "(3, 3, 3)",
        "(1e-200 * i, 1e-180, 0)",
        "(i - 7, 0)",
        "(1e200, i, 1e160)",
    ];
    for (name, function, params) in operations {
        let pairs = vectors.iter().flat_map(|a| vectors.iter().map(move |b| [*a, *b]));
        let args: Vec<[&str; 2]> = match function {
            OnVectors::OfLengthAndAngle(_) => vec![
                ["i / 7", "i * 1deg"],
                ["i * 1mm", "-30deg"],
                ["2", "i"],
                ["i * 1deg", "30deg"],
                ["1e308 * i", "0deg"],
            ],
            _ => pairs.collect(),
        };
        for args in args {
            let plain = args[..params.len()].join(", ");
            let named: Vec<String> =
                params.iter().zip(args).map(|(name, arg)| format!("{name} = {arg}")).collect();
            let by_position = outcome(&run(&format!("[for i in 1..40: {name}({plain})]")));
            let by_name = outcome(&run(&format!("[for i in 1..40: {name}({})]", named.join(", "))));
            assert_eq!(by_position.0, by_name.0, "{name}({plain})");
            assert_eq!(by_position.1.is_empty(), by_name.1.is_empty(), "{name}({plain})");
            agree("i in 1..40", &format!("{name}({plain})"));
        }
    }
}

#[test]
fn points_of_a_list_are_taken_together_as_far_as_they_are_points() {
    agree("p in [...[for i in 1..2000: (i, 0)], (0, 0)]", "unit_vector(p)");
    agree("p in [...[for i in 1..2000: (i, 0)], 3]", "p * 2");
    agree("p in [for i in 1..2000: (i, i % 7)] if p.y < 3", "p - (0, 3)");
    agree("p in [for i in 1..2000: (i, i % 7)]", "p.w");
    agree("p in [for i in 1..2000: (i, i % 7)]", "p * p");
    agree("p in [for i in 1..2000: (i, i % 7)]", "p * 30deg");
    agree("p in [for i in 1..2000: (i, i % 7)]", "p + 1");
    agree("p in [for i in 1..2000: (i, i % 7)]", "p / p.y");
    agree("p in [for i in 1..2000: (i, i % 7)]", "norm(p, p)");
    agree("p in [for i in 1..2000: (i, i % 7)]", "norm(p.x)");
}
