//! The machine that evaluates expressions: a tree walk over values, with slots for names.
//!
//! Frames lie on one stack of values; a function sees its frame, what it captured, and the
//! definitions of the file. Depth and steps are counted, so that nothing a script does can
//! exhaust the stack or run for ever. What seldom lies between two expressions is not inlined (`inline(never)`), so that
//! each frame holds what its own work needs, and no more: deep calls touch less memory. In a page the stack is the
//! browser's, and nothing that lies between two expressions is inlined.

use std::{
    collections::BTreeSet,
    fmt,
    sync::{Arc, Mutex},
};

use super::{
    env::Env,
    field_memory::FieldMemory,
    function::ScriptFunction,
    globals::Globals,
    import_fault::ImportFault,
    index,
    ir::{BinaryOp, Block, CaptureSource, Expr, ExprKind, Group},
    memory::{Fields, FileRead},
    meter::Meter,
    operator::{
        self,
        table::{BinaryMeaning, binary_meaning},
    },
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, fault},
    limits::Ceiling,
    value::{Function, Switch, Value, Witness},
};

/// The machine. One for each thread that evaluates.
#[derive(Debug)]
pub(crate) struct Machine<'a> {
    pub(crate) env: Env<'a>,
    /// The file that runs.
    pub(crate) home: Arc<Globals>,
    pub(super) stack: Vec<Value>,
    pub(super) base: usize,
    pub(super) running: Option<ScriptFunction>,
    pub(super) n_calls: usize,
    depth: usize,
    pub(super) steps: u64,
    /// Whether the memory has run out, which was told.
    pub(super) is_full: bool,
    pub(crate) warnings: Vec<Diagnostic>,
    /// The files that were read, where somebody wants to know.
    pub(super) reads: Option<FileReads>,
    /// What decided the last test of a list, and the call that made it.
    pub(super) witness: Option<(Span, Witness)>,
    /// What decided which way functions went, where somebody wants to know.
    pub(super) switches: Option<Vec<Switch>>,
    /// Whether texts were made of what carries derivatives.
    pub(super) has_varying_texts: bool,
    /// Callers of the failure under way that no remark tells of.
    pub(super) n_untold: usize,
    /// The results that the last import brought, where they have an identity.
    pub(super) imported: Fields,
    /// How many files with warnings were evaluated.
    pub(super) n_doubtful: usize,
    /// What went wrong in the file that was imported last.
    pub(super) import_fault: Option<ImportFault>,
    /// The scripts that the expression under way has called, by their numbers.
    pub(super) scripts: BTreeSet<usize>,
    fields: FieldMemory,
}

/// Files that were read so far.
pub(super) type FileReads = Arc<Mutex<BTreeSet<FileRead>>>;

impl<'a> Machine<'a> {
    pub(crate) fn new(env: Env<'a>, home: Arc<Globals>) -> Self {
        Self {
            env,
            home,
            stack: Vec::new(),
            base: 0,
            running: None,
            n_calls: 0,
            depth: 0,
            steps: 0,
            is_full: false,
            warnings: Vec::new(),
            reads: None,
            witness: None,
            switches: None,
            has_varying_texts: false,
            n_untold: 0,
            imported: Fields::default(),
            n_doubtful: 0,
            import_fault: None,
            scripts: BTreeSet::new(),
            fields: FieldMemory::default(),
        }
    }

    /// Evaluates an expression of the file in a fresh frame.
    pub(crate) fn run(&mut self, expr: &Expr, n_slots: usize) -> Result<Value> {
        self.prepare(n_slots);
        self.check_memory(expr.span)?;
        fault::caught(expr.span, || self.eval(expr))
    }

    /// An empty frame of so many slots at the bottom of the stack.
    pub(super) fn prepare(&mut self, n_slots: usize) {
        self.stack.clear();
        self.stack.resize(n_slots, Value::None);
        self.base = 0;
        self.running = None;
        (self.n_calls, self.depth, self.steps) = (0, 0, 0);
        self.fields = FieldMemory::default();
        self.scripts.clear();
    }

    /// What it has used up.
    pub(super) fn meter(&self) -> Meter {
        Meter { n_calls: self.n_calls, depth: self.depth, steps: self.steps }
    }

    /// Goes on from what others have used up.
    pub(super) fn set_meter(&mut self, meter: Meter) {
        (self.n_calls, self.depth, self.steps) = (meter.n_calls, meter.depth, meter.steps);
    }

    /// Counts what was used up elsewhere on behalf of this machine.
    pub(super) fn add_steps(&mut self, steps: u64) {
        self.steps += steps;
    }

