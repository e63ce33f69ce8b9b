//! Compiles expressions of numbers to lanes; `None` wherever the machine is needed.

use super::{Body, Comparison, Node, Operation, Truth};
use crate::{
    eval::{
        function::ScriptFunction,
        ir::{BinaryOp, Block, CallExpr, Expr, ExprKind, UnaryOp},
        machine::Machine,
    },
    value::{Dim, Function, Number, Value},
};

/// Expressions inside one another, calls included; also what keeps recursion from being compiled.
const MOST_NESTED: usize = 64;

/// Calls inside one another.
const MOST_CALLS: usize = 6;

/// What is known of an expression before any element is.
#[derive(Clone, Debug)]
enum Known {
    /// A value that is the same for all elements.
    Value(Value),
    /// A lane of numbers.
    Lane(usize, Dim),
}

/// A compiled expression.
enum Compiled {
    Known(Known),
    Number(Node, Dim),
    Truth(Truth),
}

/// A frame of the machine as far as it differs from the one on its stack.
struct Frame<'f> {
    /// `None` for the frame in which the comprehension stands.
    function: Option<&'f ScriptFunction>,
    slots: Vec<(usize, Known)>,
}

pub(super) struct Compiler<'m> {
    machine: &'m Machine<'m>,
    slots: Vec<(usize, Known)>,
    n_variables: usize,
    n_nested: usize,
    n_calls: usize,
}

impl<'m> Compiler<'m> {
    /// A compiler in the running frame, whose slot `variable` is lane 0.
    pub(super) fn new(machine: &'m Machine<'_>, variable: usize, dim: Dim) -> Self {
        let slots = vec![(variable, Known::Lane(0, dim))];
        Self { machine, slots, n_variables: 1, n_nested: 0, n_calls: 0 }
    }

    pub(super) fn n_variables(&self) -> usize {
        self.n_variables
    }

    pub(super) fn condition(&mut self, expr: &Expr) -> Option<Truth> {
        let mut frame = Frame { function: None, slots: self.slots.clone() };
        self.expr(expr, &mut frame)?.truth()
    }

    pub(super) fn body(&mut self, expr: &Expr) -> Option<Body> {
        let mut frame = Frame { function: None, slots: self.slots.clone() };
        if let ExprKind::Point(coordinates) = &expr.kind {
            let mut coordinate = |expr: &Expr| {
                let (node, dim) = self.expr(expr, &mut frame)?.number()?;
                (dim.is_none() || dim == Dim::LENGTH).then_some(node)
            };
            let [x, y, z] = &**coordinates;
            return Some(Body::Point(Box::new([coordinate(x)?, coordinate(y)?, coordinate(z)?])));
        }
        let (node, dim) = self.expr(expr, &mut frame)?.number()?;
        Some(Body::Number(node, dim))
    }

    fn expr(&mut self, expr: &Expr, frame: &mut Frame<'_>) -> Option<Compiled> {
        self.n_nested += 1;
        let most = MOST_NESTED.min(self.machine.depth_left());
        let compiled = if self.n_nested <= most { self.dispatch(expr, frame) } else { None };
        self.n_nested -= 1;
        compiled
    }

