//! Advice: the built-in that was meant where a field, a call or a first argument does not fit.
//!
//! The registry knows what takes a value as its first argument; a name that is near does the rest.

use super::{
    env::Env,
    ir::{Expr, ExprKind},
};
use crate::{
    diag::{Code, Diagnostic, Span, nearest},
    kernel::sorting::sort_by_key,
    value::{Op, Registry, Type, Value},
};

/// Characters of an expression that advice repeats.
const MOST_REPEATED: usize = 40;
/// Calls that advice lists.
const MOST_LISTED: usize = 4;
/// Letters from which the beginning of a name says what is meant.
const FEWEST_LETTERS: usize = 3;

impl Env<'_> {
    /// The text at a place, white space folded; none where it is long or not at hand.
    pub(super) fn repeated(&self, span: Span) -> Option<String> {
        let source = self.sources?.at(span)?;
        let text = source.text.get(source.local(span))?;
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        (!text.is_empty() && text.chars().count() <= MOST_REPEATED).then_some(text)
    }

    /// What to write for `subject.name`, where a built-in answers what is no field.
    pub(super) fn instead_of_field(
        &self,
        subject: Span,
        value: &Value,
        name: &str,
    ) -> Option<String> {
        let op = asked_by_name(self.registry?, value, name)?;
        let subject = self.repeated(subject).unwrap_or_else(|| first_name(op).to_owned());
        Some(format!("`{}` is asked by a call: write `{}`", op.name, call_of(op, &subject)))
    }

    /// The mistake in a call, with a word on the built-in whose name the callee takes away.
    pub(super) fn told_of_hidden(&self, callee: &Expr, found: Box<Diagnostic>) -> Box<Diagnostic> {
        let is_own = matches!(
            callee.kind,
            ExprKind::Local(_) | ExprKind::Captured(_) | ExprKind::Sibling(_) | ExprKind::Global(_)
        );
        if !is_own || !matches!(found.code, Code::NotCallable | Code::BadCall) {
            return found;
        }
        let name = self.repeated(callee.span);
        let Some((name, ops)) = name.and_then(|name| self.registry?.get(&name)) else {
            return found;
        };
        let signatures: Vec<String> =
            ops.iter().take(1).map(|op| format!("`{}`", op.signature())).collect();
        let hint = format!(
            "`{name}` is the script's own here, which hides the built-in {}; give it another name to call that one",
            signatures.concat()
        );
        Box::new(found.hint(hint))
    }

    /// The built-ins near in name to `op` that take `value`, where `op` takes other things.
    pub(super) fn others_for(&self, op: &Op, value: &Value) -> Option<String> {
        let is_last = |word: &str| op.name.rsplit('_').next() == Some(word);
        let kin = |other: &Op| {
            let shared =
                other.name.split('_').filter(|word| op.name.split('_').any(|own| own == *word));
            shared.map(|word| if is_last(word) { 2 } else { 1 }).max()
        };
        let mut found: Vec<(u8, &Op)> = self
            .registry?
            .iter()
            .filter(|other| other.name != op.name && other.family == op.family)
            .filter(|other| takes(other, value))
            .filter_map(|other| Some((kin(other)?, other)))
            .collect();
        sort_by_key(&mut found, |&(kin, other)| (3 - kin, other.name));
        let calls: Vec<String> = found
            .iter()
            .take(MOST_LISTED)
            .map(|(_, other)| format!("`{}`", call_of(other, first_name(other))))
            .collect();
        (!calls.is_empty()).then(|| format!("of a {} ask {}", value.kind(), calls.join(", ")))
    }
}

/// The built-in that `name` asks of `value`: by that name, by its beginning, by one that is near.
fn asked_by_name<'r>(registry: &'r Registry, value: &Value, name: &str) -> Option<&'r Op> {
    let fitting = || registry.iter().filter(|op| takes(op, value));
    let open = || registry.iter().filter(|op| takes(op, value) || takes_any(op));
    let is_called = |op: &&Op| op.name == name || op.aliases.contains(&name);
    let begins = |op: &&Op| {
        let shorter = op.name.len().min(name.len());
        FEWEST_LETTERS <= shorter && (op.name.starts_with(name) || name.starts_with(op.name))
    };
    open().find(is_called).or_else(|| open().find(begins)).or_else(|| {
        let near = nearest(name, fitting().map(|op| op.name))?;
        fitting().find(|op| op.name == near)
    })
}

/// Whether the first argument may be such a value.
fn takes(op: &Op, value: &Value) -> bool {
    !takes_any(op) && op.params.first().is_some_and(|param| param.ty.accepts(value))
}

/// Whether the first argument may be anything, so that its kind says nothing.
fn takes_any(op: &Op) -> bool {
    op.params.first().is_some_and(|param| param.ty == Type::Any)
}

fn first_name(op: &Op) -> &'static str {
    op.params.first().map_or("_", |param| param.name)
}

/// The shortest call of `op` with `subject` as its first argument.
fn call_of(op: &Op, subject: &str) -> String {
    let rest = op.params.iter().skip(1).filter(|param| !param.may_be_left_out());
    let rest: String = rest.map(|param| format!(", {}", param.name)).collect();
    format!("{}({subject}{rest})", op.name)
}
