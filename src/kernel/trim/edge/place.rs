//! Places that two surfaces have in common across a curve.

use glam::DVec3;

use super::piece::Carrier;
use crate::{
    Interval, NurbsCurve, NurbsSurface, Side,
    ceiling::CROSSING_STEPS,
    numeric::{
        linear::{TwoEquations, solved},
        newton::{FREE, NewtonStep, within_limits},
    },
    tolerance::{
        BESIDE_POLE, BORDER_END_SHARE, CORNER_RELATIVE, LAST_BIT, LEAST_CROSSING_SINE,
        MEETING_SHARE, SHORTEST_EDGE_PIECE, VANISHING_RELATIVE,
    },
};

/// How far, in tolerances, a common place may be from the curve: further away it is another one.
pub(super) const FAR: f64 = 16.0;

/// Finds places of two surfaces beside a curve in which they meet.
#[derive(Debug)]
pub(super) struct PlaceFinder<'s> {
    pub(super) carriers: [Carrier<'s>; 2],
    pub(super) curve: &'s NurbsCurve,
    pub(super) domains: [Interval; 4],
    /// The knots of each parameter, in order, the ends of the domain among them.
    pub(super) knots: [Vec<f64>; 4],
    pub(super) tolerance: f64,
    rounding: f64,
}

/// A place by the parameters of both surfaces, and how everything changes with the curve's parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct CommonPlace {
    pub(super) at: [f64; 4],
    pub(super) speeds: [f64; 4],
    pub(super) point: DVec3,
    pub(super) velocity: DVec3,
    /// Whether parameters there are limits, as at a pole.
    is_limit: bool,
}

impl CommonPlace {
    /// About where the parameters are further on.
    pub(super) fn ahead(&self, by: f64) -> [f64; 4] {
        std::array::from_fn(|k| self.at[k] + self.speeds[k] * by)
    }
}

