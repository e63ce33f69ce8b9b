//! Numbers with units: what sums, products, powers and comparisons of them are, and what they
//! refuse.

use virote::{
    session::{Report, Session},
    value::{Dimension, NoFiles, Number, Value},
};

const BARE: [i8; 2] = [0, 0];
const LENGTH: [i8; 2] = [6, 0];
const AREA: [i8; 2] = [12, 0];
const VOLUME: [i8; 2] = [18, 0];
const ANGLE: [i8; 2] = [0, 6];

fn run(expr: &str) -> Report {
    let script = format!("let result = {expr}");
    Session::default().run("quantities.geo", script.as_bytes(), &NoFiles, &[])
}

/// The value of an expression, which is no error.
#[track_caller]
fn value(expr: &str) -> Value {
    let report = run(expr);
    assert!(report.diagnostics.is_empty(), "{expr}: {:?}", report.diagnostics);
    report.definitions[0].value.clone().expect("a value")
}

#[track_caller]
fn truth(expr: &str) -> bool {
    match value(expr) {
        Value::Bool(truth) => truth,
        other => unreachable!("{expr} is {other:?}"),
    }
}

#[track_caller]
fn number(expr: &str) -> Number {
    match value(expr) {
        Value::Number(number) => number,
        other => unreachable!("{expr} is {other:?}"),
    }
}

/// Each expression is that number, with these powers of length and angle in sixths.
#[track_caller]
fn numbers(expected: &[(&str, f64, [i8; 2])]) {
    for &(expr, expected, powers) in expected {
        let expected = Number { value: expected, dim: Dimension::of_powers(powers) };
        assert_eq!(number(expr), expected, "{expr}");
    }
}

/// Each expression is refused with that code.
#[track_caller]
fn refused(expected: &[(&str, &str)]) {
    for &(expr, code) in expected {
        let codes: Vec<_> = run(expr).diagnostics.iter().map(|found| found.code.id()).collect();
        assert_eq!(codes, [code], "{expr}");
    }
}

/// Comparisons of the two, smaller first, as the language and mathematics know them.
#[track_caller]
fn ordered(small: &str, large: &str) {
    for (a, b, [less, same, greater]) in [
        (small, large, [true, false, false]),
        (small, small, [false, true, false]),
        (large, large, [false, true, false]),
        (large, small, [false, false, true]),
    ] {
        for (op, expected) in [
            ("<", less),
            ("<=", less || same),
            ("==", same),
            ("!=", !same),
            (">=", same || greater),
            (">", greater),
        ] {
            assert_eq!(truth(&format!("{a} {op} {b}")), expected, "{a} {op} {b}");
        }
    }
}

#[test]
fn order_tells_equal_from_less() {
    ordered("2", "3");
    ordered("-3", "-2");
    ordered("2mm", "3mm");
    ordered("9mm", "1cm");
    ordered("90deg", "2rad");
    ordered("(2mm * 2mm)", "(3mm * 2mm)");
    // A number without a unit counts as document units.
    assert_eq!(["2mm <= 2", "2 >= 2mm", "2mm < 3", "2mm == 2"].map(truth), [true; 4]);
    assert_eq!(["2mm < 2", "2 > 2mm", "2mm != 2"].map(truth), [false; 3]);
    // Texts by their letters; equality is of any kind.
    for (expr, expected) in [
        ("\"a\" < \"b\"", true),
        ("\"b\" <= \"b\"", true),
        ("\"b\" >= \"b\"", true),
        ("\"b\" > \"b\"", false),
        ("\"b\" < \"b\"", false),
        ("\"b\" > \"a\"", true),
    ] {
        assert_eq!(truth(expr), expected, "{expr}");
    }
}

/// What is compared while it is differentiated has no other order.
#[test]
fn order_is_the_same_where_derivatives_are_carried() {
    for (op, slope) in [("<", 3.0), ("<=", 2.0), (">", 2.0), (">=", 3.0)] {
        let (then, other) = if op.starts_with('<') { (2, 3) } else { (3, 2) };
        let expr = format!(
            "derivative(parametric(t => (if t {op} 0.5 then {then}*t else {other}*t, 0), 0..1), 0.5).x"
        );
        assert_eq!(number(&expr), Number::open(slope), "{expr}");
    }
}

