//! What is seen of a surface at one place of a border, and its height over the tangent plane there.

use glam::{DVec3, DVec4};

use crate::{
    Direction, Grid, Interval, Side,
    frame::{norm, unit},
    homogeneous,
    numeric::{linear::TwoEquations, symmetric_eigen::mean_and_spread},
    surface::NurbsSurface,
    tolerance::VANISHING_RELATIVE,
};

/// Order of the derivatives that are looked at.
pub(in crate::surface) const ORDER: usize = 3;

/// How rounding grows with each derivative of a function, whose derivatives are exact.
const FUNCTION_GROWTH: f64 = 4.0;

/// Both sides of a line are looked at place by place: what is found on one.
#[derive(Clone, Debug)]
pub(in crate::surface) struct TwoSidedSample {
    /// Derivatives; first index across the line, second along it.
    space: Grid<DVec3>,
    /// The same of the homogeneous surface; of a function those of weight one.
    pub(in crate::surface) homogeneous: Grid<DVec4>,
    /// Whether the surface ends at the line, so that it is left where the parameter grows.
    pub(in crate::surface) is_end: bool,
    /// The width of the piece across the line, in its parameter.
    pub(in crate::surface) reach: f64,
    /// How far the piece goes across and along, as a length.
    pub(in crate::surface) extent: f64,
    /// How wide the piece is at its narrower.
    leg: f64,
    /// The length that rounding of the coordinates may leave, and its growth with each derivative.
    pub(in crate::surface) rounding: f64,
    growth: f64,
}

impl TwoSidedSample {
    pub(in crate::surface) fn of_nurbs(
        surface: &NurbsSurface,
        [u, v]: [f64; 2],
        sides: [Side; 2],
        across: Direction,
    ) -> Self {
        let (knots_u, knots_v) = (surface.knots_u(), surface.knots_v());
        let (u, v) = (knots_u.snapped(u), knots_v.snapped(v));
        let spans = [knots_u.span_beside(u, sides[0]), knots_v.span_beside(v, sides[1])];
        let homogeneous = surface.homogeneous_derivatives_on(spans, [u, v], ORDER);
        let space = homogeneous::quotient_grid(&homogeneous);
        let widths = [knots_u.span_interval(spans[0]), knots_v.span_interval(spans[1])];
        let points = surface.control_points();
        let (mut magnitude, mut heaviest) = (0.0_f64, 0.0_f64);
        for i in knots_u.support(spans[0]) {
            for &point in &points.row(i)[knots_v.support(spans[1])] {
                magnitude = magnitude.max(homogeneous::place(point).abs().max_element());
                heaviest = heaviest.max(point.w);
            }
        }
        let degree = knots_u.degree().max(knots_v.degree()).max(1) as f64;
        let growth = degree * heaviest / homogeneous.get(0, 0).w;
        let looked = Self::new(space, homogeneous, widths.map(Interval::length), across);
        Self { rounding: VANISHING_RELATIVE * magnitude, growth, ..looked }
    }

    pub(in crate::surface) fn of_function(
        space: &Grid<DVec3>,
        widths: [f64; 2],
        across: Direction,
    ) -> Self {
        let homogeneous = Grid::from_fn(space.n_rows(), space.n_columns(), |k, l| {
            space.get(k, l).extend(if k + l == 0 { 1.0 } else { 0.0 })
        });
        let looked = Self::new(space.clone(), homogeneous, widths, across);
        let magnitude = looked.point().abs().max_element() + looked.extent;
        Self { rounding: VANISHING_RELATIVE * magnitude, growth: FUNCTION_GROWTH, ..looked }
    }

    fn new(
        space: Grid<DVec3>,
        homogeneous: Grid<DVec4>,
        widths: [f64; 2],
        across: Direction,
    ) -> Self {
        let extent = norm(space.get(1, 0)) * widths[0] + norm(space.get(0, 1)) * widths[1];
        let (space, homogeneous) = match across {
            Direction::U => (space, homogeneous),
            Direction::V => (space.transposed(), homogeneous.transposed()),
        };
        let (reach, width) = (widths[across], widths[across.other()]);
        let along = norm(space.get(0, 1));
        let height = norm(space.get(1, 0).cross(space.get(0, 1))) / along;
        let leg = (height * reach).min(along * width);
        Self { space, homogeneous, is_end: false, reach, extent, leg, rounding: 0.0, growth: 1.0 }
    }

    pub(in crate::surface) fn point(&self) -> DVec3 {
        self.space.get(0, 0)
    }

