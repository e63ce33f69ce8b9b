//! Two surfaces that are asked where they cross, and the places that they share.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::pair::SurfacePart;
use crate::{
    Bounds, Interval, NurbsSurface,
    ceiling::CROSSING_STEPS,
    frame::{norm, unit},
    numeric::{
        linear::solved,
        newton::{FREE, NewtonStep, within_limits},
    },
    tolerance::{LAST_BIT, MEETING_SHARE},
};

/// Two surfaces that are asked where they cross.
#[derive(Debug)]
pub(super) struct SurfacePair<'s> {
    pub(super) surfaces: [&'s NurbsSurface; 2],
    pub(super) domains: [Interval; 4],
    /// Where inside of them derivatives may jump.
    pub(super) creases: [Vec<f64>; 4],
    pub(super) tolerance: f64,
    /// Within this distance surfaces whose normals are parallel touch.
    pub(super) contact: f64,
    pub(super) size: f64,
    /// What rounding leaves of a distance.
    pub(super) rounding: f64,
    /// Poles and corners in which the surfaces touch.
    pub(super) poles: Vec<DVec3>,
    /// Collapsed edges of either surface on the other one: curves that arrive there end.
    pub(super) collapsed: Vec<CollapsedEdge>,
}

/// An edge of one surface that is a point, on the other surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct CollapsedEdge {
    pub(super) point: DVec3,
    /// Along N × N of both, zero where one has no normal.
    pub(super) tangent: DVec3,
}

/// A place on both surfaces: u and v on the first, u and v on the second.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairParameters {
    pub(super) at: [f64; 4],
    pub(super) point: DVec3,
    /// Along N × N of both, zero where they touch.
    pub(super) tangent: DVec3,
}

/// What both surfaces tell at parameters: how far apart they are, how that changes, and the point.
pub(super) struct PairState {
    apart: DVec3,
    pub(super) slopes: [DVec3; 4],
    point: DVec3,
}

impl<'s> SurfacePair<'s> {
    /// Parts of surfaces that touch are no larger than this: the tolerance's height over a bend of
    /// the size.
    pub(super) fn touch_size(&self) -> f64 {
        (self.tolerance * self.size).sqrt()
    }

    /// Beyond its domain a surface goes on straight.
    pub(super) fn look(&self, at: [f64; 4]) -> PairState {
        let one = |surface: &NurbsSurface, i: usize| {
            let inside = [0, 1].map(|k| within(self.domains[i + k], at[i + k]));
            let [point, by_u, by_v] = surface.tangents_at(inside[0], inside[1]);
            let beyond = by_u * (at[i] - inside[0]) + by_v * (at[i + 1] - inside[1]);
            (point + beyond, by_u, by_v)
        };
        let (p, pu, pv) = one(self.surfaces[0], 0);
        let (q, qu, qv) = one(self.surfaces[1], 2);
        PairState { apart: p - q, slopes: [pu, pv, -qu, -qv], point: p.midpoint(q) }
    }

    /// The point of one of the surfaces at the parameters of its domain nearest to some.
    pub(super) fn point_within(&self, surface: usize, [u, v]: [f64; 2]) -> DVec3 {
        let [u, v] =
            [within(self.domains[2 * surface], u), within(self.domains[2 * surface + 1], v)];
        self.surfaces[surface].point_at(u, v)
    }

    pub(super) fn place(&self, at: [f64; 4]) -> PairParameters {
        self.look(at).place(at)
    }

    /// The common place nearest to parameters, these counted by widths.
    pub(super) fn common(&self, start: [f64; 4], widths: [f64; 4]) -> Option<PairParameters> {
        let mut seen = None;
        let found = within_limits(
            [FREE; 4],
            start,
            CROSSING_STEPS,
            |_, _| false,
            |at| {
                let (_, look) = seen.insert((at, self.look(at)));
                if norm(look.apart) <= self.rounding {
                    return NewtonStep::Stay;
                }
                // The shortest step that removes the gap.
                let columns: [DVec3; 4] = std::array::from_fn(|i| look.slopes[i] * widths[i]);
                let matrix: [[f64; 3]; 3] = std::array::from_fn(|i| {
                    std::array::from_fn(|k| columns.iter().map(|c| c[i] * c[k]).sum())
                });
                let factors = solved(matrix, (-look.apart).to_array()).map(DVec3::from_array);
                NewtonStep::perhaps(factors.map(|factors| {
                    std::array::from_fn(|i| widths[i] * columns[i].dot(factors).clamp(-2.0, 2.0))
                }))
            },
        );
        let at = found.unless_stuck()?;
        let look = match seen {
            Some((place, look)) if DVec4::from_array(place) == DVec4::from_array(at) => look,
            _ => self.look(at),
        };
        (norm(look.apart) <= MEETING_SHARE * self.tolerance).then(|| look.place(at))
    }

    /// The place that the surfaces have in common to which Newton's method leads from the middle of two parts.
    pub(super) fn common_near(&self, [a, b]: &[Arc<SurfacePart>; 2]) -> Option<PairParameters> {
        let ([u, v], [s, t]) = (a.middle(), b.middle());
        let widths = [
            a.high[0] - a.low[0],
            a.high[1] - a.low[1],
            b.high[0] - b.low[0],
            b.high[1] - b.low[1],
        ];
        self.common([u, v, s, t], widths)
    }

