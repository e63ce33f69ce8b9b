//! Bounds of what a function of the script yields over an interval, from its compiled body.

use super::{
    compile::Compiler,
    node::{LaneDefinition, LaneNode, TruthNode},
};
use crate::{
    eval::{function::ScriptFunction, machine::Machine},
    kernel::Enclosure,
    value::{Bounded, Function, Value},
};

/// A function of one number whose bounds can be computed.
#[derive(Debug)]
struct BoundedFunction {
    body: LaneNode,
    n_variables: usize,
}

impl Bounded for BoundedFunction {
    fn over(&self, interval: [f64; 2]) -> Option<Enclosure> {
        let mut lanes = vec![None; self.n_variables];
        lanes[0] = Some(Enclosure::variable(interval));
        number(&self.body, &mut lanes)
    }
}

/// A function of the script as one whose bounds can be computed, if it consists of what tells them.
pub(in crate::eval) fn bounded(
    machine: &Machine<'_>,
    function: &Value,
) -> Option<Box<dyn Bounded>> {
    let Value::Function(Function::Closure(closure)) = function else { return None };
    let function = closure.as_any().downcast_ref::<ScriptFunction>()?;
    let (body, n_variables) = Compiler::bounds_of(machine, function)?;
    Some(Box::new(BoundedFunction { body, n_variables }))
}

fn number(node: &LaneNode, lanes: &mut [Option<Enclosure>]) -> Option<Enclosure> {
    match node {
        LaneNode::Constant(value) => Some(Enclosure::constant(*value)),
        LaneNode::Variable(variable) => lanes[*variable],
        LaneNode::Unary(row, inner) => Some((row.enclosure)(&number(inner, lanes)?)),
        LaneNode::Arithmetic(row, sides) => {
            let [left, right] = &**sides;
            (row.enclosure)(&number(left, lanes)?, &number(right, lanes)?)
        }
        LaneNode::Builtin(..) | LaneNode::OfVectors(..) | LaneNode::Coordinate(..) => None,
        LaneNode::Enclosed(enclosed, inner) => enclosed(&number(inner, lanes)?),
        LaneNode::Choose(condition, sides) => {
            let [yes, no] = &**sides;
            number(if truth(condition, lanes)? { yes } else { no }, lanes)
        }
        LaneNode::Let(definitions, value, _) => {
            define(definitions, lanes);
            number(value, lanes)
        }
    }
}

fn define(definitions: &[LaneDefinition], lanes: &mut [Option<Enclosure>]) {
    for definition in definitions {
        // Nothing tells bounds of points.
        if let LaneDefinition::Number(variable, node) = definition {
            lanes[*variable] = number(node, lanes);
        }
    }
}

/// A truth that is the same all over the interval.
fn truth(node: &TruthNode, lanes: &mut [Option<Enclosure>]) -> Option<bool> {
    match node {
        TruthNode::Constant(value) => Some(*value),
        TruthNode::Compare(row, sides) => {
            let [left, right] = [number(&sides[0], lanes)?, number(&sides[1], lanes)?];
            let [a, b] = [left.value(), right.value()];
            // Intervals apart compare as any of their numbers do.
            (a[1] < b[0] || b[1] < a[0]).then(|| (row.numbers)(a[0], b[0]))
        }
        TruthNode::Not(truth_of, inner) => truth(inner, lanes).map(truth_of),
        TruthNode::Logic { decided_by, sides } => {
            let first = truth(&sides[0], lanes)?;
            if first == *decided_by { Some(first) } else { truth(&sides[1], lanes) }
        }
        TruthNode::Let(definitions, value, _) => {
            define(definitions, lanes);
            truth(value, lanes)
        }
    }
}
