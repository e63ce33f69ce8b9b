//! Several unknowns: as the script holds them, as numbers, and as numbers that carry derivatives.

use std::{ops, sync::Arc};

use super::{
    bounds::{FREE, bound, middle, take_apart},
    six_digits,
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Answers, Jet, Wanted,
        tolerance::{EXACT_RELATIVE, PARAMETER_RELATIVE},
    },
    value::{Callback, Ctx, Dimension, IntoValue, Number, Range, Real, Record, Value, Vector},
};

/// Derivatives that the unknowns, or as many numbers made of them, carry at a time: 64 MB. Of thousands of
/// unknowns some are asked for after others.
const SLOPES_AT_ONCE: usize = 1 << 23;

/// Unknowns as the script holds them: a number, a point, or a list or record of such.
pub(super) struct Unknowns {
    shape: Value,
    pub(super) values: Vec<f64>,
}

impl Unknowns {
    /// The unknowns of a start.
    ///
    /// # Errors
    /// A value that is none of these.
    pub(super) fn new(start: &Spanned<Value>) -> Result<Self> {
        let mut values = Vec::new();
        if !take_apart(&start.value, &mut values) || values.is_empty() {
            if start.value.is_jet() {
                return super::no_derivatives(start.span);
            }
            let message = format!("a search starts from numbers, found {}", start.value.phrase());
            return Diagnostic::error(Code::WrongKind, start.span, message)
                .hint("the start is a number, a point, or a list or record of such: `start = {beam: 3m, draft: 1m}`")
                .fail();
        }
        Ok(Self { shape: start.value.clone(), values })
    }

    /// The unknowns in the middle of their bounds.
    ///
    /// # Errors
    /// Bounds that are no ranges, or backwards.
    pub(super) fn between(within: &Spanned<Value>) -> Result<Self> {
        Self::new(&Spanned::new(middle(&within.value, within.span)?, within.span))
    }

    /// Between which numbers each unknown stays.
    ///
    /// # Errors
    /// Bounds that do not fit the unknowns.
    pub(super) fn bounds(&self, within: Option<&Spanned<Value>>) -> Result<Vec<[f64; 2]>> {
        let mut bounds = Vec::with_capacity(self.values.len());
        match within {
            Some(within) => bound(&self.shape, &within.value, within.span, &mut bounds)?,
            None => bounds.resize(self.values.len(), FREE),
        }
        Ok(bounds)
    }

    /// That the unknowns lie between their bounds.
    ///
    /// # Errors
    /// One that does not.
    pub(super) fn check_inside(&self, bounds: &[[f64; 2]], span: Span) -> Result<()> {
        // A bound that was computed may be off by its roundings.
        let is_outside = |(&value, &[low, high]): (&f64, &[f64; 2])| {
            let slack = |end: f64| if end.is_finite() { EXACT_RELATIVE * end.abs() } else { 0.0 };
            value < low - slack(low) || high + slack(high) < value
        };
        if !self.values.iter().zip(bounds).any(is_outside) {
            return Ok(());
        }
        let moved =
            self.values.iter().zip(bounds).map(|(value, ends)| value.clamp(ends[0], ends[1]));
        let inside = self.with(&moved.collect::<Vec<f64>>());
        Diagnostic::error(Code::Domain, span, "the start is outside of `within`")
            .hint(format!("the nearest place inside is {inside}"))
            .fail()
    }

    /// The same unknowns, found by numbers of this dimension: those without a unit are open where these are.
    pub(super) fn found_by(&self, dim: Dimension) -> Self {
        Self { shape: opened(&self.shape, dim), values: self.values.clone() }
    }

    /// The value of the start's shape with these numbers.
    pub(super) fn with(&self, values: &[f64]) -> Value {
        self.each(values, |_, value| Real::Plain(value))
    }

    /// The same with numbers that carry derivatives by some of them.
    fn varying(&self, values: &[f64], chosen: &ops::Range<usize>) -> Value {
        self.each(values, |idx, value| match chosen.contains(&idx) {
            true => Real::Jet(Jet::one_of(idx - chosen.start, chosen.len(), value)),
            false => Real::Plain(value),
        })
    }

