//! The machine, lanes and jets mean the same by every operator: the table, walked.

use std::sync::Arc;

use glam::DVec3;

use super::{OperandPlaces, binary, unary};
use crate::{
    diag::{Code, Result, Span},
    eval::{
        env::Env,
        globals::Globals,
        ir::{BinaryOp, Comprehension, Expr, ExprKind, Generator, UnaryOp},
        lanes::{BlockResult, Lanes},
        machine::Machine,
        operator::table::{BinaryMeaning, binary_meaning},
    },
    kernel::{Jet, Tolerance},
    limits::{
        Limits,
        work::{MemoryGauge, StopToken},
    },
    syntax::ast::Unit,
    value::{Dimension, List, NoFiles, Number, Range, Real, Value},
};

/// Elements of a list that is held as numbers, which lanes take.
const N_ELEMENTS: usize = 64;

const SPAN: Span = Span::new(0, 1);

const PLACES: OperandPlaces = OperandPlaces { whole: SPAN, left: SPAN, right: SPAN };

fn numbers() -> Vec<Value> {
    let known = [[0, 0], [6, 0], [0, 6], [12, 0], [0, 12], [6, -6]].map(Dimension::of_powers);
    let open = [Dimension::OPEN, Dimension::OPEN.times(Dimension::ANGLE).unwrap_or_default()];
    let values = [0.0, 1.0, -2.0, 2.5, 3.0, 0.5, 1e300];
    let number = |dim| values.map(|value| Value::Number(Number { value, dim }));
    known.into_iter().chain(open).flat_map(number).collect()
}

/// Values of every kind that an operator could be tried on.
fn values() -> Vec<Value> {
    let bare = Number::bare;
    let mut values = numbers();
    values.extend([
        Value::Point(DVec3::new(1.0, -2.0, 3.5)),
        Value::Point(DVec3::ZERO),
        Value::Bool(true),
        Value::Bool(false),
        Value::Text("a".into()),
        Value::Text("b".into()),
        Value::List(vec![Value::number(1.0), Value::number(2.0)].into()),
        Value::Range(Range { start: bare(0.0), end: bare(3.0), closed: true }),
        Value::None,
    ]);
    values
}

/// The same value with derivatives, where it can have some.
fn with_slope(value: &Value) -> Option<Value> {
    let jet = |value| Jet::variable(value, 2);
    match value {
        Value::Number(Number { value, dim }) => {
            Some(Value::Jet(Arc::new(Number { value: Real::Jet(jet(*value)), dim: *dim })))
        }
        Value::Point(point) => Some(Value::JetPoint(Arc::new(point.to_array().map(jet)))),
        _ => None,
    }
}

/// A result to the bit, or the kind of mistake.
fn bits_or_code(result: Result<Value>) -> std::result::Result<String, Code> {
    result.map(|value| format!("{:?}", value.looked_at())).map_err(|mistake| mistake.code)
}

/// Jets say what plain values say, unless there is no derivative.
#[track_caller]
fn check_jets(what: &str, plain: Result<Value>, jets: Result<Value>) {
    let (plain, jets) = (bits_or_code(plain), bits_or_code(jets));
    assert!(
        plain == jets || (plain.is_ok() && jets == Err(Code::NoDerivative)),
        "{what}: {plain:?}, with derivatives {jets:?}"
    );
}

fn expr(kind: ExprKind) -> Expr {
    Expr { kind, span: SPAN }
}

fn constant(value: &Value) -> Expr {
    expr(ExprKind::Constant(value.clone()))
}

/// One for true and zero for false, as lanes hold no truths.
fn as_number(truth: ExprKind) -> ExprKind {
    let [one, zero] = [1.0, 0.0].map(|value| constant(&Value::number(value)));
    ExprKind::If(Box::new([expr(truth), one, zero]))
}

/// Whether an expression comes to something true or false.
fn is_truth(kind: &ExprKind) -> bool {
    match kind {
        ExprKind::Unary(op, _) => *op == UnaryOp::Not,
        ExprKind::Binary(op, _) => {
            matches!(
                binary_meaning(*op),
                BinaryMeaning::Comparison(_) | BinaryMeaning::Logic { .. }
            )
        }
        _ => false,
    }
}

