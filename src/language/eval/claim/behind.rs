//! Claims behind which a test of a list stands: under a name, in a function of the script, in the condition of an
//! `if`, beside `true` or `false`.

use std::sync::Arc;

use super::Verdict;
use crate::{
    diag::Span,
    eval::{
        function::ScriptFunction,
        globals::Globals,
        ir::{BinaryOp, Block, CallExpr, Expr, ExprKind, Program, UnaryOp},
        machine::Machine,
    },
    value::{Function, Value},
};

impl Machine<'_> {
    /// The verdict on a claim that failed, with which element of a list decided it, if that stands behind the claim.
    /// For that it is evaluated again; what goes wrong then leaves it out.
    pub(super) fn with_witness(
        &mut self,
        failed: Verdict,
        claim: &Expr,
        (program, n_slots): (&Program, usize),
    ) -> Verdict {
        let is_told = failed.witness.is_some() || failed.apart.is_some() || failed.differ.is_some();
        if failed.holds || is_told {
            return failed;
        }
        let n_warnings = self.warnings.len();
        let scripts = self.scripts.clone();
        self.prepare(n_slots);
        let home = Arc::clone(&self.home);
        let behind = NameSearch { program, home: &home, n_left: MOST_STEPS };
        let found = self.behind(claim, &behind);
        self.warnings.truncate(n_warnings);
        self.scripts.extend(scripts);
        match found {
            Some(found) => Verdict { holds: false, ..found },
            None => failed,
        }
    }

    /// The verdict of the test of a list that decides an expression.
    fn behind(&mut self, expr: &Expr, scope: &NameSearch<'_>) -> Option<Verdict> {
        match &expr.kind {
            ExprKind::Binary(op @ (BinaryOp::And | BinaryOp::Or), sides) => {
                let first = self.is_true(&sides[0])?;
                let is_first = first == (*op == BinaryOp::Or);
                self.behind(&sides[usize::from(!is_first)], scope)
            }
            ExprKind::Binary(BinaryOp::Equal | BinaryOp::NotEqual, sides) => match &**sides {
                [side, Expr { kind: ExprKind::Constant(Value::Bool(_)), .. }]
                | [Expr { kind: ExprKind::Constant(Value::Bool(_)), .. }, side] => {
                    self.behind(side, scope)
                }
                _ => None,
            },
            ExprKind::If(parts) => {
                let chosen = &parts[if self.is_true(&parts[0])? { 1 } else { 2 }];
                match chosen.kind {
                    ExprKind::Constant(_) => self.behind(&parts[0], scope),
                    _ => self.behind(chosen, scope),
                }
            }
            ExprKind::Block(block) => self.behind_block(block, scope),
            ExprKind::Promise(inner, ..) => self.behind(inner, scope),
            ExprKind::Global(idx) if std::ptr::eq(scope.home.as_ref(), self.home.as_ref()) => {
                let (definition, scope) = (scope.program.definition(*idx)?, scope.deeper()?);
                self.in_frame(definition.n_slots, |machine| {
                    machine.behind(&definition.value, &scope)
                })
            }
            ExprKind::Call(call) => match self.called(call) {
                Some((function, args)) => self.behind_call(&function, args, expr.span, scope),
                None => self.of_list(expr),
            },
            ExprKind::Unary(UnaryOp::Not, inner) => {
                self.of_list(expr).or_else(|| self.behind(inner, scope))
            }
            _ => None,
        }
    }

    fn is_true(&mut self, expr: &Expr) -> Option<bool> {
        match self.eval(expr) {
            Ok(Value::Bool(truth)) => Some(truth),
            _ => None,
        }
    }

    /// The verdict of a test of a list that stands here.
    fn of_list(&mut self, expr: &Expr) -> Option<Verdict> {
        self.witness = None;
        let value = self.eval(expr).ok()?;
        self.plain_verdict(&value, expr).ok().filter(|verdict| verdict.witness.is_some())
    }

    /// Behind the value of a block, or behind what a name in it stands for.
    fn behind_block(&mut self, block: &Block, scope: &NameSearch<'_>) -> Option<Verdict> {
        self.define(block).ok()?;
        let named = match block.value.kind {
            ExprKind::Local(slot) => block.definitions.iter().rev().find(|(own, _)| *own == slot),
            _ => None,
        };
        self.behind(named.map_or(&block.value, |(_, expr)| expr), scope)
    }

    /// The function of the script that a call calls, with its arguments, where these stand in order.
    fn called(&mut self, call: &CallExpr) -> Option<(ScriptFunction, Vec<Option<Value>>)> {
        if call.is_partial || call.args.iter().any(|arg| arg.label.is_some()) {
            return None;
        }
        let Ok(Value::Function(Function::Closure(closure))) = self.eval(&call.callee) else {
            return None;
        };
        let function = closure.as_any().downcast_ref::<ScriptFunction>()?.clone();
        let mut args = Vec::with_capacity(call.args.len());
        for arg in &call.args {
            args.push(Some(self.eval(arg.value.as_ref()?).ok()?));
        }
        let n = function.lambda().parameters.len();
        (args.len() <= n).then(|| {
            args.resize(n, None);
            (function, args)
        })
    }

    fn behind_call(
        &mut self,
        function: &ScriptFunction,
        args: Vec<Option<Value>>,
        span: Span,
        scope: &NameSearch<'_>,
    ) -> Option<Verdict> {
        let scope = scope.deeper()?;
        self.step(span).ok()?;
        self.enter(function, args, |machine, body| Ok(machine.behind(body, &scope))).ok()?
    }

    /// Runs in a frame of its own, outside of any function.
    fn in_frame<T>(&mut self, n_slots: usize, run: impl FnOnce(&mut Self) -> T) -> T {
        let outer_base = std::mem::replace(&mut self.base, self.stack.len());
        let outer = self.running.take();
        self.stack.resize(self.base + n_slots, Value::None);
        let found = run(self);
        self.stack.truncate(self.base);
        (self.base, self.running) = (outer_base, outer);
        found
    }
}

/// Names and calls that are followed one behind the other.
const MOST_STEPS: usize = 16;

/// The file that is asked about, and how much farther names and calls are followed.
#[derive(Clone, Copy)]
struct NameSearch<'p> {
    program: &'p Program,
    home: &'p Arc<Globals>,
    n_left: usize,
}

impl NameSearch<'_> {
    /// The same behind one name or call more.
    fn deeper(self) -> Option<Self> {
        Some(Self { n_left: self.n_left.checked_sub(1)?, ..self })
    }
}