impl<'s> PlaceFinder<'s> {
    pub(super) fn new(
        surfaces: [&'s NurbsSurface; 2],
        curve: &'s NurbsCurve,
        tolerance: f64,
    ) -> Self {
        let knots = [0, 1, 2, 3].map(|k: usize| {
            let surface = surfaces[k / 2];
            let knots = if k.is_multiple_of(2) { surface.knots_u() } else { surface.knots_v() };
            let domain = knots.domain();
            let inside = |t: &f64| domain.contains(*t);
            knots.distinct().into_iter().map(|(t, _)| t).filter(inside).collect::<Vec<_>>()
        });
        let [a, b] = surfaces;
        let domains = [a.domain_u(), a.domain_v(), b.domain_u(), b.domain_v()];
        let magnitude = a.bounds().magnitude().max(b.bounds().magnitude());
        let rounding = 8.0 * LAST_BIT * magnitude;
        Self { carriers: surfaces.map(Carrier::new), curve, domains, knots, tolerance, rounding }
    }

    /// Where pieces of the curve end at least: at its knots, and at poles of either surface on it.
    pub(super) fn breaks(&self, curve: &NurbsCurve) -> Vec<f64> {
        let mut breaks = curve.knots().breaks();
        let domain = curve.domain();
        for carrier in &self.carriers {
            for edge in carrier.surface.edges() {
                if edge.bounds().diagonal() <= LAST_BIT.sqrt() * self.tolerance {
                    let foot = curve.closest(edge.start(), self.tolerance);
                    if foot.distance <= self.tolerance {
                        breaks.push(foot.parameter);
                    }
                }
            }
        }
        breaks.sort_by(f64::total_cmp);
        let slack = SHORTEST_EDGE_PIECE * domain.length();
        let mut kept: Vec<f64> = Vec::new();
        for t in breaks {
            if kept.last().is_none_or(|&last| slack < t - last) {
                kept.push(t);
            } else if domain.end() <= t && 1 < kept.len() {
                kept.pop();
                kept.push(t);
            }
        }
        kept
    }

    /// The point of a surface; beyond its domain it goes on straight.
    pub(super) fn look(&self, surface: usize, at: [f64; 2]) -> [DVec3; 3] {
        let carrier = &self.carriers[surface];
        let inside = carrier.within(at);
        let [point, by_u, by_v] = carrier.surface.tangents_at(inside[0], inside[1]);
        [point + by_u * (at[0] - inside[0]) + by_v * (at[1] - inside[1]), by_u, by_v]
    }

    pub(super) fn point(&self, surface: usize, at: [f64; 2]) -> DVec3 {
        self.carriers[surface].surface.point_at(at[0], at[1])
    }

    /// The place across the curve at a parameter, seen from one of its sides.
    pub(super) fn place(&self, t: f64, side: Side, guess: Option<[f64; 4]>) -> Option<CommonPlace> {
        let derivatives = self.curve.derivatives_beside(t, side, 1);
        let [point, velocity] = [derivatives[0], derivatives[1]];
        let start = guess.unwrap_or_else(|| self.feet(point));
        if let Some(found) = self.crossing(point, velocity, start) {
            return Some(found);
        }
        self.touching(t, side, [point, velocity], start)
    }

    /// The same at an end of the curve: on the border of a surface where it is that near.
    pub(super) fn at_end(
        &self,
        t: f64,
        side: Side,
        guess: Option<[f64; 4]>,
    ) -> Option<CommonPlace> {
        let mut place = self.place(t, side, guess)?;
        if self.curve.start() == self.curve.end() || place.is_limit {
            return Some(place);
        }
        let near = BORDER_END_SHARE * self.tolerance;
        for k in 0..4 {
            let looked = self.look(k / 2, [place.at[k - k % 2], place.at[k - k % 2 + 1]]);
            let speed = looked[1 + k % 2].length();
            for end in [self.domains[k].start(), self.domains[k].end()] {
                let off = (place.at[k] - end).abs();
                // Along a border there is nowhere to go.
                let is_crossed =
                    off * speed <= near * place.speeds[k].abs() * speed / place.velocity.length();
                if off == 0.0 || near < off * speed || !is_crossed {
                    continue;
                }
                if let Some((_, found)) = self.at_knot(k, end, place.at, t)
                    && found.point.distance(place.point) <= near
                {
                    place = found;
                }
            }
        }
        Some(place)
    }

    fn feet(&self, point: DVec3) -> [f64; 4] {
        let [a, b] = [0, 1].map(|i| self.carriers[i].surface.closest(point).parameters);
        [a[0], a[1], b[0], b[1]]
    }

    /// The common place in the plane across a velocity, by Newton's method.
    fn crossing(&self, point: DVec3, velocity: DVec3, start: [f64; 4]) -> Option<CommonPlace> {
        let pace = velocity.length();
        if pace == 0.0 {
            return None;
        }
        let normal = velocity / pace;
        let at = self.solved(start, |a, [u, v]| {
            ([u.dot(normal), v.dot(normal), 0.0, 0.0], (a - point).dot(normal))
        })?;
        let found = self.moving(at, velocity)?;
        (found.point.distance(point) <= FAR * self.tolerance).then_some(found)
    }

    /// Where both surfaces are one place and one condition holds: a row of the Jacobian, and what is missing.
    fn solved(
        &self,
        start: [f64; 4],
        condition: impl Fn(DVec3, [DVec3; 2]) -> ([f64; 4], f64),
    ) -> Option<[f64; 4]> {
        let found = within_limits(
            [FREE; 4],
            start,
            CROSSING_STEPS,
            |_, _| false,
            |at| {
                let [a, au, av] = self.look(0, [at[0], at[1]]);
                let [b, bu, bv] = self.look(1, [at[2], at[3]]);
                let (row, missing) = condition(a, [au, av]);
                let columns = [au, av, -bu, -bv];
                let matrix: [[f64; 4]; 4] = std::array::from_fn(|i| match i {
                    3 => row,
                    _ => std::array::from_fn(|k| columns[k][i]),
                });
                let [x, y, z] = (b - a).to_array();
                let Some(step) = solved(matrix, [x, y, z, -missing]) else {
                    return NewtonStep::Stuck;
                };
                let is_still = (0..4).all(|k| {
                    let size = (at[k] + step[k]).abs() + self.domains[k].length();
                    step[k].abs() <= 4.0 * LAST_BIT * size
                });
                if is_still { NewtonStep::Last(step) } else { NewtonStep::By(step) }
            },
        );
        let at = found.unless_stuck()?;
        let [a, b] = [self.look(0, [at[0], at[1]])[0], self.look(1, [at[2], at[3]])[0]];
        let near = (MEETING_SHARE * self.tolerance).max(self.rounding);
        (at.iter().all(|t| t.is_finite()) && a.distance(b) <= near).then_some(at)
    }

    /// A common place with how it moves as the curve does; none where normals are nearly parallel.
    fn moving(&self, at: [f64; 4], velocity: DVec3) -> Option<CommonPlace> {
        let looks = [0, 1].map(|i| self.look(i, [at[2 * i], at[2 * i + 1]]));
        let [a, b] = looks.map(|[_, u, v]| self.unit_normal([u, v]));
        let tangent = a?.cross(b?);
        if tangent.length() <= LEAST_CROSSING_SINE {
            return None;
        }
        let along = tangent.dot(velocity);
        let moved = tangent * (velocity.length_squared() / along);
        let speeds = self.speeds(&looks, moved);
        // The plane across the curve cuts what it runs along at a flat angle elsewhere.
        let is_along = 0.5 * tangent.length() * velocity.length() < along.abs();
        let point = looks[0][0].midpoint(looks[1][0]);
        (is_along && speeds.iter().all(|speed| speed.is_finite())).then_some(CommonPlace {
            at,
            speeds,
            point,
            velocity: moved,
            is_limit: false,
        })
    }

    /// The normal, none where Su and Sv are parallel or vanish.
    fn unit_normal(&self, [u, v]: [DVec3; 2]) -> Option<DVec3> {
        let normal = u.cross(v);
        let least = VANISHING_RELATIVE.sqrt() * u.length().max(v.length());
        let is_clear = least * least < normal.length();
        let thinnest = normal.length() / u.length().max(v.length());
        (is_clear && self.rounding < thinnest).then(|| normal / normal.length())
    }

    /// How parameters change along a velocity, each surface seen in its own tangent plane.
    fn speeds(&self, looks: &[[DVec3; 3]; 2], velocity: DVec3) -> [f64; 4] {
        let one = |[_, u, v]: [DVec3; 3]| {
            let form = TwoEquations::symmetric(u.dot(u), u.dot(v), v.dot(v));
            form.solved([u.dot(velocity), v.dot(velocity)])
        };
        let [a, b] = looks.map(one);
        [a[0], a[1], b[0], b[1]]
    }

    /// The nearest places of both surfaces; where one has no tangent plane, what its parameters come to.
    fn touching(
        &self,
        t: f64,
        side: Side,
        [point, velocity]: [DVec3; 2],
        start: [f64; 4],
    ) -> Option<CommonPlace> {
        let feet = [0, 1].map(|i| {
            let surface = self.carriers[i].surface;
            let near =
                surface.foot_from(self.carriers[i].within([start[2 * i], start[2 * i + 1]]), point);
            if near.distance <= self.tolerance { near } else { surface.closest(point) }
        });
        if feet.iter().any(|foot| FAR * self.tolerance < foot.distance) {
            return None;
        }
        let mut at: [f64; 4] = std::array::from_fn(|k| feet[k / 2].parameters[k % 2]);
        // A foot tells no better than that on which side of a knot it is.
        for k in 0..4 {
            let pace = self.look(k / 2, feet[k / 2].parameters)[1 + k % 2].length();
            let near =
                |knot: &&f64| (at[k] - **knot).abs() * pace <= MEETING_SHARE * self.tolerance;
            at[k] = self.knots[k].iter().find(near).copied().unwrap_or(at[k]);
        }
        let looks = [0, 1].map(|i| self.look(i, [at[2 * i], at[2 * i + 1]]));
        let is_flat = looks.map(|[_, u, v]| self.unit_normal([u, v]).is_some());
        let speeds = self.speeds(&looks, velocity);
        let middle = feet[0].point.midpoint(feet[1].point);
        let mut place = CommonPlace { at, speeds, point: middle, velocity, is_limit: false };
        if is_flat == [true, true] {
            return Some(place);
        }
        place.is_limit = true;
        let domain = self.curve.domain();
        let step = BESIDE_POLE * domain.length() * if side == Side::Left { -1.0 } else { 1.0 };
        if !domain.contains(t + 2.0 * step) {
            return None;
        }
        let beside = |n: f64| {
            let derivatives = self.curve.derivatives_beside(t + n * step, side, 1);
            self.crossing(derivatives[0], derivatives[1], self.feet(derivatives[0]))
        };
        let (near, far) = (beside(1.0)?, beside(2.0)?);
        for i in (0..2).filter(|&i| !is_flat[i]) {
            for k in [2 * i, 2 * i + 1] {
                let speed = 2.0 * near.speeds[k] - far.speeds[k];
                let limit = near.at[k] - 0.5 * (speed + near.speeds[k]) * step;
                let domain = self.domains[k];
                place.speeds[k] = speed;
                place.at[k] = limit.clamp(domain.start(), domain.end());
            }
            // The side that is one point.
            let collapsed = (0..2).find(|&k| looks[i][1 + k].length() <= looks[i][2 - k].length());
            let across = 2 * i + 1 - collapsed.unwrap_or(0);
            place.at[across] = at[across];
        }
        Some(place)
    }

    /// Where a parameter is at a knot, near a start, and the curve's parameter there.
    pub(super) fn at_knot(
        &self,
        k: usize,
        value: f64,
        start: [f64; 4],
        t: f64,
    ) -> Option<(f64, CommonPlace)> {
        let row: [f64; 4] = std::array::from_fn(|i| f64::from(u8::from(i == k)));
        let mut start = start;
        start[k] = value;
        // The row of Newton's matrix leaves that parameter where it is.
        let mut at = self.solved(start, |_, _| (row, 0.0))?;
        at[k] = value;
        let point = self.look(k / 2, [at[k - k % 2], at[k - k % 2 + 1]])[0];
        let domain = self.curve.domain();
        let foot = within_limits(
            [[domain.start(), domain.end()]],
            [t],
            CROSSING_STEPS,
            |[a], [b]| (a - b).abs() <= 4.0 * LAST_BIT * domain.length(),
            |[t]| {
                let derivatives = self.curve.derivatives_beside(t, Side::Right, 1);
                crate::numeric::newton::to_foot(point - derivatives[0], derivatives[1])
            },
        );
        let [t] = foot.unless_stuck()?;
        let derivatives = self.curve.derivatives_beside(t, Side::Left, 1);
        let is_near = derivatives[0].distance(point) <= FAR * self.tolerance;
        let found = self.moving(at, derivatives[1])?;
        is_near.then_some((t, found))
    }

    /// The same place on the other side of the end of a domain, where a parameter leaves it.
    pub(super) fn across(&self, place: &CommonPlace, k: usize, t: f64) -> Option<CommonPlace> {
        let domain = self.domains[k];
        let is_start = place.at[k] < domain.at(0.5);
        let mut at = place.at;
        at[k] = if is_start { domain.end() } else { domain.start() };
        let pair = |at: [f64; 4]| [at[k - k % 2], at[k - k % 2 + 1]];
        let points = [place.at, at].map(|at| self.point(k / 2, pair(at)));
        if points[0].distance(points[1]) <= MEETING_SHARE * self.tolerance {
            return self.moving(at, place.velocity).or(Some(CommonPlace { at, ..*place }));
        }
        self.place(t, Side::Right, None)
    }

    /// The same place as it is behind it: where the curve has a corner or a surface a pole, another.
    pub(super) fn behind(&self, t: f64, place: CommonPlace) -> Option<CommonPlace> {
        if place.is_limit {
            return self.place(t, Side::Right, None);
        }
        let [before, behind] =
            [Side::Left, Side::Right].map(|side| self.curve.derivatives_beside(t, side, 1)[1]);
        let is_smooth = before.distance(behind) <= CORNER_RELATIVE * before.length();
        let is_knot = (0..4).any(|k| self.knots[k].contains(&place.at[k]));
        if is_smooth && !is_knot {
            return Some(place);
        }
        self.place(t, Side::Right, Some(place.at))
    }
}
