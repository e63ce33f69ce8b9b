//! Values that own what they need to answer.
//!
//! While a file runs, its values hold each other: a definition stays in the [`Globals`](super::globals::Globals) of
//! its file, and a function of the script reads from them whatever it uses. If functions owned them, nothing would
//! ever be freed, so that within a file they only know where its definitions lie. What leaves the run owns them:
//! [`OwningCopies`] makes the same value with functions, curves and surfaces that keep the definitions alive. No definition
//! holds such a value, so that there is no circle, and evaluation knows nothing of it.

use std::{any::Any, collections::HashMap, sync::Arc};

use super::{
    function::ScriptFunction,
    globals::KeptGlobals,
    outcome::{Defined, EffectOutput, TestOutcome},
};
use crate::{
    kernel::{Curve, Surface},
    value::{Function, Partial, Record, Value},
};

/// Makes values that own the definitions of a run. What two of them share they share afterwards.
pub(super) struct OwningCopies<'a> {
    globals: &'a KeptGlobals,
    kept: Arc<dyn Any + Send + Sync>,
    /// What was made of values by where these lie, which nobody frees as long as this lives.
    made: HashMap<*const (), (Value, Value)>,
}

impl<'a> OwningCopies<'a> {
    /// Of these definitions.
    pub(super) fn new(globals: &'a KeptGlobals) -> Self {
        Self { globals, kept: Arc::new(globals.clone()), made: HashMap::new() }
    }

    /// The same value, which answers as long as it lives.
    pub(super) fn owning(&mut self, value: &Value) -> Value {
        if !value.extent().holds_functions || owns(value) {
            return value.clone();
        }
        let Some(place) = place(value) else { return value.clone() };
        if let Some((_, made)) = self.made.get(&place) {
            return made.clone();
        }
        let made = self.made_of(value);
        self.made.insert(place, (value.clone(), made.clone()));
        made
    }

    fn made_of(&mut self, value: &Value) -> Value {
        match value {
            Value::List(items) => Value::List(items.iter().map(|item| self.owning(item)).collect()),
            Value::Record(record) => {
                let fields = record.iter().map(|(label, value)| (label.into(), self.owning(value)));
                Value::Record(Arc::new(Record::new(fields)))
            }
            Value::Function(Function::Partial(partial)) => {
                let Partial { callee, positional, named } = partial.as_ref();
                let positional = positional.iter().map(|arg| Some(self.owning(arg.as_ref()?)));
                let positional = positional.collect();
                let named = named.iter().map(|(label, arg)| {
                    (Arc::clone(label), arg.as_ref().map(|arg| self.owning(arg)))
                });
                let named = named.collect();
                let callee = self.owning(callee);
                Value::Function(Function::Partial(Arc::new(Partial { callee, positional, named })))
            }
            Value::Function(Function::Closure(closure)) => {
                let Some(function) = closure.as_any().downcast_ref::<ScriptFunction>() else {
                    return value.clone();
                };
                let captures = function.captures.iter().map(|value| self.owning(value)).collect();
                let kept = Some(self.globals.clone());
                let function = ScriptFunction { captures, kept, ..function.clone() };
                Value::Function(Function::Closure(Arc::new(function)))
            }
            Value::Curve(Curve::Parametric(curve)) => {
                let curve = curve.keeping(Arc::clone(&self.kept));
                Value::Curve(Curve::Parametric(Arc::new(curve)))
            }
            Value::Surface(Surface::Parametric(surface)) => {
                let surface = surface.keeping(Arc::clone(&self.kept));
                Value::Surface(Surface::Parametric(Arc::new(surface)))
            }
            other => other.clone(),
        }
    }

    /// Lets what a run tells own what it needs.
    pub(super) fn own(
        &mut self,
        definitions: &mut [Defined],
        outputs: &mut [EffectOutput],
        tests: &mut [TestOutcome],
    ) {
        for value in definitions.iter_mut().filter_map(|defined| defined.value.as_mut()) {
            *value = self.owning(value);
        }
        for output in outputs.iter_mut().chain(tests.iter_mut().flat_map(|test| &mut test.outputs))
        {
            match output {
                EffectOutput::Printed(printed) => printed.value = self.owning(&printed.value),
                EffectOutput::Exported(exported) => {
                    for subject in &mut exported.subjects {
                        subject.value.value = self.owning(&subject.value.value);
                    }
                }
                EffectOutput::Checked(_) | EffectOutput::Expected(_) => {}
            }
        }
    }
}

/// Whether a value left another run, and so owns what it needs already: it stays the very same.
fn owns(value: &Value) -> bool {
    if !value.extent().holds_functions {
        return true;
    }
    match value {
        Value::List(items) => items.iter().all(owns),
        Value::Record(record) => record.iter().all(|(_, value)| owns(value)),
        Value::Function(Function::Partial(partial)) => {
            let named = partial.named.iter().filter_map(|(_, arg)| arg.as_ref());
            partial.positional.iter().flatten().chain(named).chain([&partial.callee]).all(owns)
        }
        Value::Function(Function::Closure(closure)) => {
            let function = closure.as_any().downcast_ref::<ScriptFunction>();
            function.is_none_or(|function| function.kept.is_some())
        }
        Value::Curve(Curve::Parametric(curve)) => curve.is_keeping(),
        Value::Surface(Surface::Parametric(surface)) => surface.is_keeping(),
        _ => true,
    }
}

/// Adds the definitions that functions in a value own: what they answer may need them too.
pub(super) fn add_owned(value: &Value, globals: &mut KeptGlobals) {
    if !value.extent().holds_functions {
        return;
    }
    match value {
        Value::List(items) => items.iter().for_each(|item| add_owned(item, globals)),
        Value::Record(record) => record.iter().for_each(|(_, value)| add_owned(value, globals)),
        Value::Function(Function::Partial(partial)) => {
            let named = partial.named.iter().filter_map(|(_, arg)| arg.as_ref());
            let args = partial.positional.iter().flatten().chain(named);
            args.chain([&partial.callee]).for_each(|value| add_owned(value, globals));
        }
        Value::Function(Function::Closure(closure)) => {
            let Some(function) = closure.as_any().downcast_ref::<ScriptFunction>() else { return };
            function.kept.iter().for_each(|kept| globals.keep(kept));
            function.captures.iter().for_each(|value| add_owned(value, globals));
        }
        _ => {}
    }
}

/// Where a value lies that can hold functions.
fn place(value: &Value) -> Option<*const ()> {
    Some(match value {
        Value::List(items) => items.as_ptr().cast(),
        Value::Record(record) => Arc::as_ptr(record).cast(),
        Value::Function(Function::Closure(closure)) => Arc::as_ptr(closure).cast(),
        Value::Function(Function::Partial(partial)) => Arc::as_ptr(partial).cast(),
        Value::Curve(Curve::Parametric(curve)) => Arc::as_ptr(curve).cast(),
        Value::Surface(Surface::Parametric(surface)) => Arc::as_ptr(surface).cast(),
        _ => return None,
    })
}
