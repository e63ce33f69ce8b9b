//! Parts of two surfaces in search of one another: boxes, slabs, and cones of normals.

use std::{
    collections::BTreeMap,
    sync::{Arc, OnceLock},
};

use glam::{DVec3, DVec4};

use super::{shade, square};
use crate::{
    Bounds, Direction, Grid, Interval, NurbsSurface, Side,
    ceiling::KEPT_COEFFICIENTS,
    frame::{unit, widest_angle},
    homogeneous,
    surface::Edge,
    tolerance::{CONE_CLEARANCE, LAST_BIT, NORMAL_ROUNDING, PLACE_RELATIVE},
};

/// Two parts cross in at most one arc when their cones of normals together are narrower than this
/// fraction of the sine of the angle between them.
const CLEAR: f64 = 0.4;

/// Cones of normals of parts in which places are looked for where normals are parallel are together
/// no wider than this: Newton's method finds them.
const FLAT_ENOUGH: f64 = 0.8;

/// Last bits of the places of a part, by its size, that its normals may be turned by.
const NORMAL_BITS: f64 = 8.0;

/// A part of a surface, between parameters.
#[derive(Clone, Debug)]
pub(in crate::surface) struct SurfacePart {
    pub(in crate::surface) low: [f64; 2],
    pub(in crate::surface) high: [f64; 2],
    net: Grid<DVec4>,
    normals: Grid<DVec3>,
    places: Grid<DVec3>,
    pub(super) bounds: Bounds,
    /// Known once it was asked for: boxes keep most parts apart.
    cone: OnceLock<NormalCone>,
    /// Its halves where they were kept: it may be near to several parts.
    kept_halves: OnceLock<[Arc<SurfacePart>; 2]>,
}

/// All normals are within the angle of the axis.
#[derive(Clone, Copy, Debug)]
struct NormalCone {
    axis: DVec3,
    angle: f64,
}

/// The Bézier patches of a surface, of which those are made that come near something.
pub(super) struct SurfacePatches<'s> {
    surface: &'s NurbsSurface,
    spans: [Vec<usize>; 2],
    /// By the numbers of their spans; a line or a point is no part.
    made: BTreeMap<[usize; 2], Option<Arc<SurfacePart>>>,
}

impl<'s> SurfacePatches<'s> {
    pub(super) fn new(surface: &'s NurbsSurface) -> Self {
        let spans = [surface.knots_u(), surface.knots_v()].map(|knots| knots.spans().collect());
        Self { surface, spans, made: BTreeMap::new() }
    }

    /// The patch of these spans; `None` where it is a line or a point.
    pub(super) fn part(&mut self, spans: [usize; 2]) -> Option<Arc<SurfacePart>> {
        let make = || {
            let [u, v] = [0, 1].map(|i| self.spans[i][spans[i]]);
            SurfacePart::of_patch(self.surface, [u, v]).map(Arc::new)
        };
        self.made.entry(spans).or_insert_with(make).clone()
    }

    /// The pairs of patches of both that are not apart by more than a distance.
    pub(super) fn pairs(&mut self, other: &mut Self, distance: f64) -> Vec<[Arc<SurfacePart>; 2]> {
        let [boxes, others] = [self.surface, other.surface].map(NurbsSurface::patch_boxes);
        let near = boxes.near_pairs(others, distance).into_iter();
        near.filter_map(|[own, its]| {
            let pair = [self.part(own)?, other.part(its)?];
            (!pair[0].is_apart(&pair[1], distance)).then_some(pair)
        })
        .collect()
    }
}

impl SurfacePart {
    /// The Bézier patches of a surface; those that are lines or points are left out.
    pub(in crate::surface) fn all(surface: &NurbsSurface) -> Vec<Self> {
        let spans = [surface.knots_u(), surface.knots_v()].map(|k| k.spans().collect::<Vec<_>>());
        let pairs = spans[0].iter().flat_map(|&u| spans[1].iter().map(move |&v| [u, v]));
        pairs.filter_map(|spans| Self::of_patch(surface, spans)).collect()
    }

    /// The Bézier patch over a span of each direction; `None` where it is a line or a point.
    fn of_patch(surface: &NurbsSurface, [u, v]: [usize; 2]) -> Option<Self> {
        let patch = surface.patch(u, v);
        let normals = shade::normals_of(&patch)?;
        let domains = [patch.domain_u(), patch.domain_v()];
        let net = patch.control_points().clone();
        Some(Self::new(domains.map(Interval::start), domains.map(Interval::end), net, normals))
    }

    fn new(low: [f64; 2], high: [f64; 2], net: Grid<DVec4>, normals: Grid<DVec3>) -> Self {
        let places = net.map(|&point| homogeneous::place(point));
        let nothing = Bounds { min: DVec3::ZERO, max: DVec3::ZERO };
        let bounds = Bounds::of(places.iter().copied()).unwrap_or(nothing);
        let (cone, kept_halves) = (OnceLock::new(), OnceLock::new());
        Self { low, high, net, normals, places, bounds, cone, kept_halves }
    }

