//! Rates of change that go one way or another, where derivatives are carried along: as a place moves at which the rate
//! jumps, the trajectory goes with the one rate for longer and with the other one for less.
//!
//! Which way the function goes is told by its comparisons. Steps end where that changes; how the place moves follows from
//! what is compared there, by the theorem of implicit functions, and by so much times the jump of the rate the slopes of
//! the trajectory jump. Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, §I.14, §II.6.

use super::{
    super::switching::{END_SLOPE, bisected},
    state::{Search, State},
};
use crate::{
    diag::{Code, Diagnostic, Result},
    kernel::{
        BranchEnd, BranchedRate, Jet, Trajectory,
        tolerance::{
            BEYOND_END_RELATIVE, SWITCH_ALIKE_RELATIVE, SWITCH_SPEED_RELATIVE,
            SWITCH_STEP_RELATIVE, SWITCH_STEP_SHRINK,
        },
    },
    value::{Ctx, Real, Switch, is_like},
};

/// How often such steps become shorter, where on a longer way back another way was gone.
const TIMES_SHORTER: usize = 5;

/// Why the rate is not told.
#[derive(Debug)]
pub(super) enum Stop {
    /// The function goes another way than where the branch began.
    Branch,
    /// The function failed, or no derivative is known.
    Failed(Box<Diagnostic>),
}

/// What a function of the script yields at a place, with what decided it.
struct RateAnswer {
    rate: Vec<f64>,
    way: Vec<Switch>,
}

/// The rate that a function of the script tells.
pub(super) struct ScriptRate<'a, 'c> {
    ctx: &'a mut Ctx<'c>,
    search: &'a Search<'a>,
    state: &'a State,
    /// Which way the function went where the branch began, and where that is.
    way: Vec<Switch>,
    since: f64,
    /// The largest rate of which it was told.
    largest: f64,
    /// The shape of derivatives that it told without being given any.
    pub(super) seen: Option<Jet>,
}

impl<'a, 'c> ScriptRate<'a, 'c> {
    pub(super) fn new(ctx: &'a mut Ctx<'c>, search: &'a Search<'a>, state: &'a State) -> Self {
        let since = search.range.ends[0];
        Self { ctx, search, state, way: Vec::new(), since, largest: 0.0, seen: None }
    }

    fn asked(&mut self, place: f64, parts: &[f64]) -> Result<RateAnswer> {
        let Search { f, range, varies, .. } = self.search;
        let is_noted = *varies || self.state.like.is_some();
        let outer = self.ctx.caller.note_switches(is_noted.then(Vec::new));
        let found = self.state.asked(self.ctx, f, range, (place, parts));
        let way = self.ctx.caller.note_switches(outer).unwrap_or_default();
        let found = found?;
        if *varies && self.seen.is_none() {
            let margins = way.iter().filter_map(|switch| switch.margin.as_ref());
            self.seen = found.iter().chain(margins).find_map(|real| match real {
                Real::Jet(jet) => Some(jet.clone()),
                Real::Plain(_) => None,
            });
        }
        let rate = self.state.flat(&found);
        let own = rate.iter().take(self.state.n_numbers());
        self.largest = own.fold(self.largest, |most, part| most.max(part.abs()));
        Ok(RateAnswer { rate, way })
    }

    /// Between which widths behind the end of a branch the function goes another way first, neighbouring numbers, with its
    /// answers there; none if it does not over all of the width.
    fn change(&mut self, end: BranchEnd<'_>, width: f64) -> Result<Option<[(f64, RateAnswer); 2]>> {
        let mut ask = |width: f64| self.asked(end.place + width, &end.state_after(width));
        let sides = [(0.0, ask(0.0)?), (width, ask(width)?)];
        let is_first = |one: &RateAnswer, other: &RateAnswer| is_like(&one.way, &other.way);
        if is_first(&sides[0].1, &sides[1].1) {
            return Ok(None);
        }
        let beyond = sides[1].1.way.clone();
        let [inside, mut outside] = bisected(sides, &mut ask, is_first);
        // A way that is gone at one number alone, as by `sign` at 0, lies between the two others.
        let at = end.place + outside.0;
        let next = (if 0.0 < width { at.next_up() } else { at.next_down() }) - end.place;
        if let Ok(found) = ask(next)
            && !is_first(&found, &outside.1)
            && !is_first(&found, &inside.1)
            && is_like(&found.way, &beyond)
        {
            outside = (next, found);
        }
        Ok(Some([inside, outside]))
    }

