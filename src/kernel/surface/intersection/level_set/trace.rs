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
    tolerance::{
        FIRST_STEP_SHARE, KNOT_RELATIVE, LONGEST_STEP_SHARE, ONE_PLACE_SHARE, SHORTEST_STEP_SHARE,
    },
    work,
};

/// How much longer the next step is than one that was good.
pub(super) const GROWTH: f64 = 1.6;

impl SurfacePair<'_> {
    /// The whole curve through a place: to the ends of the domains, to where it meets others, or
    /// around.
    pub(super) fn run(&self, start: PairParameters, ends: &CurveEnds) -> BranchSamples {
        let (ahead, is_closed) = self.half(self.beside_crease(start, 1.0), 1.0, ends);
        let mut places = Vec::new();
        if !is_closed {
            places = self.half(self.beside_crease(start, -1.0), -1.0, ends).0;
            places.reverse();
            places.push(self.beside_crease(start, -1.0));
        }
        places.push(self.beside_crease(start, 1.0));
        places.extend(ahead);
        run_of(places, ONE_PLACE_SHARE * self.tolerance)
    }

    /// The curve along a branch out of a junction.
    pub(super) fn run_out(&self, way: BranchDirection, ends: &CurveEnds) -> BranchSamples {
        let (mut places, _) = self.half(way.place, way.sign, ends);
        places.insert(0, way.place);
        if way.sign < 0.0 {
            places.reverse();
        }
        run_of(places, ONE_PLACE_SHARE * self.tolerance)
    }

    /// The places behind the start in a direction, and whether the last one is the start again.
    fn half(
        &self,
        start: PairParameters,
        sign: f64,
        ends: &CurveEnds,
    ) -> (Vec<PairParameters>, bool) {
        let mut places: Vec<PairParameters> = Vec::new();
        // The start as it is for who comes back to it.
        let back_at = self.beside_crease(start, -sign);
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
            let Some((next, end)) = self.advance(last, sign * step) else {
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
                && back <= reached + self.rounding
                && self.cubic(last, next, sign).misses_near(start.point, back / reached)
                    <= self.tolerance
                && 0.0 < next.tangent.dot(back_at.tangent)
            {
                places.push(back_at);
                return (places, true);
            }
            if let Some(end) = self.pole_ahead(last, next, sign) {
                places.push(end);
                break;
            }
            places.push(next);
            let is_spot = |s: &VanishingPlace| s.point.distance(next.point) <= s.radius;
            if end == StepEnd::Border || ends.spots.iter().any(is_spot) {
                break;
            }
            last = next;
            if end == StepEnd::Crease {
                last = self.beside_crease(next, sign);
                places.push(last);
            }
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

    /// The place a step further, or that where it reaches the end of a domain or a crease; none where the step is too
    /// long.
    fn advance(&self, from: PairParameters, step: f64) -> Option<(PairParameters, StepEnd)> {
        let speed = self.speed(from);
        let guess =
            |f: f64| -> [f64; 4] { std::array::from_fn(|i| from.at[i] + speed[i] * step * f) };
        let place = |f: f64| {
            let origin = from.point + from.tangent * (step * f);
            self.common_where(guess(f), PlaceCondition::InPlane { origin, normal: from.tangent })
        };
        let ahead = place(0.5).zip(place(1.0));
        let sign = step.signum();
        // Behind a crease the curve may turn back and reach no further: the stop is where it was headed for.
        let headed = ahead.map_or_else(|| guess(1.0), |(_, next)| next.at);
        let stops = self.creases_between(from.at, headed);
        if !stops.is_empty() {
            let (way, place) = self.first_stop(from, sign, &stops, guess, headed)?;
            let place = self.beside_crease(place, -sign);
            let share = way / step.abs();
            let is_followed =
                share <= 1.0 && self.is_followed(from, place, sign * way, guess(0.5 * share));
            return is_followed.then_some((place, StepEnd::Crease));
        }
        let (middle, next) = ahead?;
        if !self.follows(from, [middle, next], sign) {
            return None;
        }
        if self.is_inside(next.at) {
            return Some((next, StepEnd::Open));
        }
        // The first end of a domain on the way.
        let beyond = (0..4).filter_map(|parameter| {
            let value = within(self.domains[parameter], next.at[parameter]);
            let is_beyond = self.slack(parameter) < (value - next.at[parameter]).abs();
            is_beyond.then_some((parameter, value))
        });
        let stops: Vec<(usize, f64)> = beyond.collect();
        // The end may be elsewhere, where the surfaces go on straight: it is looked at as any other place.
        let (way, place) = self.first_stop(from, sign, &stops, guess, next.at)?;
        let share = way / step.abs();
        let is_followed =
            share <= 1.0 && self.is_followed(from, place, sign * way, guess(0.5 * share));
        is_followed.then_some((place, StepEnd::Border))
    }

    /// The first of the places at which a parameter has a value on the way to others, and how far it is.
    fn first_stop(
        &self,
        from: PairParameters,
        sign: f64,
        stops: &[(usize, f64)],
        guess: impl Fn(f64) -> [f64; 4],
        to: [f64; 4],
    ) -> Option<(f64, PairParameters)> {
        let mut first: Option<(f64, PairParameters)> = None;
        for &(parameter, value) in stops {
            let share = (value - from.at[parameter]) / (to[parameter] - from.at[parameter]);
            let start = guess(share.clamp(0.0, 1.0));
            let mut found = self.common_where(start, PlaceCondition::At { parameter, value })?;
            found.at[parameter] = value;
            let way = (found.point - from.point).dot(from.tangent) * sign;
            if self.is_inside(found.at) && 0.0 <= way && first.is_none_or(|(least, _)| way < least)
            {
                first = Some((way, found));
            }
        }
        first
    }

    /// Whether the curve keeps to the cubic to a place, by that half of the way there.
    fn is_followed(
        &self,
        from: PairParameters,
        to: PairParameters,
        way: f64,
        half: [f64; 4],
    ) -> bool {
        let origin = from.point + from.tangent * (0.5 * way);
        let plane = PlaceCondition::InPlane { origin, normal: from.tangent };
        self.common_where(half, plane).is_some_and(|middle| {
            self.is_inside(middle.at) && self.follows(from, [middle, to], way.signum())
        })
    }

    /// The creases that are passed between places on neither of them, by the parameter.
    fn creases_between(&self, from: [f64; 4], to: [f64; 4]) -> Vec<(usize, f64)> {
        let mut passed = Vec::new();
        for parameter in 0..4 {
            let slack = self.slack(parameter);
            let [low, high] = [from, to].map(|at| at[parameter]);
            let is_passed = |crease: f64| {
                let ways = [low - crease, high - crease];
                slack < ways[0].abs() && ways[0] * ways[1] < 0.0
            };
            let creases = self.creases[parameter].iter().copied();
            passed.extend(creases.filter(|&crease| is_passed(crease)).map(|c| (parameter, c)));
        }
        passed
    }

    /// A place as it is for who leaves it along the curve, forward for a positive sign: on a crease of a surface that of
    /// the side to which the curve goes from there.
    fn beside_crease(&self, place: PairParameters, sign: f64) -> PairParameters {
        let mut place = place;
        for parameter in 0..4 {
            let near =
                |crease: &&f64| (place.at[parameter] - **crease).abs() <= self.slack(parameter);
            let Some(&crease) = self.creases[parameter].iter().find(near) else { continue };
            let on_side = |value: f64| {
                let mut at = place.at;
                at[parameter] = value;
                PairParameters { point: place.point, ..self.place(at) }
            };
            let [before, behind] = [crease.next_down(), crease].map(on_side);
            let grows = |found: PairParameters| 0.0 < self.speed(found)[parameter] * sign;
            place = match (grows(behind), grows(before)) {
                (true, true) => behind,
                (false, false) => before,
                // Along it, or away from it on both sides: as it was found.
                _ => continue,
            };
        }
        place
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

    /// The curve's place at the end of a domain for one just beyond it: where a curve leaves a surface at a small angle
    /// that is a long way from its end.
    pub(super) fn within_domains(&self, place: PairParameters) -> PairParameters {
        let end_of = |parameter: usize| {
            let value = within(self.domains[parameter], place.at[parameter]);
            let mut found = self.common_where(place.at, PlaceCondition::At { parameter, value })?;
            found.at[parameter] = value;
            self.is_inside(found.at).then_some(found)
        };
        match self.is_inside(place.at) {
            true => place,
            false => (0..4).find_map(end_of).unwrap_or(place),
        }
    }

    /// How far beyond a domain is still on its end.
    fn slack(&self, parameter: usize) -> f64 {
        KNOT_RELATIVE * self.domains[parameter].length()
    }

    pub(super) fn is_inside(&self, at: [f64; 4]) -> bool {
        (0..4).all(|i| (within(self.domains[i], at[i]) - at[i]).abs() <= self.slack(i))
    }
}

/// What a step along a curve comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum StepEnd {
    /// Another place of it.
    Open,
    /// The end of a domain.
    Border,
    /// A line over which derivatives of a surface may jump.
    Crease,
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

/// Places as samples; what follows up to a distance is one place, with the tangents of both sides: a curve may start just
/// beside a crease.
fn run_of(places: Vec<PairParameters>, one_place: f64) -> BranchSamples {
    let mut samples: Vec<BranchSample> = Vec::with_capacity(places.len());
    for place in places {
        match samples.last_mut() {
            Some(last) if last.point.distance(place.point) <= one_place => {
                last.behind = place.tangent;
            }
            _ => samples.push(BranchSample {
                point: place.point,
                before: place.tangent,
                behind: place.tangent,
            }),
        }
    }
    BranchSamples { samples }
}
