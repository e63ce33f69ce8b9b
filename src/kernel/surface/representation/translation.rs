//! Surfaces that a curve leaves behind it where it is moved straight and evenly.

use crate::{
    surface::{Direction, NurbsSurface},
    tolerance::LAST_BIT,
};

/// Last bits of the largest coordinate by which the ways of control points may differ that are one way.
const BITS: f64 = 4.0;

impl NurbsSurface {
    /// Along which directions points move evenly, all in the same way, so that Su × Sv stays as it is: of an extrusion
    /// of one span along its way, of a parallelogram along both.
    pub(crate) fn even_ways(&self) -> [bool; 2] {
        let net = self.control_points();
        let within = BITS * LAST_BIT * self.bounds().magnitude();
        Direction::BOTH.map(|along| {
            let lines = if along == Direction::U { net.transposed() } else { net.clone() };
            let degree = [self.degree_u(), self.degree_v()][along];
            if [degree, lines.n_columns()] != [1, 2] {
                return false;
            }
            let way = |i: usize| {
                let [from, to] = [0, 1].map(|j| lines.get(i, j)).map(|p| p.truncate() / p.w);
                to - from
            };
            let first = way(0);
            (0..lines.n_rows()).all(|i| {
                let has_one_weight = (lines.get(i, 0).w - lines.get(i, 1).w).abs() <= 0.0;
                has_one_weight && (way(i) - first).abs().max_element() <= within
            })
        })
    }
}