    fn cone(&self) -> NormalCone {
        *self.cone.get_or_init(|| {
            let units: Vec<DVec3> =
                self.normals.iter().filter_map(|&normal| unit(normal)).collect();
            let axis = unit(units.iter().sum()).unwrap_or(DVec3::ZERO);
            let angle = match axis == DVec3::ZERO {
                true => std::f64::consts::PI,
                false => widest_angle(units.into_iter(), axis),
            };
            NormalCone { axis, angle }
        })
    }

    pub(super) fn middle(&self) -> [f64; 2] {
        [0, 1].map(|i| 0.5 * (self.low[i] + self.high[i]))
    }

    /// The halves across the direction in which it is longer.
    pub(in crate::surface) fn halves(&self) -> [Self; 2] {
        let along_u = longest(&self.places) >= longest(&self.places.transposed());
        let direction = if along_u { Direction::U } else { Direction::V };
        let middle = self.middle()[direction];
        let nets = cut(&self.net, direction, 0.5);
        let [before, behind] = cut(&self.normals, direction, 0.5);
        let mut ends = [(self.low, self.high); 2];
        (ends[0].1[direction], ends[1].0[direction]) = (middle, middle);
        let [first, second] = nets;
        [
            Self::new(ends[0].0, ends[0].1, first, before),
            Self::new(ends[1].0, ends[1].1, second, behind),
        ]
    }

    /// The part with what its polynomials are up to parameters beyond it.
    pub(super) fn reaching(&self, at: [f64; 2]) -> Self {
        let (mut low, mut high) = (self.low, self.high);
        let (mut net, mut normals) = (self.net.clone(), self.normals.clone());
        for along in Direction::BOTH {
            let fraction = (at[along] - low[along]) / (high[along] - low[along]);
            // Of both sides of a cut beyond an end one is longer than the whole.
            let (end, longer) = match fraction {
                ..0.0 => (&mut low, 1),
                _ if 1.0 < fraction => (&mut high, 0),
                _ => continue,
            };
            end[along] = at[along];
            net = cut(&net, along, fraction)[longer].clone();
            normals = cut(&normals, along, fraction)[longer].clone();
        }
        Self::new(low, high, net, normals)
    }

    /// The same as halves, kept for when they are asked for again, unless more than [`KEPT_COEFFICIENTS`] are, whose number goes up.
    pub(super) fn shared_halves(&self, n_kept: &mut usize) -> [Arc<Self>; 2] {
        if let Some(kept) = self.kept_halves.get() {
            return kept.clone();
        }
        let halves = self.halves().map(Arc::new);
        if *n_kept < KEPT_COEFFICIENTS && self.kept_halves.set(halves.clone()).is_ok() {
            let n_own = [self.net.as_slice().len(), self.places.as_slice().len()];
            *n_kept += 2 * (n_own.iter().sum::<usize>() + self.normals.as_slice().len());
        }
        halves
    }

    /// The steps along one of its sides.
    pub(super) fn along(&self, edge: Edge) -> Vec<DVec3> {
        let rows = self.rows_behind(edge);
        rows.row(0).windows(2).map(|pair| pair[1] - pair[0]).collect()
    }

    /// The steps that lead from one of its sides to the opposite one.
    pub(super) fn inward(&self, edge: Edge) -> Vec<DVec3> {
        let rows = self.rows_behind(edge);
        let steps = |i: usize| rows.row(i).iter().zip(rows.row(i - 1)).map(|(to, from)| to - from);
        (1..rows.n_rows()).flat_map(steps).collect()
    }

    /// The net with the row along a side as its first.
    fn rows_behind(&self, edge: Edge) -> Grid<DVec3> {
        let (along, side) = edge.place();
        let rows =
            if along == Direction::U { self.places.clone() } else { self.places.transposed() };
        let last = rows.n_rows() - 1;
        match side {
            Side::Left => rows,
            Side::Right => Grid::from_fn(last + 1, rows.n_columns(), |i, j| rows.get(last - i, j)),
        }
    }

