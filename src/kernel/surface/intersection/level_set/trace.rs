//! The curve in which two surfaces cross, followed from a place of it.

use glam::DVec3;

use super::{
    SAMPLING,
    branch_sample::{BranchSample, length_between},
    cubic::CubicSegment,
    sample::{BranchSamples, MOST_TURN, VanishingPlace},
    surface_pair::{PairParameters, PlaceCondition, SurfacePair, within},
    tangential_contact::{BranchCrossing, BranchDirection},
};
use crate::{
    ceiling::TRACE_SAMPLES,
    frame::unit,
    tolerance::{FIRST_STEP_SHARE, KNOT_RELATIVE, LONGEST_STEP_SHARE, SHORTEST_STEP_SHARE},
    work,
};

/// How much longer the next step is than one that was good.
pub(super) const GROWTH: f64 = 1.6;

impl SurfacePair<'_> {
    /// The whole curve through a place: to the ends of the domains, to where it meets others, or
    /// around.
    pub(super) fn run(&self, start: PairParameters, ends: &CurveEnds) -> BranchSamples {
        let (ahead, is_closed) = self.half(start, 1.0, ends);
        let mut places = Vec::new();
        if !is_closed {
            places = self.half(start, -1.0, ends).0;
            places.reverse();
        }
        places.push(start);
        places.extend(ahead);
        run_of(places)
    }

    /// The curve along a branch out of a junction.
    pub(super) fn run_out(&self, way: BranchDirection, ends: &CurveEnds) -> BranchSamples {
        let (mut places, _) = self.half(way.place, way.sign, ends);
        places.insert(0, way.place);
        if way.sign < 0.0 {
            places.reverse();
        }
        run_of(places)
    }

    /// The places behind the start in a direction, and whether the last one is the start again.
    fn half(
        &self,
        start: PairParameters,
        sign: f64,
        ends: &CurveEnds,
    ) -> (Vec<PairParameters>, bool) {
        let mut places: Vec<PairParameters> = Vec::new();
        let mut last = start;
        let mut step = FIRST_STEP_SHARE * self.size;
        while places.len() < TRACE_SAMPLES && last.tangent != DVec3::ZERO && work::goes_on(1) {
            if let Some(junction) = ends.junction_ahead(last, sign) {
                if let Some(place) = self.arrival(last, sign, junction) {
                    places.push(place);
                    break;
                }
                step = step.min(0.5 * junction.reach.point.distance(last.point));
            }
            if let Some(collapsed) = self.collapsed_ahead(last, sign, step) {
                if let Some(place) = self.arrival_at(last, sign, collapsed) {
                    places.push(place);
                    break;
                }
                step = step.min(0.5 * collapsed.point.distance(last.point));
            }
            let Some((next, is_end)) = self.advance(last, sign * step) else {
                step *= 0.5;
                if step < SHORTEST_STEP_SHARE * self.tolerance {
                    break;
                }
                continue;
            };
            let reached = (next.point - last.point).dot(last.tangent * sign);
            let back = (start.point - last.point).dot(last.tangent * sign);
            if !places.is_empty()
                && 0.0 < back
                && back <= reached
                && self.cubic(last, next, sign).misses_near(start.point, back / reached)
                    <= self.tolerance
                && 0.0 < next.tangent.dot(start.tangent)
            {
                places.push(start);
                return (places, true);
            }
            if let Some(end) = self.pole_ahead(last, next, sign) {
                places.push(end);
                break;
            }
            places.push(next);
            if is_end || ends.spots.iter().any(|s| s.point.distance(next.point) <= s.radius) {
                break;
            }
            last = next;
            step = (GROWTH * step).min(LONGEST_STEP_SHARE * self.size);
        }
        (places, false)
    }

    /// A pole on the way to the next place, where the surfaces touch.
    fn pole_ahead(
        &self,
        last: PairParameters,
        next: PairParameters,
        sign: f64,
    ) -> Option<PairParameters> {
        let reached = (next.point - last.point).dot(last.tangent * sign);
        self.poles.iter().find_map(|&pole| {
            let share = (pole - last.point).dot(last.tangent * sign) / reached;
            let is_passed = 0.0 < share
                && share <= 1.0
                && self.tolerance < pole.distance(last.point)
                && self.cubic(last, next, sign).misses_near(pole, share) <= 4.0 * self.tolerance;
            let tangent = unit(last.tangent.lerp(next.tangent, share))?;
            is_passed.then_some(PairParameters { at: next.at, point: pole, tangent })
        })
    }

    /// The junction as the next place, where a cubic to it stays on the curve.
    fn arrival(
        &self,
        last: PairParameters,
        sign: f64,
        junction: &BranchCrossing,
    ) -> Option<PairParameters> {
        let back = last.point - junction.reach.point;
        let outward = |way: &BranchDirection| (way.place.tangent * way.sign).dot(back);
        let way = junction.ways.iter().max_by(|a, b| outward(a).total_cmp(&outward(b)))?;
        let end = way.place;
        if MOST_TURN < last.tangent.distance_squared(end.tangent) {
            return None;
        }
        let cubic = self.cubic(last, end, sign);
        let middle = std::array::from_fn(|i| 0.5 * (last.at[i] + end.at[i]));
        let plane = PlaceCondition::InPlane { origin: cubic.middle(), normal: unit(back)? };
        let place = self.common_where(middle, plane)?;
        (cubic.misses(place.point) <= SAMPLING * self.tolerance).then_some(end)
    }

    pub(super) fn cubic(
        &self,
        from: PairParameters,
        to: PairParameters,
        sign: f64,
    ) -> CubicSegment {
        let sample = |place: PairParameters| {
            let tangent = place.tangent * sign;
            BranchSample { point: place.point, before: tangent, behind: tangent }
        };
        let [from, to] = [from, to].map(sample);
        CubicSegment::between(from, to, length_between(from, to))
    }

    /// The place a step further, and whether a domain ends there; none where the step is too long.
    fn advance(&self, from: PairParameters, step: f64) -> Option<(PairParameters, bool)> {
        let speed = self.speed(from);
        let guess =
            |f: f64| -> [f64; 4] { std::array::from_fn(|i| from.at[i] + speed[i] * step * f) };
        let place = |f: f64| {
            let origin = from.point + from.tangent * (step * f);
            self.common_where(guess(f), PlaceCondition::InPlane { origin, normal: from.tangent })
        };
        let (middle, next) = (place(0.5)?, place(1.0)?);
        let sign = step.signum();
        if !self.follows(from, [middle, next], sign) {
            return None;
        }
        if self.is_inside(next.at) {
            return Some((next, false));
        }
        // The first end of a domain on the way.
        let mut end: Option<(f64, PairParameters)> = None;
        for parameter in 0..4 {
            let domain = self.domains[parameter];
            let beyond = next.at[parameter];
            let value = within(domain, beyond);
            if (value - beyond).abs() <= self.slack(parameter) {
                continue;
            }
            let share =
                ((value - from.at[parameter]) / (beyond - from.at[parameter])).clamp(0.0, 1.0);
            let mut found =
                self.common_where(guess(share), PlaceCondition::At { parameter, value })?;
            found.at[parameter] = value;
            let way = (found.point - from.point).dot(from.tangent) * sign;
            if self.is_inside(found.at) && 0.0 <= way && end.is_none_or(|(least, _)| way < least) {
                end = Some((way, found));
            }
        }
        // The end may be elsewhere, where the surfaces go on straight: it is looked at as any other place.
        let (way, place) = end?;
        let share = way / step.abs();
        let origin = from.point + from.tangent * (0.5 * way * sign);
        let plane = PlaceCondition::InPlane { origin, normal: from.tangent };
        let middle = self.common_where(guess(0.5 * share), plane)?;
        let is_followed =
            share <= 1.0 && self.is_inside(middle.at) && self.follows(from, [middle, place], sign);
        is_followed.then_some((place, true))
    }

    /// Whether the curve keeps to the cubic from one place to the last by way of the one between.
    fn follows(&self, from: PairParameters, [middle, to]: [PairParameters; 2], sign: f64) -> bool {
        from.tangent.distance_squared(to.tangent) <= MOST_TURN
            && self.cubic(from, to, sign).misses(middle.point) <= SAMPLING * self.tolerance
    }

    /// How the parameters change along the curve, by its length.
    pub(super) fn speed(&self, from: PairParameters) -> [f64; 4] {
        let [pu, pv, qu, qv] = self.look(from.at).slopes;
        let one = |u: DVec3, v: DVec3| {
            let normal = u.cross(v);
            let squared = normal.length_squared();
            [
                from.tangent.cross(v).dot(normal) / squared,
                u.cross(from.tangent).dot(normal) / squared,
            ]
        };
        let ([a, b], [c, d]) = (one(pu, pv), one(-qu, -qv));
        [a, b, c, d].map(|x| if x.is_finite() { x } else { 0.0 })
    }

    /// How far beyond a domain is still on its end.
    fn slack(&self, parameter: usize) -> f64 {
        KNOT_RELATIVE * self.domains[parameter].length()
    }

    pub(super) fn is_inside(&self, at: [f64; 4]) -> bool {
        (0..4).all(|i| (within(self.domains[i], at[i]) - at[i]).abs() <= self.slack(i))
    }
}

/// Where curves end.
#[derive(Debug, Default)]
pub(super) struct CurveEnds {
    /// Places up to a radius where nothing is told.
    pub(super) spots: Vec<VanishingPlace>,
    pub(super) junctions: Vec<BranchCrossing>,
}

impl CurveEnds {
    /// A junction whose reach a curve is in, on its way there.
    fn junction_ahead(&self, last: PairParameters, sign: f64) -> Option<&BranchCrossing> {
        self.junctions.iter().find(|junction| {
            let way = junction.reach.point - last.point;
            junction.reach.holds(last.at, last.at) && 0.0 < way.dot(last.tangent * sign)
        })
    }
}

fn run_of(places: Vec<PairParameters>) -> BranchSamples {
    let sample = |place: PairParameters| BranchSample {
        point: place.point,
        before: place.tangent,
        behind: place.tangent,
    };
    BranchSamples { samples: places.into_iter().map(sample).collect() }
}
