//! The function under an integral, and integrals over one number.

use super::{
    super::{six_digits, unknowns},
    found::{Found, Tolerances},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{IntegralError, Jet, find_sized_integral},
    value::{Callback, Ctx, Dimension, Number, Real, Value},
};

/// A function of the script under the integral.
pub(super) struct Integrand<'a, 'c> {
    ctx: &'a mut Ctx<'c>,
    f: &'a Spanned<Callback>,
    /// Of how many components its values are, and of which dimension.
    known: Option<(usize, Dimension)>,
    /// What its derivatives are by, where it has any.
    pub(super) like: Option<Jet>,
    /// How often it was asked.
    pub(super) n_asked: usize,
    /// The shape of the derivatives whose coefficients are all wanted, and whether the function itself has some.
    carried: Option<(Jet, bool)>,
}

impl<'a, 'c> Integrand<'a, 'c> {
    pub(super) fn new(ctx: &'a mut Ctx<'c>, f: &'a Spanned<Callback>) -> Self {
        Self { ctx, f, known: None, like: None, n_asked: 0, carried: None }
    }

    /// Lets it answer with the coefficients of all derivatives.
    pub(super) fn carry(&mut self, like: Jet, is_varying: bool) {
        self.carried = Some((like, is_varying));
    }

    /// The shape of the derivatives that are wanted.
    pub(super) fn carried(&self) -> Option<&Jet> {
        self.carried.as_ref().map(|(like, _)| like)
    }

    /// Whether it carries derivatives itself.
    pub(super) fn is_varying(&self) -> bool {
        matches!(&self.carried, Some((_, true)))
    }

    pub(super) fn span(&self) -> Span {
        self.f.span
    }

    /// The dimension of its values.
    pub(super) fn dimension(&self) -> Dimension {
        self.known.map_or(Dimension::NONE, |(_, dim)| dim)
    }

    /// The components at a place, times a factor.
    pub(super) fn at(&mut self, args: &[Value], factor: &Real) -> Result<Vec<f64>> {
        self.n_asked += 1;
        let value = self.asked(args)?;
        let mut parts: Vec<Number<Real>> = Vec::new();
        match &value {
            Value::List(_) | Value::Record(_) => {
                super::super::plain_number(&value, self.f.span)?;
            }
            value => unknowns::numbers(value, self.f.span, &mut parts)?,
        }
        self.check(&parts, &value, args)?;
        if let Some((like, _)) = &self.carried {
            let factor = factor.like(like);
            let part =
                |part: &Number<Real>| part.value.like(like).times(&factor).coefficients().to_vec();
            return Ok(parts.iter().flat_map(part).collect());
        }
        if self.like.is_none() {
            self.like = parts.iter().find_map(|part| match &part.value {
                Real::Jet(jet) => Some(jet.clone()),
                Real::Plain(_) => None,
            });
        }
        Ok(parts.iter().map(|part| factor.value() * part.value.value()).collect())
    }

    fn asked(&mut self, args: &[Value]) -> Result<Value> {
        let found = self.ctx.call(&self.f.value, args);
        found.map_err(|found| unknowns::from_here(self.ctx, *found, &place(args)))
    }

    /// # Errors
    /// Values of other kinds or dimensions than before.
    fn check(&mut self, parts: &[Number<Real>], value: &Value, args: &[Value]) -> Result<()> {
        let dim = parts.first().map_or(Dimension::NONE, |part| part.dim);
        let (n_before, dim_before) = *self.known.get_or_insert((parts.len(), dim));
        if n_before != parts.len() {
            let (what, place) = (value.phrase(), place(args));
            let message =
                format!("the function yields {what} at {place}, and something else before");
            return Diagnostic::error(Code::WrongKind, self.f.span, message).fail();
        }
        if dim_before.common(dim).is_none() {
            let place = place(args);
            let message = format!("the function yields {dim} at {place} and {dim_before} before");
            return Diagnostic::error(Code::UnitMismatch, self.f.span, message).fail();
        }
        Ok(())
    }
}

/// Where a function is asked.
fn place(args: &[Value]) -> Value {
    match args {
        [place] => place.looked_at(),
        args => Value::list(args.iter().map(Value::looked_at).collect()),
    }
}

/// An integral over one number, with its refusal; what it adds up may be integrals itself, whose largest error
/// counts everywhere.
pub(super) fn settled(
    span: Span,
    ends: [f64; 2],
    [relative, absolute]: Tolerances,
    place: impl Fn(f64) -> String,
    mut ask: impl FnMut(f64) -> Result<Found>,
) -> Result<Found> {
    let mut most = 0.0_f64;
    let asked = |at| {
        let found = ask(at)?;
        most = most.max(found.error);
        Ok((found.value, found.size))
    };
    match find_sized_integral(asked, ends, relative, absolute) {
        Ok(found) => {
            let error = found.error + most * (ends[1] - ends[0]);
            Ok(Found { value: found.value, error, size: found.size })
        }
        Err(IntegralError::Function(found)) => Err(found),
        Err(IntegralError::Unsettled { at, error }) => {
            let message = format!("the integral does not settle near {}", place(at));
            let left = match error.is_finite() {
                true => format!("it may be off by {} still", six_digits(error, None)),
                false => "its value is beyond all numbers".to_owned(),
            };
            Diagnostic::error(Code::NoAnswer, span, message)
                .label(left)
                .hint("it may have no finite value; else divide the range there, or give a larger `tolerance`")
                .fail()
        }
    }
}
