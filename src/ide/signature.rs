//! Signatures of a call while its arguments are written.

use super::{Document, NameRole, Outline, hover};
use crate::{
    docs,
    kernel::sorting::sort_by_key,
    syntax::{OpenCall, open_call},
    value::{Op, Registry},
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
    /// The ways to call what is being called at a byte, the likeliest first.
    #[must_use]
    pub fn signatures(&self, registry: &Registry, at: usize) -> Vec<CalledSignature> {
        let Some(call) = self.call_around(at) else { return Vec::new() };
        let own = self.outline.of_file().chain(self.imported.iter().flat_map(Outline::of_file));
        let mut own = own.filter(|name| name.name == call.name && name.role == NameRole::Function);
        if let Some(function) = own.next() {
            let names: Vec<&str> =
                function.parameters.iter().map(|(name, _)| name.as_str()).collect();
            return vec![CalledSignature {
                label: hover::signature(function),
                docs: function.docs.as_deref().map(docs::paragraph).unwrap_or_default(),
                active: active(&call, &names, names.len()),
                parameters: function
                    .parameters
                    .iter()
                    .map(|parameter| SignatureParameter {
                        label: hover::parameter(parameter),
                        docs: String::new(),
                    })
                    .collect(),
            }];
        }
        let Some((_, ops)) = registry.get(call.name) else { return Vec::new() };
        let mut found: Vec<CalledSignature> = ops
            .iter()
            .map(|op| CalledSignature {
                label: op.signature(),
                docs: docs::paragraph(op.docs),
                active: active_parameter(op, &call),
                parameters: op
                    .params
                    .iter()
                    .map(|param| SignatureParameter {
                        label: param.signature(),
                        docs: docs::paragraph(param.docs),
                    })
                    .collect(),
            })
            .collect();
        sort_by_key(&mut found, |signature| signature.active.is_none());
        found
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
    let is_one = |param: &&crate::value::OpParameter| !param.may_be_left_out() || param.by_position;
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
) -> impl Iterator<Item = &'o crate::value::OpParameter> {
    let spreads = op.params.first().is_some_and(|param| param.spreads);
    let is_left = |param: &crate::value::OpParameter| !call.labels.contains(&param.name);
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
