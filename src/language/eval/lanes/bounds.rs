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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::eval::{
        ir::BinaryOp,
        operator::table::{BinaryMeaning, binary_meaning},
    };

    /// Whether x is less than a number.
    fn less(than: f64) -> TruthNode {
        let BinaryMeaning::Comparison(row) = binary_meaning(BinaryOp::Less) else {
            unreachable!("`<` compares")
        };
        TruthNode::Compare(row, Box::new([LaneNode::Variable(0), LaneNode::Constant(than)]))
    }

    /// What is known of a truth about x over 1..2.
    fn over_one_to_two(node: &TruthNode) -> Option<bool> {
        truth(node, &mut [Some(Enclosure::variable([1.0, 2.0]))])
    }

    #[test]
    fn a_comparison_is_known_where_the_intervals_are_apart() {
        for (than, expected) in
            [(2.5, Some(true)), (0.5, Some(false)), (1.5, None), (2.0, None), (1.0, None)]
        {
            assert_eq!(over_one_to_two(&less(than)), expected, "x < {than}");
            let not = TruthNode::Not(|truth| !truth, Box::new(less(than)));
            assert_eq!(over_one_to_two(&not), expected.map(|truth| !truth), "not x < {than}");
        }
    }

    #[test]
    fn a_side_that_decides_hides_one_that_is_not_known() {
        let both = |decided_by: bool, first: f64, second: f64| {
            over_one_to_two(&TruthNode::Logic {
                decided_by,
                sides: Box::new([less(first), less(second)]),
            })
        };
        assert_eq!(both(false, 0.5, 1.5), Some(false));
        assert_eq!(both(true, 2.5, 1.5), Some(true));
        assert_eq!(both(false, 2.5, 1.5), None);
        assert_eq!(both(true, 0.5, 1.5), None);
        assert_eq!(both(false, 2.5, 0.5), Some(false));
        assert_eq!(both(true, 0.5, 2.5), Some(true));
    }

    #[test]
    fn a_choice_has_the_bounds_of_the_side_that_is_taken_all_over_the_interval() {
        let chosen = |than: f64| {
            let sides = Box::new([LaneNode::Variable(0), LaneNode::Constant(7.0)]);
            let node = LaneNode::Choose(Box::new(less(than)), sides);
            let mut lanes = [Some(Enclosure::variable([1.0, 2.0]))];
            number(&node, &mut lanes).map(|found| (found.value(), found.slope()))
        };
        assert_eq!(chosen(2.5), Some(([1.0, 2.0], [1.0, 1.0])));
        assert_eq!(chosen(0.5), Some(([7.0, 7.0], [0.0, 0.0])));
        assert_eq!(chosen(1.5), None);
    }
}
