//! How far two curves are apart at most.

use glam::DVec4;

use crate::{
    bernstein::{maximum, product},
    bezier,
    curve::NurbsCurve,
    homogeneous,
    tolerance::LAST_BIT,
};

impl NurbsCurve {
    /// How far the curve is at most from another one on the same domain at equal parameters: an
    /// upper bound, rarely more than 2% above the truth: the search for it is bounded.
    ///
    /// The difference of two rational pieces is one rational piece, whose coefficients bound it.
    #[must_use]
    pub fn deviation_from(&self, other: &Self) -> f64 {
        let (Ok(a), Ok(b)) = (self.with_breaks_of(other), other.with_breaks_of(self)) else {
            return f64::INFINITY;
        };
        if a.n_segments() != b.n_segments() {
            return f64::INFINITY;
        }
        let difference = |(i, j): (usize, usize)| {
            let a = bezier::piece(&a.knots, &a.control_points, i);
            let b = bezier::piece(&b.knots, &b.control_points, j);
            product(&a, &b, |a, b| (a.truncate() * b.w - b.truncate() * a.w).extend(a.w * b.w))
        };
        let pieces = a.knots.spans().zip(b.knots.spans()).map(difference).collect();
        let bound = |piece: &[DVec4]| {
            let least = piece.iter().map(|point| point.w).fold(f64::INFINITY, f64::min);
            let most = piece.iter().map(|point| point.truncate().length()).fold(0.0, f64::max);
            if 0.0 < least { most / least } else { f64::INFINITY }
        };
        let value = |point: DVec4| homogeneous::project(point).length();
        maximum(pieces, LAST_BIT * self.magnitude(), bound, value)
    }

    /// The largest coordinate of a control point.
    pub(crate) fn magnitude(&self) -> f64 {
        let largest = |&point| homogeneous::place(point).abs().max_element();
        self.control_points.iter().map(largest).fold(0.0, f64::max)
    }

    /// The same curve, cut wherever the other one is.
    fn with_breaks_of(&self, other: &Self) -> Result<Self, crate::GeomError> {
        let is_missing = |t: &f64| self.knots.exact_multiplicity(self.knots.snapped(*t)) == 0;
        let missing: Vec<f64> = other.knots.breaks().into_iter().filter(is_missing).collect();
        self.insert_knots(&missing)
    }
}
