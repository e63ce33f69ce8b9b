//! Functions of the script as values.

use std::sync::{Arc, Weak};

use super::{
    globals::{Globals, KeptGlobals},
    ir::{Group, Lambda},
};
use crate::value::{Closure, Function, List, Value, ValueExtent};

/// A function of the script with what it took from around it.
#[derive(Clone, Debug)]
pub(crate) struct ScriptFunction {
    pub(crate) group: Arc<Group>,
    pub(crate) idx: usize,
    pub(crate) captures: List,
    /// The file that it belongs to, which holds it.
    pub(crate) home: Weak<Globals>,
    /// What it owns of the run, once it has left it.
    pub(crate) kept: Option<KeptGlobals>,
}

impl ScriptFunction {
    pub(crate) fn lambda(&self) -> &Lambda {
        &self.group.lambdas[self.idx]
    }

    /// A function that was defined together with it.
    pub(super) fn sibling(&self, idx: usize) -> Value {
        Value::Function(Function::Closure(Arc::new(Self { idx, ..self.clone() })))
    }
}

impl Closure for ScriptFunction {
    fn signature(&self) -> String {
        let lambda = self.lambda();
        let parameters: Vec<String> = lambda
            .parameters
            .iter()
            .map(|parameter| match parameter.default {
                Some(_) => format!("{} = ...", parameter.name),
                None => parameter.name.to_string(),
            })
            .collect();
        match &lambda.name {
            Some(name) => format!("{name}({})", parameters.join(", ")),
            None => format!("({}) => ...", parameters.join(", ")),
        }
    }

    fn extent(&self) -> ValueExtent {
        ValueExtent { holds_functions: true, ..self.captures.extent() }
    }

    fn as_any(&self) -> &dyn std::any::Any {
        self
    }
}
