//! Lines along which two surfaces touch, followed from a place of them.

use glam::DVec3;

use super::{
    SAMPLING,
    branch_sample::{BranchSample, length_between},
    cubic::CubicSegment,
    parallel_pair::{ParallelPair, ParameterRegion},
    sample::{BranchSamples, MOST_TURN},
    surface_pair::SurfacePair,
};
use crate::{
    ceiling::{BISECTIONS, CONTACT_PLACES},
    numeric::bisection::bisected,
};

/// How much longer the next step is than one that was good.
const GROWTH: f64 = 1.6;

/// The longest step, by the reach of what is known about a place.
const STEP_REACH: f64 = 0.5;

/// A place of the line.
#[derive(Clone, Copy)]
struct TangencyPlace {
    seen: ParallelPair,
    /// Ahead, a unit vector.
    tangent: DVec3,
    reach: ParameterRegion,
}

impl TangencyPlace {
    fn sample(self) -> BranchSample {
        BranchSample { point: self.seen.point, before: self.tangent, behind: self.tangent }
    }
}

impl SurfacePair<'_> {
    /// The line through a place, and how far about it all is known that the surfaces share; `None`
    /// where they do not touch along one. Its direction is arbitrary.
    pub(super) fn tangency(
        &self,
        start: &ParallelPair,
    ) -> Option<(BranchSamples, Vec<ParameterRegion>)> {
        let first = self.stop(*start, start.along(), self.size)?;
        let (mut stops, is_closed) = self.stops(first);
        if !is_closed {
            let (mut back, _) = self.stops(TangencyPlace { tangent: -first.tangent, ..first });
            back.reverse();
            back.iter_mut().for_each(|stop| stop.tangent = -stop.tangent);
            back.push(first);
            back.append(&mut stops);
            stops = back;
        } else {
            stops.insert(0, first);
        }
        let run = BranchSamples { samples: stops.iter().map(|stop| stop.sample()).collect() };
        let reaches = stops.into_iter().map(|stop| stop.reach).collect();
        (self.touch_size() < run.length()).then_some((run, reaches))
    }

    /// The places ahead of one, and whether the last is that one again.
    fn stops(&self, start: TangencyPlace) -> (Vec<TangencyPlace>, bool) {
        let mut stops = Vec::new();
        let mut last = start;
        let mut step = start.reach.radius;
        while stops.len() < CONTACT_PLACES && self.tolerance < step {
            step = step.min(STEP_REACH * last.reach.radius);
            let Some((next, is_end)) = self.next(last, step) else {
                step *= 0.5;
                continue;
            };
            let back = (start.seen.point - last.seen.point).dot(last.tangent);
            let reached = (next.seen.point - last.seen.point).dot(last.tangent);
            let closes = !stops.is_empty()
                && 0.0 < back
                && back <= reached
                && cubic(last, next).misses_near(start.seen.point, back / reached)
                    <= self.tolerance;
            if closes {
                stops.push(start);
                return (stops, true);
            }
            if self.tolerance < next.seen.point.distance(last.seen.point) {
                stops.push(next);
            }
            if is_end {
                break;
            }
            last = next;
            step *= GROWTH;
        }
        (stops, false)
    }

    /// The place a step ahead, and whether the surfaces end there.
    fn next(&self, from: TangencyPlace, step: f64) -> Option<(TangencyPlace, bool)> {
        let at = |step: f64| {
            let seen = self.touch_near(from.seen.ahead(from.tangent * step))?;
            self.is_contact(&seen).then_some(seen)
        };
        let far = at(step)?;
        let is_end = !self.is_inside(far.at);
        let length = if is_end {
            let is_on = |step: f64| at(step).is_some_and(|seen| self.is_inside(seen.at));
            bisected([0.0, step], BISECTIONS, is_on)[0]
        } else {
            step
        };
        let (middle, seen) = (at(0.5 * length)?, if is_end { at(length)? } else { far });
        let next = self.stop(seen, from.tangent, 2.0 * from.reach.radius)?;
        let turn = from.tangent.distance_squared(next.tangent);
        let follows = turn <= MOST_TURN
            && cubic(from, next).misses(middle.point) <= SAMPLING * self.tolerance;
        follows.then_some((next, is_end))
    }

    fn stop(&self, seen: ParallelPair, ahead: DVec3, most: f64) -> Option<TangencyPlace> {
        let along = seen.along();
        let tangent = if along.dot(ahead) < 0.0 { -along } else { along };
        let radius = self.radius(&seen, seen.strongest(), most)?;
        Some(TangencyPlace { seen, tangent, reach: seen.reach(radius) })
    }
}

fn cubic(from: TangencyPlace, to: TangencyPlace) -> CubicSegment {
    let [from, to] = [from, to].map(TangencyPlace::sample);
    CubicSegment::between(from, to, length_between(from, to))
}