#[test]
fn sums_keep_the_unit_of_either_side() {
    numbers(&[
        ("5mm + 3", 8.0, LENGTH),
        ("3 + 5mm", 8.0, LENGTH),
        ("5mm - 3", 2.0, LENGTH),
        ("3 - 5mm", -2.0, LENGTH),
        ("5mm % 3", 2.0, LENGTH),
        ("5 % 3mm", 2.0, LENGTH),
        ("-5mm % 3mm", 1.0, LENGTH),
        ("5mm % -3mm", -1.0, LENGTH),
        ("-6mm % 3mm", 0.0, LENGTH),
        ("5mm + 1cm", 15.0, LENGTH),
        ("2mm * 3mm + 1", 7.0, AREA),
        ("-(2mm)", -2.0, LENGTH),
        ("5 + 3", 8.0, BARE),
        ("sum([1mm, 2, 3])", 6.0, LENGTH),
        ("max([1, 2mm])", 2.0, LENGTH),
    ]);
    refused(&[
        ("1rad + 1", "E0303"),
        ("1 - 1rad", "E0303"),
        ("1 % 1rad", "E0303"),
        ("sum([1, 1rad])", "E0303"),
        ("5mm + 3deg", "E0303"),
        ("3deg - 5mm", "E0303"),
        ("5mm % 3deg", "E0303"),
        ("2mm * 3mm + 1mm", "E0303"),
        ("5mm < 3deg", "E0303"),
        ("5mm == 3deg", "E0303"),
        ("5mm != 3mm * 1mm", "E0303"),
        ("[5mm] == [3deg]", "E0303"),
        ("5mm..3deg", "E0303"),
    ]);
}

#[test]
fn products_add_powers_and_quotients_take_them_away() {
    numbers(&[
        ("2mm * 3mm", 6.0, AREA),
        ("2 * 3mm", 6.0, LENGTH),
        ("6mm / 2mm", 3.0, BARE),
        ("6mm / 2", 3.0, LENGTH),
        ("6 / 2mm", 3.0, [-6, 0]),
        ("6mm / 2rad", 3.0, [6, -6]),
        ("3mm * 2rad", 6.0, [6, 6]),
        ("2rad * 3rad / 1rad", 6.0, ANGLE),
        // Powers reach 127 sixths.
        ("1mm^21", 1.0, [126, 0]),
        ("1mm^-21", 1.0, [-126, 0]),
    ]);
    refused(&[
        ("1mm^21 * 1mm", "E0303"),
        ("1rad^21 * 1rad", "E0303"),
        ("1mm^-21 / 1mm", "E0303"),
        ("1rad^-21 / 1rad", "E0303"),
        ("1mm^22", "E0303"),
        ("1mm / 0", "E0501"),
        ("1mm % 0mm", "E0501"),
    ]);
}

#[test]
fn powers_and_roots_of_quantities() {
    numbers(&[
        ("(2mm)^3", 8.0, VOLUME),
        ("(2mm)^0", 1.0, BARE),
        ("(2mm)^-1", 0.5, [-6, 0]),
        ("(4mm)^0.5", 2.0, [3, 0]),
        ("(3rad)^2", 9.0, [0, 12]),
        ("sqrt(9mm * 4mm)", 6.0, LENGTH),
        ("sqrt(4mm)", 2.0, [3, 0]),
        ("sqrt(4rad * 1rad)", 2.0, ANGLE),
        ("cbrt(27mm * 1mm * 1mm)", 3.0, LENGTH),
        ("cbrt(8mm)", 2.0, [2, 0]),
        ("cbrt(8 / 1mm)", 2.0, [-2, 0]),
        ("cbrt(8rad)", 2.0, [0, 2]),
        ("cbrt(-8mm * 1mm * 1mm)", -2.0, LENGTH),
        ("cbrt(sqrt(64mm))", 2.0, [1, 0]),
        ("cbrt(8)", 2.0, BARE),
    ]);
    refused(&[
        // A sixth of a power is the least there is.
        ("cbrt(cbrt(8mm))", "E0502"),
        ("cbrt(cbrt(8rad))", "E0502"),
        ("sqrt(sqrt(sqrt(4mm)))", "E0502"),
        ("(2mm)^0.3", "E0303"),
        ("2^2mm", "E0303"),
        ("0^-1", "E0501"),
        ("(-8)^0.5", "E0502"),
    ]);
}