    /// Evaluates an expression in the frame of the running function.
    pub(super) fn eval(&mut self, expr: &Expr) -> Result<Value> {
        match &expr.kind {
            ExprKind::Constant(value) => Ok(value.clone()),
            ExprKind::Local(slot) => Ok(self.local(*slot)),
            _ => self.eval_deep(expr),
        }
    }

    /// Whatever may contain further expressions: counts the depth.
    fn eval_deep(&mut self, expr: &Expr) -> Result<Value> {
        self.depth += 1;
        let result = if self.depth <= self.env.limits.evaluation_depth {
            self.dispatch(expr)
        } else {
            self.expressions_too_deep(expr.span)
        };
        self.depth -= 1;
        match result {
            Ok(value) => self.check_extent(value, expr.span),
            failed => failed,
        }
    }

    #[inline(never)]
    fn expressions_too_deep(&mut self, span: Span) -> Result<Value> {
        let most = self.env.limits.evaluation_depth;
        let what = format!("expressions lie more than {most} deep inside one another");
        self.too_deep(what, Ceiling::EVALUATION_DEPTH, span)
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn dispatch(&mut self, expr: &Expr) -> Result<Value> {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Binary(op, sides) => self.binary(*op, sides, span),
            ExprKind::Call(call) => self.call_expr(call, span),
            ExprKind::If(parts) => self.choose(parts),
            ExprKind::Global(idx) => self.global(*idx, span),
            ExprKind::Captured(idx) => Ok(self.captured(*idx)),
            ExprKind::Sibling(idx) => Ok(self.sibling(*idx)),
            ExprKind::Constant(value) => Ok(value.clone()),
            ExprKind::Local(slot) => Ok(self.local(*slot)),
            ExprKind::Point(coordinates) => self.point(coordinates),
            ExprKind::List(elements) => self.list(elements, span),
            ExprKind::Record(fields) => self.record(fields),
            ExprKind::Text(pieces) => self.text(pieces, span),
            ExprKind::Comprehension(comprehension) => self.comprehension(comprehension, span),
            ExprKind::Block(block) => self.block(block),
            ExprKind::Unary(op, operand) => {
                let value = self.eval(operand)?;
                operator::unary(*op, &value, operand.span)
            }
            ExprKind::Within(parts) => self.within(parts),
            ExprKind::Index(parts) => self.index(parts),
            ExprKind::Field(subject, name, place) => self.field(subject, name, *place),
            ExprKind::Lambda(group, idx, sources) => Ok(self.make_function(group, *idx, sources)),
            ExprKind::Exactly(list, n) => self.exactly(list, *n),
            ExprKind::Promise(value, kind, name) => self.promise(value, *kind, *name),
            ExprKind::Import(file, with) => self.import(*file, with, span),
            ExprKind::Script(file, with) => self.script_file(file, with, span),
            ExprKind::Poison => unreachable!("poisoned definitions are never evaluated"),
        }
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn global(&self, idx: usize, span: Span) -> Result<Value> {
        match self.home.known(idx) {
            Some(value) => Ok(value.clone()),
            // The order of evaluation puts what is used first, and failures stay quiet.
            _ => Diagnostic::error(Code::Cycle, span, "this has no value yet").fail(),
        }
    }

    /// A value of the running frame.
    pub(super) fn local(&self, slot: usize) -> Value {
        self.stack[self.base + slot].clone()
    }

    /// A value of the running frame, which has it no more.
    pub(super) fn take_local(&mut self, slot: usize) -> Value {
        std::mem::replace(&mut self.stack[self.base + slot], Value::None)
    }

    /// How many expressions lie around the running one.
    pub(super) fn depth(&self) -> usize {
        self.depth
    }

    /// How much deeper expressions may lie in the running one.
    pub(super) fn depth_left(&self) -> usize {
        self.env.limits.evaluation_depth.saturating_sub(self.depth)
    }

    /// How much deeper calls may go.
    pub(super) fn calls_left(&self) -> usize {
        self.env.limits.call_depth.saturating_sub(self.n_calls)
    }

    pub(super) fn captured(&self, idx: usize) -> Value {
        self.running.as_ref().map_or(Value::None, |function| function.captures[idx].clone())
    }

    pub(super) fn sibling(&self, idx: usize) -> Value {
        self.running.as_ref().map_or(Value::None, |running| running.sibling(idx))
    }

    #[inline(never)]
    fn make_function(&self, group: &Arc<Group>, idx: usize, sources: &[CaptureSource]) -> Value {
        let captures = sources
            .iter()
            .map(|source| match source {
                CaptureSource::Local(slot) => self.stack[self.base + slot].clone(),
                CaptureSource::Captured(idx) => self.captured(*idx),
                CaptureSource::Sibling(idx) => self.sibling(*idx),
            })
            .collect();
        let home = Arc::downgrade(&self.home);
        let function = ScriptFunction { group: Arc::clone(group), idx, captures, home, kept: None };
        Value::Function(Function::Closure(Arc::new(function)))
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn choose(&mut self, parts: &[Expr; 3]) -> Result<Value> {
        let [condition, yes, no] = parts;
        if self.truth(condition, "the condition of `if`")? { self.eval(yes) } else { self.eval(no) }
    }

    /// A value that must be true or false.
    pub(super) fn truth(&mut self, expr: &Expr, subject: impl fmt::Display) -> Result<bool> {
        match self.eval(expr)? {
            Value::Bool(truth) => Ok(truth),
            other => {
                let message = format!("{subject} must be true or false, found {}", other.phrase());
                Diagnostic::error(Code::WrongKind, expr.span, message).fail()
            }
        }
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn binary(&mut self, op: BinaryOp, sides: &[Expr; 2], span: Span) -> Result<Value> {
        let [left, right] = sides;
        match binary_meaning(op) {
            BinaryMeaning::Logic { decided_by } => {
                let truth = self.truth(left, format_args!("a side of `{}`", op.symbol()))?;
                if truth == decided_by {
                    return Ok(Value::Bool(truth));
                }
                self.truth(right, format_args!("a side of `{}`", op.symbol())).map(Value::Bool)
            }
            _ => {
                let (a, b) = (self.eval(left)?, self.eval(right)?);
                if let (Value::Number(x), Value::Number(y)) = (&a, &b)
                    && let Some(value) = operator::plain(op, *x, *y)
                {
                    return Ok(value);
                }
                let places =
                    operator::OperandPlaces { whole: span, left: left.span, right: right.span };
                self.combined(op, [&a, &b], places)
            }
        }
    }

    /// What an operator makes of two values.
    #[cfg_attr(target_family = "wasm", inline(never))]
    fn combined(
        &mut self,
        op: BinaryOp,
        [a, b]: [&Value; 2],
        places: operator::OperandPlaces,
    ) -> Result<Value> {
        self.passes(a.extent().size.min(b.extent().size), places.whole)?;
        let value = operator::binary(op, a, b, places, self.env.tolerance)?;
        if let Some(noted) = &mut self.switches {
            noted.extend(operator::switch(op, [a, b], &value, places.whole));
        }
        Ok(value)
    }

    #[inline(never)]
    fn within(&mut self, parts: &[Expr; 3]) -> Result<Value> {
        let [left, right, _] = parts;
        let (a, b) = (self.eval(left)?, self.eval(right)?);
        let tolerance = self.tolerance_of(&parts[2], [&a, &b])?;
        operator::near(&a, &b, tolerance, left.span.to(right.span)).map(Value::Bool)
    }

    /// The number after `within`: a plain one, in the units of both sides, or one of their dimension.
    #[inline(never)]
    pub(super) fn tolerance_of(&mut self, expr: &Expr, sides: [&Value; 2]) -> Result<f64> {
        match self.eval(expr)? {
            Value::Number(number) if 0.0 <= number.value => {
                match sides.into_iter().find_map(|side| operator::of_other_unit(number, side)) {
                    Some(side) => operator::limit_of_other_unit(number, &side, expr.span),
                    None => Ok(number.value),
                }
            }
            other => {
                let message = format!(
                    "`within` takes a number that is not negative, found {}",
                    other.phrase()
                );
                Diagnostic::error(Code::WrongKind, expr.span, message).fail()
            }
        }
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn block(&mut self, block: &Block) -> Result<Value> {
        self.define(block)?;
        self.eval(&block.value)
    }

    /// Evaluates the definitions of a block.
    pub(super) fn define(&mut self, block: &Block) -> Result<()> {
        for (slot, expr) in &block.definitions {
            let value = self.eval(expr)?;
            let place = self.base + slot;
            self.stack[place] = value;
        }
        Ok(())
    }

    #[inline(never)]
    fn index(&mut self, parts: &[Expr; 2]) -> Result<Value> {
        let (subject, index) = (self.eval(&parts[0])?, self.eval(&parts[1])?);
        match (&subject, &index) {
            (Value::Table(_) | Value::Record(_), Value::Text(name)) => {
                self.field_of(&subject, parts[0].span, name, parts[1].span)
            }
            _ => index::index(&subject, &index, parts[0].span, parts[1].span),
        }
    }

    #[inline(never)]
    fn field(&mut self, subject: &Expr, name: &str, place: Span) -> Result<Value> {
        let value = self.eval(subject)?;
        if let Some(known) = self.fields.find(&value, name) {
            return Ok(known);
        }
        let found = self.field_of(&value, subject.span, name, place)?;
        self.fields.keep(value, name, &found);
        Ok(found)
    }
}
