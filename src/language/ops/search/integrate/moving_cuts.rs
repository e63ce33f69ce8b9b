//! Places at which a function under an integral goes another way, where derivatives are carried along: as such a
//! place moves, the integral gains what the function is on the one side and loses what it is on the other.
//!
//! Which way the function goes is told by its comparisons. Between two neighbouring places at which it was asked and
//! goes different ways the change is found by bisection; how it moves follows from what is compared there, by
//! the theorem of implicit functions. Leibniz' rule, as for the ends of a range.

use super::{
    super::switching::{END_SLOPE, bisected},
    found::{Found, six_digit_place},
};
use crate::{
    diag::{Code, Diagnostic, Result, Span},
    kernel::{
        Jet,
        jet::moved_end,
        sorting::sort_by,
        tolerance::{SWITCH_ALIKE_RELATIVE, SWITCH_STEP_RELATIVE},
    },
    value::{Real, Switch, is_like},
};

/// Changes between two neighbouring places.
const MOST_CHANGES: usize = 8;

/// What follows beyond an end of a range.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum RangeEnd {
    /// Nothing: the end itself is never asked for.
    Last,
    /// A further range of the same integral, as if there were no end.
    Smooth,
    /// A further one in which places move in another way.
    Corner,
}

/// A place at which the function was asked.
#[derive(Clone)]
pub(super) struct SeenPlace {
    pub(super) at: f64,
    pub(super) switches: Vec<Switch>,
}

/// What is known of an integral.
pub(super) struct MovingCuts<'a> {
    pub(super) span: Span,
    /// The shape of what is carried along.
    pub(super) like: &'a Jet,
    pub(super) ends: [f64; 2],
    pub(super) beyond: [RangeEnd; 2],
    /// Whether the function can be asked at places that carry derivatives.
    pub(super) can_move: bool,
    pub(super) seen: Vec<SeenPlace>,
}

/// Both sides of a place, with the number of what goes another way.
pub(super) struct BranchChange {
    pub(super) sides: [(f64, Found); 2],
    pub(super) number: usize,
}

/// Whether a function is another one on both sides of a place, as far as that counts for derivatives of this shape.
pub(super) fn jumps(like: &Jet, [(_, before), (_, behind)]: &[(f64, Found); 2]) -> bool {
    let size = before.size.max(behind.size);
    let (width, order) = (like.coefficients().len(), like.order());
    let counts =
        |k: usize| like.n_variables().map_or(k % width < order, |_| k.is_multiple_of(width));
    let mut parts = before.value.iter().zip(&behind.value).enumerate();
    parts.any(|(k, (a, b))| counts(k) && SWITCH_ALIKE_RELATIVE * size < (a - b).abs())
}

