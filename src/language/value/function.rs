//! Values that can be called.

use std::{any::Any, fmt::Debug, sync::Arc};

use super::{Op, Value, list::ValueExtent};

/// A function of the script. The evaluator makes it and knows how to call it; everyone else sees
/// its name and parameters.
pub trait Closure: Any + Debug + Send + Sync {
    /// The signature as it was declared: `fn radius(h)` or `(x, y) => ...`.
    fn signature(&self) -> String;
    /// How deep and how large it is with what it took from around it.
    fn extent(&self) -> ValueExtent;
    /// For the evaluator to recognise its own.
    fn as_any(&self) -> &dyn Any;
}

/// A function as a value.
#[derive(Clone, Debug)]
pub enum Function {
    /// A built-in.
    Builtin(&'static str, Arc<[&'static Op]>),
    /// A function of the script.
    Closure(Arc<dyn Closure>),
    /// A call with places left open by `_`.
    Partial(Arc<Partial>),
}

/// A call that waits for the arguments at its placeholders.
#[derive(Clone, Debug)]
pub struct Partial {
    /// What is called.
    pub callee: Value,
    /// Positional arguments; `None` is a placeholder.
    pub positional: Vec<Option<Value>>,
    /// Named arguments; `None` is a placeholder.
    pub named: Vec<(Arc<str>, Option<Value>)>,
}

impl Function {
    /// How deep and how large it is with what it holds.
    #[must_use]
    pub fn extent(&self) -> ValueExtent {
        match self {
            Self::Builtin(..) => ValueExtent::ATOM,
            Self::Closure(closure) => closure.extent(),
            Self::Partial(partial) => {
                let positional = partial.positional.iter().flatten();
                let named = partial.named.iter().filter_map(|(_, arg)| arg.as_ref());
                ValueExtent::around(positional.chain(named).chain([&partial.callee]))
            }
        }
    }

    /// The signature of each way to call it, each on one line.
    #[must_use]
    pub fn signatures(&self) -> Vec<String> {
        match self {
            Self::Builtin(_, ops) => ops.iter().map(|op| op.signature()).collect(),
            _ => vec![self.signature()],
        }
    }

    /// Its signature on one line, that of the first way to call it.
    #[must_use]
    pub fn signature(&self) -> String {
        match self {
            Self::Builtin(name, ops) => {
                ops.first().map_or_else(|| (*name).to_owned(), |op| op.signature())
            }
            Self::Closure(closure) => closure.signature(),
            Self::Partial(partial) => match &partial.callee {
                Value::Function(function) => {
                    format!("{} with places left open", function.signature())
                }
                other => format!("a {} with places left open", other.kind()),
            },
        }
    }
}
