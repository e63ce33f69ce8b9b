//! Functions of the script as curves and surfaces.
//!
//! The kernel asks for derivatives wherever and on whatever thread it likes; each question runs the
//! function on a machine of its own, on jets. What a function may ask for is counted together with
//! whoever asks on the same thread, so that no nesting of curves in curves escapes the ceilings.

use std::sync::{Arc, Weak};

use glam::DVec3;

use super::{
    env::Env,
    function::ScriptFunction,
    globals::Globals,
    machine::Machine,
    meter::{Meter, USED},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::{CurveFunction, FunctionFailure, Grid, Jet, SurfaceFunction, Tolerance},
    limits::{
        Limits, stack,
        work::{MemoryGauge, StopToken},
    },
    syntax::ast::Unit,
    value::{Dimension, Files, Function, IntoValue, Real, Value, shortest},
};

/// Files that a function cannot read: it is asked again and again, also when the script has ended.
#[derive(Debug)]
struct FilesOutOfReach;

impl Files for FilesOutOfReach {
    fn read(&self, path: &str, _: usize) -> std::result::Result<Vec<u8>, String> {
        Err(format!("`{path}` cannot be read inside a parametric curve or surface"))
    }
}

/// Fails: whoever kept a part of the definitions has let go of the whole.
pub(super) fn gone<T>(span: Span) -> Result<T> {
    let message = "the script that this function belongs to is gone";
    Diagnostic::error(Code::FileMissing, span, message).fail()
}

/// A function of the script under the conditions in which it was made into geometry.
#[derive(Debug)]
pub(super) struct GeometryFunction {
    function: Value,
    /// The call that made it.
    span: Span,
    limits: Limits,
    tolerance: Tolerance,
    unit: Unit,
    gauge: MemoryGauge,
    stop: StopToken,
    /// The file whose function it is, which may hold the curve or surface; what leaves the run keeps it alive.
    home: Weak<Globals>,
}

impl GeometryFunction {
    pub(super) fn new(machine: &Machine<'_>, function: &Value, span: Span) -> Result<Arc<Self>> {
        if holds_jets(function) {
            let message = "this function uses a parameter of a function that is differentiated";
            return Diagnostic::error(Code::NoDerivative, span, message)
                .hint("make the curve or surface outside, or evaluate it there")
                .fail();
        }
        let (env, home) = (machine.env, Arc::downgrade(&machine.home));
        Ok(Arc::new(Self {
            function: function.clone(),
            span,
            limits: *env.limits,
            tolerance: env.tolerance,
            unit: env.unit,
            gauge: env.gauge.clone(),
            stop: env.stop.clone(),
            home,
        }))
    }

    fn call(&self, args: &[Value]) -> std::result::Result<Value, FunctionFailure> {
        let asked = self.answer(args);
        asked.map_err(|mut diagnostic| {
            let names: &[&str] = if args.len() == 1 { &["t"] } else { &["u", "v"] };
            let values = args.iter().map(|arg| match arg.looked_at() {
                Value::Number(number) => shortest(number.value),
                other => other.to_string(),
            });
            let place: Vec<String> =
                names.iter().zip(values).map(|(name, value)| format!("{name} = {value}")).collect();
            let text = format!("at {} of this", place.join(", "));
            diagnostic.others.retain(|other| other.span != self.span);
            FunctionFailure::new(diagnostic.also(self.span, text))
        })
    }

    fn answer(&self, args: &[Value]) -> Result<Value> {
        let Some(home) = self.home.upgrade() else { return gone(self.span) };
        // The kernel may ask on a thread that nobody gave a stack.
        let limits = self.limits.on_stack(self.limits.stack_bytes.min(stack::own_bytes()));
        let env = Env {
            limits: &limits,
            n_threads: 1,
            files: &FilesOutOfReach,
            tolerance: self.tolerance,
            unit: self.unit,
            gauge: &self.gauge,
            stop: &self.stop,
            registry: None,
            library: None,
            sources: None,
        };
        let mut machine = Machine::new(env, home);
        machine.set_meter(USED.get());
        let result = machine.apply(&self.function, args.to_vec(), self.span);
        USED.set(Meter { steps: machine.meter().steps, ..USED.get() });
        result
    }

    /// The coordinates of an answer.
    fn coordinates(
        &self,
        answer: &Value,
        n_parameters: usize,
    ) -> std::result::Result<[Real; 3], FunctionFailure> {
        match answer {
            Value::Point(point) => Ok(point.to_array().map(Real::Plain)),
            Value::JetPoint(jets) => Ok(jets.as_ref().clone().map(Real::Jet)),
            other => {
                let message =
                    format!("the function must yield a point, but it yields {}", other.phrase());
                let hint = match n_parameters {
                    1 => "for example `t => (cos(t), sin(t), t)`",
                    _ => "for example `(u, v) => (u, v, u * v)`",
                };
                let diagnostic = Diagnostic::error(Code::WrongKind, self.place(), message);
                Err(FunctionFailure::new(diagnostic.hint(hint)))
            }
        }
    }

    /// The body of the function, or the call that made geometry of it.
    fn place(&self) -> Span {
        match script_function(&self.function) {
            Some(function) => function.lambda().body.span,
            None => self.span,
        }
    }
}

fn script_function(value: &Value) -> Option<&ScriptFunction> {
    match value {
        Value::Function(Function::Closure(closure)) => closure.as_any().downcast_ref(),
        _ => None,
    }
}

/// Whether a value, or what a function took from around it, carries derivatives.
pub(super) fn holds_jets(value: &Value) -> bool {
    match value {
        value if value.is_jet() => true,
        Value::List(items) => items.iter().any(holds_jets),
        Value::Record(record) => record.iter().any(|(_, value)| holds_jets(value)),
        Value::Function(Function::Partial(partial)) => {
            let args = partial.positional.iter().flatten();
            let named = partial.named.iter().filter_map(|(_, arg)| arg.as_ref());
            args.chain(named).chain([&partial.callee]).any(holds_jets)
        }
        _ => {
            script_function(value).is_some_and(|function| function.captures.iter().any(holds_jets))
        }
    }
}

fn number(real: Real) -> Value {
    crate::value::Number { value: real, dim: Dimension::NONE }.into_value()
}

impl CurveFunction for GeometryFunction {
    fn derivatives_at(
        &self,
        t: f64,
        order: usize,
    ) -> std::result::Result<Vec<DVec3>, FunctionFailure> {
        let parameter = match order {
            0 => Real::Plain(t),
            _ => Real::Jet(Jet::variable(t, order)),
        };
        let coordinates = self.coordinates(&self.call(&[number(parameter)])?, 1)?;
        let derivative = |k| DVec3::from(coordinates.each_ref().map(|part| part.derivative(k, 0)));
        Ok((0..=order).map(derivative).collect())
    }
}

impl SurfaceFunction for GeometryFunction {
    fn derivatives_at(
        &self,
        u: f64,
        v: f64,
        order: usize,
    ) -> std::result::Result<Grid<DVec3>, FunctionFailure> {
        let parameters = match order {
            0 => [u, v].map(Real::Plain),
            _ => Jet::variables(u, v, order).map(Real::Jet),
        };
        let coordinates = self.coordinates(&self.call(&parameters.map(number))?, 2)?;
        Ok(Grid::from_fn(order + 1, order + 1, |k, l| {
            DVec3::from(coordinates.each_ref().map(|part| part.derivative(k, l)))
        }))
    }
}
