//! A Bézier patch seen from a place, and the nearest point on a part of it.

use std::{convert::Infallible, ops::ControlFlow};

use glam::{DVec2, DVec3, DVec4};

use super::{
    basis::{self, Basis},
    spans::DirectionSpans,
};
use crate::{
    Bounds, Direction, Interval, bezier,
    ceiling::{NEAREST_STEPS, STEP_HALVINGS, WHOLE_STEPS},
    homogeneous,
    numeric::{
        linear::TwoEquations,
        newton::{improved, shortened},
    },
    tolerance::LAST_BIT,
};

/// Last bits of the square of a distance that the bound by a tangent plane may be off.
const BEYOND_ROUNDINGS: f64 = 16.0;

/// A part of a patch, in fractions of its spans.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PatchPart {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    pub(super) n_halvings: [u8; 2],
}

/// The nearest point on a part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Minimum {
    pub(super) place: [f64; 2],
    /// The square of its distance.
    pub(super) squared: f64,
    /// Whether it is a minimum up to rounding.
    pub(super) is_stationary: bool,
    /// Whether nothing of the part can be as near as was asked for, so that the descent ended.
    pub(super) is_beyond: bool,
}

/// The net of a patch, with room to work.
pub(super) struct BezierPatch {
    degrees: [usize; 2],
    net: Vec<DVec4>,
    /// Whether all weights are one number.
    has_one_weight: bool,
    strip: Vec<DVec4>,
    /// The net of a part, and the places of its points.
    part: Vec<DVec4>,
    places: Vec<DVec3>,
    bases: [Basis; 2],
}

/// The way from the place that is asked for to a point, with its derivatives.
#[derive(Clone, Copy)]
pub(crate) struct FootVector {
    pub(crate) place: [f64; 2],
    squared: f64,
    /// Half the derivatives of the square.
    slope: [f64; 2],
    /// The same of second order: by u, mixed, by v.
    bend: [f64; 3],
    /// That of the tangents alone.
    metric: [f64; 3],
}

impl PatchPart {
    /// The whole patch; of a direction without extent its start.
    pub(super) fn whole(degrees: [usize; 2]) -> Self {
        let high = degrees.map(|degree| if degree == 0 { 0.0 } else { 1.0 });
        Self { low: [0.0; 2], high, n_halvings: [0; 2] }
    }

    /// A rectangle of parameters.
    pub(crate) fn between(u: Interval, v: Interval) -> Self {
        let (low, high) = ([u.start(), v.start()], [u.end(), v.end()]);
        Self { low, high, n_halvings: [0; 2] }
    }

    pub(super) fn at(&self, fraction: [f64; 2]) -> [f64; 2] {
        let along = |i: usize| self.low[i] * (1.0 - fraction[i]) + self.high[i] * fraction[i];
        [along(0), along(1)]
    }

    pub(super) fn halves(mut self, along: Direction) -> [Self; 2] {
        self.n_halvings[along] += 1;
        let middle = 0.5 * (self.low[along] + self.high[along]);
        let (mut left, mut right) = (self, self);
        (left.high[along], right.low[along]) = (middle, middle);
        [left, right]
    }

    fn clamp(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| place[i].clamp(self.low[i], self.high[i]))
    }

    /// By how much a plane that is tangent to the square of the distance falls at most from a place to the end of the part.
    fn fall(&self, way: &FootVector) -> f64 {
        let along = |i: usize| {
            let [to_low, to_high] = [way.place[i] - self.low[i], way.place[i] - self.high[i]];
            2.0 * (way.slope[i] * to_low).max(way.slope[i] * to_high)
        };
        along(0) + along(1)
    }

    /// Whether the way down is barred along a direction.
    fn bars(&self, way: &FootVector, i: usize) -> bool {
        (way.place[i] <= self.low[i] && 0.0 <= way.slope[i])
            || (self.high[i] <= way.place[i] && way.slope[i] <= 0.0)
    }
}