    /// By how much the rate falls from one side to the other; none where it goes on.
    fn jump(&self, [before, behind]: [&RateAnswer; 2]) -> Option<Vec<f64>> {
        let n = self.state.n_numbers();
        let jump: Vec<f64> =
            before.rate.iter().zip(&behind.rate).take(n).map(|(a, b)| a - b).collect();
        jump.iter().any(|part| SWITCH_ALIKE_RELATIVE * self.largest < part.abs()).then_some(jump)
    }

    /// How the place moves with each variable at which the function goes over from one way to the other.
    fn motion(&mut self, end: BranchEnd<'_>, ways: [&[Switch]; 2]) -> Result<Vec<f64>> {
        let Some(like) = &self.state.like else { return Ok(Vec::new()) };
        let mut known: Option<Vec<f64>> = None;
        let pairs = ways[0].iter().zip(ways[1]).take_while(|(one, other)| one.span == other.span);
        for (number, (one, _)) in pairs.enumerate().filter(|(_, (one, other))| !one.is_like(other))
        {
            let Some(margin) = &one.margin else { return self.unknown(end.place) };
            let mut motion = margin.like(like).slopes().to_vec();
            if motion.iter().any(|slope| *slope != 0.0) {
                let Some(speed) = self.speed(end, number)? else { return self.unknown(end.place) };
                motion.iter_mut().for_each(|slope| *slope /= -speed);
            }
            let size = motion.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
            let is_other = |known: &Vec<f64>| {
                let mut pairs = known.iter().zip(&motion);
                pairs.any(|(a, b)| SWITCH_SPEED_RELATIVE * size.max(a.abs()) < (a - b).abs())
            };
            // What is decided in one place by several comparisons is so only as long as they move together.
            if known.as_ref().is_some_and(is_other) {
                return self.unknown(end.place);
            }
            known = Some(motion);
        }
        known.map_or_else(|| self.unknown(end.place), Ok)
    }

    /// How fast what is compared changes along the trajectory before the end of a branch; none where it does not, or is not
    /// the same function.
    fn speed(&mut self, end: BranchEnd<'_>, number: usize) -> Result<Option<f64>> {
        let [from, to] = self.search.range.ends;
        let mut step = (0.25 * (end.place - self.since)).min(SWITCH_STEP_RELATIVE * (to - from));
        for _ in 0..TIMES_SHORTER {
            let speed = self.speed_over(end, number, step)?;
            if speed.is_some_and(|speed| speed.is_finite() && speed != 0.0) {
                return Ok(speed);
            }
            step *= SWITCH_STEP_SHRINK;
        }
        Ok(None)
    }

    fn speed_over(&mut self, end: BranchEnd<'_>, number: usize, step: f64) -> Result<Option<f64>> {
        let mut sum = 0.0;
        for (k, weight) in END_SLOPE.iter().enumerate() {
            let back = -(k as f64) * step;
            let found = self.asked(end.place + back, &end.state_after(back))?;
            let margin = found.way.get(number).and_then(|switch| switch.margin.as_ref());
            let Some(margin) = margin.filter(|_| is_like(&found.way, &self.way)) else {
                return Ok(None);
            };
            sum += weight * margin.value();
        }
        Ok(Some(sum / step))
    }

