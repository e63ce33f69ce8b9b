//! The function under an integral, and integrals over one number.

use super::{
    super::{six_digits, take, unknowns},
    found::{Found, Tolerances},
    moving_cuts::{MovingCuts, RangeEnd, SeenPlace},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        IntegralError, IntegralReason, Interval, Jet,
        ceiling::{INTEGRAL_EVALUATIONS, INTEGRAL_LOOKS_OF_SEVERAL},
        find_sized_integral,
    },
    value::{Callback, CommonDimension, Ctx, Dimension, Number, Real, Value},
};

/// Where a part is asked for the function's size, along each of its numbers: beside a sixth, half and five sixths of
/// the way, since functions have their poles at simple shares.
pub(super) const LOOKS: [f64; 3] = [0.163, 0.513, 0.837];

/// A function of the script under the integral.
pub(super) struct Integrand<'a, 'c> {
    ctx: &'a mut Ctx<'c>,
    f: &'a Spanned<Callback>,
    /// Of how many components its values are.
    n_parts: Option<usize>,
    /// The dimension of all that it yielded.
    dim: CommonDimension,
    /// What its derivatives are by, where it has any.
    pub(super) like: Option<Jet>,
    /// How often it was asked.
    pub(super) n_asked: usize,
    /// Whether it took something from around it that carries derivatives.
    varies: bool,
    /// The shape of the derivatives whose coefficients are all wanted.
    carried: Option<Jet>,
}

impl<'a, 'c> Integrand<'a, 'c> {
    pub(super) fn new(ctx: &'a mut Ctx<'c>, f: &'a Spanned<Callback>) -> Self {
        let varies = ctx.caller.is_varying(&f.value.0);
        Self {
            ctx,
            f,
            n_parts: None,
            dim: CommonDimension::default(),
            like: None,
            n_asked: 0,
            varies,
            carried: None,
        }
    }

    /// Lets it answer with the coefficients of all derivatives.
    pub(super) fn carry(&mut self, like: Jet) {
        self.carried = Some(like);
    }

    /// The shape of the derivatives that are wanted.
    pub(super) fn carried(&self) -> Option<&Jet> {
        self.carried.as_ref()
    }

    /// Of how many numbers its values are, with those of their derivatives; none before it was asked.
    pub(super) fn n_numbers(&self) -> Option<usize> {
        let width = self.carried().map_or(1, |like| like.coefficients().len());
        self.n_parts.map(|n| n * width)
    }

    /// Whether it carries derivatives itself.
    pub(super) fn is_varying(&self) -> bool {
        self.varies
    }

    pub(super) fn span(&self) -> Span {
        self.f.span
    }

    /// A range of it that moves by its ends alone, if at all.
    pub(super) fn range(&self, ends: [f64; 2]) -> IntegralRange {
        let carried = self.carried().cloned();
        let n_looks = INTEGRAL_LOOKS_OF_SEVERAL;
        let beyond = [RangeEnd::Last; 2];
        IntegralRange { span: self.span(), ends, beyond, carried, can_move: false, n_looks }
    }

    /// The dimension of its values, wherever it was asked.
    pub(super) fn dimension(&self) -> Dimension {
        self.dim.dimension()
    }

    /// The components at a place, times a factor; with what decided, where derivatives are carried along.
    pub(super) fn at(&mut self, args: &[Value], factor: &Real) -> Result<Found> {
        self.n_asked += 1;
        if INTEGRAL_EVALUATIONS < self.n_asked {
            return self.too_often(args);
        }
        let is_noted = self.carried.is_some() || self.varies;
        let outer = self.ctx.caller.note_switches(is_noted.then(Vec::new));
        let value = self.asked(args);
        let switches = self.ctx.caller.note_switches(outer).unwrap_or_default();
        let value = value?;
        let mut parts: Vec<Number<Real>> = Vec::new();
        match &value {
            Value::List(_) | Value::Record(_) => {
                super::super::plain_number(&value, self.f.span)?;
            }
            value => unknowns::numbers(value, self.f.span, &mut parts)?,
        }
        self.check(&parts, &value, args)?;
        if let Some(like) = &self.carried {
            let factor = factor.like(like);
            let part =
                |part: &Number<Real>| part.value.like(like).times(&factor).coefficients().to_vec();
            let value = parts.iter().flat_map(part).collect();
            return Ok(Found { switches, ..Found::exact(value) });
        }
        if self.like.is_none() {
            // Where only its comparisons depend on something it yields plain numbers.
            let margins = switches.iter().filter_map(|switch| switch.margin.as_ref());
            let reals = parts.iter().map(|part| &part.value).chain(margins);
            self.like = reals.into_iter().find_map(|real| match real {
                Real::Jet(jet) => Some(jet.clone()),
                Real::Plain(_) => None,
            });
        }
        Ok(Found::exact(parts.iter().map(|part| factor.value() * part.value.value()).collect()))
    }

    /// How large it is at a place, times a factor; nothing where it fails.
    pub(super) fn size_at(&mut self, args: &[Value], factor: f64) -> f64 {
        let size = self.at(args, &Real::Plain(factor)).map_or(0.0, |found| found.size);
        if size.is_finite() { size } else { 0.0 }
    }

    fn too_often<T>(&self, args: &[Value]) -> Result<T> {
        let message =
            format!("the integral does not settle within {INTEGRAL_EVALUATIONS} evaluations");
        Diagnostic::error(Code::NoAnswer, self.f.span, message)
            .label(format!("asked at {} last", place(args)))
            .hint("a step or an edge that runs across an area takes many: let the ranges end there, `integrate(x => integrate(y => f(x, y), 0..edge(x)), 0..1)`, or give a `tolerance`, such as 1e-6")
            .fail()
    }