    /// The derivative along the line.
    pub(in crate::surface) fn along(&self) -> DVec3 {
        self.space.get(0, 1)
    }

    /// Derivatives across the line by order.
    pub(in crate::surface) fn across(&self) -> [DVec3; ORDER + 1] {
        std::array::from_fn(|k| self.space.get(k, 0))
    }

    pub(in crate::surface) fn homogeneous_across(&self) -> [DVec4; ORDER + 1] {
        std::array::from_fn(|k| self.homogeneous.get(k, 0))
    }

    /// The length that rounding may leave in the term of an order.
    pub(in crate::surface) fn rounding_of(&self, order: usize) -> f64 {
        self.rounding * libm::pow(self.growth, order.saturating_sub(1) as f64)
    }

    /// What rounding may leave in a derivative of that order by lengths on the surface.
    pub(in crate::surface) fn noise(&self, order: usize) -> f64 {
        self.rounding_of(order) / libm::pow(self.leg, order as f64)
    }

    /// Unit vector of the tangent plane at right angles to the line, out of the surface or, with
    /// −1, into it; none where Su × Sv vanishes.
    pub(in crate::surface) fn conormal(&self, along: DVec3, outward: f64) -> Option<DVec3> {
        let sign = if self.is_end { outward } else { -outward };
        unit_across(sign * self.space.get(1, 0) * self.reach, along, self.rounding)
    }

    /// The height over the tangent plane of two unit vectors.
    ///
    /// With the inverse M of the map of parameters into the plane, second derivatives of the
    /// height are h₂(x, y) = n·S(Mx, My), and third ones n·S(Mx, My, Mz) less h₂ of each vector
    /// with what S does in the plane along the two others.
    pub(in crate::surface) fn height_over(&self, [x, y]: [DVec3; 2]) -> Option<HeightDerivatives> {
        let d = |k, l| self.space.get(k, l);
        let normal = x.cross(y);
        let (across, along) = (d(1, 0), d(0, 1));
        let map = [[across.dot(x), along.dot(x)], [across.dot(y), along.dot(y)]];
        // Steps in the parameters that make unit steps along x and along y.
        let steps = [[1.0, 0.0], [0.0, 1.0]].map(|unit| TwoEquations { matrix: map }.solved(unit));
        let twice = |i: usize, j: usize| {
            let (a, b) = (steps[i], steps[j]);
            d(2, 0) * (a[0] * b[0])
                + d(1, 1) * (a[0] * b[1] + a[1] * b[0])
                + d(0, 2) * (a[1] * b[1])
        };
        let second = [twice(0, 0), twice(0, 1), twice(1, 1)].map(|bend| normal.dot(bend));
        let form =
            |i: usize, vector: DVec3| second[i] * vector.dot(x) + second[i + 1] * vector.dot(y);
        let third = |i: usize, j: usize, k: usize| {
            let (a, b, c) = (steps[i], steps[j], steps[k]);
            let mut sum = DVec3::ZERO;
            for (p, q, r) in (0..8).map(|bits| (bits & 1, bits >> 1 & 1, bits >> 2)) {
                let order = p + q + r;
                sum += d(3 - order, order) * (a[p] * b[q] * c[r]);
            }
            let inner = form(i, twice(j, k)) + form(j, twice(i, k)) + form(k, twice(i, j));
            normal.dot(sum) - inner
        };
        let third = [third(0, 0, 0), third(0, 0, 1), third(0, 1, 1), third(1, 1, 1)];
        let is_finite = second.iter().chain(&third).all(|value| value.is_finite());
        is_finite.then_some(HeightDerivatives { second, third })
    }
}

/// Derivatives of the height of a surface over its tangent plane, along two unit vectors of it.
#[derive(Clone, Copy, Debug)]
pub(in crate::surface) struct HeightDerivatives {
    /// By x twice, by both, by y twice: the second fundamental tensor.
    pub(in crate::surface) second: [f64; 3],
    /// By x three times and so on.
    pub(in crate::surface) third: [f64; 4],
}

impl HeightDerivatives {
    /// The largest difference of normal curvatures in one direction.
    pub(in crate::surface) fn bend_from(&self, other: &Self) -> f64 {
        let apart = [0, 1, 2].map(|i| self.second[i] - other.second[i]);
        let [mean, spread] = mean_and_spread(apart);
        mean.abs() + spread
    }
}

/// The part of a vector that is normal to a unit vector, made a unit vector.
fn unit_across(vector: DVec3, axis: DVec3, rounding: f64) -> Option<DVec3> {
    let part = vector - axis * axis.dot(vector);
    unit(part).filter(|_| rounding < norm(part))
}
