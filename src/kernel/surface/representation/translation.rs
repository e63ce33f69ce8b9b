//! Surfaces that a curve leaves behind it where it is moved straight and evenly.

use crate::{
    surface::{Direction, NurbsSurface},
    tolerance::LAST_BIT,
};

/// Last bits of the largest coordinate by which the ways of control points may differ that are one way.
const BITS: f64 = 4.0;

impl NurbsSurface {
    /// The direction along which points move evenly, all in the same way, so that Su × Sv stays as it is; none of a
    /// surface that is no extrusion of one span.
    pub(crate) fn translation_direction(&self) -> Option<Direction> {
        Direction::BOTH.into_iter().find(|&along| {
            let (degree, n) = match along {
                Direction::U => (self.degree_u(), self.control_points().n_rows()),
                Direction::V => (self.degree_v(), self.control_points().n_columns()),
            };
            if [degree, n] != [1, 2] {
                return false;
            }
            let net = self.control_points();
            let pair = |i: usize| match along {
                Direction::U => [net.get(0, i), net.get(1, i)],
                Direction::V => [net.get(i, 0), net.get(i, 1)],
            };
            let n_pairs = net.n_rows() * net.n_columns() / 2;
            let is_even = |i: usize| (pair(i)[0].w - pair(i)[1].w).abs() <= 0.0;
            let way = |i: usize| {
                let [from, to] = pair(i).map(|point| point.truncate() / point.w);
                to - from
            };
            let first = way(0);
            let within = BITS * LAST_BIT * self.bounds().magnitude();
            (0..n_pairs).all(|i| is_even(i) && (way(i) - first).abs().max_element() <= within)
        })
    }
}
