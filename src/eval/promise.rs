//! Promises: that a value is of the kind that its definition's keyword tells, that a list has as
//! many elements as the pattern that takes it apart.

use super::{
    ir::{Expr, Kind},
    machine::Machine,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    value::Value,
};

impl Machine<'_> {
    pub(super) fn exactly(&mut self, list: &Expr, n: usize) -> Result<Value> {
        let value = self.eval(list)?;
        match &value {
            Value::List(items) if items.len() == n => Ok(value),
            other => {
                let message = format!("the pattern takes a list of {n}, found {}", other.phrase());
                Diagnostic::error(Code::WrongKind, list.span, message).fail()
            }
        }
    }

    pub(super) fn promise(&mut self, expr: &Expr, kind: Kind, name: Span) -> Result<Value> {
        let value = self.eval(expr)?;
        if keeps(kind, &value) {
            return Ok(value);
        }
        let promised = match kind {
            Kind::Points | Kind::Curves | Kind::Surfaces | Kind::Meshes | Kind::Tables => {
                format!("a list of {}", kind.word())
            }
            _ => format!("a {}", kind.word()),
        };
        let message = format!("{promised} is promised, but this is {}", value.phrase());
        Diagnostic::error(Code::BrokenPromise, expr.span, message)
            .label(format!("this is {}", value.phrase()))
            .also(name, format!("promised to be {promised} here"))
            .hint(match fitting(&value) {
                Some(word) => format!("write `{word}` instead, or `let`"),
                None => "write `let` instead".to_owned(),
            })
            .fail()
    }
}

/// Whether `value` is what `kind` promises.
fn keeps(kind: Kind, value: &Value) -> bool {
    let all = |wanted: &str| match value {
        Value::List(items) => items.iter().all(|item| item.kind() == wanted),
        _ => false,
    };
    match kind {
        Kind::Let => true,
        Kind::Point | Kind::Curve | Kind::Surface | Kind::Mesh | Kind::Table => {
            value.kind() == kind.word()
        }
        Kind::Points => all("point"),
        Kind::Curves => all("curve"),
        Kind::Surfaces => all("surface"),
        Kind::Meshes => all("mesh"),
        Kind::Tables => all("table"),
    }
}

/// The keyword that promises what `value` is.
fn fitting(value: &Value) -> Option<&'static str> {
    Kind::ALL
        .iter()
        .find(|&&(_, kind)| kind != Kind::Let && keeps(kind, value))
        .map(|&(word, _)| word)
}
