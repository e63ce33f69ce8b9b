//! Promises: that a value is of the kind that its definition's keyword tells, that a list has as
//! many elements as the pattern that takes it apart.

use super::{
    ir::{Element, Expr, ExprKind, Kind},
    machine::Machine,
};
use crate::{
    diag::{Code, Diagnostic, Fix, Result, Span},
    value::{Type, Value},
};

impl Machine<'_> {
    #[inline(never)]
    pub(super) fn exactly(&mut self, list: &Expr, n: usize) -> Result<Value> {
        let value = self.eval(list)?;
        match &value {
            Value::List(items) if items.len() == n => Ok(value),
            other => {
                let message = format!("the pattern takes a list of {n}, found {}", other.phrase());
                let found = Diagnostic::error(Code::WrongKind, list.span, message);
                match other {
                    Value::List(items) if 0 < n && n < items.len() => found
                        .hint(format!(
                            "name each element, or take as many as there are names: `list[0..{}]`",
                            n - 1
                        ))
                        .fail(),
                    Value::List(items) if items.len() < n => {
                        found.hint("there are more names than elements").fail()
                    }
                    _ => found.fail(),
                }
            }
        }
    }

    #[inline(never)]
    pub(super) fn promise(&mut self, expr: &Expr, kind: Kind, name: Span) -> Result<Value> {
        let value = self.eval(expr)?;
        if keeps(kind, &value) {
            self.warn_of_point(expr, &value);
            return Ok(value);
        }
        let promised = match element_of(kind) {
            Some(_) => format!("a list of {}", kind.word()),
            None => format!("a {}", kind.word()),
        };
        if let Some(found) = stranger(expr, &value, kind, &promised) {
            let fix =
                self.keyword_before(kind.word(), name).map(|place| Fix::replace(place, "let"));
            let found = found
                .also(name, format!("promised to be {promised} here"))
                .hint("leave it out, or write `let` for a list of several kinds");
            return fix.into_iter().fold(found, Diagnostic::fix).fail();
        }
        let message = format!("{promised} is promised, but this is {}", value.phrase());
        let word = fitting(&value).unwrap_or("let");
        let fix = self.keyword_before(kind.word(), name).map(|place| Fix::replace(place, word));
        let found = Diagnostic::error(Code::BrokenPromise, expr.span, message)
            .label(format!("this is {}", value.phrase()))
            .also(name, format!("promised to be {promised} here"))
            .hint(match fitting(&value) {
                Some(word) => format!("write `{word}` instead, or `let`"),
                None => "write `let` instead".to_owned(),
            });
        let remedy = type_of(kind).and_then(|of| of.remedy(&value));
        let found = remedy.into_iter().fold(found, Diagnostic::hint);
        fix.into_iter().fold(found, Diagnostic::fix).fail()
    }
}

impl Machine<'_> {
    /// The place of a keyword right before a defined name.
    fn keyword_before(&self, word: &str, name: Span) -> Option<Span> {
        let source = self.env.sources?.at(name)?;
        let before = source.text[..source.local(name).start].trim_end();
        let start = before.strip_suffix(word)?.len() as u32 + source.base;
        Some(Span::new(start, start + word.len() as u32))
    }

    /// Warns of a promised curve that is one point. Inside of calls such curves have their uses.
    fn warn_of_point(&mut self, expr: &Expr, value: &Value) {
        let Value::Curve(curve) = value else { return };
        let Ok(spline) = curve.nurbs() else { return };
        let points = spline.points();
        if points.iter().any(|&point| point != points[0]) {
            return;
        }
        let point = Value::Point(spline.start());
        let message = format!("this curve is one point, {point}");
        self.warnings.push(
            Diagnostic::warning(Code::DegenerateResult, expr.span, message).hint(
                "give points that differ, or write `let` where a curve of no length is meant",
            ),
        );
    }
}

/// Whether `value` is what `kind` promises.
fn keeps(kind: Kind, value: &Value) -> bool {
    match (element_of(kind), value) {
        _ if kind == Kind::Let => true,
        (None, _) => value.kind() == kind.word(),
        (Some(element), Value::List(items)) => items.iter().all(|item| item.kind() == element),
        (Some(_), _) => false,
    }
}

/// The first element of another kind, where others of the list keep the promise.
fn stranger(expr: &Expr, value: &Value, kind: Kind, promised: &str) -> Option<Diagnostic> {
    let wanted = element_of(kind)?;
    let Value::List(items) = value else { return None };
    let is_mixed = items.iter().any(|item| item.kind() == wanted);
    let (idx, item) = items.iter().enumerate().find(|(_, item)| item.kind() != wanted)?;
    if !is_mixed {
        return None;
    }
    let found = item.phrase();
    let message = format!("{promised} is promised, but its element [{idx}] is {found}");
    let place = match &expr.kind {
        ExprKind::List(elements) => match elements.get(idx) {
            // What a spread brings shifts the places behind it.
            Some(Element::Item(item)) if is_plain(&elements[..idx]) => item.span,
            _ => expr.span,
        },
        _ => expr.span,
    };
    Some(Diagnostic::error(Code::BrokenPromise, place, message).label(format!("this is {found}")))
}

fn is_plain(elements: &[Element]) -> bool {
    elements.iter().all(|element| matches!(element, Element::Item(_)))
}

/// The type of what one of a kind is, where other values are easily made to it.
fn type_of(kind: Kind) -> Option<Type> {
    Some(match kind {
        Kind::Region => Type::Region,
        Kind::Face => Type::Face,
        Kind::Solid => Type::Solid,
        Kind::Mesh => Type::Mesh,
        _ => return None,
    })
}

/// What a list of a kind holds.
fn element_of(kind: Kind) -> Option<&'static str> {
    Some(match kind {
        Kind::Points => "point",
        Kind::Curves => "curve",
        Kind::Surfaces => "surface",
        Kind::Regions => "region",
        Kind::Faces => "face",
        Kind::Solids => "solid",
        Kind::Meshes => "mesh",
        Kind::Tables => "table",
        _ => return None,
    })
}

/// The keyword that promises what `value` is.
fn fitting(value: &Value) -> Option<&'static str> {
    Kind::ALL
        .iter()
        .find(|&&(_, kind)| kind != Kind::Let && keeps(kind, value))
        .map(|&(word, _)| word)
}
