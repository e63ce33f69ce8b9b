//! Calls: of functions of the script, of built-ins, of curves and surfaces, and with places left
//! open.

use std::sync::Arc;

use super::{
    autodiff::run,
    function::ScriptFunction,
    globals::Globals,
    ir::{CallExpr, Expr},
    machine::Machine,
    number_call::{numbers_with_derivatives, on_few, switch},
    parametric::gone,
    relative_files::RelativeFiles,
};
use crate::{
    diag::{Code, Diagnostic, Fix, Label, Result, Span, Spanned},
    kernel::Jet,
    limits::{
        Ceiling,
        work::{self, End},
    },
    value::{
        Call, Ctx, FormalParameter, Function, Making, Mistakes, Op, Value, assign, choose, pointed,
        turned_around,
    },
};

/// Remarks "called from here" that one error collects.
const MOST_CALLERS: usize = 8;

/// The value, unless arithmetic inside a built-in has left the numbers.
pub(super) fn finite(value: Value, name: &str, span: Span) -> Result<Value> {
    let is_finite = |value: &Value| match value {
        Value::Number(number) => number.value.is_finite(),
        Value::Point(point) => point.is_finite(),
        Value::Jet(number) => number.value.is_finite(),
        Value::JetPoint(jets) => jets.iter().all(Jet::is_finite),
        _ => true,
    };
    let is_well = match &value {
        Value::List(items) => match items.numbers() {
            Some((values, _)) => values.iter().all(|value| value.is_finite()),
            // What is made when it is asked for is known to be.
            None => items.is_made() || items.iter().all(is_finite),
        },
        Value::Record(record) => record.iter().all(|(_, value)| is_finite(value)),
        value => is_finite(value),
    };
    if is_well {
        return Ok(value);
    }
    let message = format!("the result of `{name}` is beyond the largest number, 1.8e308");
    Diagnostic::error(Code::Domain, span, message).fail()
}

/// Parts of a value that whoever made it has passed.
fn made_parts(value: &Value) -> u64 {
    match value {
        Value::List(items) => items.len() as u64,
        Value::Text(_) => value.extent().size,
        _ => 1,
    }
}

