//! Compiles expressions of numbers and points to lanes; `None` wherever the machine is needed.

use super::node::{LaneBody, LaneDefinition, LaneNode, PointNode, TruthNode};
use crate::{
    eval::{
        function::ScriptFunction,
        ir::{Arg, BinaryOp, Block, CallExpr, Expr, ExprKind},
        machine::Machine,
        operator::table::{BinaryMeaning, UnaryMeaning, binary_meaning, unary_meaning},
    },
    value::{Dimension, Function, Number, OnNumbers, Op, Value},
};

/// Expressions inside one another, calls included; also what keeps recursion from being compiled.
const MOST_NESTED: usize = 64;

/// Calls inside one another.
const MOST_CALLS: usize = 6;

/// What is known of an expression before any element is.
#[derive(Clone, Debug)]
pub(super) enum LaneInput {
    /// A value that is the same for all elements.
    Value(Value),
    /// A lane of numbers.
    Lane(usize, Dimension),
    /// Three lanes of coordinates.
    Point([usize; 3]),
}

/// A compiled expression.
pub(super) enum Compiled {
    LaneInput(LaneInput),
    Number(LaneNode, Dimension),
    TruthNode(TruthNode),
    Point(PointNode),
}

/// A frame of the machine as far as it differs from the one on its stack.
pub(super) struct LaneFrame<'f> {
    /// `None` for the frame in which the comprehension stands.
    function: Option<&'f ScriptFunction>,
    slots: Vec<(usize, LaneInput)>,
}

pub(super) struct Compiler<'m> {
    machine: &'m Machine<'m>,
    slots: Vec<(usize, LaneInput)>,
    n_variables: usize,
    n_nested: usize,
    n_calls: usize,
    /// Whether bounds are wanted alone: then built-ins that tell bounds are taken, and dimensions, which
    /// change no bounds, are not looked at.
    pub(super) is_for_bounds: bool,
}

impl<'m> Compiler<'m> {
    /// The body of a function of one number, whose parameter is lane 0, for its bounds.
    pub(super) fn bounds_of(
        machine: &'m Machine<'_>,
        function: &ScriptFunction,
    ) -> Option<(LaneNode, usize)> {
        let lambda = function.lambda();
        if lambda.parameters.len() != 1 {
            return None;
        }
        let (slots, n_variables) = (Vec::new(), 1);
        let mut compiler =
            Self { machine, slots, n_variables, n_nested: 0, n_calls: 0, is_for_bounds: true };
        let slots = vec![(0, LaneInput::Lane(0, Dimension::NONE))];
        let mut frame = LaneFrame { function: Some(function), slots };
        let (node, _) = compiler.expr(&lambda.body, &mut frame)?.number()?;
        Some((node, compiler.n_variables))
    }

    /// A compiler in the running frame, whose slot `variable` has the first lanes.
    pub(super) fn new(machine: &'m Machine<'_>, variable: usize, known: LaneInput) -> Self {
        let n_variables = if matches!(known, LaneInput::Point(_)) { 3 } else { 1 };
        let slots = vec![(variable, known)];
        Self { machine, slots, n_variables, n_nested: 0, n_calls: 0, is_for_bounds: false }
    }

    pub(super) fn n_variables(&self) -> usize {
        self.n_variables
    }

    pub(super) fn condition(&mut self, expr: &Expr) -> Option<TruthNode> {
        let mut frame = LaneFrame { function: None, slots: self.slots.clone() };
        self.expr(expr, &mut frame)?.truth()
    }

    pub(super) fn body(&mut self, expr: &Expr) -> Option<LaneBody> {
        let mut frame = LaneFrame { function: None, slots: self.slots.clone() };
        let compiled = self.expr(expr, &mut frame)?;
        if compiled.is_point() {
            return Some(LaneBody::Point(compiled.point()?));
        }
        let (node, dim) = compiled.number()?;
        Some(LaneBody::Number(node, dim))
    }

    pub(super) fn expr(&mut self, expr: &Expr, frame: &mut LaneFrame<'_>) -> Option<Compiled> {
        self.n_nested += 1;
        let most = MOST_NESTED.min(self.machine.depth_left());
        let compiled = if self.n_nested <= most { self.dispatch(expr, frame) } else { None };
        self.n_nested -= 1;
        compiled
    }