impl BezierPatch {
    pub(super) fn new(degrees: [usize; 2]) -> Self {
        let net = vec![DVec4::ZERO; (degrees[0] + 1) * (degrees[1] + 1)];
        Self {
            degrees,
            strip: net.clone(),
            net,
            has_one_weight: false,
            part: Vec::new(),
            places: Vec::new(),
            bases: degrees.map(Basis::new),
        }
    }

    /// Becomes the patch over a pair of spans, seen from `p` with lengths multiplied by `unit`.
    pub(super) fn take(
        &mut self,
        along: &[DirectionSpans; 2],
        spans: [usize; 2],
        (points, n_columns): (&[DVec4], usize),
        (p, unit): (DVec3, f64),
    ) {
        let [n_u, n_v] = self.degrees.map(|degree| degree + 1);
        let first = [0, 1].map(|i| along[i].spans[spans[i]].first);
        let seen = |point: DVec4| ((point.truncate() - p * point.w) * unit).extend(point.w);
        let to_bezier = along[1].to_bezier(spans[1]);
        let row_of = |i: usize| &points[(first[0] + i) * n_columns + first[1]..][..n_v];
        let weight = row_of(0)[0].w.to_bits();
        self.has_one_weight =
            (0..n_u).all(|i| row_of(i).iter().all(|point| point.w.to_bits() == weight));
        for i in 0..n_u {
            let row = row_of(i);
            let strip = &mut self.strip[i * n_v..][..n_v];
            strip.fill(DVec4::ZERO);
            for (j, &point) in row.iter().enumerate() {
                let point = seen(point);
                for (l, sum) in strip.iter_mut().enumerate() {
                    *sum += point * to_bezier[l * n_v + j];
                }
            }
        }
        let to_bezier = along[0].to_bezier(spans[0]);
        for k in 0..n_u {
            let net = &mut self.net[k * n_v..][..n_v];
            net.fill(DVec4::ZERO);
            for i in 0..n_u {
                let factor = to_bezier[k * n_u + i];
                for (sum, &point) in net.iter_mut().zip(&self.strip[i * n_v..][..n_v]) {
                    *sum += point * factor;
                }
            }
        }
    }

    pub(super) fn net(&self) -> &[DVec4] {
        &self.net
    }

    /// Whether a plane keeps all control points further away than `limit`.
    pub(super) fn is_beyond(&self, limit: f64) -> bool {
        let middle: DVec3 = self.net.iter().map(|point| point.truncate()).sum();
        let Some(direction) = middle.try_normalize() else { return false };
        let is_behind =
            |point: &DVec4| 0.0 < point.w && limit * point.w <= point.truncate().dot(direction);
        self.net.iter().all(is_behind)
    }

    /// Whether a plane along the direction in which a part is longest keeps all of it further away than `limit`.
    ///
    /// Of a thin part that is slanted against the parameters the squares of distances say little: what is large in
    /// them along the part comes and goes between coefficients, and what is small across it tells how far it is.
    pub(super) fn is_part_beyond(&mut self, cell: PatchPart, limit: f64) -> bool {
        self.narrow_to(cell);
        if !self.part.iter().all(|point| 0.0 < point.w) {
            return false;
        }
        self.places.clear();
        self.places.extend(self.part.iter().map(|&point| homogeneous::place(point)));
        let places = &self.places;
        let reach = |place: &&DVec3| place.distance_squared(places[0]);
        let furthest = places.iter().max_by(|a, b| reach(a).total_cmp(&reach(b)));
        let along = furthest.and_then(|far| (*far - places[0]).try_normalize());
        let middle = places.iter().sum::<DVec3>() / places.len() as f64;
        let across = along.map_or(middle, |along| middle - along * middle.dot(along));
        let Some(across) = across.try_normalize() else { return false };
        places.iter().all(|place| limit <= place.dot(across))
    }

