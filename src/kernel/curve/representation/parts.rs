//! What a curve's form is made of: its polygon, its basis, the levels of corner cutting.

use glam::{DVec3, DVec4};

use crate::{GeomError, bezier::blend, curve::NurbsCurve, homogeneous};

impl NurbsCurve {
    /// The polyline through the control points, without those of weight zero.
    ///
    /// # Errors
    /// `CountError::TooFewPoints` for a curve of one point.
    pub fn control_polygon(&self) -> Result<Self, GeomError> {
        let are_there = self.control_points.iter().filter(|point| point.w != 0.0);
        let points: Vec<DVec3> = are_there.map(|&point| homogeneous::place(point)).collect();
        Self::polyline(&points)
    }

    /// Values at `t` of the rational basis functions, one a control point; they sum to one.
    #[must_use]
    pub fn basis_at(&self, t: f64) -> Vec<f64> {
        let mut all = vec![0.0; self.control_points.len()];
        self.knots.with_basis(t, |span, values| {
            let support = self.knots.support(span);
            let weighted = self.control_points[support.clone()].iter().zip(values);
            let weighted: Vec<f64> = weighted.map(|(point, value)| point.w * value).collect();
            let sum: f64 = weighted.iter().sum();
            for (i, value) in support.zip(weighted) {
                all[i] = value / sum;
            }
        });
        all
    }

    /// The levels of de Casteljau's algorithm, from the control polygon to the point at `t`; none
    /// unless the curve is one Bézier segment.
    ///
    /// Farin, *Curves and Surfaces for CAGD*, §4.2.
    #[must_use]
    pub fn de_casteljau(&self, t: f64) -> Option<Vec<Vec<DVec3>>> {
        let (domain, degree) = (self.domain(), self.degree());
        let ends = [domain.start(), domain.end()];
        if ends.iter().any(|&end| self.knots.exact_multiplicity(end) != degree + 1)
            || self.control_points.len() != degree + 1
        {
            return None;
        }
        let fraction = domain.fraction_of(t);
        let mut levels: Vec<Vec<DVec4>> = vec![self.control_points.clone()];
        for level in 0..degree {
            let cut = levels[level].windows(2).map(|leg| blend(leg[0], leg[1], fraction));
            levels.push(cut.collect());
        }
        let place = |level: Vec<DVec4>| level.into_iter().map(homogeneous::place).collect();
        Some(levels.into_iter().map(place).collect())
    }
}