    /// What functions answer at a place, with the derivatives by all unknowns: by so many at a time as
    /// numbers with derivatives have room for.
    ///
    /// # Errors
    /// Those of the functions.
    pub(super) fn with_gradients(
        &self,
        values: &[f64],
        mut ask: impl FnMut(&Value) -> Result<Vec<Real>>,
    ) -> Result<Answers> {
        let n = values.len();
        let width = (SLOPES_AT_ONCE / n).clamp(1, n);
        let mut answers: Answers = Vec::new().into();
        for first in (0..n).step_by(width) {
            let chosen = first..(first + width).min(n);
            let reals = ask(&self.varying(values, &chosen))?;
            answers.values = reals.iter().map(Real::value).collect();
            let gradients = answers.gradients.get_or_insert_with(|| vec![Vec::new(); reals.len()]);
            for (gradient, real) in gradients.iter_mut().zip(&reals) {
                match real {
                    Real::Plain(_) => gradient.resize(chosen.end, 0.0),
                    Real::Jet(jet) => gradient.extend(jet.slopes()),
                }
            }
        }
        Ok(answers)
    }

    /// These derivatives, of something of a dimension, by the unknowns: each of the dimension of the quotient.
    /// None where its powers are too high.
    pub(super) fn over(&self, slopes: &[f64], dim: Dimension) -> Option<Value> {
        quotient(&self.with(slopes), dim)
    }

    /// The value of the start's shape with numbers that may carry derivatives.
    pub(super) fn with_reals(&self, reals: &[Real]) -> Value {
        put_together(&self.shape, &mut reals.iter().cloned())
    }

    fn each(&self, values: &[f64], real: impl Fn(usize, f64) -> Real) -> Value {
        let mut reals = values.iter().enumerate().map(|(idx, &value)| real(idx, value));
        put_together(&self.shape, &mut reals)
    }

    /// What functions answer at a place: with derivatives, where they are wanted and pass through all that
    /// the functions do.
    ///
    /// # Errors
    /// Those of the functions.
    pub(super) fn answers(
        &self,
        values: &[f64],
        wanted: Wanted,
        mut ask: impl FnMut(&Value) -> Result<Vec<Real>>,
    ) -> Result<Answers> {
        if wanted == Wanted::Gradients {
            match self.with_gradients(values, &mut ask) {
                Ok(answers) => return Ok(answers),
                Err(found) if found.code == Code::NoDerivative => {}
                Err(found) => return Err(found),
            }
        }
        let reals = ask(&self.with(values))?;
        Ok(reals.iter().map(Real::value).collect::<Vec<f64>>().into())
    }

    /// A place with zeros where it is nearer to that than rounding, by the size of the start.
    pub(super) fn beside_zero(&self, values: &[f64]) -> Vec<f64> {
        let size = self.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let is_zero = |value: f64| value.abs() < PARAMETER_RELATIVE * size;
        values.iter().map(|&value| if is_zero(value) { 0.0 } else { value }).collect()
    }

    /// A place as messages tell it.
    pub(super) fn rounded(&self, values: &[f64]) -> Value {
        let six = |_, value: f64| {
            Real::Plain(six_digits(value, Some(Dimension::NONE)).parse().unwrap_or(value))
        };
        self.each(values, six)
    }
}

/// What a function yields at a place.
///
/// # Errors
/// Those of the function, with the search that asked.
pub(super) fn asked(ctx: &mut Ctx<'_>, function: &Callback, place: &Value) -> Result<Value> {
    ctx.call(function, std::slice::from_ref(place)).map_err(|found| from_here(ctx, *found, place))
}

/// Whether a mistake says that there is no value at a place, rather than that the function is wrong.
pub(super) fn is_without_value(found: &Diagnostic) -> bool {
    let is_of_place = matches!(
        found.code,
        Code::DivisionByZero
            | Code::Domain
            | Code::NoAnswer
            | Code::OutsideDomain
            | Code::Degenerate
            | Code::Gap
            | Code::OpenShell
    );
    is_of_place && found.ceiling.is_none()
}

/// A mistake at a place, with the search that asked.
pub(super) fn from_here(ctx: &Ctx<'_>, mut found: Diagnostic, place: &Value) -> Box<Diagnostic> {
    found.others.retain(|other| other.span != ctx.span);
    Box::new(found.also(ctx.span, format!("asked at {} from here", without_derivatives(place))))
}