    /// Has the net of a part in `part`.
    fn narrow_to(&mut self, cell: PatchPart) {
        let n_v = self.degrees[1] + 1;
        self.part.clear();
        self.part.extend_from_slice(&self.net);
        let [along_u, along_v] = [0, 1].map(|i| [cell.low[i], cell.high[i]]);
        for row in self.part.chunks_exact_mut(n_v) {
            bezier::keep_between(row, 1, along_v);
        }
        for j in 0..n_v {
            bezier::keep_between(&mut self.part[j..], n_v, along_u);
        }
    }

    /// The box of the control points; without bounds where a weight is not positive.
    pub(super) fn bounds(&self) -> Bounds {
        let place = |point: &DVec4| point.truncate() / point.w;
        let is_hull = self.net.iter().all(|point| 0.0 < point.w);
        let everywhere = Bounds { min: DVec3::NEG_INFINITY, max: DVec3::INFINITY };
        Bounds::of(self.net.iter().map(place)).filter(|_| is_hull).unwrap_or(everywhere)
    }

    /// The nearest point on a part, of those that a descent from `start` comes to. It is a minimum
    /// if no other distance in the part would be less by more than `rounding`, were the square of
    /// the distance convex.
    ///
    /// The descent ends where nothing of the part can be within the distance `sought`, if there is one weight and the
    /// square of the distance is convex, as the caller knows: then it lies above its tangent plane.
    pub(super) fn minimum(
        &mut self,
        cell: PatchPart,
        start: [f64; 2],
        rounding: f64,
        sought: f64,
    ) -> Minimum {
        let has_one_weight = self.has_one_weight;
        let is_beyond = |way: &FootVector| {
            let least = way.squared * (1.0 - BEYOND_ROUNDINGS * LAST_BIT) - cell.fall(way);
            has_one_weight && sought * sought < least
        };
        let Ok(way) = descend_until(&cell, start, is_beyond, |place| {
            Ok::<FootVector, Infallible>(self.way(place))
        });
        let left: f64 = [0, 1]
            .into_iter()
            .filter(|&i| !cell.bars(&way, i))
            .map(|i| 2.0 * way.slope[i].abs() * (cell.high[i] - cell.low[i]))
            .sum();
        let is_stationary = left <= rounding * (2.0 * way.squared.sqrt() + rounding);
        let is_beyond = is_beyond(&way);
        Minimum { place: way.place, squared: way.squared, is_stationary, is_beyond }
    }

    /// The square of the distance of a place.
    pub(super) fn squared_at(&mut self, place: [f64; 2]) -> f64 {
        self.way(place).squared
    }

    fn way(&mut self, place: [f64; 2]) -> FootVector {
        FootVector::new(
            place,
            homogeneous::second_order(basis::sums(&self.net, &mut self.bases, place)),
        )
    }
}

/// Goes down from `start` within a part, by Newton's method, as far as that leads or to a place as near as `near`.
pub(crate) fn descend<E>(
    cell: &PatchPart,
    start: [f64; 2],
    near: f64,
    way_at: impl FnMut([f64; 2]) -> Result<FootVector, E>,
) -> Result<FootVector, E> {
    descend_until(cell, start, |way| way.squared <= near * near, way_at)
}

/// Goes down from `start` within a part, by Newton's method, as far as that leads or is of use.
fn descend_until<E>(
    cell: &PatchPart,
    start: [f64; 2],
    is_enough: impl Fn(&FootVector) -> bool,
    mut way_at: impl FnMut([f64; 2]) -> Result<FootVector, E>,
) -> Result<FootVector, E> {
    improved(way_at(start)?, NEAREST_STEPS, |way| match is_enough(way) {
        true => Ok(None),
        false => lower(cell, way, &mut way_at),
    })
}

