//! Splines through points: right-hand sides in, control points out.

use glam::{DVec3, DVec4};

use super::{
    growth::fixed_slopes_asked,
    interpolate::{EndRow, FactoredEquations, Interpolator},
    periodic::cut_to,
};
use crate::{CountError, FitError, GeomError, NurbsCurve, PointSlopes, VariedCurve};

impl Interpolator {
    /// The control points of the spline through the values.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless there is one a parameter; [`FitError::NoFit`] where the
    /// ends want tangents or the equations derivatives.
    pub fn through(&self, values: &[DVec4]) -> Result<Vec<DVec4>, GeomError> {
        self.through_own(values.to_vec())
    }

    /// [`Self::through`] values that need not be kept.
    fn through_own(&self, mut values: Vec<DVec4>) -> Result<Vec<DVec4>, GeomError> {
        self.check_count("points", values.len())?;
        match &self.equations {
            FactoredEquations::Values(band) => {
                band.solve(&mut values);
                Ok(values)
            }
            FactoredEquations::WithEnds(_, [EndRow::Along(_), _])
            | FactoredEquations::WithDerivatives(_)
            | FactoredEquations::WithEndSlopes(..) => Err(GeomError::Fit(FitError::NoFit)),
            FactoredEquations::WithEnds(..) => self.with_tangents(&values, [DVec4::ZERO; 2]),
            FactoredEquations::Ring(cyclic, ring) => {
                cyclic.solve(&mut values);
                let reach = self.knots.degree() / 2;
                let knots = ring.as_ref().unwrap_or(&self.knots);
                let n = self.n_values;
                let around = (0..knots.n_points()).map(|i| values[(n + i - reach) % n]).collect();
                match ring {
                    None => Ok(around),
                    Some(ring) => {
                        let ends = self.knots.domain();
                        let parameters = [ends.start(), ends.end()];
                        Ok(cut_to(&parameters, ring, around)?.control_points().to_vec())
                    }
                }
            }
        }
    }

    /// The control points of the spline through the values, with derivatives at both ends.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless there is one value a parameter; [`FitError::NoFit`]
    /// unless the ends are [`Ends::Clamped`](super::Ends::Clamped).
    pub fn with_tangents(
        &self,
        values: &[DVec4],
        tangents: [DVec4; 2],
    ) -> Result<Vec<DVec4>, GeomError> {
        self.check_count("points", values.len())?;
        let FactoredEquations::WithEnds(band, rows) = &self.equations else {
            return Err(FitError::NoFit.into());
        };
        let last = values.len() - 1;
        let from_end = |k: usize| values[last - k.min(last)];
        let start = rows[0].value(|k| values[k.min(last)], tangents[0]);
        let end = rows[1].value(from_end, tangents[1]);
        let mut unknowns = Vec::with_capacity(values.len() + 2);
        unknowns.extend([values[0], start]);
        unknowns.extend(&values[1..last]);
        unknowns.extend([end, values[last]]);
        band.solve(&mut unknowns);
        Ok(unknowns)
    }

    /// The control points of the spline through the values with a derivative at each.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless there is one of each a parameter; [`FitError::NoFit`]
    /// unless made by [`Self::with_derivatives`].
    pub fn with_slopes(
        &self,
        values: &[DVec4],
        derivatives: &[DVec4],
    ) -> Result<Vec<DVec4>, GeomError> {
        self.check_count("points", values.len())?;
        self.check_count("derivatives", derivatives.len())?;
        let FactoredEquations::WithDerivatives(band) = &self.equations else {
            return Err(FitError::NoFit.into());
        };
        let both = |(&value, &derivative): (&DVec4, &DVec4)| [value, derivative];
        let mut unknowns: Vec<DVec4> = values.iter().zip(derivatives).flat_map(both).collect();
        let last = unknowns.len() - 1;
        unknowns.swap(last - 1, last);
        band.solve(&mut unknowns);
        Ok(unknowns)
    }

    /// The polynomial curve through points.
    ///
    /// # Errors
    /// Those of [`Self::through`].
    pub fn curve(&self, points: &[DVec3]) -> Result<NurbsCurve, GeomError> {
        self.polynomial(self.through_own(lifted(points, 1.0))?)
    }

    /// The polynomial curve through points with derivatives at both ends.
    ///
    /// # Errors
    /// Those of [`Self::with_tangents`].
    pub fn curve_with_tangents(
        &self,
        points: &[DVec3],
        tangents: [DVec3; 2],
    ) -> Result<NurbsCurve, GeomError> {
        let tangents = tangents.map(|tangent| tangent.extend(0.0));
        self.polynomial(self.with_tangents(&lifted(points, 1.0), tangents)?)
    }

    /// The polynomial curve through points with a derivative at each.
    ///
    /// # Errors
    /// Those of [`Self::with_slopes`].
    pub fn curve_with_derivatives(
        &self,
        points: &[DVec3],
        derivatives: &[DVec3],
    ) -> Result<NurbsCurve, GeomError> {
        self.polynomial(self.with_slopes(&lifted(points, 1.0), &lifted(derivatives, 0.0))?)
    }

    /// The curve through points that vary, the parameters and with them the knots of which do not.
    ///
    /// # Errors
    /// Those of [`Self::through`], and fewer slopes than points.
    pub fn varied(
        &self,
        curve: NurbsCurve,
        slopes: &PointSlopes,
    ) -> Result<VariedCurve, GeomError> {
        if slopes.n_points() == self.n_values
            && let Some(slopes) = fixed_slopes_asked(self, slopes)
        {
            return VariedCurve::new(curve.into(), slopes);
        }
        let own = |(variable, own): &(usize, Vec<DVec4>)| -> Result<_, GeomError> {
            Ok((*variable, self.through(&own[..own.len().min(self.n_values)])?))
        };
        let by_variable: Result<Vec<_>, GeomError> = slopes.by_variable().iter().map(own).collect();
        let n_points = curve.control_points().len();
        let slopes = PointSlopes::new(slopes.n_variables(), n_points, by_variable?)?;
        VariedCurve::new(curve.into(), slopes)
    }

    /// The weights are one but for rounding.
    fn polynomial(&self, mut points: Vec<DVec4>) -> Result<NurbsCurve, GeomError> {
        points.iter_mut().for_each(|point| point.w = 1.0);
        NurbsCurve::new(self.knots.clone(), points)
    }

    fn check_count(&self, what: &'static str, got: usize) -> Result<(), GeomError> {
        let needed = self.n_values;
        if got == needed {
            Ok(())
        } else {
            Err(GeomError::Count(CountError::WrongCount { what, needed, got }))
        }
    }
}

impl EndRow {
    /// The right-hand side, from the values counted from the end and the derivative there.
    fn value(self, from_end: impl Fn(usize) -> DVec4, derivative: DVec4) -> DVec4 {
        match self {
            Self::Values([a, b, c]) => a * from_end(0) + b * from_end(1) + c * from_end(2),
            Self::Vanishing(_) => DVec4::ZERO,
            Self::Along(third) => from_end(0) + third * derivative,
        }
    }
}

fn lifted(points: &[DVec3], w: f64) -> Vec<DVec4> {
    points.iter().map(|point| point.extend(w)).collect()
}
