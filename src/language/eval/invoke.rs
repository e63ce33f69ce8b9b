//! A call of a built-in by a program, without any script around it.

use std::sync::Arc;

use super::{
    env::Env,
    globals::{Globals, KeptGlobals},
    machine::Machine,
    ownership::{OwningCopies, add_owned},
    settings::Settings,
};
use crate::{
    diag::{Diagnostic, Result, fault},
    kernel::Tolerance,
    syntax::ast::Unit,
    value::{Call, Value},
};

/// What the value `callee` answers to a call in a document of this unit and tolerance, and what it warns of.
pub(crate) fn invoke(
    callee: &Value,
    call: Call,
    (unit, tolerance): (Unit, Tolerance),
    settings: Settings<'_>,
) -> (Result<Value>, Vec<Diagnostic>) {
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
    // A curve of a function asks it in the file that made it.
    let mut kept = KeptGlobals::new(vec![Arc::clone(&machine.home)]);
    let named = call.named.iter().map(|(_, value)| value);
    let given = call.positional.iter().chain(named).map(|given| &given.value);
    given.chain([callee]).for_each(|value| add_owned(value, &mut kept));
    let answer = fault::caught(span, || machine.invoke(callee, call, span));
    let answer = answer.map(|value| OwningCopies::new(&kept).owning(&value.looked_at()));
    (answer, machine.warnings)
}
