//! The set of known operations.

use std::{collections::BTreeMap, sync::Arc};

use super::{Call, Op, OpParameter, Type, Value};

/// Operations by name. The evaluator, the help, the completion and the reference read this and
/// nothing else. One name may have several operations, told apart by their first argument.
#[derive(Debug, Default)]
pub struct Registry {
    by_name: BTreeMap<&'static str, Arc<[&'static Op]>>,
    constants: &'static [Constant],
}

/// A built-in value with a name.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    /// What scripts call it.
    pub name: &'static str,
    /// What it is.
    pub docs: &'static str,
    /// Its value.
    pub value: fn() -> Value,
}

impl Registry {
    /// The operations called `name`; aliases count.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<(&'static str, &Arc<[&'static Op]>)> {
        self.by_name.get_key_value(name).map(|(&name, ops)| (name, ops))
    }

    /// Whether a call of `name` names a script.
    #[must_use]
    pub fn names_script(&self, name: &str) -> bool {
        self.get(name).is_some_and(|(_, ops)| ops.iter().any(|op| op.names_script))
    }

    /// The same operations, and these constants.
    #[must_use]
    pub fn with_constants(self, constants: &'static [Constant]) -> Self {
        Self { constants, ..self }
    }

    /// The constant called `name`.
    #[must_use]
    pub fn constant(&self, name: &str) -> Option<&'static Constant> {
        self.constants.iter().find(|constant| constant.name == name)
    }

    /// Every constant.
    #[must_use]
    pub fn constants(&self) -> &'static [Constant] {
        self.constants
    }

    /// Every name of an operation or constant, aliases included.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.by_name.keys().copied().chain(self.constants.iter().map(|constant| constant.name))
    }

    /// Every operation once, by name.
    pub fn iter(&self) -> impl Iterator<Item = &'static Op> {
        self.by_name
            .iter()
            .flat_map(|(&name, ops)| ops.iter().copied().filter(move |op| op.name == name))
    }
}

impl FromIterator<&'static Op> for Registry {
    fn from_iter<I: IntoIterator<Item = &'static Op>>(ops: I) -> Self {
        let names = |op: &'static Op| std::iter::once(op.name).chain(op.aliases.iter().copied());
        let mut named: Vec<(&'static str, &'static Op)> =
            ops.into_iter().flat_map(|op| names(op).map(move |name| (name, op))).collect();
        // Of one name they stay in their order.
        named.sort_by_key(|&(name, _)| name);
        let by_name = named
            .chunk_by(|(one, _), (next, _)| one == next)
            .map(|same| (same[0].0, same.iter().map(|&(_, op)| op).collect()))
            .collect();
        Self { by_name, constants: &[] }
    }
}

impl Op {
    /// Whether its first argument can be such a value, or where it is a list without its brackets, its first element.
    #[must_use]
    pub fn takes_first(&self, value: &Value) -> bool {
        self.params.first().is_some_and(|param| {
            let element = match param.ty {
                Type::List(of, _) if param.spreads => of.accepts(value),
                _ => false,
            };
            element || param.ty.accepts(value)
        })
    }

    /// Whether it has a place for so many arguments by position and for those with these labels.
    #[must_use]
    pub fn has_places<'l>(
        &self,
        n_positional: usize,
        mut labels: impl Iterator<Item = &'l str>,
    ) -> bool {
        let by_position = |param: &&OpParameter| !param.may_be_left_out() || param.by_position;
        n_positional <= self.params.iter().filter(by_position).count()
            && labels.all(|label| self.params.iter().any(|param| param.name == label))
    }
}

/// The operation among `ops` that takes `first` as its first argument; among several such the
/// first that has a place for every argument.
///
/// With one operation there is no choice: what does not fit is told when arguments are read.
///
/// # Errors
/// A sentence on what the first argument may be.
pub fn choose(
    ops: &[&'static Op],
    first: Option<&Value>,
    call: &Call,
) -> Result<&'static Op, String> {
    let has_places = |op: &&&'static Op| {
        let labels = call.named.iter().map(|(label, _)| &*label.value);
        op.has_places(call.positional.len(), labels)
    };
    match (ops, first) {
        ([only], _) | ([only, ..], None) => Ok(only),
        (_, Some(value)) => {
            let mut taking = ops.iter().filter(|op| op.takes_first(value));
            let first = taking.clone().next();
            // Of a list without its brackets the operation itself tells.
            let loose = |op: &&&'static Op| {
                op.params.first().is_some_and(|param| param.ty.is_list_of(value))
            };
            let loose = || ops.iter().find(loose);
            taking.find(has_places).or(first).or_else(loose).copied().ok_or_else(|| {
                let firsts = ops.iter().filter_map(|op| op.params.first());
                let wanted = Type::phrase_of_any(firsts.map(|param| param.ty));
                format!("takes {wanted}, found {}", value.phrase())
            })
        }
        ([], None) => Err("is not there".to_owned()),
    }
}
