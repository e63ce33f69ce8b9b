//! `minimize` and `maximize`: where a function is best, within bounds and under conditions.

use super::{
    MOST_LABELS, SearchRange, no_derivatives, number_at, six_digits, take,
    unknowns::{Unknowns, asked, from_here, is_without_value, number, numbers, single},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Answers, ConstrainedLeast, LeastEnd, LeastProblem, Sample, Wanted, find_least,
        find_least_place, find_pole,
        tolerance::{CONDITION_RELATIVE, LAST_BIT},
    },
    value::{
        Callback, CommonDimension, Ctx, FromValue, IntoValue, Number, Real, Record, Relation, Value,
    },
};

/// Last bits of a best value by which one at a place that slopes tell may be worse: both are rounded.
const BEST_ROUNDINGS: f64 = 16.0;

/// Which values are better.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Extreme {
    Lower,
    Higher,
}

/// What a search for the best place is given.
pub(super) struct BestSearch {
    pub(super) f: Spanned<Callback>,
    pub(super) within: Option<Spanned<Value>>,
    pub(super) start: Option<Spanned<Value>>,
    pub(super) subject: Option<Spanned<Value>>,
    pub(super) is_report: bool,
}

impl BestSearch {
    /// The best place.
    pub(super) fn run(&self, ctx: &mut Ctx<'_>, better: Extreme) -> Result<Value> {
        let conditions = self.conditions()?;
        for function in conditions.iter().chain([&self.f]) {
            if ctx.caller.is_varying(&function.value.0) {
                return no_derivatives(function.span);
            }
        }
        let range = self.within.as_ref().and_then(single);
        match (range, &self.start, &self.subject) {
            (Some(range), None, None) => self.of_one(ctx, &SearchRange::new(range)?, better),
            (None, None, _) if self.within.is_none() => {
                let message = "a range or a start is needed to search from";
                Diagnostic::error(Code::BadCall, ctx.span, message)
                    .hint("`within = 0..10` for one number, `start = (1, 2)` or `within = {a: 0..1, b: 2..3}` for several")
                    .fail()
            }
            _ => self.of_several(ctx, better, &conditions),
        }
    }

    fn of_one(&self, ctx: &mut Ctx<'_>, range: &SearchRange, better: Extreme) -> Result<Value> {
        let (mut dim, mut n_asked) = (CommonDimension::default(), 0_usize);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        let sign = better.sign();
        let found = find_least(
            |at| {
                n_asked += 1;
                let value = number_at(ctx, &self.f, range, (at, &mut dim))?;
                (least, most) = (least.min(value), most.max(value));
                Ok::<_, Box<Diagnostic>>(sign * value)
            },
            range.ends,
        )?;
        if most <= least {
            let [from, to] = range.ends.map(|at| range.place_text(at));
            let message = format!(
                "the function is {} everywhere within {from}..{to}",
                six_digits(least, dim.known())
            );
            return Diagnostic::error(Code::NoAnswer, self.f.span, message)
                .label("so no place is better than another")
                .hint("it may not depend on its unknown; else look elsewhere")
                .fail();
        }
        let pole = find_pole(
            |at| {
                n_asked += 1;
                match number_at(ctx, &self.f, range, (at, &mut dim)) {
                    Err(found) if is_without_value(&found) => Ok::<_, Box<Diagnostic>>(None),
                    value => Ok(Some(sign * value?)),
                }
            },
            range.ends,
            found,
        )?;
        if let Some(pole) = pole {
            let message = format!(
                "the function {} without bound near {}",
                better.falls(),
                range.place_text(pole)
            );
            return Diagnostic::error(Code::NoAnswer, self.f.span, message)
                .label("so no value is the best")
                .hint("it has a pole there: let the range end beside it")
                .fail();
        }
        let (found, n_slopes) = self.refined(ctx, range, better, found)?;
        let value = Number { value: sign * found.value, dim: dim.dimension() };
        let place = range.found_by(dim.known()).place(found.at).into_value();
        let slopes = if 0 < n_slopes { "exact" } else { "none" };
        Ok(self.answer(place, value, (n_asked + n_slopes, slopes)))
    }

    /// The best place of one number to its last digit, where derivatives tell it, and how often these were asked for.
    fn refined(
        &self,
        ctx: &mut Ctx<'_>,
        range: &SearchRange,
        better: Extreme,
        found: Sample,
    ) -> Result<(Sample, usize)> {
        let start = Spanned::new(range.place(found.at).into_value(), self.f.span);
        let unknowns = Unknowns::new(&start)?;
        let mut asking = Asking::new(ctx, &self.f, &[], better);
        let (mut n_asked, mut is_known) = (0, false);
        let at = find_least_place(
            |at| {
                n_asked += 1;
                let slopes = asking.answers(&unknowns, &[at], Wanted::Gradients)?.gradients;
                is_known |= slopes.is_some();
                Ok::<_, Box<Diagnostic>>(slopes.map(|slopes| slopes[0][0]))
            },
            range.ends,
            found.at,
        )?;
        let n_asked = if is_known { n_asked } else { 0 };
        if at.to_bits() == found.at.to_bits() {
            return Ok((found, n_asked));
        }
        let value = asking.answers(&unknowns, &[at], Wanted::Values)?.values[0];
        let is_better = value <= found.value + BEST_ROUNDINGS * LAST_BIT * found.value.abs();
        let refined = if is_better { Sample { at, value } } else { found };
        Ok((refined, n_asked + 1))
    }

