//! Signatures of a call while its arguments are written.

use super::{
    Document, NameRole, Outline, Values, completion_spot::CompletionSpot, hover, owner::Owner,
};
use crate::{
    docs,
    kernel::sorting::sort_by_key,
    session::Session,
    syntax::{OpenCall, open_call},
    value::{Function, Op, OpParameter, Type, Value},
};

/// A way to call what is being called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CalledSignature {
    /// All of it on one line.
    pub label: String,
    /// What it does, as Markdown.
    pub docs: String,
    /// Its parameters.
    pub parameters: Vec<SignatureParameter>,
    /// The parameter that is being written.
    pub active: Option<usize>,
}

/// A parameter of a signature.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignatureParameter {
    /// Its part of the signature.
    pub label: String,
    /// What it is, as Markdown.
    pub docs: String,
}

impl Document {
    /// The ways to call what is being called at a byte, the likeliest first. `values` are of the last run, if there was
    /// one.
    #[must_use]
    pub fn signatures(
        &self,
        session: &Session,
        values: Option<&Values>,
        at: usize,
    ) -> Vec<CalledSignature> {
        let registry = session.registry();
        let Some(call) = self.call_around(at) else { return Vec::new() };
        let own = self.outline.of_file().chain(self.imported.iter().flat_map(Outline::of_file));
        let mut own = own.filter(|name| name.name == call.name && name.role == NameRole::Function);
        if let Some(function) = own.next() {
            let parameters = function.parameters.iter().map(hover::parameter).collect();
            let label = hover::signature(function);
            let docs = function.docs.as_deref().map(docs::paragraph).unwrap_or_default();
            return vec![CalledSignature { docs, ..of_script(label, parameters, &call) }];
        }
        let spot = CompletionSpot { document: self, session, registry, values, at: call.start };
        let is_defined = call.callee != call.name || spot.defined(call.name).is_some();
        match registry.get(call.name) {
            Some((_, ops)) if !is_defined => of_ops(ops, &call),
            _ => spot.owner(call.callee).map(|owner| of_value(&owner, &call)).unwrap_or_default(),
        }
    }

    /// The innermost call that is open at a byte, around points, lists and records.
    fn call_around(&self, at: usize) -> Option<OpenCall<'_>> {
        let mut open = Vec::new();
        for (idx, (_, place)) in self.pieces.iter().enumerate() {
            if at < place.end {
                break;
            }
            match self.piece(idx) {
                "(" | "[" | "{" => open.push(place.start),
                ")" | "]" | "}" => {
                    open.pop();
                }
                _ => {}
            }
        }
        let inner = open_call(&self.text, at);
        inner.or_else(|| open.into_iter().rev().find_map(|place| open_call(&self.text, place)))
    }
}

/// A function of a script that takes these parameters, each with its default.
fn of_script(label: String, parameters: Vec<String>, call: &OpenCall<'_>) -> CalledSignature {
    let name = |parameter: &String| parameter.split(" = ").next().unwrap_or_default().to_owned();
    let names: Vec<String> = parameters.iter().map(name).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    CalledSignature {
        label,
        docs: String::new(),
        active: active(call, &names, names.len()),
        parameters: parameters
            .into_iter()
            .map(|label| SignatureParameter { label, docs: String::new() })
            .collect(),
    }
}

/// Operations of one name, those that the arguments may be for before.
fn of_ops(ops: &[&Op], call: &OpenCall<'_>) -> Vec<CalledSignature> {
    let parameter = |param: &OpParameter| SignatureParameter {
        label: param.signature(),
        docs: docs::paragraph(param.docs),
    };
    let signature = |op: &&Op| CalledSignature {
        label: op.signature(),
        docs: docs::paragraph(op.docs),
        active: active_parameter(op, call),
        parameters: op.params.iter().map(parameter).collect(),
    };
    let mut found: Vec<CalledSignature> = ops.iter().map(signature).collect();
    sort_by_key(&mut found, |signature| signature.active.is_none());
    found
}

/// A value that is called: a function, or geometry with parameters.
fn of_value(owner: &Owner, call: &OpenCall<'_>) -> Vec<CalledSignature> {
    let plain = |parameters: &[&str], docs: &str| {
        let label = format!("{}({})", call.callee, parameters.join(", "));
        let parameters = parameters.iter().map(|&name| name.to_owned()).collect();
        vec![CalledSignature { docs: docs.to_owned(), ..of_script(label, parameters, call) }]
    };
    match owner {
        Owner::Function(names) => {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            plain(&names, "")
        }
        Owner::Value(Value::Function(Function::Builtin(_, ops))) => of_ops(ops, call),
        Owner::Value(Value::Function(function)) => function
            .signatures()
            .into_iter()
            .map(|label| {
                let inside = label.split_once('(').map_or("", |(_, rest)| rest);
                let inside = inside.rsplit_once(')').map_or("", |(inside, _)| inside);
                let parameters = inside.split(", ").filter(|name| !name.is_empty());
                let parameters = parameters.map(str::to_owned).collect();
                // One without a name has that by which it is called.
                let label = match label.starts_with('(') {
                    true => format!("{}({inside})", call.callee),
                    false => label.clone(),
                };
                of_script(label, parameters, call)
            })
            .collect(),
        Owner::Value(Value::Curve(_)) | Owner::Type(Type::Curve) => {
            plain(&["t"], "The point of the curve at parameter `t`.")
        }
        Owner::Value(Value::Surface(_) | Value::Face(_))
        | Owner::Type(Type::Surface | Type::Face) => {
            plain(&["u", "v"], "The point of the surface at parameters `u` and `v`.")
        }
        _ => Vec::new(),
    }
}

/// Which of the parameters of these names, of which so many can be given by position, is being given.
fn active(call: &OpenCall<'_>, names: &[&str], n_by_position: usize) -> Option<usize> {
    match call.label {
        Some(label) => names.iter().position(|name| *name == label),
        None => (0..names.len())
            .filter(|&idx| idx < n_by_position && !call.labels.contains(&names[idx]))
            .nth(call.position),
    }
}

/// How many parameters of an operation can be given by position.
fn count_by_position(op: &Op) -> usize {
    let is_one = |param: &&OpParameter| !param.may_be_left_out() || param.by_position;
    op.params.iter().take_while(is_one).count()
}

/// The parameter of an operation that is being given.
pub(super) fn active_parameter(op: &Op, call: &OpenCall<'_>) -> Option<usize> {
    let names: Vec<&str> = op.params.iter().map(|param| param.name).collect();
    let spreads = op.params.first().is_some_and(|param| param.spreads);
    active(call, &names, count_by_position(op))
        .or_else(|| (spreads && call.label.is_none()).then_some(0))
}

/// The parameters of an operation that a call has not given yet.
pub(super) fn left_to_give<'o>(
    op: &'o Op,
    call: &OpenCall<'_>,
) -> impl Iterator<Item = &'o OpParameter> {
    let spreads = op.params.first().is_some_and(|param| param.spreads);
    let is_left = |param: &OpParameter| !call.labels.contains(&param.name);
    let n_by_position = count_by_position(op);
    let mut n_given = if spreads { call.position.min(1) } else { call.position };
    let mut left = Vec::new();
    for (idx, param) in op.params.iter().enumerate().filter(|(_, param)| is_left(param)) {
        if idx < n_by_position && 0 < n_given {
            n_given -= 1;
        } else {
            left.push(param);
        }
    }
    left.into_iter()
}
