//! Evaluation of what holds other values: points, lists, records, texts, comprehensions.

use std::sync::Arc;

use glam::DVec3;

use super::{
    ir::{Comprehension, Element, Expr, Piece},
    machine::Machine,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    value::{Dim, Record, Value},
};

impl Machine<'_> {
    pub(super) fn point(&mut self, coordinates: &[Expr; 3]) -> Result<Value> {
        let mut point = DVec3::ZERO;
        for (i, expr) in coordinates.iter().enumerate() {
            point[i] = match self.eval(expr)? {
                Value::Number(number) if number.dim.is_none() || number.dim == Dim::LENGTH => {
                    number.value
                }
                Value::Number(number) => {
                    let message = format!("a coordinate must be a length, found {}", number.dim);
                    return Diagnostic::error(Code::UnitMismatch, expr.span, message).fail();
                }
                other => {
                    let message =
                        format!("a coordinate must be a number, found {}", other.phrase());
                    return Diagnostic::error(Code::WrongKind, expr.span, message)
                        .hint("points and groups take round brackets, lists take square ones")
                        .fail();
                }
            };
        }
        Ok(Value::Point(point))
    }

    /// Fails when a list grows beyond its ceiling.
    pub(super) fn check_length(&self, n: usize, span: Span) -> Result<()> {
        let most = self.env.limits.list_length;
        if n <= most {
            return Ok(());
        }
        let message = format!("a list of more than {most} elements");
        Diagnostic::error(Code::TooLarge, span, message).fail()
    }

    pub(super) fn list(&mut self, elements: &[Element], span: Span) -> Result<Value> {
        let mut items = Vec::with_capacity(elements.len());
        for element in elements {
            match element {
                Element::Item(expr) => items.push(self.eval(expr)?),
                Element::Spread(expr) => {
                    let value = self.eval(expr)?;
                    let n_items = self.iterate(&value, expr.span)?.len();
                    self.check_length(items.len() + n_items, span)?;
                    items.extend(self.iterate(&value, expr.span)?);
                }
            }
        }
        Ok(Value::list(items))
    }

    /// What a list or a range of whole numbers runs through.
    pub(super) fn iterate<'v>(&self, value: &'v Value, span: Span) -> Result<Items<'v>> {
        match value {
            Value::List(items) => Ok(Items::List(items.iter())),
            Value::Range(range) => match range.integers() {
                Some((start, count)) => {
                    self.check_length(count, span)?;
                    Ok(Items::Integers(start, count))
                }
                None => {
                    let message =
                        format!("only a range of whole numbers can be run through, found {range}");
                    Diagnostic::error(Code::WrongKind, span, message)
                        .hint("`linspace(a, b, n)` makes n numbers from a to b")
                        .fail()
                }
            },
            other => {
                let message = format!(
                    "a list or a range of whole numbers is needed here, found {}",
                    other.phrase()
                );
                Diagnostic::error(Code::WrongKind, span, message).fail()
            }
        }
    }

    pub(super) fn record(&mut self, fields: &[(Arc<str>, Expr)]) -> Result<Value> {
        let mut values = Vec::with_capacity(fields.len());
        for (label, expr) in fields {
            values.push((Arc::clone(label), self.eval(expr)?));
        }
        Ok(Value::Record(Arc::new(Record::new(values))))
    }

    /// Fails when a text grows beyond its ceiling.
    fn check_text(&self, n_bytes: usize, span: Span) -> Result<()> {
        let most = self.env.limits.text_bytes;
        if n_bytes <= most {
            return Ok(());
        }
        let message = format!("a text of more than {most} bytes");
        Diagnostic::error(Code::TooLarge, span, message).fail()
    }

    pub(super) fn text(&mut self, pieces: &[Piece], span: Span) -> Result<Value> {
        let mut out = String::new();
        for piece in pieces {
            match piece {
                Piece::Text(text) => out.push_str(text),
                Piece::Expr(expr) => match self.eval(expr)? {
                    Value::Text(text) => out.push_str(&text),
                    other => out.push_str(&other.to_string()),
                },
            }
            self.check_text(out.len(), span)?;
        }
        Ok(Value::text(&out))
    }

    pub(super) fn comprehension(
        &mut self,
        comprehension: &Comprehension,
        span: Span,
    ) -> Result<Value> {
        let mut items = Vec::new();
        self.generate(comprehension, 0, &mut items, span)?;
        Ok(Value::list(items))
    }

    fn generate(
        &mut self,
        comprehension: &Comprehension,
        level: usize,
        items: &mut Vec<Value>,
        span: Span,
    ) -> Result<()> {
        let Some(generator) = comprehension.generators.get(level) else {
            self.check_length(items.len() + 1, span)?;
            let item = self.eval(&comprehension.body)?;
            items.push(item);
            return Ok(());
        };
        let source = self.eval(&generator.source)?;
        for item in self.iterate(&source, generator.source.span)? {
            self.step(span)?;
            let base = self.base;
            self.stack[base + generator.slot] = item;
            for (slot, part) in &generator.parts {
                let value = self.eval(part)?;
                self.stack[base + slot] = value;
            }
            let counts = match &generator.condition {
                Some(condition) => self.truth(condition, "the condition of a comprehension")?,
                None => true,
            };
            if counts {
                self.generate(comprehension, level + 1, items, span)?;
            }
        }
        Ok(())
    }
}

/// What a comprehension or a spread runs through.
pub(super) enum Items<'v> {
    /// Elements of a list.
    List(std::slice::Iter<'v, Value>),
    /// The next whole number and how many are left.
    Integers(i64, usize),
}

impl Iterator for Items<'_> {
    type Item = Value;

    fn next(&mut self) -> Option<Value> {
        match self {
            Self::List(items) => items.next().cloned(),
            Self::Integers(_, 0) => None,
            Self::Integers(next, left) => {
                let value = Value::number(*next as f64);
                (*next, *left) = (*next + 1, *left - 1);
                Some(value)
            }
        }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let n = match self {
            Self::List(items) => items.len(),
            Self::Integers(_, left) => *left,
        };
        (n, Some(n))
    }
}

impl ExactSizeIterator for Items<'_> {}
