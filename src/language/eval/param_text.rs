//! Texts that parameters are given from outside, as values.

use std::sync::Arc;

use super::{
    env::Env,
    ir::{Expr, ExprKind, ParamKind},
    lower,
    machine::Machine,
    settings::Setting,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    limits::Limits,
    syntax,
    value::{Registry, Value},
};

/// The value of a setting: a string as it is, anything else as an expression without names.
pub(super) fn read(
    env: Env<'_>,
    kind: ParamKind,
    setting: &Setting,
    span: Span,
    registry: &Registry,
) -> Result<Value> {
    if kind == ParamKind::Text {
        return Ok(Value::text(&setting.text));
    }
    let source = format!("let value = {}", setting.text);
    literal(env, &source, registry).ok_or_else(|| {
        let message = format!(
            "{setting} is \"{}\", which is not a value that a script could write",
            setting.text
        );
        Box::new(
            Diagnostic::error(Code::BadParameterValue, span, message)
                .hint(advice(kind, &setting.text)),
        )
    })
}

/// What to write for a parameter of a kind in the place of a text that says nothing.
fn advice(kind: ParamKind, text: &str) -> String {
    let with_point = text.replacen(',', ".", 1);
    let is_decimal = with_point.trim_end_matches(char::is_alphabetic).parse::<f64>().is_ok();
    if text.contains(',') && is_decimal {
        return format!("the decimal sign is a point: `{with_point}`");
    }
    if let Some((number, unit)) = text.trim().split_once(char::is_whitespace)
        && number.parse::<f64>().is_ok()
        && unit.trim_start().chars().all(char::is_alphabetic)
    {
        return format!("a unit stands right behind its number: `{number}{}`", unit.trim_start());
    }
    match kind {
        ParamKind::Bool => "it is `true` or `false`".to_owned(),
        ParamKind::Integer => "it is a whole number, such as `7`".to_owned(),
        ParamKind::Number => "it is a number, such as `7` or `0.5`".to_owned(),
        ParamKind::Length => "it is a length, such as `15mm`".to_owned(),
        ParamKind::Angle => "it is an angle, such as `30deg`".to_owned(),
        ParamKind::Text => "it is a text, as it stands".to_owned(),
    }
}

fn literal(env: Env<'_>, source: &str, registry: &Registry) -> Option<Value> {
    let limits: &Limits = env.limits;
    let (tree, diagnostics) = syntax::parse(source, limits);
    if !diagnostics.is_empty() || tree.statements.len() != 1 {
        return None;
    }
    let lowered = lower::lower(&tree, lower::Origin::default(), registry, env.unit);
    let definition = lowered.program.definitions.first()?;
    let value: &Expr = &definition.value;
    let is_poison = matches!(value.kind, ExprKind::Poison);
    if !lowered.diagnostics.is_empty()
        || !definition.dependencies.is_empty()
        || is_poison
        || !lowered.scripts.is_empty()
    {
        return None;
    }
    // Its places are not those of the script.
    let env = Env { sources: None, ..env };
    Machine::new(env, Arc::default()).run(value, definition.n_slots).ok()
}
