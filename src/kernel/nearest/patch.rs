//! A Bézier patch seen from a place, and the nearest point on a part of it.

use std::{convert::Infallible, ops::ControlFlow};

use glam::{DVec2, DVec3, DVec4};

use super::spans::DirectionSpans;
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
}

/// The net of a patch, with room to work.
pub(super) struct BezierPatch {
    degrees: [usize; 2],
    net: Vec<DVec4>,
    strip: Vec<DVec4>,
    /// The net of a part, and the places of its points.
    part: Vec<DVec4>,
    places: Vec<DVec3>,
    bases: [Basis; 2],
}

/// Bernstein polynomials and their first two derivatives.
struct Basis {
    values: Vec<f64>,
    slopes: Vec<f64>,
    bends: Vec<f64>,
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

    /// Whether the way down is barred along a direction.
    fn bars(&self, way: &FootVector, i: usize) -> bool {
        (way.place[i] <= self.low[i] && 0.0 <= way.slope[i])
            || (self.high[i] <= way.place[i] && way.slope[i] <= 0.0)
    }
}

impl BezierPatch {
    pub(super) fn new(degrees: [usize; 2]) -> Self {
        let basis = |degree: usize| Basis {
            values: vec![0.0; degree + 1],
            slopes: vec![0.0; degree + 1],
            bends: vec![0.0; degree + 1],
        };
        let net = vec![DVec4::ZERO; (degrees[0] + 1) * (degrees[1] + 1)];
        let (part, places) = (Vec::with_capacity(net.len()), Vec::with_capacity(net.len()));
        Self { degrees, strip: net.clone(), net, part, places, bases: degrees.map(basis) }
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
        for i in 0..n_u {
            let row = &points[(first[0] + i) * n_columns + first[1]..][..n_v];
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
    pub(super) fn minimum(&mut self, cell: PatchPart, start: [f64; 2], rounding: f64) -> Minimum {
        let Ok(way) =
            descend(&cell, start, 0.0, |place| Ok::<FootVector, Infallible>(self.way(place)));
        let left: f64 = [0, 1]
            .into_iter()
            .filter(|&i| !cell.bars(&way, i))
            .map(|i| 2.0 * way.slope[i].abs() * (cell.high[i] - cell.low[i]))
            .sum();
        let is_stationary = left <= rounding * (2.0 * way.squared.sqrt() + rounding);
        Minimum { place: way.place, squared: way.squared, is_stationary }
    }

    /// The square of the distance of a place.
    pub(super) fn squared_at(&mut self, place: [f64; 2]) -> f64 {
        self.way(place).squared
    }

    fn way(&mut self, place: [f64; 2]) -> FootVector {
        let [along_u, along_v] = &mut self.bases;
        along_u.tabulate(place[0]);
        along_v.tabulate(place[1]);
        let n_v = along_v.values.len();
        let mut sums = [DVec4::ZERO; 6];
        for (i, row) in self.net.chunks_exact(n_v).enumerate() {
            let [mut value, mut slope, mut bend] = [DVec4::ZERO; 3];
            for (j, &point) in row.iter().enumerate() {
                value += point * along_v.values[j];
                slope += point * along_v.slopes[j];
                bend += point * along_v.bends[j];
            }
            let (n, dn, ddn) = (along_u.values[i], along_u.slopes[i], along_u.bends[i]);
            sums[0] += value * n;
            sums[1] += value * dn;
            sums[2] += slope * n;
            sums[3] += value * ddn;
            sums[4] += slope * dn;
            sums[5] += bend * n;
        }
        FootVector::new(place, homogeneous::second_order(sums))
    }
}

/// Goes down from `start` within a part, by Newton's method, as far as that leads or to a place as near as `near`.
pub(crate) fn descend<E>(
    cell: &PatchPart,
    start: [f64; 2],
    near: f64,
    mut way_at: impl FnMut([f64; 2]) -> Result<FootVector, E>,
) -> Result<FootVector, E> {
    improved(way_at(start)?, NEAREST_STEPS, |way| match way.squared <= near * near {
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
    let mut ahead = *way;
    for _ in 0..WHOLE_STEPS {
        match stepped(cell, &ahead, step_of(&ahead), way_at)? {
            Some(next) if is_lower(cell, &next, way) => return Ok(Some(next)),
            Some(next) => ahead = next,
            None => break,
        }
    }
    shortened(step_of(way).map(|step| 0.5 * step), STEP_HALVINGS, |step| {
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

impl Basis {
    fn tabulate(&mut self, s: f64) {
        let p = self.values.len() - 1;
        self.values[0] = 1.0;
        for degree in 0..=p {
            if degree + 2 == p {
                let factor = (p * (p - 1)) as f64;
                for i in 0..=p {
                    let at = |back: usize| match i.checked_sub(back) {
                        Some(i) if i <= degree => self.values[i],
                        _ => 0.0,
                    };
                    self.bends[i] = factor * ((at(2) - at(1)) - (at(1) - at(0)));
                }
            }
            if degree + 1 == p {
                for i in 0..=p {
                    let before = if i == 0 { 0.0 } else { self.values[i - 1] };
                    let this = if i == p { 0.0 } else { self.values[i] };
                    self.slopes[i] = p as f64 * (before - this);
                }
            }
            if degree < p {
                raise(&mut self.values[..degree + 2], s);
            }
        }
    }
}

/// The Bernstein polynomials of one degree more.
fn raise(values: &mut [f64], s: f64) {
    let mut passed = 0.0;
    let last = values.len() - 1;
    for value in &mut values[..last] {
        let this = *value;
        *value = passed + this * (1.0 - s);
        passed = this * s;
    }
    values[last] = passed;
}
