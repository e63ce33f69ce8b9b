//! Lines of a surface across which its derivative jumps, and what it is on either side of them.

use glam::DVec3;

use crate::{
    Interval, Side,
    frame::unit,
    homogeneous,
    surface::{Direction, NurbsSurface},
    tolerance::{NORMAL_AGREEMENT, NORMAL_STEP, SMOOTH_RELATIVE},
};

/// An inner knot across which the derivative jumps somewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Crease {
    pub(crate) at: f64,
    /// Whether the normal or the surface itself jumps, too, and not only the pace of the parameter.
    pub(crate) is_crease: bool,
}

impl NurbsSurface {
    /// The knots along a direction across which the derivative jumps, in order.
    ///
    /// Compared at so many places of each span across that rational derivatives which agree at
    /// all of them are the same.
    pub(crate) fn breaks_of_derivative(&self, along: Direction) -> Vec<Crease> {
        let (knots, domain) = (self.knots(along), self.domain(along));
        let across = self.knots(along.other());
        let n_steps = 2 * across.degree() + 1;
        let places: Vec<f64> =
            across.spans().flat_map(|span| across.span_interval(span).steps(n_steps)).collect();
        let is_inner = |&(t, times): &(f64, usize)| {
            domain.start() < t && t < domain.end() && knots.degree() <= times
        };
        let inner = knots.distinct().into_iter().filter(is_inner);
        inner.filter_map(|(t, _)| self.break_at(along, t, &places)).collect()
    }

    /// The knots along which it is bent, in order.
    pub(crate) fn creases(&self, along: Direction) -> Vec<f64> {
        let breaks = self.breaks_of_derivative(along).into_iter();
        breaks.filter(|line| line.is_crease).map(|line| line.at).collect()
    }

    fn break_at(&self, along: Direction, t: f64, places: &[f64]) -> Option<Crease> {
        let (mut most, mut jump, mut is_crease) = (0.0_f64, 0.0_f64, false);
        let mut gap = 0.0_f64;
        for &s in places {
            let place = if along == Direction::U { [t, s] } else { [s, t] };
            let [left, right] = [Side::Left, Side::Right].map(|side| {
                let sides =
                    if along == Direction::U { [side, Side::Right] } else { [Side::Right, side] };
                self.tangents_beside(place, sides)
            });
            let index = if along == Direction::U { 1 } else { 2 };
            most = most.max(left[index].length()).max(right[index].length());
            jump = jump.max(left[index].distance(right[index]));
            gap = gap.max(left[0].distance(right[0]));
            let normals = [left, right].map(|[_, u, v]| unit(u.cross(v)));
            if let [Some(left), Some(right)] = normals {
                is_crease |= NORMAL_AGREEMENT < left.distance(right);
            }
        }
        let is_torn = SMOOTH_RELATIVE * most * self.domain(along).length() < gap;
        (is_torn || SMOOTH_RELATIVE * most < jump)
            .then_some(Crease { at: t, is_crease: is_crease || is_torn })
    }

    /// Whether the surface goes on around a place to all sides, across a seam too, with derivatives that do not jump.
    #[must_use]
    pub fn is_smooth_around(&self, u: f64, v: f64) -> bool {
        let sides = |along: Direction, t: f64| {
            let (start, end) = (self.domain(along).start(), self.domain(along).end());
            match t {
                t if t <= start || end <= t => [(end, Side::Left), (start, Side::Right)],
                t => [(t, Side::Left), (t, Side::Right)],
            }
        };
        let (along_u, along_v) = (sides(Direction::U, u), sides(Direction::V, v));
        let all = along_u
            .map(|(u, in_u)| along_v.map(|(v, in_v)| self.tangents_beside([u, v], [in_u, in_v])));
        let [point, by_u, by_v] = all[0][0];
        let (length_u, length_v) = (by_u.length(), by_v.length());
        let lengths = [self.domain(Direction::U), self.domain(Direction::V)].map(Interval::length);
        let size = length_u * lengths[0] + length_v * lengths[1];
        all.as_flattened().iter().all(|other| {
            other[0].distance(point) <= SMOOTH_RELATIVE * size
                && other[1].distance(by_u) <= SMOOTH_RELATIVE * length_u
                && other[2].distance(by_v) <= SMOOTH_RELATIVE * length_v
        })
    }

    /// Point, Su and Sv of the pieces on these sides of a place.
    fn tangents_beside(&self, [u, v]: [f64; 2], sides: [Side; 2]) -> [DVec3; 3] {
        let spans = [self.knots_u.span_beside(u, sides[0]), self.knots_v.span_beside(v, sides[1])];
        let derivatives =
            homogeneous::quotient_grid(&self.homogeneous_derivatives_on(spans, [u, v], 1));
        [derivatives.get(0, 0), derivatives.get(1, 0), derivatives.get(0, 1)]
    }

    /// The point, and a unit normal for shading, of the pieces on these sides of a place.
    pub(crate) fn sample_beside(&self, [u, v]: [f64; 2], sides: [Side; 2]) -> (DVec3, DVec3) {
        let [point, along_u, along_v] = self.tangents_beside([u, v], sides);
        let normal = along_u.cross(along_v);
        let [width_u, width_v] = self.span_widths(u, v);
        if self.fold_area < normal.length() * width_u * width_v
            && let Some(normal) = unit(normal)
        {
            return (point, normal);
        }
        let step = |t: f64, side: Side, width: f64| match side {
            Side::Left => t - NORMAL_STEP * width,
            Side::Right => t,
        };
        let (u, v) = (step(u, sides[0], width_u), step(v, sides[1], width_v));
        (point, self.shading_normal(u, v))
    }

    /// A unit vector for shading at a place.
    pub(crate) fn shade_at(&self, u: f64, v: f64) -> DVec3 {
        self.shading_normal(u, v)
    }
}