    /// Where it lies along an axis.
    fn reach(&self, axis: DVec3) -> [f64; 2] {
        let heights = || self.places.iter().map(|place| place.dot(axis));
        [heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max)]
    }

    /// How thick the slab across its axis is.
    pub(super) fn thickness(&self) -> f64 {
        let NormalCone { axis, .. } = self.cone();
        let [least, most] = self.reach(axis);
        if axis == DVec3::ZERO { self.bounds.diagonal() } else { most - least }
    }

    /// Whether it is further than a distance from points, told by boxes and by slabs.
    pub(super) fn is_beside(&self, bounds: Bounds, points: &[DVec3], distance: f64) -> bool {
        if !self.bounds.is_near(bounds, distance) {
            return true;
        }
        let NormalCone { axis, .. } = self.cone();
        let [least, most] = self.reach(axis);
        let heights = || points.iter().map(|point| point.dot(axis));
        heights().fold(f64::NEG_INFINITY, f64::max) < least - distance
            || most + distance < heights().fold(f64::INFINITY, f64::min)
    }

    /// Whether two parts are further than a distance from one another.
    pub(super) fn is_apart(&self, other: &Self, distance: f64) -> bool {
        self.is_beside(other.bounds, other.places.as_slice(), distance)
            || other.is_beside(self.bounds, self.places.as_slice(), distance)
    }

    /// Whether two parts cross in at most one arc, and never against its direction.
    pub(super) fn crosses_clearly(&self, other: &Self) -> bool {
        let [own, its] = [self.cone(), other.cone()];
        let spread = own.angle + its.angle + self.rounding_beside(other);
        spread < CLEAR * own.axis.cross(its.axis).length()
    }

    /// Whether a normal is outside of its own by no more than these are wide: with it two parts that cross clearly still
    /// cross in at most one arc.
    pub(super) fn turns_little_to(&self, normal: DVec3) -> bool {
        let NormalCone { axis, angle } = self.cone();
        axis.angle_between(normal) <= 2.0 * angle + NORMAL_ROUNDING
    }

    /// Whether its normals are all on one side of a plane, so that it does not turn over.
    pub(in crate::surface) fn is_regular(&self) -> bool {
        self.cone().angle < std::f64::consts::FRAC_PI_2
    }

    /// Whether normals of both may be parallel, and little else.
    pub(super) fn may_touch(&self, other: &Self) -> bool {
        let [own, its] = [self.cone(), other.cone()];
        let between = libm::asin(own.axis.cross(its.axis).length().min(1.0));
        let spread = own.angle + its.angle;
        spread <= FLAT_ENOUGH && between <= spread + self.rounding_beside(other)
    }

    /// By how much rounding of their points may turn the normals of two parts, radians.
    fn rounding_beside(&self, other: &Self) -> f64 {
        let share = |part: &Self| part.bounds.magnitude() / part.bounds.diagonal();
        (NORMAL_BITS * LAST_BIT * share(self).max(share(other))).min(NORMAL_ROUNDING)
    }

    /// Whether parameters are within it or beside it.
    pub(super) fn is_about(&self, at: [f64; 2]) -> bool {
        (0..2).all(|i| {
            let slack = 0.5 * (self.high[i] - self.low[i]);
            self.low[i] - slack <= at[i] && at[i] <= self.high[i] + slack
        })
    }

    /// Whether directions within an angle of another stay clear of its tangent planes.
    pub(super) fn is_crossed_by(&self, direction: DVec3, angle: f64) -> bool {
        let own = self.cone();
        angle + own.angle < libm::asin(direction.dot(own.axis).abs().min(1.0)) - CONE_CLEARANCE
    }

    pub(super) fn holds(&self, at: [f64; 2]) -> bool {
        (0..2).all(|i| {
            let slack = PLACE_RELATIVE * (self.high[i] - self.low[i]);
            self.low[i] - slack <= at[i] && at[i] <= self.high[i] + slack
        })
    }
}

fn longest(places: &Grid<DVec3>) -> f64 {
    let n = places.n_rows();
    let steps = (1..n).flat_map(|i| {
        (0..places.n_columns()).map(move |j| places.get(i, j).distance(places.get(i - 1, j)))
    });
    (n - 1) as f64 * steps.fold(0.0, f64::max)
}

fn cut<T>(field: &Grid<T>, along: Direction, fraction: f64) -> [Grid<T>; 2]
where
    T: Copy + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    match along {
        Direction::U => square::cut_v(&field.transposed(), fraction).map(|part| part.transposed()),
        Direction::V => square::cut_v(field, fraction),
    }
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, DVec3};

    use super::SurfacePart;
    use crate::{Grid, NurbsSurface};

    #[test]
    fn a_half_that_reaches_over_the_other_is_the_whole() {
        let point =
            |i, j| DVec3::new(i as f64, j as f64, (i * j * j) as f64 - 0.5 * (i * i) as f64);
        let points = Grid::from_fn(3, 4, point);
        let surface = NurbsSurface::bezier(&points).expect("a patch");
        let whole = SurfacePart::all(&surface).remove(0);
        let [first, second] = whole.halves();
        for again in [first.reaching(second.high), second.reaching(first.low)] {
            let ends = [&again, &whole].map(|part| [part.low, part.high].map(DVec2::from_array));
            assert_eq!(ends[0], ends[1]);
            let misses = again.places.iter().zip(whole.places.iter()).map(|(a, b)| a.distance(*b));
            assert!(misses.fold(0.0, f64::max) <= 1e-13);
            let misses =
                again.normals.iter().zip(whole.normals.iter()).map(|(a, b)| a.distance(*b));
            assert!(misses.fold(0.0, f64::max) <= 1e-11);
        }
    }
}