    /// The state behind the end of a branch, with the slopes that have jumped.
    fn state_beyond(&mut self, end: BranchEnd<'_>, to: f64) -> Result<Vec<f64>> {
        let Some([inside, outside]) = self.change(end, to - end.place)? else {
            return Ok(end.state_after(to - end.place));
        };
        let mut state = end.state_after(inside.0);
        let jump = self.jump([&inside.1, &outside.1]);
        let mut moves = false;
        if let Some(jump) = &jump {
            let motion = self.motion(end, [&inside.1.way, &outside.1.way])?;
            moves = motion.iter().any(|part| *part != 0.0);
            for (motion, slopes) in motion.iter().zip(state.chunks_mut(jump.len()).skip(1)) {
                slopes.iter_mut().zip(jump).for_each(|(slope, jump)| *slope += motion * jump);
            }
        }
        let place = end.place + outside.0;
        let rate = self.asked(place, &state)?.rate;
        let behind = BranchEnd { place, state: &state, rate: &rate }.state_after(to - place);
        // It turns back at once, goes a third way, or the range ends there.
        let is_beside = || to >= self.search.range.ends[1];
        if moves && (is_beside() || !is_like(&self.asked(to, &behind)?.way, &outside.1.way)) {
            return self.unknown(end.place);
        }
        Ok(behind)
    }

    /// That at neither end of the range the rate jumps at a place that moves: it has a derivative on each side alone.
    ///
    /// # Errors
    /// Such an end.
    pub(super) fn check_ends(&mut self, found: &Trajectory) -> Result<()> {
        let (Some(like), [from, to]) = (&self.state.like, self.search.range.ends) else {
            return Ok(());
        };
        let reach = BEYOND_END_RELATIVE * (to - from);
        for (node, width) in [(found.nodes.first(), -reach), (found.nodes.last(), reach)] {
            let Some(node) = node else { continue };
            let end = BranchEnd { place: node.place, state: &node.state, rate: &node.rate };
            // Beyond the range there may be no rate.
            let Ok(Some([inside, outside])) = self.change(end, width) else { continue };
            let ways = inside.1.way.iter().zip(&outside.1.way);
            let mut other = ways.filter(|(one, other)| !one.is_like(other));
            let moves = other.next().is_some_and(|(one, _)| {
                let slopes = one.margin.as_ref().map(|margin| margin.like(like).slopes().to_vec());
                slopes.is_none_or(|slopes| slopes.iter().any(|slope| *slope != 0.0))
            });
            if moves && self.jump([&inside.1, &outside.1]).is_some() {
                return self.unknown(node.place);
            }
        }
        Ok(())
    }

    fn unknown<T>(&self, at: f64) -> Result<T> {
        let message = format!(
            "the rate jumps at {}, and how that place moves with what derivatives are wanted by is not known",
            self.search.range.place_text(at)
        );
        Diagnostic::error(Code::NoDerivative, self.search.f.span, message)
            .label("no derivative passes through here")
            .hint("the trajectory may turn back there, start, end, or only touch what is compared; take differences: `gradient(f, at, differences = true)`")
            .fail()
    }
}

impl BranchedRate<Stop> for ScriptRate<'_, '_> {
    fn at(&mut self, place: f64, state: &[f64]) -> std::result::Result<Vec<f64>, Stop> {
        self.asked(place, state).map(|found| found.rate).map_err(Stop::Failed)
    }

    fn begin(&mut self, place: f64, state: &[f64]) -> std::result::Result<Vec<f64>, Stop> {
        let found = self.asked(place, state).map_err(Stop::Failed)?;
        (self.way, self.since) = (found.way, place);
        Ok(found.rate)
    }

    fn along(&mut self, place: f64, state: &[f64]) -> std::result::Result<Vec<f64>, Stop> {
        match self.asked(place, state) {
            Ok(found) if self.state.like.is_none() || is_like(&found.way, &self.way) => {
                Ok(found.rate)
            }
            Ok(_) => Err(Stop::Branch),
            // On the place itself at which it kinks there is no derivative.
            Err(found) if found.code == Code::NoDerivative => Err(Stop::Branch),
            Err(found) => Err(Stop::Failed(found)),
        }
    }

    fn beyond(
        &mut self,
        failed: Stop,
        end: BranchEnd<'_>,
        to: f64,
    ) -> std::result::Result<Vec<f64>, Stop> {
        match failed {
            Stop::Branch => self.state_beyond(end, to).map_err(Stop::Failed),
            failed @ Stop::Failed(_) => Err(failed),
        }
    }
}
