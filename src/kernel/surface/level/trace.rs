//! The curve in which two surfaces cross, followed from a place of it.

use glam::DVec3;

use super::{
    SAMPLING,
    chain::Spot,
    collapsed::{Collapsed, collapsed},
    cubic::Cubic,
    linear::solved,
    sample::{MOST_TURN, Run, Sample, length_between},
    touch::{Junction, Way, poles},
};
use crate::{
    Interval, NurbsSurface,
    frame::{norm, unit},
    tolerance::{KNOT_RELATIVE, LAST_BIT},
    work,
};

/// Steps of Newton's method.
const MAX_STEPS: usize = 25;

/// Samples of one curve.
const MAX_SAMPLES: usize = 200_000;

/// How much longer the next step is than one that was good.
pub(super) const GROWTH: f64 = 1.6;

/// Two surfaces that are asked where they cross.
#[derive(Debug)]
pub(super) struct Crossing<'s> {
    pub(super) surfaces: [&'s NurbsSurface; 2],
    pub(super) domains: [Interval; 4],
    pub(super) tolerance: f64,
    /// Within this distance surfaces whose normals are parallel touch.
    pub(super) contact: f64,
    pub(super) size: f64,
    /// What rounding leaves of a distance.
    pub(super) rounding: f64,
    /// Poles and corners in which the surfaces touch.
    pub(super) poles: Vec<DVec3>,
    /// Collapsed edges of either surface on the other one: curves that arrive there end.
    pub(super) collapsed: Vec<Collapsed>,
}

/// A place on both surfaces: u and v on the first, u and v on the second.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) at: [f64; 4],
    pub(super) point: DVec3,
    /// Along N × N of both, zero where they touch.
    pub(super) tangent: DVec3,
}

/// What both surfaces tell at parameters: how far apart they are, how that changes, and the point.
struct Look {
    apart: DVec3,
    slopes: [DVec3; 4],
    point: DVec3,
}