    fn asked(&mut self, args: &[Value]) -> Result<Value> {
        let found = self.ctx.call(&self.f.value, args);
        found.map_err(|found| unknowns::from_here(self.ctx, *found, &place(args)))
    }

    /// # Errors
    /// Values of other kinds or dimensions than before.
    fn check(&mut self, parts: &[Number<Real>], value: &Value, args: &[Value]) -> Result<()> {
        if *self.n_parts.get_or_insert(parts.len()) != parts.len() {
            let (what, place) = (value.phrase(), place(args));
            let message =
                format!("the function yields {what} at {place}, and something else before");
            return Diagnostic::error(Code::WrongKind, self.f.span, message).fail();
        }
        let (dim, span) = (&mut self.dim, self.f.span);
        parts
            .iter()
            .try_for_each(|part| take(dim, part.looked_at(), span, || place(args).to_string()))
    }
}

/// Where a function is asked.
fn place(args: &[Value]) -> Value {
    match args {
        [place] => place.looked_at(),
        args => Value::list(args.iter().map(Value::looked_at).collect()),
    }
}

/// What an integral over one number is over.
#[derive(Clone)]
pub(super) struct IntegralRange {
    /// The function.
    pub(super) span: Span,
    pub(super) ends: [f64; 2],
    pub(super) beyond: [RangeEnd; 2],
    /// The shape of the derivatives that are carried along.
    pub(super) carried: Option<Jet>,
    /// Whether the function can be asked at places that carry derivatives.
    pub(super) can_move: bool,
    /// Places at which the function is looked at once more.
    pub(super) n_looks: usize,
}

impl IntegralRange {
    /// The same as a part of a domain which goes on smoothly beyond ends inside of it.
    pub(super) fn between(mut self, domain: Interval) -> Self {
        let limits = [domain.start(), domain.end()];
        for ((beyond, end), limit) in self.beyond.iter_mut().zip(self.ends).zip(limits) {
            if end.total_cmp(&limit).is_ne() {
                *beyond = RangeEnd::Smooth;
            }
        }
        self
    }
}

/// An integral over one number, with its refusal; what it adds up may be integrals itself, whose largest error
/// counts everywhere.
pub(super) fn settled(
    range: &IntegralRange,
    [relative, absolute]: Tolerances,
    place: impl Fn(f64) -> String,
    mut ask: impl FnMut(Real) -> Result<Found>,
) -> Result<Found> {
    let (span, ends) = (range.span, range.ends);
    let (mut most, mut seen) = (0.0_f64, Vec::new());
    let asked = |at| {
        let found = ask(Real::Plain(at))?;
        most = most.max(found.error);
        if range.carried.is_some() {
            seen.push(SeenPlace { at, switches: found.switches });
        }
        Ok((found.value, found.size))
    };
    match find_sized_integral(asked, ends, [relative, absolute], range.n_looks) {
        Ok(found) => {
            let error = found.error + most * (ends[1] - ends[0]);
            let switches = seen.first().map_or_else(Vec::new, |place| place.switches.clone());
            let total = Found { value: found.value, error, size: found.size, switches };
            let Some(like) = &range.carried else { return Ok(total) };
            // What goes another way on the end itself does so for one of the two ranges that meet there.
            for (at, _) in ends.into_iter().zip(range.beyond).filter(|end| end.1 != RangeEnd::Last)
            {
                if let Ok(found) = ask(Real::Plain(at)) {
                    seen.push(SeenPlace { at, switches: found.switches });
                }
            }
            let (beyond, can_move) = (range.beyond, range.can_move);
            let cuts = MovingCuts { span, like, ends, beyond, can_move, seen };
            Ok(total.plus(Found::exact(cuts.gain(&mut ask)?)))
        }
        Err(IntegralError::Function(found)) => Err(found),
        Err(IntegralError::Unsettled { at, error, reason: IntegralReason::Noise }) => {
            let message =
                format!("the function has too few digits for the integral near {}", place(at));
            // A power of ten above.
            let enough = libm::pow(10.0, libm::log10(error).ceil() + 1.0);
            Diagnostic::error(Code::NoAnswer, span, message)
                .label(format!("halves of the range are off as far as the whole, by {}", six_digits(error, None)))
                .hint(format!("what it measures may be known within a tolerance only: give `tolerance = {enough:e}`"))
                .fail()
        }
        Err(IntegralError::Unsettled { at, reason: IntegralReason::Endless, .. }) => {
            let message = format!("the integral does not settle near {}", place(at));
            Diagnostic::error(Code::NoAnswer, span, message)
                .label("the function grows so fast there that no sum up to it is the last")
                .hint("no `tolerance` gives it a value: let the range end beside that place")
                .fail()
        }
        Err(IntegralError::Unsettled { at, error, .. }) => {
            let message = format!("the integral does not settle near {}", place(at));
            let [left, larger] = match error.is_finite() {
                true => [
                    format!("it may be off by {} still", six_digits(error, None)),
                    ", or give a larger `tolerance`".to_owned(),
                ],
                false => ["its value is beyond all numbers".to_owned(), String::new()],
            };
            Diagnostic::error(Code::NoAnswer, span, message)
                .label(left)
                .hint(format!("it may have no finite value; else divide the range there{larger}"))
                .fail()
        }
    }
}