#[test]
fn points_are_scaled_by_anything_but_an_angle() {
    let point = |x: f64, y: f64, z: f64| glam::DVec3::new(x, y, z);
    for (expr, expected) in [
        ("(1, 2, 3) * 2", point(2.0, 4.0, 6.0)),
        ("2 * (1, 2, 3)", point(2.0, 4.0, 6.0)),
        ("(1, 2, 3) * 2mm", point(2.0, 4.0, 6.0)),
        ("2mm * (1, 2, 3)", point(2.0, 4.0, 6.0)),
        ("(2, 4, 6) / 2", point(1.0, 2.0, 3.0)),
        ("(2, 4, 6) / 2mm", point(1.0, 2.0, 3.0)),
        ("(2, 4, 6) + (1, 1, 1)", point(3.0, 5.0, 7.0)),
        ("(2, 4, 6) - (1, 1, 1)", point(1.0, 3.0, 5.0)),
        ("-(2, 4, 6)", point(-2.0, -4.0, -6.0)),
    ] {
        let Value::Point(found) = value(expr) else { unreachable!("{expr} is no point") };
        assert_eq!(found, expected, "{expr}");
    }
    refused(&[
        ("(1, 2, 3) * 30deg", "E0303"),
        ("30deg * (1, 2, 3)", "E0303"),
        ("(1, 2, 3) / 30deg", "E0303"),
        ("(1, 2, 3) / 0", "E0501"),
        ("(1, 2, 3) + 1", "E0301"),
        ("(1, 2, 3) * (1, 2, 3)", "E0301"),
        ("1 / (1, 2, 3)", "E0301"),
    ]);
}

/// Up to 2⁵³ every whole number is a double; beyond, neighbours fall together.
#[test]
fn integers_end_where_neighbours_fall_together() {
    for seed in ["9007199254740992", "-9007199254740992", "0", "-1", "2^53"] {
        assert_eq!(number(&format!("len(random(3, seed = {seed}))")), Number::bare(3.0), "{seed}");
    }
    numbers(&[
        ("len(9007199254740990..9007199254740992)", 3.0, BARE),
        ("len(9007199254740990..<9007199254740992)", 2.0, BARE),
        ("len(-9007199254740992..-9007199254740990)", 3.0, BARE),
        ("[for i in 9007199254740990..9007199254740992: i][-1]", 9_007_199_254_740_992.0, BARE),
        ("len(3..<3)", 0.0, BARE),
        ("len(3..2)", 0.0, BARE),
        ("len(3..1)", 0.0, BARE),
    ]);
    refused(&[
        ("random(3, seed = 9007199254740994)", "E0301"),
        ("random(3, seed = -9007199254740994)", "E0301"),
        ("random(3, seed = 2^64)", "E0301"),
        ("random(3, seed = 0.5)", "E0301"),
        ("random(3, seed = 1mm)", "E0301"),
        ("random(-1)", "E0301"),
        ("[for i in 0..9007199254740994: i]", "E0301"),
        ("[1, 2][9007199254740994]", "E0301"),
    ]);
}

/// What is exactly as far apart as the tolerance is near.
#[test]
fn nearness_counts_its_limit() {
    for (expr, expected) in [
        ("1 ~= 2 within 1", true),
        ("1 ~= 2 within 0.5", false),
        ("2mm ~= 3 within 1mm", true),
        ("(0, 0) ~= (3, 4) within 5", true),
        ("(0, 0) ~= (3, 4) within 4.5", false),
        ("[1, [2]] ~= [1, [3]] within 1", true),
        ("[1, 2] ~= [1] within 9", false),
    ] {
        assert_eq!(truth(expr), expected, "{expr}");
    }
    refused(&[
        ("1mm ~= 1deg within 9", "E0303"),
        ("[1, 1mm] ~= [1, 1deg] within 1e-9", "E0301"),
        ("30deg ~= 60deg within 1", "E0303"),
        ("[30deg] ~= [60deg] within 1mm", "E0303"),
    ]);
}