    /// The answer, or the record that tells how it was found.
    fn answer(&self, at: Value, value: Number, (n_asked, gradients): (usize, &str)) -> Value {
        if !self.is_report {
            return at;
        }
        let fields = [
            ("at", at),
            ("value", value.into_value()),
            ("evaluations", Value::number(n_asked as f64)),
            ("derivatives", Value::text(gradients)),
        ];
        Record::new(fields.map(|(label, value)| (label.into(), value))).into_value()
    }

    /// The functions whose comparisons are to hold.
    fn conditions(&self) -> Result<Vec<Spanned<Callback>>> {
        let Some(subject) = &self.subject else { return Ok(Vec::new()) };
        let one = |value: &Value| match Callback::from_value(value, subject.span) {
            Ok(function) => Ok(Spanned::new(function, subject.span)),
            Err(_) => {
                let message =
                    format!("conditions are given by functions, found {}", value.phrase());
                Diagnostic::error(Code::WrongKind, subject.span, message)
                    .hint("for example `subject = u => u.x + u.y <= 5 and u.x >= u.y`")
                    .fail()
            }
        };
        match &subject.value {
            Value::List(items) => items.iter().map(one).collect(),
            value => Ok(vec![one(value)?]),
        }
    }

    fn of_several(
        &self,
        ctx: &mut Ctx<'_>,
        better: Extreme,
        conditions: &[Spanned<Callback>],
    ) -> Result<Value> {
        let unknowns = match (&self.start, &self.within) {
            (Some(start), _) => Unknowns::new(start)?,
            (None, Some(within)) => Unknowns::between(within)?,
            (None, None) => unreachable!("a search has a range or a start"),
        };
        let bounds = unknowns.bounds(self.within.as_ref())?;
        if let Some(start) = &self.start {
            unknowns.check_inside(&bounds, start.span)?;
        }
        let mut asking = Asking::new(ctx, &self.f, conditions, better);
        // The first question tells what there is, and its mistakes are the script's.
        asking.ask(&unknowns.with(&unknowns.values))?;
        let n_equations = asking.known.as_ref().map_or(0, |(_, n_equations)| *n_equations);
        let mut problem = LeastProblem { start: &unknowns.values, bounds: &bounds, n_equations };
        let place;
        if self.start.is_none() {
            place = problem.spread(|values, wanted| asking.answers(&unknowns, values, wanted))?;
            problem.start = &place;
        }
        let found = problem.find(|values, wanted| asking.answers(&unknowns, values, wanted))?;
        if found.end != LeastEnd::Settled {
            return asking.refusal(&unknowns, &found).fail();
        }
        let value = Number { value: better.sign() * found.values[0], dim: asking.dim.dimension() };
        let gradients = if found.has_differences { "differences" } else { "exact" };
        let place = unknowns.found_by(value.dim).with(&found.unknowns);
        Ok(self.answer(place, value, (found.n_evaluations, gradients)))
    }
}

impl Extreme {
    fn sign(self) -> f64 {
        match self {
            Self::Lower => 1.0,
            Self::Higher => -1.0,
        }
    }

    /// What a function does that becomes better and better.
    fn falls(self) -> &'static str {
        match self {
            Self::Lower => "falls",
            Self::Higher => "grows",
        }
    }

    /// What its best value is.
    fn least(self) -> &'static str {
        match self {
            Self::Lower => "least",
            Self::Higher => "greatest",
        }
    }
}

/// A function under conditions that is asked.
struct Asking<'a, 'c> {
    ctx: &'a mut Ctx<'c>,
    f: &'a Spanned<Callback>,
    conditions: &'a [Spanned<Callback>],
    better: Extreme,
    /// The dimension of the function's values.
    dim: CommonDimension,
    /// Where the conditions stand, equations first, each as often as it has numbers, and how many of them
    /// are equations.
    known: Option<(Vec<Span>, usize)>,
}

impl<'a, 'c> Asking<'a, 'c> {
    fn new(
        ctx: &'a mut Ctx<'c>,
        f: &'a Spanned<Callback>,
        conditions: &'a [Spanned<Callback>],
        better: Extreme,
    ) -> Self {
        Self { ctx, f, conditions, better, dim: CommonDimension::default(), known: None }
    }