    fn dispatch(&mut self, expr: &Expr, frame: &mut Frame<'_>) -> Option<Compiled> {
        let known = |value: Value| Some(Compiled::Known(Known::Value(value)));
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
                Some(function) => function.home.upgrade()?.value(*idx)?.clone(),
                None => self.machine.home.value(*idx)?.clone(),
            }),
            ExprKind::Unary(UnaryOp::Negate, operand) => {
                let (node, dim) = self.expr(operand, frame)?.number()?;
                Some(Compiled::Number(Node::Negate(Box::new(node)), dim))
            }
            ExprKind::Unary(UnaryOp::Not, operand) => {
                let truth = self.expr(operand, frame)?.truth()?;
                Some(Compiled::Truth(Truth::Not(Box::new(truth))))
            }
            ExprKind::Binary(op, sides) => self.binary(*op, sides, frame),
            ExprKind::If(parts) => {
                let [condition, yes, no] = &**parts;
                let condition = self.expr(condition, frame)?.truth()?;
                let (yes, dim) = self.expr(yes, frame)?.number()?;
                let (no, other) = self.expr(no, frame)?.number()?;
                let choice = Node::Choose(Box::new(condition), Box::new([yes, no]));
                (dim == other).then_some(Compiled::Number(choice, dim))
            }
            ExprKind::Block(block) => self.block(block, frame),
            ExprKind::Call(call) => self.call(call, frame),
            _ => None,
        }
    }

    fn local(&self, slot: usize, frame: &Frame<'_>) -> Option<Compiled> {
        let is_it = |(own, _): &&(usize, Known)| *own == slot;
        let known = match (frame.slots.iter().rev().find(is_it), frame.function) {
            (Some((_, known)), _) => known.clone(),
            (None, None) => Known::Value(self.machine.local(slot)),
            (None, Some(_)) => return None,
        };
        Some(Compiled::Known(known))
    }

    fn binary(
        &mut self,
        op: BinaryOp,
        sides: &[Expr; 2],
        frame: &mut Frame<'_>,
    ) -> Option<Compiled> {
        use BinaryOp as Op;
        let (left, right) = (self.expr(&sides[0], frame)?, self.expr(&sides[1], frame)?);
        if matches!(op, Op::And | Op::Or) {
            let sides = Box::new([left.truth()?, right.truth()?]);
            let truth = if op == Op::And { Truth::And(sides) } else { Truth::Or(sides) };
            return Some(Compiled::Truth(truth));
        }
        let ((left, a), (right, b)) = (left.number()?, right.number()?);
        let comparison = match op {
            Op::Less => Some(Comparison::Less),
            Op::LessEqual => Some(Comparison::LessEqual),
            Op::Greater => Some(Comparison::Greater),
            Op::GreaterEqual => Some(Comparison::GreaterEqual),
            Op::Equal => Some(Comparison::Equal),
            Op::NotEqual => Some(Comparison::NotEqual),
            _ => None,
        };
        if let Some(comparison) = comparison {
            a.common(b)?;
            let sides = Box::new([left, right]);
            return Some(Compiled::Truth(Truth::Compare(comparison, sides)));
        }
        let (operation, dim) = match op {
            Op::Add => (Operation::Add, a.common(b)?),
            Op::Subtract => (Operation::Subtract, a.common(b)?),
            Op::Multiply => (Operation::Multiply, a.times(b)?),
            Op::Divide => (Operation::Divide, a.over(b)?),
            Op::Remainder => (Operation::Remainder, a.common(b)?),
            Op::Power => match right {
                _ if !b.is_none() => return None,
                Node::Constant(exponent) => (Operation::Power, a.power(exponent)?),
                _ if a.is_none() => (Operation::Power, a),
                _ => return None,
            },
            _ => return None,
        };
        Some(Compiled::Number(Node::Arithmetic(operation, Box::new([left, right])), dim))
    }

    fn block(&mut self, block: &Block, frame: &mut Frame<'_>) -> Option<Compiled> {
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
    fn named(&mut self, compiled: Compiled, lanes: &mut Vec<(usize, Node)>) -> Option<Known> {
        match compiled {
            Compiled::Known(known) => Some(known),
            Compiled::Number(node, dim) => {
                lanes.push((self.n_variables, node));
                self.n_variables += 1;
                Some(Known::Lane(self.n_variables - 1, dim))
            }
            Compiled::Truth(_) => None,
        }
    }

    /// The body of a function of the script in the place of its call.
    fn call(&mut self, call: &CallExpr, frame: &mut Frame<'_>) -> Option<Compiled> {
        let Compiled::Known(Known::Value(Value::Function(Function::Closure(closure)))) =
            self.expr(&call.callee, frame)?
        else {
            return None;
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
        let body = self.expr(&lambda.body, &mut Frame { function: Some(function), slots });
        self.n_calls -= 1;
        body?.after(lanes, 1)
    }
}

impl Compiled {
    fn number(self) -> Option<(Node, Dim)> {
        match self {
            Self::Number(node, dim) => Some((node, dim)),
            Self::Known(Known::Lane(variable, dim)) => Some((Node::Variable(variable), dim)),
            Self::Known(Known::Value(Value::Number(Number { value, dim }))) => {
                Some((Node::Constant(value), dim))
            }
            _ => None,
        }
    }

    fn truth(self) -> Option<Truth> {
        match self {
            Self::Truth(truth) => Some(truth),
            Self::Known(Known::Value(Value::Bool(truth))) => Some(Truth::Constant(truth)),
            _ => None,
        }
    }

    /// The same after some lanes were computed and so many functions called.
    fn after(self, lanes: Vec<(usize, Node)>, n_calls: u64) -> Option<Self> {
        if lanes.is_empty() && n_calls == 0 {
            return Some(self);
        }
        if let Self::Truth(truth) = self {
            return Some(Self::Truth(Truth::Let(lanes, Box::new(truth), n_calls)));
        }
        let (node, dim) = self.number()?;
        Some(Self::Number(Node::Let(lanes, Box::new(node), n_calls), dim))
    }
}
