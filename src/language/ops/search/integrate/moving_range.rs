//! Ranges whose ends may carry derivatives.

use super::{
    super::SearchRange,
    found::{Found, Tolerances, nested},
    integrand::{IntegralRange, Integrand, settled},
    moving_cuts::{jumps, unknown},
};
use crate::{
    diag::{Code, Result, Span, Spanned},
    kernel::{
        Jet,
        ceiling::INTEGRAL_LOOKS,
        jet::moved_end,
        tolerance::{LAST_BIT, SWITCH_ALIKE_RELATIVE},
    },
    value::{IntoValue, Number, Range, Real, Value, is_like},
};

/// Beyond this even squares leave the numbers: 1e154² is 1e308.
const FAR: f64 = 1e150;

/// What to do about that.
const TOO_FAR: &str = "the function is asked all over the range: end it where what is left no longer counts, or write what stays among numbers, `(1/x)^2` for `1/x^2`";

/// A range to integrate over, in either sense.
pub(super) struct MovingRange {
    /// In rising order.
    range: SearchRange,
    /// Start and end.
    ends: [Real; 2],
}

impl MovingRange {
    /// The range of a value, if it is one.
    ///
    /// # Errors
    /// Ends that do not go together.
    pub(super) fn of(value: &Value, over: &Spanned<Value>) -> Option<Result<Self>> {
        let (plain, ends) = match value {
            Value::Range(range) => {
                (*range, [range.start, range.end].map(|end| Real::Plain(end.value)))
            }
            Value::JetRange(range) => {
                (range.looked_at(), [range.start.value.clone(), range.end.value.clone()])
            }
            _ => return None,
        };
        let dim = SearchRange::dimension(&Spanned::new(plain, over.span));
        Some(dim.map(|dim| Self { range: SearchRange { ends: rising(&plain), dim }, ends }))
    }

    /// A jet of the shape of those at its ends.
    pub(super) fn like(&self) -> Option<&Jet> {
        self.ends.iter().find_map(|end| match end {
            Real::Jet(jet) => Some(jet),
            Real::Plain(_) => None,
        })
    }

    pub(super) fn dim(&self) -> crate::value::Dimension {
        self.range.dim
    }

    pub(super) fn length(&self) -> f64 {
        self.range.ends[1] - self.range.ends[0]
    }

    /// The place at a share of the way.
    pub(super) fn place_within(&self, share: f64) -> Value {
        self.place(Real::Plain(self.range.ends[0] + share * self.length()))
    }

    /// A place as a value.
    fn place(&self, at: Real) -> Value {
        Number { value: at, dim: self.range.dim }.into_value()
    }
}

fn rising(range: &Range) -> [f64; 2] {
    let [start, end] = [range.start.value, range.end.value];
    if start <= end { [start, end] } else { [end, start] }
}

/// An integral over ranges, one inside the other, behind the arguments that are known.
pub(super) fn over_box(
    ranges: &[MovingRange],
    known: &mut Vec<Value>,
    integrand: &mut Integrand<'_, '_>,
    tolerances: Tolerances,
) -> Result<Found> {
    let Some((first, rest)) = ranges.split_first() else {
        return integrand.at(known, &Real::Plain(1.0));
    };
    let [low, high] = first.range.ends;
    let is_backwards = first.ends[1].value() < first.ends[0].value();
    let [own, inner] = match rest {
        [] => [tolerances; 2],
        _ => nested(tolerances, high - low),
    };
    // Of what carries nothing only the ends move the integral.
    let is_still = integrand.carried().is_some()
        && !integrand.is_varying()
        && rest.iter().all(|range| range.like().is_none())
        && !known.iter().any(Value::is_jet);
    let is_alone = known.is_empty() && rest.is_empty();
    let moves_inside = integrand.is_varying() || known.iter().any(Value::is_jet);
    let mut ask = |integrand: &mut Integrand<'_, '_>, at: Real| {
        known.push(first.place(at));
        let found = over_box(rest, known, integrand, inner);
        known.pop();
        found
    };
    let mut total = if low < high && !is_still {
        let place = |at| first.range.place_text(at);
        let mut over = IntegralRange { can_move: true, ..integrand.range([low, high]) };
        if is_alone {
            over.n_looks = INTEGRAL_LOOKS;
        }
        let asked = |at| ask(&mut *integrand, at);
        settled(&over, own, place, asked).map_err(|found| {
            let is_far = FAR < low.abs().max(high.abs()) && found.code == Code::Domain;
            if is_far { Box::new(found.hint(TOO_FAR)) } else { found }
        })?
    } else {
        // Ends are never asked for where it is known of how many numbers its values are.
        let n = integrand
            .n_numbers()
            .map_or_else(|| ask(integrand, Real::Plain(low)).map(|found| found.value.len()), Ok)?;
        Found::exact(vec![0.0; n])
    };
    if is_backwards {
        total.value.iter_mut().for_each(|part| *part = -*part);
    }
    let Some(like) = integrand.carried().cloned() else { return Ok(total) };
    let ends = MovingEnds { ends: &first.ends, moves_inside, like: &like, span: integrand.span() };
    ends.added_to(total, [low, high], &mut |at| ask(integrand, at))
}

