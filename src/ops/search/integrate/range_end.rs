//! Ends of ranges on which a function under an integral goes another way, where derivatives are carried along: what moves
//! there apart from the end comes into the range on one side alone.

use super::{
    found::Found,
    moving_cuts::{SeenPlace, between, jumps, unknown},
};
use crate::{
    diag::{Result, Span},
    kernel::{Jet, tolerance::SWITCH_SPEED_RELATIVE},
    value::{Real, is_like},
};

/// Numbers next to one another on each side of an end, between which a place is on it.
const NEAR: f64 = 4.0;

/// An end of a range.
pub(super) struct RangeLimit<'a> {
    pub(super) end: &'a Real,
    /// Which way the range goes from there: 1 where it is its low end, -1 where it is its high one, 0 where it has no length.
    pub(super) inward: f64,
    /// The distance of numbers there.
    pub(super) spacing: f64,
}

impl RangeLimit<'_> {
    /// Where the function is asked for what it is at the end: there, or on the last number inside where beyond it goes
    /// another way. Where it has no value beside the end nothing is known of that.
    ///
    /// # Errors
    /// A jump on the end that moves apart from it; those of the function.
    pub(super) fn place(
        &self,
        (like, span): (&Jet, Span),
        mut ask: impl FnMut(Real) -> Result<Found>,
    ) -> Result<f64> {
        let at = self.end.value();
        // A series of one variable goes into one side of the place.
        if like.n_variables().is_none() {
            return Ok(at);
        }
        let moved = |at: f64| Real::Jet(self.end.like(like).with_value(at));
        let mut seen =
            |at: f64| ask(moved(at)).map(|found| SeenPlace { at, switches: found.switches });
        let reach = NEAR * self.spacing;
        let (Ok(low), Ok(high)) = (seen(at - reach), seen(at + reach)) else { return Ok(at) };
        if is_like(&low.switches, &high.switches) {
            return Ok(at);
        }
        let mut beside = |at: Real| ask(moved(at.value()));
        let Some((cut, _)) = between([&low, &high], &mut beside)? else { return Ok(at) };
        if !jumps(like, &cut.sides) {
            return Ok(at);
        }
        let (inside, found) = &cut.sides[usize::from(0.0 < self.inward)];
        let margin = |found: &Found| found.switches.get(cut.number)?.margin.clone();
        let own = ask(Real::Jet(like.same(*inside)))?;
        let away = ask(Real::Jet(like.with_coefficients(&[*inside, 1.0])))?;
        let moves = match (margin(found), margin(&own), margin(&away)) {
            (Some(along), Some(own), Some(away)) => {
                let first = |margin: &Real| margin.like(like).slopes().first().copied();
                let speed = first(&away).zip(first(&own)).map_or(0.0, |(away, own)| away - own);
                // The place is known to some of the numbers beside it.
                let rest = reach / SWITCH_SPEED_RELATIVE * speed.abs();
                along.like(like).slopes().iter().any(|slope| rest < slope.abs())
            }
            _ => true,
        };
        match moves || self.inward == 0.0 {
            true => unknown(span, at),
            false => Ok(*inside),
        }
    }
}