/// A place without the derivatives that its numbers carry.
pub(super) fn without_derivatives(place: &Value) -> Value {
    match place {
        Value::List(items) => Value::List(items.iter().map(without_derivatives).collect()),
        Value::Record(record) => {
            let field =
                |(label, value): (&str, &Value)| (Arc::from(label), without_derivatives(value));
            Value::Record(Arc::new(Record::new(record.iter().map(field).collect::<Vec<_>>())))
        }
        other => other.looked_at(),
    }
}

/// The numbers that a function yields: of a point, a list or a record all of them.
///
/// # Errors
/// What holds no numbers.
pub(super) fn numbers(value: &Value, span: Span, all: &mut Vec<Number<Real>>) -> Result<()> {
    let bare = |value: Real| Number { value, dim: Dimension::OPEN };
    match value {
        Value::Point(point) => all.extend(point.to_array().map(|part| bare(Real::Plain(part)))),
        Value::JetPoint(jets) => all.extend(jets.iter().map(|jet| bare(Real::Jet(jet.clone())))),
        Value::List(items) => items.iter().try_for_each(|item| numbers(item, span, all))?,
        Value::Record(record) => {
            record.iter().try_for_each(|(_, value)| numbers(value, span, all))?;
        }
        other => all.push(number(other, span)?),
    }
    Ok(())
}

/// A number with or without derivatives.
///
/// # Errors
/// Any other value.
pub(super) fn number(value: &Value, span: Span) -> Result<Number<Real>> {
    match value {
        Value::Jet(number) => Ok((**number).clone()),
        other => {
            let Number { value, dim } = super::plain_number(&other.looked_at(), span)?;
            Ok(Number { value: Real::Plain(value), dim })
        }
    }
}

fn put_together(shape: &Value, values: &mut dyn Iterator<Item = Real>) -> Value {
    match shape {
        Value::Number(number) => {
            let value = values.next().unwrap_or(Real::Plain(number.value));
            Number { value, dim: number.dim }.into_value()
        }
        Value::Point(point) => {
            let parts = point.to_array().map(|part| values.next().unwrap_or(Real::Plain(part)));
            Vector::new(parts).into_value()
        }
        Value::List(items) => {
            Value::List(items.iter().map(|item| put_together(item, values)).collect())
        }
        Value::Record(record) => {
            let field =
                |(label, value): (&str, &Value)| (Arc::from(label), put_together(value, values));
            Value::Record(Arc::new(Record::new(record.iter().map(field).collect::<Vec<_>>())))
        }
        other => other.clone(),
    }
}

/// A shape of unknowns that numbers of a dimension have told.
fn opened(shape: &Value, by: Dimension) -> Value {
    match shape {
        Value::Number(Number { value, dim }) => {
            Number { value: *value, dim: super::found_dimension(*dim, by) }.into_value()
        }
        Value::List(items) => Value::List(items.iter().map(|item| opened(item, by)).collect()),
        Value::Record(record) => {
            let field = |(label, value): (&str, &Value)| (Arc::from(label), opened(value, by));
            Value::Record(Arc::new(Record::new(record.iter().map(field).collect::<Vec<_>>())))
        }
        other => other.clone(),
    }
}

/// Numbers with the dimension of a quotient by their own one.
fn quotient(value: &Value, dim: Dimension) -> Option<Value> {
    Some(match value {
        Value::Number(number) => {
            Number { value: number.value, dim: dim.over(number.dim)? }.into_value()
        }
        Value::List(items) => {
            let items: Option<Vec<Value>> = items.iter().map(|item| quotient(item, dim)).collect();
            Value::list(items?)
        }
        Value::Record(record) => {
            Value::Record(Arc::new(record.mapped(|value| quotient(value, dim))?))
        }
        other => other.clone(),
    })
}

/// The ends of a single range.
pub(super) fn single(within: &Spanned<Value>) -> Option<Spanned<Range>> {
    match &within.value {
        Value::Range(range) => Some(Spanned::new(*range, within.span)),
        _ => None,
    }
}