    fn dispatch(&mut self, expr: &Expr, frame: &mut LaneFrame<'_>) -> Option<Compiled> {
        let known = |value: Value| Some(Compiled::LaneInput(LaneInput::Value(value)));
        match &expr.kind {
            ExprKind::Constant(value) => known(value.clone()),
            ExprKind::Local(slot) => self.local(*slot, frame),
            ExprKind::Captured(idx) => known(match frame.function {
                Some(function) => function.captures[*idx].clone(),
                None => self.machine.captured(*idx),
            }),
            ExprKind::Sibling(idx) => known(match frame.function {
                Some(function) => function.sibling(*idx),
                None => self.machine.sibling(*idx),
            }),
            ExprKind::Global(idx) => known(match frame.function {
                Some(function) => function.home.upgrade()?.known(*idx)?.clone(),
                None => self.machine.home.known(*idx)?.clone(),
            }),
            ExprKind::Unary(op, operand) => {
                let operand = self.expr(operand, frame)?;
                Some(match unary_meaning(*op) {
                    UnaryMeaning::Arithmetic(row) if operand.is_point() => {
                        Compiled::Point(PointNode::Unary(row, Box::new(operand.point()?)))
                    }
                    UnaryMeaning::Arithmetic(row) => {
                        let (node, dim) = operand.number()?;
                        Compiled::Number(LaneNode::Unary(row, Box::new(node)), dim)
                    }
                    UnaryMeaning::Logic(truth_of) => {
                        let truth = Box::new(operand.truth()?);
                        Compiled::TruthNode(TruthNode::Not(truth_of, truth))
                    }
                })
            }
            ExprKind::Binary(op, sides) => self.binary(*op, sides, frame),
            ExprKind::If(parts) => {
                let [condition, yes, no] = &**parts;
                let condition = self.expr(condition, frame)?.truth()?;
                let (yes, dim) = self.expr(yes, frame)?.number()?;
                let (no, other) = self.expr(no, frame)?.number()?;
                let choice = LaneNode::Choose(Box::new(condition), Box::new([yes, no]));
                (dim == other || self.is_for_bounds).then_some(Compiled::Number(choice, dim))
            }
            ExprKind::Block(block) => self.block(block, frame),
            ExprKind::Call(call) => self.call(call, frame),
            ExprKind::Point(coordinates) => self.coordinates(coordinates, frame),
            ExprKind::Field(subject, name, _) => self.expr(subject, frame)?.coordinate(name),
            _ => None,
        }
    }

    fn local(&self, slot: usize, frame: &LaneFrame<'_>) -> Option<Compiled> {
        let is_it = |(own, _): &&(usize, LaneInput)| *own == slot;
        let known = match (frame.slots.iter().rev().find(is_it), frame.function) {
            (Some((_, known)), _) => known.clone(),
            (None, None) => LaneInput::Value(self.machine.local(slot)),
            (None, Some(_)) => return None,
        };
        Some(Compiled::LaneInput(known))
    }

    fn binary(
        &mut self,
        op: BinaryOp,
        sides: &[Expr; 2],
        frame: &mut LaneFrame<'_>,
    ) -> Option<Compiled> {
        let (left, right) = (self.expr(&sides[0], frame)?, self.expr(&sides[1], frame)?);
        let meaning = binary_meaning(op);
        if let BinaryMeaning::Logic { decided_by } = meaning {
            let sides = Box::new([left.truth()?, right.truth()?]);
            return Some(Compiled::TruthNode(TruthNode::Logic { decided_by, sides }));
        }
        if left.is_point() || right.is_point() {
            return match meaning {
                BinaryMeaning::Arithmetic(row) => left.with_points(row, right),
                _ => None,
            };
        }
        let ((left, a), (right, b)) = (left.number()?, right.number()?);
        match meaning {
            BinaryMeaning::Comparison(row) => {
                if !self.is_for_bounds {
                    a.common(b)?;
                }
                Some(Compiled::TruthNode(TruthNode::Compare(row, Box::new([left, right]))))
            }
            BinaryMeaning::Arithmetic(row) => {
                let known = match right {
                    LaneNode::Constant(value) => Some(value),
                    _ => None,
                };
                let dim = match self.is_for_bounds {
                    true => Dimension::NONE,
                    false => (row.dimension)(a, b, known).ok()?,
                };
                Some(Compiled::Number(LaneNode::Arithmetic(row, Box::new([left, right])), dim))
            }
            BinaryMeaning::Near | BinaryMeaning::Range { .. } | BinaryMeaning::Logic { .. } => None,
        }
    }

    fn block(&mut self, block: &Block, frame: &mut LaneFrame<'_>) -> Option<Compiled> {
        let mut lanes = Vec::new();
        for (slot, expr) in &block.definitions {
            let compiled = self.expr(expr, frame)?;
            let known = self.named(compiled, &mut lanes)?;
            frame.slots.push((*slot, known));
        }
        let value = self.expr(&block.value, frame)?;
        value.after(lanes, 0)
    }

    /// What a name stands for; a computation gets a lane of its own.
    fn named(&mut self, compiled: Compiled, lanes: &mut Vec<LaneDefinition>) -> Option<LaneInput> {
        match compiled {
            Compiled::LaneInput(known) => Some(known),
            Compiled::Number(node, dim) => {
                lanes.push(LaneDefinition::Number(self.n_variables, node));
                self.n_variables += 1;
                Some(LaneInput::Lane(self.n_variables - 1, dim))
            }
            Compiled::Point(node) => {
                let variables = [0, 1, 2].map(|axis| self.n_variables + axis);
                lanes.push(LaneDefinition::Point(variables, node));
                self.n_variables += 3;
                Some(LaneInput::Point(variables))
            }
            Compiled::TruthNode(_) => None,
        }
    }

