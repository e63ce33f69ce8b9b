//! A call of a built-in by a program, without any script around it.

use std::sync::Arc;

use super::{
    env::Env,
    globals::{Globals, KeptGlobals},
    machine::Machine,
    settings::Settings,
};
use crate::{
    diag::{Diagnostic, Result, fault},
    kernel::Tolerance,
    syntax::ast::Unit,
    value::{Call, Value},
};

/// What the value `callee` answers to a call in a document of this unit and tolerance, what it warns of,
/// and what the answer needs to answer itself.
pub(crate) fn invoke(
    callee: &Value,
    call: Call,
    (unit, tolerance): (Unit, Tolerance),
    settings: Settings<'_>,
) -> (Result<Value>, Vec<Diagnostic>, KeptGlobals) {
    let env = Env {
        limits: settings.limits,
        n_threads: settings.n_threads,
        files: settings.files,
        tolerance,
        unit,
        registry: Some(settings.registry),
        library: None,
        sources: None,
        gauge: settings.gauge,
        stop: settings.stop,
    };
    let mut machine = Machine::new(env, Arc::<Globals>::default());
    machine.prepare(0);
    let span = call.span;
    let answer = fault::caught(span, || machine.invoke(callee, call, span));
    let kept = KeptGlobals::new(vec![machine.home]);
    (answer.map(|value| value.looked_at()), machine.warnings, kept)
}