    /// The answers at a place; where something has no value, numbers that are not finite.
    fn answers(&mut self, unknowns: &Unknowns, values: &[f64], wanted: Wanted) -> Result<Answers> {
        let n = self.known.as_ref().map_or(0, |(spans, _)| spans.len());
        match unknowns.answers(values, wanted, |place| self.ask(place)) {
            Err(found) if is_without_value(&found) => Ok(vec![f64::INFINITY; n + 1].into()),
            other => other,
        }
    }

    /// The value that is to be least, then the equations, then what is not to be negative.
    fn ask(&mut self, place: &Value) -> Result<Vec<Real>> {
        let value = asked(self.ctx, &self.f.value, place)?;
        let found = number(&value, self.f.span)?;
        take(&mut self.dim, found.looked_at(), self.f.span, || place.looked_at().to_string())?;
        let (mut equations, mut others) = (Vec::new(), Vec::new());
        for condition in self.conditions {
            let callback = &condition.value.0;
            let args = std::slice::from_ref(place);
            let compared = self
                .ctx
                .caller
                .comparisons(callback, args, condition.span)
                .map_err(|found| from_here(self.ctx, *found, place))?;
            for comparison in compared {
                let mut parts = Vec::new();
                let spanned = |number: Number<Real>| (number.value, comparison.span);
                match comparison.relation {
                    Relation::Equal => {
                        numbers(&comparison.difference, comparison.span, &mut parts)?;
                        equations.extend(parts.into_iter().map(spanned));
                    }
                    Relation::NotNegative => {
                        parts.push(number(&comparison.difference, comparison.span)?);
                        others.extend(parts.into_iter().map(spanned));
                    }
                }
            }
        }
        let n_equations = equations.len();
        let (reals, spans): (Vec<Real>, Vec<Span>) = equations.into_iter().chain(others).unzip();
        let (known, n_before) = self.known.get_or_insert((spans, n_equations));
        if (known.len(), *n_before) != (reals.len(), n_equations) {
            let message = format!(
                "there are {} conditions at {place}, and {} before",
                reals.len(),
                known.len()
            );
            let span = self.conditions.first().map_or(self.f.span, |condition| condition.span);
            return Diagnostic::error(Code::WrongKind, span, message).fail();
        }
        let value = found.value.scaled(self.better.sign());
        Ok(std::iter::once(value).chain(reals).collect())
    }

    /// The conditions that do not hold, and by how much.
    fn broken(&self, values: &[f64]) -> impl Iterator<Item = (Span, f64)> {
        let (spans, n_equations) = self.known.clone().unwrap_or_default();
        let broken: Vec<(Span, f64)> = spans
            .into_iter()
            .zip(values)
            .enumerate()
            .map(|(idx, (span, value))| {
                (span, if idx < n_equations { value.abs() } else { -value })
            })
            .filter(|(_, off)| CONDITION_RELATIVE < *off)
            .take(MOST_LABELS)
            .collect();
        broken.into_iter()
    }

    /// Why there is no best place.
    fn refusal(&self, unknowns: &Unknowns, found: &ConstrainedLeast) -> Diagnostic {
        let [falls, least] = [self.better.falls(), self.better.least()];
        let place = unknowns.rounded(&found.unknowns);
        let best = six_digits(self.better.sign() * found.values[0], self.dim.known());
        let refused = |message| {
            Diagnostic::error(Code::NoAnswer, self.f.span, message)
                .label(format!("the best place found is {place}, where it is {best}"))
        };
        match found.end {
            LeastEnd::Unbounded => refused(format!("the function {falls} without bound"))
                .hint("give bounds by `within`, or conditions by `subject`"),
            LeastEnd::Unattained => {
                refused(format!("the function {falls} by less and less the farther off, and attains no {least} value"))
                    .hint("what it may tend to is not reached: give bounds by `within`, or conditions by `subject`")
            }
            LeastEnd::Pole => {
                let place = unknowns.rounded(&unknowns.beside_zero(&found.unknowns));
                let message = format!("the function {falls} without bound near {place}");
                Diagnostic::error(Code::NoAnswer, self.f.span, message)
                    .label("so no value is the best")
                    .hint("it has a pole there: keep off it by `within`, or by conditions in `subject`")
            }
            LeastEnd::Flat => refused("the function is the same all around the start".to_owned())
                .hint("it may not depend on the unknowns; else start elsewhere"),
            LeastEnd::Contradictory => {
                let refused =
                    refused("the conditions do not hold together near the start".to_owned());
                let refused =
                    self.broken(&found.values[1..]).fold(refused, |refused, (span, off)| {
                        refused
                            .also(span, format!("this is off by {} there", six_digits(off, None)))
                    });
                refused.hint("take conditions away, or start where they hold")
            }
            LeastEnd::Settled | LeastEnd::Unsettled => {
                refused(format!("no {least} value was settled on"))
                    .hint("start nearer to it, or give bounds by `within`")
            }
        }
    }
}