/// A step that leads down, or none.
///
/// Along a narrow curved valley whole steps lead up on its side first, and from there down to its floor far ahead,
/// where steps that are shortened until they lead down would creep.
fn lower<E>(
    cell: &PatchPart,
    way: &FootVector,
    way_at: &mut impl FnMut([f64; 2]) -> Result<FootVector, E>,
) -> Result<Option<FootVector>, E> {
    let step_of = |from: &FootVector| from.step([0, 1].map(|i| cell.bars(from, i)));
    let whole = step_of(way);
    let mut ahead = *way;
    for _ in 0..WHOLE_STEPS {
        match stepped(cell, &ahead, step_of(&ahead), way_at)? {
            Some(next) if is_lower(cell, &next, way) => return Ok(Some(next)),
            Some(_) if way.gains_rounding(whole) => return Ok(None),
            Some(next) => ahead = next,
            None => break,
        }
    }
    shortened(whole.map(|step| 0.5 * step), STEP_HALVINGS, |step| {
        Ok(match stepped(cell, way, step, way_at)? {
            Some(next) if is_lower(cell, &next, way) => ControlFlow::Break(Some(next)),
            Some(_) => ControlFlow::Continue(()),
            None => ControlFlow::Break(None),
        })
    })
}

/// Where a step leads within a part; none where it does not lead away.
fn stepped<E>(
    cell: &PatchPart,
    from: &FootVector,
    step: [f64; 2],
    way_at: &mut impl FnMut([f64; 2]) -> Result<FootVector, E>,
) -> Result<Option<FootVector>, E> {
    let place = cell.clamp([from.place[0] + step[0], from.place[1] + step[1]]);
    let is_away = DVec2::from_array(place) != DVec2::from_array(from.place);
    is_away.then(|| way_at(place)).transpose()
}

/// Whether a place is nearer than another, or as near where it is less steep.
fn is_lower(cell: &PatchPart, next: &FootVector, way: &FootVector) -> bool {
    let steepness = |way: &FootVector| {
        let free = |i: usize| if cell.bars(way, i) { 0.0 } else { way.slope[i].abs() };
        free(0).max(free(1))
    };
    let is_level = next.squared <= way.squared * (1.0 + 4.0 * LAST_BIT);
    next.squared < way.squared || (is_level && steepness(next) < 0.5 * steepness(way))
}

impl FootVector {
    /// From the way and its derivatives S, Su, Sv, Suu, Suv, Svv.
    pub(crate) fn new(place: [f64; 2], [r, u, v, uu, uv, vv]: [DVec3; 6]) -> Self {
        let metric = [u.dot(u), u.dot(v), v.dot(v)];
        let bend = [metric[0] + r.dot(uu), metric[1] + r.dot(uv), metric[2] + r.dot(vv)];
        Self { place, squared: r.dot(r), slope: [r.dot(u), r.dot(v)], bend, metric }
    }

    /// Whether all that a step of Newton's is to take off the square of the distance is its rounding.
    fn gains_rounding(&self, step: [f64; 2]) -> bool {
        let gain = self.slope[0] * step[0] + self.slope[1] * step[1];
        gain.abs() <= LAST_BIT * self.squared
    }

    /// Newton's step along the free directions; where the square of the distance is not convex
    /// that of Gauss and Newton, which goes down always.
    fn step(&self, barred: [bool; 2]) -> [f64; 2] {
        let [a, b] = self.slope;
        match barred {
            [true, true] => [0.0, 0.0],
            [false, true] => [single(a, self.bend[0], self.metric[0]), 0.0],
            [true, false] => [0.0, single(b, self.bend[2], self.metric[2])],
            [false, false] => {
                let solve = |[uu, uv, vv]: [f64; 3]| {
                    let form = TwoEquations::symmetric(uu, uv, vv);
                    let is_convex = 0.0 < uu && 0.0 < vv && LAST_BIT * uu * vv < form.determinant();
                    is_convex.then(|| form.solved([-a, -b]))
                };
                solve(self.bend).or_else(|| solve(self.metric)).unwrap_or([
                    single(a, self.bend[0], self.metric[0]),
                    single(b, self.bend[2], self.metric[2]),
                ])
            }
        }
    }
}

/// The step along one direction.
fn single(slope: f64, bend: f64, metric: f64) -> f64 {
    if 0.0 < bend {
        -slope / bend
    } else if 0.0 < metric {
        -slope / metric
    } else {
        0.0
    }
}