impl Machine<'_> {
    /// Evaluates a call as written.
    #[cfg_attr(target_family = "wasm", inline(never))]
    pub(super) fn call_expr(&mut self, call: &CallExpr, span: Span) -> Result<Value> {
        let callee = self.eval(&call.callee)?;
        if call.is_partial {
            return self.partial(callee, call, span);
        }
        let mut args =
            Call { span, positional: Vec::with_capacity(call.args.len()), named: Vec::new() };
        for arg in &call.args {
            let Some(expr) = &arg.value else { continue };
            let value = match arg.taken {
                Some(slot) => self.take_local(slot),
                None => self.eval(expr)?,
            };
            let value = Spanned::new(value, arg.span);
            match &arg.label {
                None => args.positional.push(value),
                Some((label, place)) => {
                    args.named.push((Spanned::new(Arc::clone(label), *place), value));
                }
            }
        }
        self.invoke(&callee, args, call.callee.span)
            .map_err(|found| self.env.told_of_hidden(&call.callee, found))
    }

    /// Calls with positional arguments that have no place of their own.
    pub(super) fn apply(
        &mut self,
        function: &Value,
        args: Vec<Value>,
        span: Span,
    ) -> Result<Value> {
        let positional = args.into_iter().map(|value| Spanned::new(value, span)).collect();
        self.invoke(function, Call { span, positional, named: Vec::new() }, span)
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    pub(super) fn invoke(&mut self, callee: &Value, call: Call, place: Span) -> Result<Value> {
        self.step(call.span)?;
        match callee {
            Value::Function(Function::Builtin(name, ops)) => self.builtin(name, ops, call),
            Value::Function(Function::Closure(closure)) => {
                match closure.as_any().downcast_ref::<ScriptFunction>() {
                    Some(function) => self.script(function, call),
                    None => unreachable!("only the machine makes closures"),
                }
            }
            Value::Function(Function::Partial(partial)) => self.fill(partial, call, place),
            Value::Curve(_)
            | Value::JetCurve(_)
            | Value::Surface(_)
            | Value::JetSurface(_)
            | Value::Face(_) => self.place_on(callee, &call),
            other => not_callable(other, place).fail(),
        }
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn builtin(&mut self, name: &str, ops: &[&'static Op], call: Call) -> Result<Value> {
        if let Some(value) = on_few(ops, &call) {
            return Ok(value);
        }
        let first_name = ops.first().and_then(|op| op.params.first()).map(|param| param.name);
        let first = call.positional.first().or_else(|| {
            call.named
                .iter()
                .find(|(label, _)| Some(&*label.value) == first_name)
                .map(|(_, value)| value)
        });
        let op = choose(ops, first.map(|first| &first.value), &call)
            .map_err(|what| Box::new(no_way_to_call(name, ops, first, &what, &call)))?;
        let (env, span) = (self.env, call.span);
        let asked = self.switches.is_some().then(|| numbers_with_derivatives(&call));
        let meter = self.meter();
        let watch = self.watch();
        let home = Arc::clone(&self.home);
        let files =
            RelativeFiles { files: env.files, folder: &home.folder, reads: self.reads.clone() };
        let mut ctx = Ctx {
            tolerance: env.tolerance,
            unit: env.unit.name(),
            limits: env.limits,
            n_threads: env.n_threads,
            files: &files,
            span,
            sources: env.sources,
            caller: self,
            making: Making::Unasked,
        };
        let foreign = first.filter(|first| op.is_foreign_to(&first.value)).cloned();
        let run = || meter.lend(|| run(op, &mut ctx, call));
        let ((value, used), done) = work::under(watch, run);
        // What the operation called was counted by this machine; what it asked, by the meter; what it
        // did itself, under the watch.
        self.add_steps(used.steps - meter.steps + done.steps);
        let value = value.map_err(|found| {
            let found = pointed(found, env.sources);
            let others = foreign.and_then(|first| env.others_for(op, &first.value));
            others.into_iter().fold(found, |found, others| Box::new(found.hint(others)))
        });
        match (done.end, value) {
            (None, value) => {
                let value = finite(value?, name, span)?;
                if let (Some(asked), Some(noted)) = (asked, &mut self.switches) {
                    noted.extend(switch(&asked, &value, span));
                }
                self.passes(made_parts(&value), span)?;
                Ok(value)
            }
            // It says itself what there was no room for.
            (Some(End::Memory), Err(found)) if found.ceiling == Some(Ceiling::MEMORY) => {
                self.is_full = true;
                Err(found)
            }
            (Some(end), _) => self.ended(end, span),
        }
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn script(&mut self, function: &ScriptFunction, call: Call) -> Result<Value> {
        self.n_calls += 1;
        let span = call.span;
        let result = if self.n_calls <= self.env.limits.call_depth {
            self.run_script(function, call)
        } else {
            let message = format!("calls go more than {} deep", self.env.limits.call_depth);
            self.too_deep(message, Ceiling::CALL_DEPTH, span)
        };
        self.n_calls -= 1;
        match result {
            Ok(value) => Ok(value),
            Err(mut found) => {
                self.tell_caller(&mut found, function.lambda().name.as_deref(), span);
                Err(found)
            }
        }
    }

    /// One more caller of what failed, unless it is told already; of a long chain the innermost and the outermost.
    #[inline(never)]
    fn tell_caller(&mut self, diagnostic: &mut Diagnostic, name: Option<&str>, span: Span) {
        let is_told = diagnostic.primary.span == span
            || diagnostic.others.iter().any(|other| other.span == span);
        if is_told {
            return;
        }
        let text = match name {
            Some(name) => format!("`{name}` is called from here"),
            None => "called from here".to_owned(),
        };
        if diagnostic.others.len() < MOST_CALLERS {
            self.n_untold = 0;
            diagnostic.others.push(Label { span, text });
        } else if let Some(last) = diagnostic.others.last_mut() {
            self.n_untold += 1;
            let calls = if self.n_untold == 1 { "call" } else { "calls" };
            let text = format!("{text}, with {} {calls} between", self.n_untold);
            *last = Label { span, text };
        }
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn run_script(&mut self, function: &ScriptFunction, call: Call) -> Result<Value> {
        let slots = self.bound(function, call)?;
        self.enter(function, slots, Self::eval)
    }

    /// The arguments of a call by the parameters of the function; none where a default stands in.
    #[cfg_attr(target_family = "wasm", inline(never))]
    fn bound(&self, function: &ScriptFunction, call: Call) -> Result<Vec<Option<Value>>> {
        let lambda = function.lambda();
        let mut mistakes = Mistakes::default();
        let span = call.span;
        let is_plain = call.named.is_empty()
            && call.positional.len() == lambda.parameters.len()
            && lambda.parameters.iter().all(|parameter| parameter.default.is_none());
        if is_plain {
            return Ok(call.positional.into_iter().map(|arg| Some(arg.value)).collect());
        }
        let formals: Vec<FormalParameter<'_>> = lambda
            .parameters
            .iter()
            .map(|parameter| FormalParameter {
                name: &parameter.name,
                optional: parameter.default.is_some(),
                by_position: false,
                ty: None,
            })
            .collect();
        let slots = assign(&formals, call, &mut mistakes);
        if !mistakes.is_empty() {
            let called = match &lambda.name {
                Some(name) => format!("`{name}`"),
                None => "this function".to_owned(),
            };
            let signature = crate::value::Closure::signature(function);
            return Err(mistakes.complaint(&called, &signature, span));
        }
        Ok(slots.into_iter().map(|slot| slot.map(|arg| arg.value)).collect())
    }

    /// Runs what is to be done with the body of a function in a frame of its own.
    pub(super) fn enter<T>(
        &mut self,
        function: &ScriptFunction,
        args: Vec<Option<Value>>,
        run: impl FnOnce(&mut Self, &Expr) -> Result<T>,
    ) -> Result<T> {
        let lambda = function.lambda();
        let outer_home = self.go_home(function)?;
        let outer_base = std::mem::replace(&mut self.base, self.stack.len());
        let outer = self.running.replace(function.clone());
        self.stack.resize(self.base + lambda.n_slots, Value::None);
        let result = self.fill_frame(function, args).and_then(|()| run(self, &lambda.body));
        self.stack.truncate(self.base);
        self.base = outer_base;
        self.running = outer;
        if let Some(home) = outer_home {
            self.home = home;
        }
        result
    }

    /// Enters the file of a function, unless it runs already; the file that ran before.
    #[cfg_attr(target_family = "wasm", inline(never))]
    fn go_home(&mut self, function: &ScriptFunction) -> Result<Option<Arc<Globals>>> {
        if std::ptr::eq(function.home.as_ptr(), Arc::as_ptr(&self.home)) {
            return Ok(None);
        }
        match function.home.upgrade() {
            Some(home) => Ok(Some(std::mem::replace(&mut self.home, home))),
            None => gone(function.lambda().body.span),
        }
    }

    #[cfg_attr(target_family = "wasm", inline(never))]
    fn fill_frame(&mut self, function: &ScriptFunction, args: Vec<Option<Value>>) -> Result<()> {
        for (slot, (arg, parameter)) in
            args.into_iter().zip(&function.lambda().parameters).enumerate()
        {
            let value = match (arg, &parameter.default) {
                (Some(value), _) => value,
                (None, Some(default)) => self.eval(default)?,
                (None, None) => Value::None,
            };
            let place = self.base + slot;
            self.stack[place] = value;
        }
        Ok(())
    }
}

/// What is wrong with a call of what is no function.
fn not_callable(callee: &Value, place: Span) -> Diagnostic {
    let message = format!("{} cannot be called", callee.phrase());
    let diagnostic = Diagnostic::error(Code::NotCallable, place, message);
    match callee {
        Value::Number(_) => diagnostic
            .label("is a `,` missing after this?")
            .hint("a product is written `a * b`")
            .fix(Fix::insert(Span::new(place.end, place.end), " * ")),
        Value::Point(_) | Value::List(_) => diagnostic.label("is a `,` missing after this?"),
        _ => diagnostic.hint("functions, curves and surfaces can be called"),
    }
}

/// What is wrong with a call that none of the operations of a name takes.
fn no_way_to_call(
    name: &str,
    ops: &[&'static Op],
    first: Option<&Spanned<Value>>,
    what: &str,
    call: &Call,
) -> Diagnostic {
    let turned = ops.iter().find_map(|op| Some((op, turned_around(op, call)?)));
    if let Some((op, (span, hint))) = turned {
        let message = format!("`{name}`: the arguments stand the other way around");
        return Diagnostic::error(Code::BadCall, span, message)
            .hint(hint)
            .hint(format!("its signature is `{}`", op.signature()));
    }
    let place = first.map_or(call.span, |first| first.span);
    let mut diagnostic = Diagnostic::error(Code::WrongKind, place, format!("`{name}` {what}"));
    let remedy = |op: &&'static Op| op.params.first()?.ty.remedy(&first?.value);
    if let Some(remedy) = ops.iter().find_map(remedy) {
        diagnostic = diagnostic.hint(remedy);
    }
    for op in ops {
        diagnostic = diagnostic.hint(format!("`{}`", op.signature()));
    }
    diagnostic
}
