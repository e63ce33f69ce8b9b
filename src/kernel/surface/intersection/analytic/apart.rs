//! Surfaces that an equation tells to be apart: thin walls, between which no search for crossings ends soon.
//!
//! A surface, put into the equation of a plane, cylinder, cone, sphere or torus, leaves a polynomial of its
//! parameters. Within a distance of that it is no larger than a bound; if it is larger all over, of one sign, both
//! keep further apart.

use glam::DVec4;

use super::AnalyticForm;
use crate::{
    Grid, NurbsSurface,
    surface::intersection::square::{product, range},
    tolerance::SIGN_RELATIVE,
};

impl NurbsSurface {
    /// Whether the equation of another surface, if it has one, tells that this one is nowhere as near to it.
    pub(in crate::surface) fn keeps_from(&self, other: &Self, distance: f64) -> bool {
        if self.control_points.iter().any(|point| point.w <= 0.0) {
            return false;
        }
        let Some(found) = other.analytic(distance) else { return false };
        let local = self.transformed(&found.frame.from_space());
        let bounds = local.bounds();
        let height = bounds.min.z.abs().max(bounds.max.z.abs());
        // Twice as far, so that rounding does not matter.
        let most = found.form.most_within(2.0 * distance, height);
        let is_beyond = |sign: f64| {
            let excess = |net: &Grid<DVec4>| {
                let [left, weights] = found.form.left_side(net);
                // At the apex of a cone no bound is so small that rounding could be larger.
                let [least, highest] = range(&left);
                let rounding = 2.0 * SIGN_RELATIVE * highest.max(-least);
                Grid::from_fn(left.n_rows(), left.n_columns(), |i, j| {
                    sign * left.get(i, j) - most * weights.get(i, j) - rounding
                })
            };
            local.sign_of(excess).is_some_and(|found| 0.0 < found)
        };
        is_beyond(1.0) || is_beyond(-1.0)
    }
}

impl AnalyticForm {
    /// The left side of its equation, with the right side taken away and without roots, over a net: the numerators,
    /// and the denominators.
    fn left_side(self, net: &Grid<DVec4>) -> [Grid<f64>; 2] {
        let weights = product(net, net, |a, b| a.w * b.w);
        let round = |a: DVec4, b: DVec4| a.x * b.x + a.y * b.y;
        let left = match self {
            Self::Plane => return [net.map(|point| point.z), net.map(|point| point.w)],
            Self::Cylinder { radius } => {
                product(net, net, |a, b| round(a, b) - radius * radius * a.w * b.w)
            }
            Self::Sphere { radius } => {
                product(net, net, |a, b| round(a, b) + a.z * b.z - radius * radius * a.w * b.w)
            }
            Self::Cone { radius, half_angle } => {
                let slope = libm::tan(half_angle);
                let out = |point: DVec4| radius * point.w + point.z * slope;
                product(net, net, |a, b| round(a, b) - out(a) * out(b))
            }
            Self::Torus { major, minor } => {
                let constant = major * major - minor * minor;
                let squares =
                    product(net, net, |a, b| round(a, b) + a.z * b.z + constant * a.w * b.w);
                let outward = product(net, net, |a, b| 4.0 * major * major * round(a, b));
                let times = |a: f64, b: f64| a * b;
                let left = product(&squares, &squares, times);
                let right = product(&outward, &weights, times);
                let left = Grid::from_fn(left.n_rows(), left.n_columns(), |i, j| {
                    left.get(i, j) - right.get(i, j)
                });
                return [left, product(&weights, &weights, times)];
            }
        };
        [left, weights]
    }

    /// What that is at most within a distance, at heights up to one.
    fn most_within(self, near: f64, height: f64) -> f64 {
        // Of the difference of squares of a length and of one that is as near to it.
        let squares = |length: f64, gap: f64| gap * (2.0 * length + gap);
        match self {
            Self::Plane => near,
            Self::Cylinder { radius } | Self::Sphere { radius } => squares(radius, near),
            Self::Cone { radius, half_angle } => {
                let widest = radius + height * libm::tan(half_angle);
                squares(widest, near / libm::cos(half_angle))
            }
            // D² − r² of the distance D from the circle in the tube, times that and 4·R·√(x² + y²).
            Self::Torus { major, minor } => {
                let tube = squares(minor, near);
                tube * (4.0 * major * (major + minor + near) + tube)
            }
        }
    }
}