/// The ends of a range over which derivatives are carried along.
struct MovingEnds<'a> {
    ends: &'a [Real; 2],
    /// Whether what the function is inside moves too.
    moves_inside: bool,
    like: &'a Jet,
    span: Span,
}

impl MovingEnds<'_> {
    /// An integral with what it gains at the ends, which are two in rising order.
    fn added_to(
        &self,
        mut total: Found,
        [low, high]: [f64; 2],
        ask: &mut dyn FnMut(Real) -> Result<Found>,
    ) -> Result<Found> {
        let width = self.like.coefficients().len();
        let mean = total.size / (high - low);
        for (end, sign) in self.ends.iter().zip([-1.0, 1.0]) {
            let place = match low < high && (self.moves_inside || matches!(end, Real::Jet(_))) {
                true => self.place_inside(end, [low, high], mean, ask)?,
                false => end.value(),
            };
            let Real::Jet(end) = end else { continue };
            let gain = moved_end(&end.clone().with_value(place), |at| -> Result<Vec<Jet>> {
                let flat = ask(Real::Jet(at.clone()))?.value;
                Ok(flat.chunks(width).map(|part| self.like.with_coefficients(part)).collect())
            })?;
            let flat = gain.iter().flat_map(|part| part.scaled(sign).coefficients().to_vec());
            total = total.plus(Found::exact(flat.collect()));
        }
        Ok(total)
    }

    /// Where the function is asked for what an end gains: at the end, or, where it goes another way there than inside and
    /// that place moves with the end, as near to it as numbers are.
    ///
    /// # Errors
    /// `E0503` where the function jumps at the end, and the place moves in another way than the end: then the integral has a
    /// derivative on one side alone.
    fn place_inside(
        &self,
        end: &Real,
        [low, high]: [f64; 2],
        mean: f64,
        ask: &mut dyn FnMut(Real) -> Result<Found>,
    ) -> Result<f64> {
        let at = end.value();
        let step = LAST_BIT * at.abs().max(high - low);
        let beside = if at <= low { low + step } else { high - step };
        let mut found = |at: f64| ask(Real::Plain(at)).ok();
        let Some(own) = found(at).filter(|own| !own.switches.is_empty()) else { return Ok(at) };
        let Some(inner) = found(beside) else { return Ok(at) };
        if is_like(&own.switches, &inner.switches) {
            return Ok(at);
        }
        let mut pairs = own.switches.iter().zip(&inner.switches);
        let number = pairs.position(|(a, b)| !a.is_like(b)).unwrap_or(own.switches.len());
        let sides = [(at, own), (beside, inner)]
            .map(|(at, found)| (at, Found { size: found.size.max(mean), ..found }));
        if !jumps(self.like, &sides) {
            return Ok(at);
        }
        let [(_, own), _] = sides;
        let (switches, speed) = match end {
            Real::Plain(_) => (own.switches, 1.0),
            Real::Jet(jet) => (ask(end.clone())?.switches, fastest(jet)),
        };
        match switches.get(number).and_then(|switch| switch.margin.as_ref()) {
            Some(Real::Plain(_)) => Ok(beside),
            Some(Real::Jet(margin)) if fastest(margin) <= SWITCH_ALIKE_RELATIVE * speed => {
                Ok(beside)
            }
            _ => unknown(self.span, at),
        }
    }
}

/// The largest of its derivatives.
fn fastest(jet: &Jet) -> f64 {
    jet.coefficients().iter().skip(1).fold(0.0, |most: f64, part| most.max(part.abs()))
}