    /// A built-in function of numbers; where bounds are wanted, one of one number that tells them.
    fn builtin(
        &mut self,
        ops: &[&'static Op],
        call: &CallExpr,
        frame: &mut LaneFrame<'_>,
    ) -> Option<Compiled> {
        let &[op] = ops else { return None };
        if call.is_partial || call.args.iter().any(|arg| arg.label.is_some()) {
            return None;
        }
        if let Some(on_vectors) = op.on_vectors {
            return self.of_vectors(on_vectors, call, frame);
        }
        let mut nodes = Vec::with_capacity(call.args.len());
        let mut dims = Vec::with_capacity(call.args.len());
        for arg in &call.args {
            let (node, dim) = self.expr(arg.value.as_ref()?, frame)?.number()?;
            nodes.push(node);
            dims.push(dim);
        }
        if self.is_for_bounds {
            let (enclosed, [_]) = (op.enclosed?, &nodes[..]) else { return None };
            let node = Box::new(nodes.pop()?);
            return Some(Compiled::Number(LaneNode::Enclosed(enclosed, node), dims[0]));
        }
        let function = op.on_numbers?;
        let dim = function.dimension(&dims)?;
        let is_written = |arg: &Arg| arg.value.as_ref().is_some_and(is_written_number);
        if matches!(function, OnNumbers::OfAngle(_)) && call.args.iter().any(is_written) {
            return None;
        }
        let first = nodes.remove(0);
        Some(Compiled::Number(LaneNode::Builtin(function, Box::new((first, nodes))), dim))
    }

    /// The body of a function of the script in the place of its call.
    fn call(&mut self, call: &CallExpr, frame: &mut LaneFrame<'_>) -> Option<Compiled> {
        let closure = match self.expr(&call.callee, frame)? {
            Compiled::LaneInput(LaneInput::Value(Value::Function(Function::Closure(closure)))) => {
                closure
            }
            Compiled::LaneInput(LaneInput::Value(Value::Function(Function::Builtin(_, ops)))) => {
                return self.builtin(&ops, call, frame);
            }
            _ => return None,
        };
        let function = closure.as_any().downcast_ref::<ScriptFunction>()?;
        let lambda = function.lambda();
        let is_plain = !call.is_partial
            && call.args.len() == lambda.parameters.len()
            && call.args.iter().all(|arg| arg.label.is_none())
            && lambda.parameters.iter().all(|parameter| parameter.default.is_none());
        if !is_plain || MOST_CALLS.min(self.machine.calls_left()) <= self.n_calls {
            return None;
        }
        let mut lanes = Vec::new();
        let mut slots = Vec::with_capacity(call.args.len());
        for (slot, arg) in call.args.iter().enumerate() {
            let compiled = self.expr(arg.value.as_ref()?, frame)?;
            slots.push((slot, self.named(compiled, &mut lanes)?));
        }
        self.n_calls += 1;
        let body = self.expr(&lambda.body, &mut LaneFrame { function: Some(function), slots });
        self.n_calls -= 1;
        body?.after(lanes, 1)
    }
}

/// Whether a number stands there itself, with or without signs.
fn is_written_number(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Constant(_) => true,
        ExprKind::Unary(_, inner) => is_written_number(inner),
        _ => false,
    }
}

impl Compiled {
    pub(super) fn number(self) -> Option<(LaneNode, Dimension)> {
        match self {
            Self::Number(node, dim) => Some((node, dim)),
            Self::LaneInput(LaneInput::Lane(variable, dim)) => {
                Some((LaneNode::Variable(variable), dim))
            }
            Self::LaneInput(LaneInput::Value(Value::Number(Number { value, dim }))) => {
                Some((LaneNode::Constant(value), dim))
            }
            _ => None,
        }
    }

    fn truth(self) -> Option<TruthNode> {
        match self {
            Self::TruthNode(truth) => Some(truth),
            Self::LaneInput(LaneInput::Value(Value::Bool(truth))) => {
                Some(TruthNode::Constant(truth))
            }
            _ => None,
        }
    }

    /// The same after some lanes were computed and so many functions called.
    fn after(self, lanes: Vec<LaneDefinition>, n_calls: u64) -> Option<Self> {
        if lanes.is_empty() && n_calls == 0 {
            return Some(self);
        }
        if self.is_point() {
            let node = Box::new(self.point()?);
            return Some(Self::Point(PointNode::Let(lanes, node, n_calls)));
        }
        if let Self::TruthNode(truth) = self {
            return Some(Self::TruthNode(TruthNode::Let(lanes, Box::new(truth), n_calls)));
        }
        let (node, dim) = self.number()?;
        Some(Self::Number(LaneNode::Let(lanes, Box::new(node), n_calls), dim))
    }
}
