//! Curves on surfaces along the parameter lines, and the box around a surface.

use glam::DVec4;

use crate::{Bounds, NurbsCurve, hull::TensorSpline, surface::NurbsSurface};

impl NurbsSurface {
    /// The curve of constant `u`, which runs along v: exact, on v's knots.
    #[must_use]
    pub fn isocurve_u(&self, u: f64) -> NurbsCurve {
        let points = self.knots_u.with_basis(u, |span, basis| {
            let mut sums = vec![DVec4::ZERO; self.control_points.n_columns()];
            for (i, &n) in self.knots_u.support(span).zip(basis) {
                for (sum, &point) in sums.iter_mut().zip(self.control_points.row(i)) {
                    *sum += point * n;
                }
            }
            sums
        });
        NurbsCurve::new_unchecked(self.knots_v.clone(), points)
    }

    /// The curve of constant `v`, which runs along u: exact, on u's knots.
    #[must_use]
    pub fn isocurve_v(&self, v: f64) -> NurbsCurve {
        let points = self.knots_v.with_basis(v, |span, basis| {
            let support = self.knots_v.support(span);
            let along_v = |i: usize| {
                let row = &self.control_points.row(i)[support.clone()];
                row.iter().zip(basis).fold(DVec4::ZERO, |sum, (&point, &n)| sum + point * n)
            };
            (0..self.control_points.n_rows()).map(along_v).collect()
        });
        NurbsCurve::new_unchecked(self.knots_u.clone(), points)
    }

    /// The boundary, `[u0, u1, v0, v1]`: first and last u, then first and last v.
    #[must_use]
    pub fn edges(&self) -> [NurbsCurve; 4] {
        let (u, v) = (self.domain_u(), self.domain_v());
        [
            self.isocurve_u(u.start()),
            self.isocurve_u(u.end()),
            self.isocurve_v(v.start()),
            self.isocurve_v(v.end()),
        ]
    }

    /// The smallest axis-aligned box around the surface, to rounding; not that of its control
    /// points.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let knots = [&self.knots_u, &self.knots_v];
        *self.bounds.get_or_make(|| TensorSpline { knots, points: &self.control_points }.bounds())
    }
}
