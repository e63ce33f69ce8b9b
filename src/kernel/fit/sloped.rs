//! The equations of splines of any degree with derivatives at their ends.

use glam::DVec4;

use super::{
    check_parameters,
    equation::Equation,
    interpolate::{FactoredEquations, Interpolator, check_degree, clamped},
};
use crate::{CountError, FitError, GeomError, numeric::banded::BandedSystem};

impl Interpolator {
    /// For values at the parameters and first derivatives at one end or both; where these do not
    /// determine a spline of the degree, of a lower one.
    ///
    /// Knots are averages of the parameters, an end with a derivative counted twice.
    /// Piegl & Tiller, *The NURBS Book*, §9.2.2.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn with_end_slopes(
        parameters: &[f64],
        degree: usize,
        has_slope: [bool; 2],
    ) -> Result<Self, GeomError> {
        let got = parameters.len();
        if got < 2 {
            return Err(CountError::TooFewPoints { got, needed: 2 }.into());
        }
        check_degree(degree)?;
        check_parameters(parameters, got)?;
        let mut data = parameters.to_vec();
        data.extend(has_slope[0].then_some(parameters[0]));
        data.extend(has_slope[1].then_some(parameters[got - 1]));
        data.sort_by(f64::total_cmp);
        let n = data.len();
        let degree = degree.min(n - 1);
        let mean = |j: usize| data[j..j + degree].iter().sum::<f64>() / degree as f64;
        let inner: Vec<f64> = (1..n - degree).map(mean).collect();
        let knots = clamped(parameters, degree, inner)?;

        let slope = |t: f64| Equation::derivative(&knots, t, 1).scaled_by(parameters);
        let mut rows = vec![Equation::point(&knots, parameters[0])];
        rows.extend(has_slope[0].then(|| slope(parameters[0])));
        rows.extend(Equation::points(&knots, &parameters[1..got - 1]));
        rows.extend(has_slope[1].then(|| slope(parameters[got - 1])));
        rows.push(Equation::point(&knots, parameters[got - 1]));
        let equations = FactoredEquations::WithEndSlopes(
            BandedSystem::new(&rows).ok_or(FitError::NoFit)?,
            has_slope,
        );
        Ok(Self { knots, n_values: got, equations })
    }

    /// The control points of the spline through the values, with the derivatives at the ends that
    /// it was made for.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] unless there is one value a parameter; [`FitError::NoFit`]
    /// unless made by [`Self::with_end_slopes`] for these.
    pub fn with_slopes_at_ends(
        &self,
        values: &[DVec4],
        slopes: [Option<DVec4>; 2],
    ) -> Result<Vec<DVec4>, GeomError> {
        let (got, needed) = (values.len(), self.n_values);
        if got != needed {
            return Err(CountError::WrongCount { what: "points", needed, got }.into());
        }
        let FactoredEquations::WithEndSlopes(band, has_slope) = &self.equations else {
            return Err(FitError::NoFit.into());
        };
        if slopes.map(|slope| slope.is_some()) != *has_slope {
            return Err(FitError::NoFit.into());
        }
        let length = self.knots.domain().length();
        let mut unknowns = vec![values[0]];
        unknowns.extend(slopes[0].map(|slope| slope * length));
        unknowns.extend(&values[1..got - 1]);
        unknowns.extend(slopes[1].map(|slope| slope * length));
        unknowns.push(values[got - 1]);
        band.solve(&mut unknowns);
        Ok(unknowns)
    }
}

impl Equation {
    /// The condition on the derivative by the fraction of the domain, not by the parameter.
    fn scaled_by(mut self, parameters: &[f64]) -> Self {
        let length = parameters[parameters.len() - 1] - parameters[0];
        self.values.iter_mut().for_each(|value| *value *= length);
        self
    }
}