impl<'s> Crossing<'s> {
    /// Of surfaces that touch within that share of the tolerance.
    pub(super) fn new(
        surfaces: [&'s NurbsSurface; 2],
        [tolerance, share]: [f64; 2],
        size: f64,
    ) -> Self {
        let [a, b] = surfaces;
        let domains = [a.domain_u(), a.domain_v(), b.domain_u(), b.domain_v()];
        let magnitude = a.bounds().magnitude().max(b.bounds().magnitude());
        let contact = share * tolerance;
        let poles = poles(surfaces, contact);
        let rounding = 8.0 * LAST_BIT * magnitude;
        let collapsed = collapsed(surfaces, contact);
        Self { surfaces, domains, tolerance, contact, size, rounding, poles, collapsed }
    }

    /// Parts of surfaces that touch are no larger than this: the tolerance's height over a bend of
    /// the size.
    pub(super) fn touch_size(&self) -> f64 {
        (self.tolerance * self.size).sqrt()
    }

    /// Beyond its domain a surface goes on straight.
    fn look(&self, at: [f64; 4]) -> Look {
        let one = |surface: &NurbsSurface, i: usize| {
            let inside = [0, 1].map(|k| within(self.domains[i + k], at[i + k]));
            let [point, by_u, by_v] = surface.tangents_at(inside[0], inside[1]);
            let beyond = by_u * (at[i] - inside[0]) + by_v * (at[i + 1] - inside[1]);
            (point + beyond, by_u, by_v)
        };
        let (p, pu, pv) = one(self.surfaces[0], 0);
        let (q, qu, qv) = one(self.surfaces[1], 2);
        Look { apart: p - q, slopes: [pu, pv, -qu, -qv], point: p.midpoint(q) }
    }

    fn place(&self, at: [f64; 4]) -> Place {
        let Look { slopes: [pu, pv, qu, qv], point, .. } = self.look(at);
        let normals = [unit(pu.cross(pv)), unit(qu.cross(qv))];
        let across = normals[0].zip(normals[1]).map_or(DVec3::ZERO, |(a, b)| a.cross(b));
        let is_clear = LAST_BIT.sqrt() < across.length();
        let tangent = unit(across).filter(|_| is_clear).unwrap_or(DVec3::ZERO);
        Place { at, point, tangent }
    }

    /// The common place nearest to parameters, these counted by widths.
    pub(super) fn common(&self, mut at: [f64; 4], widths: [f64; 4]) -> Option<Place> {
        for _ in 0..MAX_STEPS {
            let look = self.look(at);
            if norm(look.apart) <= self.rounding {
                break;
            }
            // The shortest step that removes the gap.
            let columns: [DVec3; 4] = std::array::from_fn(|i| look.slopes[i] * widths[i]);
            let matrix: [[f64; 3]; 3] = std::array::from_fn(|i| {
                std::array::from_fn(|k| columns.iter().map(|c| c[i] * c[k]).sum())
            });
            let factors = DVec3::from_array(solved(matrix, (-look.apart).to_array())?);
            let step = |i: usize| widths[i] * columns[i].dot(factors).clamp(-2.0, 2.0);
            at = std::array::from_fn(|i| at[i] + step(i));
        }
        (norm(self.look(at).apart) <= 0.01 * self.tolerance).then(|| self.place(at))
    }

    /// The common place in a plane across a direction, or with one parameter given.
    pub(super) fn common_where(&self, mut at: [f64; 4], condition: Condition) -> Option<Place> {
        for _ in 0..MAX_STEPS {
            let look = self.look(at);
            let (row, value) = match condition {
                Condition::InPlane { origin, normal } => {
                    let [pu, pv, ..] = look.slopes;
                    // The plane cuts the first surface.
                    let first = look.point + 0.5 * look.apart;
                    let row = [pu.dot(normal), pv.dot(normal), 0.0, 0.0];
                    (row, (first - origin).dot(normal))
                }
                Condition::At { parameter, value } => (
                    std::array::from_fn(|i| f64::from(u8::from(i == parameter))),
                    at[parameter] - value,
                ),
            };
            let matrix: [[f64; 4]; 4] = std::array::from_fn(|i| match i {
                3 => row,
                _ => std::array::from_fn(|k| look.slopes[k][i]),
            });
            let [x, y, z] = (-look.apart).to_array();
            let step = solved(matrix, [x, y, z, -value])?;
            at = std::array::from_fn(|i| at[i] + step[i]);
            let is_still = (0..4).all(|i| {
                step[i].abs() <= 4.0 * LAST_BIT * (at[i].abs() + self.domains[i].length())
            });
            if is_still {
                break;
            }
        }
        let is_there =
            at.iter().all(|x| x.is_finite()) && norm(self.look(at).apart) <= 0.01 * self.tolerance;
        is_there.then(|| self.place(at))
    }

    /// The whole curve through a place: to the ends of the domains, to where it meets others, or
    /// around.
    pub(super) fn run(&self, start: Place, ends: &Ends) -> Run {
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
    pub(super) fn run_out(&self, way: Way, ends: &Ends) -> Run {
        let (mut places, _) = self.half(way.place, way.sign, ends);
        places.insert(0, way.place);
        if way.sign < 0.0 {
            places.reverse();
        }
        run_of(places)
    }

    /// The places behind the start in a direction, and whether the last one is the start again.
    fn half(&self, start: Place, sign: f64, ends: &Ends) -> (Vec<Place>, bool) {
        let mut places: Vec<Place> = Vec::new();
        let mut last = start;
        let mut step = 0.02 * self.size;
        while places.len() < MAX_SAMPLES && last.tangent != DVec3::ZERO && work::goes_on(1) {
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
                if step < 0.1 * self.tolerance {
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
            step = (GROWTH * step).min(0.05 * self.size);
        }
        (places, false)
    }

    /// A pole on the way to the next place, where the surfaces touch.
    fn pole_ahead(&self, last: Place, next: Place, sign: f64) -> Option<Place> {
        let reached = (next.point - last.point).dot(last.tangent * sign);
        self.poles.iter().find_map(|&pole| {
            let share = (pole - last.point).dot(last.tangent * sign) / reached;
            let is_passed = 0.0 < share
                && share <= 1.0
                && self.tolerance < pole.distance(last.point)
                && self.cubic(last, next, sign).misses_near(pole, share) <= 4.0 * self.tolerance;
            let tangent = unit(last.tangent.lerp(next.tangent, share))?;
            is_passed.then_some(Place { at: next.at, point: pole, tangent })
        })
    }

    /// The junction as the next place, where a cubic to it stays on the curve.
    fn arrival(&self, last: Place, sign: f64, junction: &Junction) -> Option<Place> {
        let back = last.point - junction.reach.point;
        let outward = |way: &Way| (way.place.tangent * way.sign).dot(back);
        let way = junction.ways.iter().max_by(|a, b| outward(a).total_cmp(&outward(b)))?;
        let end = way.place;
        if MOST_TURN < last.tangent.distance_squared(end.tangent) {
            return None;
        }
        let cubic = self.cubic(last, end, sign);
        let middle = std::array::from_fn(|i| 0.5 * (last.at[i] + end.at[i]));
        let plane = Condition::InPlane { origin: cubic.middle(), normal: unit(back)? };
        let place = self.common_where(middle, plane)?;
        (cubic.misses(place.point) <= SAMPLING * self.tolerance).then_some(end)
    }

    pub(super) fn cubic(&self, from: Place, to: Place, sign: f64) -> Cubic {
        let sample = |place: Place| {
            let tangent = place.tangent * sign;
            Sample { point: place.point, before: tangent, behind: tangent }
        };
        let [from, to] = [from, to].map(sample);
        Cubic::between(from, to, length_between(from, to))
    }

    /// The place a step further, and whether a domain ends there; none where the step is too long.
    fn advance(&self, from: Place, step: f64) -> Option<(Place, bool)> {
        let speed = self.speed(from);
        let guess =
            |f: f64| -> [f64; 4] { std::array::from_fn(|i| from.at[i] + speed[i] * step * f) };
        let place = |f: f64| {
            let origin = from.point + from.tangent * (step * f);
            self.common_where(guess(f), Condition::InPlane { origin, normal: from.tangent })
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
        let mut end: Option<(f64, Place)> = None;
        for parameter in 0..4 {
            let domain = self.domains[parameter];
            let beyond = next.at[parameter];
            let value = within(domain, beyond);
            if (value - beyond).abs() <= self.slack(parameter) {
                continue;
            }
            let share =
                ((value - from.at[parameter]) / (beyond - from.at[parameter])).clamp(0.0, 1.0);
            let mut found = self.common_where(guess(share), Condition::At { parameter, value })?;
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
        let plane = Condition::InPlane { origin, normal: from.tangent };
        let middle = self.common_where(guess(0.5 * share), plane)?;
        let is_followed =
            share <= 1.0 && self.is_inside(middle.at) && self.follows(from, [middle, place], sign);
        is_followed.then_some((place, true))
    }

    /// Whether the curve keeps to the cubic from one place to the last by way of the one between.
    fn follows(&self, from: Place, [middle, to]: [Place; 2], sign: f64) -> bool {
        from.tangent.distance_squared(to.tangent) <= MOST_TURN
            && self.cubic(from, to, sign).misses(middle.point) <= SAMPLING * self.tolerance
    }

    /// How the parameters change along the curve, by its length.
    pub(super) fn speed(&self, from: Place) -> [f64; 4] {
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
pub(super) struct Ends {
    /// Places up to a radius where nothing is told.
    pub(super) spots: Vec<Spot>,
    pub(super) junctions: Vec<Junction>,
}

impl Ends {
    /// A junction whose reach a curve is in, on its way there.
    fn junction_ahead(&self, last: Place, sign: f64) -> Option<&Junction> {
        self.junctions.iter().find(|junction| {
            let way = junction.reach.point - last.point;
            junction.reach.holds(last.at, last.at) && 0.0 < way.dot(last.tangent * sign)
        })
    }
}

fn run_of(places: Vec<Place>) -> Run {
    let sample =
        |place: Place| Sample { point: place.point, before: place.tangent, behind: place.tangent };
    Run { samples: places.into_iter().map(sample).collect() }
}

/// What a place must fulfil besides being on both surfaces.
#[derive(Clone, Copy)]
pub(super) enum Condition {
    InPlane { origin: DVec3, normal: DVec3 },
    At { parameter: usize, value: f64 },
}

/// The parameter of a domain that is nearest to one.
pub(super) fn within(domain: Interval, t: f64) -> f64 {
    t.clamp(domain.start(), domain.end())
}