/// Runs what needs a machine.
fn with_machine<T>(f: impl FnOnce(&mut Machine<'_>) -> T) -> T {
    let (limits, gauge, stop) = (Limits::default(), MemoryGauge::default(), StopToken::default());
    let env = Env {
        limits: &limits,
        n_threads: 1,
        files: &NoFiles,
        tolerance: Tolerance::default(),
        unit: Unit::Mm,
        registry: None,
        library: None,
        sources: None,
        gauge: &gauge,
        stop: &stop,
    };
    f(&mut Machine::new(env, Arc::new(Globals::default())))
}

/// A list of one value through an expression of its variable, in lanes.
fn in_lanes(machine: &Machine<'_>, kind: ExprKind, element: &Value) -> Option<Value> {
    let kind = if is_truth(&kind) { as_number(kind) } else { kind };
    let source: List = vec![element.clone(); N_ELEMENTS].into();
    let source = Value::List(source);
    let comprehension = Comprehension {
        generators: vec![Generator {
            slot: 0,
            source: constant(&source),
            parts: Vec::new(),
            condition: None,
        }],
        body: expr(kind),
    };
    let lanes = Lanes::of(machine, &comprehension, &comprehension.generators[0], &source)?;
    let (BlockResult::Numbers(values, dim), _) = lanes.run(&(0..N_ELEMENTS))? else { return None };
    Some(Value::Number(Number { value: *values.last()?, dim }))
}

/// Lanes say what the machine says, or leave it to the machine: always where that refuses, and
/// otherwise where `may_leave`.
#[track_caller]
fn check_lanes(what: &str, machine: Result<Value>, lanes: Option<Value>, may_leave: bool) {
    let machine = machine.ok().map(|value| match value {
        Value::Bool(truth) => Value::number(if truth { 1.0 } else { 0.0 }),
        other => other,
    });
    match (&machine, &lanes) {
        (Some(a), Some(b)) => assert_eq!(format!("{a:?}"), format!("{b:?}"), "{what} in lanes"),
        (Some(a), None) => assert!(may_leave, "{what} is {a:?}, but lanes leave it"),
        (None, _) => assert!(lanes.is_none(), "{what} is refused, but not in lanes"),
    }
}

fn pairs(values: &[Value]) -> impl Iterator<Item = (&Value, &Value)> {
    values.iter().flat_map(move |a| values.iter().map(move |b| (a, b)))
}

fn operators() -> impl Iterator<Item = (BinaryOp, BinaryMeaning)> {
    BinaryOp::ALL.iter().map(|&op| (op, binary_meaning(op)))
}

#[test]
fn jets_mean_what_plain_values_mean_by_every_operator() {
    let values = values();
    let carried = |value: &Value| with_slope(value).unwrap_or_else(|| value.clone());
    for (op, meaning) in operators() {
        if matches!(meaning, BinaryMeaning::Logic { .. }) {
            continue;
        }
        let of = |a: &Value, b: &Value| binary(op, a, b, PLACES, Tolerance::default());
        for (a, b) in pairs(&values) {
            let what = format!("{a:?} {} {b:?}", op.symbol());
            for (x, y) in [(&carried(a), b), (a, &carried(b)), (&carried(a), &carried(b))] {
                check_jets(&what, of(a, b), of(x, y));
            }
        }
    }
    for &op in UnaryOp::ALL {
        for value in &values {
            let what = format!("{} {value:?}", op.symbol());
            check_jets(&what, unary(op, value, SPAN), unary(op, &carried(value), SPAN));
        }
    }
}

#[test]
fn lanes_mean_what_the_machine_means_by_every_operator_on_numbers() {
    let numbers = numbers();
    with_machine(|machine| {
        for (op, meaning) in operators() {
            let of = |sides: [Expr; 2]| ExprKind::Binary(op, Box::new(sides));
            let variable = || expr(ExprKind::Local(0));
            for (a, b) in pairs(&numbers) {
                let what = format!("{a:?} {} {b:?}", op.symbol());
                let mut says = || machine.run(&expr(of([constant(a), constant(b)])), 1);
                let (first, second) = (says(), says());
                // The machine alone knows nearness and ranges, and powers of units that differ.
                let is_left = matches!(meaning, BinaryMeaning::Near | BinaryMeaning::Range { .. });
                let is_unit = matches!(a, Value::Number(number) if !number.dim.is_none());
                let left = in_lanes(machine, of([variable(), constant(b)]), a);
                check_lanes(&what, first, left, is_left);
                let right = in_lanes(machine, of([constant(a), variable()]), b);
                check_lanes(&what, second, right, is_left || (is_unit && op == BinaryOp::Power));
            }
        }
        for number in &numbers {
            let of = |operand| ExprKind::Unary(UnaryOp::Negate, Box::new(operand));
            let says = machine.run(&expr(of(constant(number))), 1);
            let lanes = in_lanes(machine, of(expr(ExprKind::Local(0))), number);
            check_lanes(&format!("-{number:?}"), says, lanes, false);
        }
    });
}

#[test]
fn lanes_mean_what_the_machine_means_by_operators_on_truths() {
    let truths = [Value::Bool(false), Value::Bool(true)];
    let any = Value::number(0.0);
    with_machine(|machine| {
        for op in [BinaryOp::And, BinaryOp::Or] {
            for (a, b) in pairs(&truths) {
                let of = || ExprKind::Binary(op, Box::new([constant(a), constant(b)]));
                let says = machine.run(&expr(of()), 1);
                let what = format!("{a:?} {} {b:?}", op.symbol());
                check_lanes(&what, says, in_lanes(machine, of(), &any), false);
            }
        }
        for truth in &truths {
            let of = || ExprKind::Unary(UnaryOp::Not, Box::new(constant(truth)));
            let says = machine.run(&expr(of()), 1);
            check_lanes(&format!("not {truth:?}"), says, in_lanes(machine, of(), &any), false);
        }
    });
}

#[test]
fn a_point_is_scaled_by_nothing_that_holds_an_angle() {
    let point = Value::Point(DVec3::X);
    for number in numbers() {
        let Value::Number(Number { value, dim }) = &number else { continue };
        let holds_angle = dim.angle_power() != 0;
        let of = |op, a, b| bits_or_code(binary(op, a, b, PLACES, Tolerance::default()));
        let scaled =
            [of(BinaryOp::Multiply, &point, &number), of(BinaryOp::Multiply, &number, &point)];
        for result in scaled {
            assert_eq!(result.is_err(), holds_angle, "{number:?} scales to {result:?}");
        }
        let shrunk = of(BinaryOp::Divide, &point, &number);
        assert_eq!(shrunk.is_err(), holds_angle || *value == 0.0, "by {number:?}: {shrunk:?}");
    }
}
