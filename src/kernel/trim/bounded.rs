//! Quantities that are least somewhere on a surface: no more than what a part of it can give.

use glam::{DVec3, DVec4};

use super::edge::{Carrier, SlopeRanges, slope_ranges};
use crate::{
    Bounds, Direction, Grid, NurbsSurface,
    frame::norm,
    numeric::enclosure::{outward, product as interval_product, sum},
    surface::square,
    tolerance::LAST_BIT,
};

/// What is least over a part of a surface, and where, if that is known.
pub(super) struct LeastValue {
    pub(super) value: f64,
    pub(super) parameters: Option<[f64; 2]>,
}

/// A quantity that is least somewhere.
pub(super) trait BoundedQuantity {
    /// Its least value over all of a surface.
    fn least(&self, part: &NurbsSurface) -> LeastValue;

    /// No more than its least value in a box.
    fn at_least(&self, hull: Bounds) -> f64;

    /// Whether its derivatives by u and v can both be zero over a part of a surface; `carrier` is the whole.
    fn may_be_stationary(&self, part: &NurbsSurface, carrier: &Carrier<'_>) -> bool;
}

/// How far along an axis, turned around for the upper end.
pub(super) struct AxisRange {
    pub(super) axis: usize,
    pub(super) is_upper: bool,
}

impl AxisRange {
    pub(super) fn of(&self, bounds: Bounds) -> f64 {
        if self.is_upper { -bounds.max[self.axis] } else { bounds.min[self.axis] }
    }
}

impl BoundedQuantity for AxisRange {
    fn least(&self, part: &NurbsSurface) -> LeastValue {
        LeastValue { value: self.of(part.bounds()), parameters: None }
    }

    fn at_least(&self, hull: Bounds) -> f64 {
        self.of(hull)
    }

    fn may_be_stationary(&self, part: &NurbsSurface, carrier: &Carrier<'_>) -> bool {
        let may_rest = |slopes: SlopeRanges| slopes.iter().all(|by| holds_zero(by[self.axis]));
        slopes_over(part, carrier).is_none_or(may_rest)
    }
}

/// How far from a point.
pub(super) struct DistanceTo(pub(super) DVec3);

impl BoundedQuantity for DistanceTo {
    fn least(&self, part: &NurbsSurface) -> LeastValue {
        let foot = part.closest(self.0);
        LeastValue { value: foot.distance, parameters: Some(foot.parameters) }
    }

    fn at_least(&self, Bounds { min, max }: Bounds) -> f64 {
        norm((min - self.0).max(self.0 - max).max(DVec3::ZERO))
    }

    fn may_be_stationary(&self, part: &NurbsSurface, carrier: &Carrier<'_>) -> bool {
        if is_patch(part) {
            return self.may_be_stationary_on_patch(part);
        }
        let Bounds { min, max } = hull(part);
        let away = |axis: usize| outward([min[axis] - self.0[axis], max[axis] - self.0[axis]]);
        let may_rest = |slopes: SlopeRanges| {
            slopes.iter().all(|slope| {
                let along = |axis: usize| interval_product(away(axis), slope[axis]);
                holds_zero(sum(sum(along(0), along(1)), along(2)))
            })
        };
        slopes_over(part, carrier).is_none_or(may_rest)
    }
}

impl DistanceTo {
    /// The same for a Bézier patch: with A = (S − p)w, of A·(Au w − A wu) and of A·(Av w − A wv) the
    /// Bernstein coefficients do not all have one sign.
    ///
    /// Where the surface is everywhere nearly equally far, boxes and ranges of slopes say little, and these all.
    fn may_be_stationary_on_patch(&self, patch: &NurbsSurface) -> bool {
        let seen = |p: &DVec4| (p.truncate() - self.0 * p.w).extend(p.w);
        let net = patch.control_points().map(seen);
        let coordinate = |p: &DVec4| p.truncate().abs().max((self.0 * p.w).abs()).max_element();
        let far = patch.control_points().iter().map(coordinate).fold(0.0, f64::max);
        holds_zero(turning(&net, far)) && holds_zero(turning(&net.transposed(), far))
    }
}

/// Roundings in a coefficient, for each coefficient along a side.
const ROUNDINGS: f64 = 8.0;

/// The range of A·(Au w − A wu) over a patch with coordinates up to `far`.
fn turning(net: &Grid<DVec4>, far: f64) -> [f64; 2] {
    let by = square::slope_u(net);
    let step = square::product(&by, net, |by, p| by.truncate() * p.w - p.truncate() * by.w);
    let turning = square::product(net, &step, |p, step| p.truncate().dot(step));
    let largest = |grid: &Grid<DVec3>| grid.iter().map(|p| p.length()).fold(0.0, f64::max);
    let (away, steepest) = (largest(&net.map(|p| p.truncate())), largest(&step));
    let weight = net.iter().map(|p| p.w.abs()).fold(0.0, f64::max);
    let n_terms = (net.n_rows() + net.n_columns()) as f64;
    // A is off by the last bits of coordinates, and what is made of differences of it by those of them all.
    let off = far * steepest + away * far * weight * n_terms;
    let slack = ROUNDINGS * n_terms * LAST_BIT * off;
    let [low, high] = square::range(&turning);
    [low - slack, high + slack]
}

/// Whether a surface is a single Bézier patch with positive weights.
fn is_patch(surface: &NurbsSurface) -> bool {
    let net = surface.control_points();
    net.n_rows() == surface.degree_u() + 1
        && net.n_columns() == surface.degree_v() + 1
        && net.iter().all(|point| 0.0 < point.w)
}

/// Ranges that hold Su and Sv over a part of a surface.
fn slopes_over(part: &NurbsSurface, carrier: &Carrier<'_>) -> Option<SlopeRanges> {
    let ends = |along: Direction| [part.domain(along).start(), part.domain(along).end()];
    slope_ranges(carrier, Direction::BOTH.map(ends))
}

/// A box around a surface: that of its control points, or where weights are not positive its own.
pub(super) fn hull(surface: &NurbsSurface) -> Bounds {
    let has_positive_weights = surface.control_points().iter().all(|point| 0.0 < point.w);
    match Bounds::of(surface.points().iter().copied()) {
        Some(hull) if has_positive_weights => hull,
        _ => surface.bounds(),
    }
}

fn holds_zero([low, high]: [f64; 2]) -> bool {
    low <= 0.0 && 0.0 <= high
}