impl MovingCuts<'_> {
    /// What the integral gains.
    pub(super) fn gain(mut self, ask: &mut dyn FnMut(Real) -> Result<Found>) -> Result<Vec<f64>> {
        sort_by(&mut self.seen, |a, b| a.at.total_cmp(&b.at));
        let mut sum = Vec::new();
        for idx in 1..self.seen.len() {
            for _ in 0..MOST_CHANGES {
                let [low, high] = [&self.seen[idx - 1], &self.seen[idx]];
                if is_like(&low.switches, &high.switches) {
                    break;
                }
                let Some((cut, behind)) = between([low, high], ask)? else { break };
                let gain = self.gain_at(&cut, idx, ask)?;
                sum.resize(gain.len().max(sum.len()), 0.0);
                sum.iter_mut().zip(gain).for_each(|(sum, part)| *sum += part);
                self.seen[idx - 1] = behind;
            }
        }
        Ok(sum)
    }

    fn gain_at(
        &self,
        cut: &BranchChange,
        idx: usize,
        ask: &mut dyn FnMut(Real) -> Result<Found>,
    ) -> Result<Vec<f64>> {
        let [(low, before), (high, behind)] = &cut.sides;
        let switch = |found: &Found| found.switches.get(cut.number).cloned();
        let (Some(one), Some(other)) = (switch(before), switch(behind)) else {
            return Ok(Vec::new());
        };
        // Where it goes another way by plain numbers alone nothing moves.
        let is_still = one.span != other.span || matches!(one.margin, Some(Real::Plain(_)));
        if is_still || !jumps(self.like, &cut.sides) {
            return Ok(Vec::new());
        }
        let (width, order) = (self.like.coefficients().len(), self.like.order());
        let is_one = |a: f64, b: f64| a.total_cmp(&b).is_eq();
        let is_on =
            |(end, beyond)| beyond == RangeEnd::Corner && (is_one(end, *low) || is_one(end, *high));
        if self.ends.into_iter().zip(self.beyond).any(is_on) {
            return self.unknown(*low);
        }
        let slope = self.slope(cut, idx, ask)?;
        let known = one.margin.zip(slope.filter(|slope| slope.is_finite() && *slope != 0.0));
        let Some((margin, slope)) = known else { return self.unknown(*low) };
        let mut place = margin.like(self.like).scaled(-1.0 / slope).with_value(*low);
        if order < 2 {
            let way = place.coefficients();
            let gain = |k: usize| {
                (before.value[k - k % width] - behind.value[k - k % width]) * way[k % width]
            };
            return Ok((0..before.value.len())
                .map(|k| if k % width == 0 { 0.0 } else { gain(k) })
                .collect());
        }
        if !self.can_move {
            return self.unknown(*low);
        }
        for _ in 1..=order {
            let found = ask(Real::Jet(place.clone()))?;
            let Some(Some(margin)) = switch(&found).map(|switch| switch.margin) else {
                return self.unknown(*low);
            };
            let rest = margin.like(self.like).with_value(0.0);
            place = place.minus(&rest.scaled(1.0 / slope)).with_value(*low);
        }
        let mut flat = |end: Jet| {
            let parts = moved_end(&end, |at| -> Result<Vec<Jet>> {
                let flat = ask(Real::Jet(at.clone()))?.value;
                Ok(flat.chunks(width).map(|part| self.like.with_coefficients(part)).collect())
            })?;
            Result::Ok(
                parts.iter().flat_map(|part| part.coefficients().to_vec()).collect::<Vec<f64>>(),
            )
        };
        let (gained, lost) = (flat(place.clone())?, flat(place.with_value(*high))?);
        Ok(gained.iter().zip(&lost).map(|(a, b)| a - b).collect())
    }

    /// How fast what is compared changes along the range there: by its derivative, where the function can be asked at
    /// places that carry some, else from the side that is known farther.
    fn slope(
        &self,
        cut: &BranchChange,
        idx: usize,
        ask: &mut dyn FnMut(Real) -> Result<Found>,
    ) -> Result<Option<f64>> {
        match self.exact_slope(cut, ask) {
            Some(slope) => Ok(Some(slope)),
            None => self.slope_by_differences(cut, idx, ask),
        }
    }

    fn exact_slope(
        &self,
        cut: &BranchChange,
        ask: &mut dyn FnMut(Real) -> Result<Found>,
    ) -> Option<f64> {
        let (at, before) = &cut.sides[0];
        let span = before.switches.get(cut.number).filter(|_| self.can_move)?.span;
        // At such a place more may be compared that carries derivatives.
        let is_own = |switch: &&Switch| switch.span == span;
        let n = before.switches.iter().filter(is_own).count();
        let number = before.switches[..cut.number].iter().filter(is_own).count();
        let mut by_first = |slope: f64| {
            let found = ask(Real::Jet(self.like.with_coefficients(&[*at, slope]))).ok()?;
            let own: Vec<&Switch> = found.switches.iter().filter(is_own).collect();
            let margin = own.get(number).filter(|_| own.len() == n)?.margin.as_ref()?;
            margin.like(self.like).coefficients().get(1).copied()
        };
        Some(by_first(1.0)? - by_first(0.0)?)
    }

    fn slope_by_differences(
        &self,
        cut: &BranchChange,
        idx: usize,
        ask: &mut dyn FnMut(Real) -> Result<Found>,
    ) -> Result<Option<f64>> {
        let [(low, before), (high, behind)] = &cut.sides;
        let is_same = |found: &Found| {
            let switches = found.switches.clone();
            move |place: &&SeenPlace| is_like(&place.switches, &switches)
        };
        let left = self.seen[..idx].iter().rev().take_while(is_same(before)).last();
        let right = self.seen[idx..].iter().take_while(is_same(behind)).last();
        let left = low - left.map_or(*low, |place| place.at);
        let right = right.map_or(0.0, |place| place.at) - high;
        let (at, reach) = if left < right { (*high, -right) } else { (*low, left) };
        let step = (0.25 * reach.abs())
            .min(SWITCH_STEP_RELATIVE * (self.ends[1] - self.ends[0]))
            .copysign(reach);
        let mut sum = 0.0;
        for (k, weight) in END_SLOPE.iter().enumerate() {
            let found = ask(Real::Plain(at - k as f64 * step))?;
            let Some(Some(margin)) =
                found.switches.get(cut.number).map(|switch| switch.margin.clone())
            else {
                return Ok(None);
            };
            sum += weight * margin.value();
        }
        Ok(Some(sum / step))
    }

    fn unknown<T>(&self, at: f64) -> Result<T> {
        unknown(self.span, at)
    }
}

/// Fails: a place moves, and nobody knows how, or on one side alone.
pub(super) fn unknown<T>(span: Span, at: f64) -> Result<T> {
    let message = format!(
        "the function under the integral jumps or kinks near {}, which moves with what derivatives are wanted by",
        six_digit_place(at)
    );
    Diagnostic::error(Code::NoDerivative, span, message)
        .label("no derivative passes through here")
        .hint("make that place an end of the range: `integrate(f, 0..x) + integrate(g, x..1)`; or take differences")
        .fail()
}

/// The first change between two places that go different ways, with the place behind it; none between neighbouring numbers.
pub(super) fn between(
    [low, high]: [&SeenPlace; 2],
    ask: &mut dyn FnMut(Real) -> Result<Found>,
) -> Result<Option<(BranchChange, SeenPlace)>> {
    let first = ask(Real::Plain(low.at))?;
    let sides = [(low.at, first), (high.at, ask(Real::Plain(high.at))?)];
    let is_first = |one: &Found, other: &Found| is_like(&one.switches, &other.switches);
    let sides = bisected(sides, |at| ask(Real::Plain(at)), is_first);
    let [(_, before), (at, behind)] = &sides;
    let mut pairs = before.switches.iter().zip(&behind.switches);
    let number = pairs.position(|(a, b)| !a.is_like(b)).unwrap_or(before.switches.len());
    let behind = SeenPlace { at: *at, switches: behind.switches.clone() };
    Ok(Some((BranchChange { sides, number }, behind)))
}