    /// A common place that is inside two parts.
    pub(super) fn inside(
        &self,
        place: PairParameters,
        [a, b]: &[Arc<SurfacePart>; 2],
    ) -> Option<PairParameters> {
        let [u, v, s, t] = place.at;
        (a.holds([u, v]) && b.holds([s, t])).then(|| self.within_domains(place))
    }

    /// Whether a common place is no farther than the tolerance from each of two parts, and their normals hardly turn up to
    /// there, as over a crease.
    pub(super) fn is_beside(&self, place: &PairParameters, pair: &[Arc<SurfacePart>; 2]) -> bool {
        let [u, v, s, t] = place.at;
        let [pu, pv, qu, qv] = self.look(place.at).slopes;
        let sides = self.surfaces.into_iter().zip(pair).zip([[u, v], [s, t]]);
        let mut with_normals = sides.zip([pu.cross(pv), qu.cross(qv)]);
        self.is_inside(place.at)
            && with_normals.all(|(((surface, part), at), normal)| {
                let [u, v] = [0, 1].map(|k| at[k].clamp(part.low[k], part.high[k]));
                surface.point_at(u, v).distance(place.point) <= self.tolerance
                    && unit(normal).is_some_and(|normal| part.turns_little_to(normal))
            })
    }

    /// The boxes of two parts with all that their polynomials are up to a common place, where these still cross in at most
    /// one arc there.
    pub(super) fn reach(
        &self,
        place: &PairParameters,
        [a, b]: &[Arc<SurfacePart>; 2],
    ) -> Option<[Bounds; 2]> {
        let ([u, v], [s, t]) = (a.middle(), b.middle());
        let is_here = (0..4).all(|i| {
            let surface = self.surfaces[i / 2];
            let knots = if i % 2 == 0 { surface.knots_u() } else { surface.knots_v() };
            let span = knots.span_interval(knots.span_at([u, v, s, t][i]));
            span.start() <= place.at[i] && place.at[i] <= span.end()
        });
        let [u, v, s, t] = place.at;
        if !(is_here && a.is_about([u, v]) && b.is_about([s, t])) {
            return None;
        }
        let [a, b] = [a.reaching([u, v]), b.reaching([s, t])];
        a.crosses_clearly(&b).then_some([a.bounds, b.bounds])
    }

    /// The common place in a plane across a direction, or with one parameter given.
    pub(super) fn common_where(
        &self,
        start: [f64; 4],
        condition: PlaceCondition,
    ) -> Option<PairParameters> {
        let found = within_limits(
            [FREE; 4],
            start,
            CROSSING_STEPS,
            |_, _| false,
            |at| {
                let look = self.look(at);
                let (row, value) = match condition {
                    PlaceCondition::InPlane { origin, normal } => {
                        let [pu, pv, ..] = look.slopes;
                        // The plane cuts the first surface.
                        let first = look.point + 0.5 * look.apart;
                        let row = [pu.dot(normal), pv.dot(normal), 0.0, 0.0];
                        (row, (first - origin).dot(normal))
                    }
                    PlaceCondition::At { parameter, value } => (
                        std::array::from_fn(|i| f64::from(u8::from(i == parameter))),
                        at[parameter] - value,
                    ),
                };
                let matrix: [[f64; 4]; 4] = std::array::from_fn(|i| match i {
                    3 => row,
                    _ => std::array::from_fn(|k| look.slopes[k][i]),
                });
                let [x, y, z] = (-look.apart).to_array();
                let Some(step) = solved(matrix, [x, y, z, -value]) else {
                    return NewtonStep::Stuck;
                };
                let is_still = (0..4).all(|i| {
                    let size = (at[i] + step[i]).abs() + self.domains[i].length();
                    step[i].abs() <= 4.0 * LAST_BIT * size
                });
                if is_still { NewtonStep::Last(step) } else { NewtonStep::By(step) }
            },
        );
        let at = found.unless_stuck()?;
        let look = self.look(at);
        let is_there =
            at.iter().all(|x| x.is_finite()) && norm(look.apart) <= MEETING_SHARE * self.tolerance;
        is_there.then(|| look.place(at))
    }
}

impl PairState {
    /// The place of both at the parameters at which it was looked.
    fn place(&self, at: [f64; 4]) -> PairParameters {
        let [pu, pv, qu, qv] = self.slopes;
        let normals = [unit(pu.cross(pv)), unit(qu.cross(qv))];
        let across = normals[0].zip(normals[1]).map_or(DVec3::ZERO, |(a, b)| a.cross(b));
        let is_clear = LAST_BIT.sqrt() < across.length();
        let tangent = unit(across).filter(|_| is_clear).unwrap_or(DVec3::ZERO);
        PairParameters { at, point: self.point, tangent }
    }
}

/// What a place must fulfil besides being on both surfaces.
#[derive(Clone, Copy)]
pub(super) enum PlaceCondition {
    InPlane { origin: DVec3, normal: DVec3 },
    At { parameter: usize, value: f64 },
}

/// The parameter of a domain that is nearest to one.
pub(super) fn within(domain: Interval, t: f64) -> f64 {
    t.clamp(domain.start(), domain.end())
}
