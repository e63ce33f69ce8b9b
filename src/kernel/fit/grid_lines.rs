//! The lines of a grid of points along a direction as splines that move with the points.

use glam::{DVec3, DVec4};

use super::{
    Ends, Interpolator, Parametrization,
    leg_growths::LegGrowths,
    moving::{MovingSpline, SplineSpeeds},
};
use crate::{
    CountError, Direction, GeomError, Grid, KnotVector, PointSlopes,
    varied::knots::{simple_inner, with_knots_twice},
};

/// How the lines of a grid along a direction are splines.
///
/// See [`VariedSurface::through_grid`](crate::VariedSurface::through_grid).
///
/// ```
/// use virote_kernel::{Ends, GridLines, Interpolator};
///
/// // A cubic for each of two spans.
/// let lines = GridLines { degree: 3, ends: Ends::Bessel, parameters: &[0.0, 0.4, 1.0], rule: None };
/// let fit = Interpolator::new(lines.parameters, lines.degree, lines.ends)?;
/// assert_eq!(fit.knots().as_slice(), [0.0, 0.0, 0.0, 0.0, 0.4, 1.0, 1.0, 1.0, 1.0]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct GridLines<'a> {
    /// As for [`Interpolator::new`].
    pub degree: usize,
    /// As for [`Interpolator::new`].
    pub ends: Ends,
    /// Where the points are.
    pub parameters: &'a [f64],
    /// The rule that finds the parameters as [`Parametrization::mean_parameters`]; they stay where none is told.
    pub rule: Option<Parametrization>,
}

/// The splines of one direction.
#[derive(Debug)]
pub(super) struct FittedLines {
    pub(super) fit: Interpolator,
    ends: Ends,
    parameters: Vec<f64>,
    pub(super) rule: Option<MeanRule>,
}

/// How parameters that are means grow with points.
#[derive(Debug)]
pub(super) struct MeanRule {
    rule: Parametrization,
    /// Of each line its parameters, and how their steps grow; none of one that is a point, which says nothing.
    lines: Vec<Option<(Vec<f64>, LegGrowths)>>,
    n_counting: f64,
}

impl FittedLines {
    /// Of the lines of a grid, one in each row.
    pub(super) fn new(
        lines: &GridLines<'_>,
        grid: &Grid<DVec3>,
        slopes: &PointSlopes,
        along: Direction,
    ) -> Result<Option<Self>, GeomError> {
        if lines.parameters.len() != grid.n_columns() {
            let (needed, got) = (grid.n_columns(), lines.parameters.len());
            return Err(CountError::WrongCount { what: "parameters", needed, got }.into());
        }
        let fit = Interpolator::new(lines.parameters, lines.degree, lines.ends)?;
        let rule = match lines.rule {
            None | Some(Parametrization::Uniform) => None,
            Some(rule) => match MeanRule::new(rule, grid, slopes, along)? {
                Some(found) => Some(found),
                None => return Ok(None),
            },
        };
        Ok(Some(Self { fit, ends: lines.ends, parameters: lines.parameters.to_vec(), rule }))
    }

    /// The knots over which slopes are told: each inner one twice where they move.
    pub(super) fn knots(&self) -> KnotVector {
        let own = self.fit.knots();
        match self.rule {
            Some(_) => own.with(simple_inner(own).unwrap_or(&[])),
            None => own.clone(),
        }
    }

    /// Lines of control points over these knots.
    pub(super) fn on_knots(&self, lines: Vec<Vec<DVec4>>) -> Result<Vec<Vec<DVec4>>, GeomError> {
        match self.rule {
            Some(_) => with_knots_twice(self.fit.knots(), lines),
            None => Ok(lines),
        }
    }

    /// The spline through values as its parameters move; none where it has no slopes.
    pub(super) fn spline(
        &self,
        values: &[DVec4],
    ) -> Result<Option<MovingSpline<'static>>, GeomError> {
        let fit = (&self.fit, self.ends);
        let spline = MovingSpline::new(fit, &self.parameters, values, [DVec4::ZERO; 2])?;
        Ok(spline.map(MovingSpline::into_owned))
    }

    /// The slopes of the control points of a line by each variable, from those of its values and of the parameters.
    pub(super) fn line_slopes(
        &self,
        spline: Option<&MovingSpline<'static>>,
        values: &[Vec<DVec4>],
        parameters: &[Vec<f64>],
    ) -> Result<Vec<Vec<DVec4>>, GeomError> {
        match spline {
            None => values.iter().map(|values| self.fit.through(values)).collect(),
            Some(spline) => {
                let tangents = [DVec4::ZERO; 2];
                let pairs = values.iter().zip(parameters);
                let speeds: Vec<SplineSpeeds<'_>> = pairs
                    .map(|(values, parameters)| SplineSpeeds { parameters, values, tangents })
                    .collect();
                spline.slopes(&speeds)
            }
        }
    }
}

impl MeanRule {
    /// Of a grid with a line in each row; none where how they grow is not known.
    pub(super) fn new(
        rule: Parametrization,
        grid: &Grid<DVec3>,
        slopes: &PointSlopes,
        along: Direction,
    ) -> Result<Option<Self>, GeomError> {
        let mut lines = Vec::with_capacity(grid.n_rows());
        for idx in 0..grid.n_rows() {
            let line = grid.row(idx);
            let place_of = |k: usize| match along {
                Direction::U => k * grid.n_rows() + idx,
                Direction::V => idx * grid.n_columns() + k,
            };
            let part = |k: usize| {
                slopes.moving().any(|(_, _, own)| own[place_of(k)] != own[place_of(k + 1)])
            };
            let mut at_one_place = (1..line.len()).map(|k| line[k - 1] == line[k]);
            if at_one_place.clone().all(|is_so| is_so) {
                if (1..line.len()).any(|k| part(k - 1)) {
                    return Ok(None);
                }
                lines.push(None);
                continue;
            }
            if at_one_place.any(|is_so| is_so) {
                return Ok(None);
            }
            let Some(legs) = rule.leg_growths(line) else { return Ok(None) };
            lines.push(Some((rule.parameters(line)?, legs)));
        }
        let n_counting = lines.iter().flatten().count() as f64;
        Ok(Some(Self { rule, lines, n_counting }))
    }

    /// How something grows with the steps along a line, from its growths with the parameters.
    pub(super) fn steps(&self, line: usize, by_parameter: &[DVec4]) -> Vec<(DVec3, DVec3)> {
        let Some((parameters, legs)) = &self.lines[line] else { return Vec::new() };
        let steps = legs.with_steps(parameters, by_parameter).into_iter();
        steps.map(|growth| growth / self.n_counting).zip(legs.along().iter().copied()).collect()
    }

    /// How fast the parameters move where the points of each line do.
    pub(super) fn speeds(&self, lines: &Grid<DVec3>, slopes: &Grid<DVec4>) -> Option<Vec<f64>> {
        let mut sums = vec![0.0; lines.n_columns()];
        for (idx, line) in self.lines.iter().enumerate() {
            let Some((parameters, _)) = line else { continue };
            let own = self.rule.speeds(lines.row(idx), parameters, slopes.row(idx))?;
            sums.iter_mut().zip(own).for_each(|(sum, speed)| *sum += speed / self.n_counting);
        }
        Some(sums)
    }
}

/// How a sum of control points of a line with these factors grows with each of its values; adds how it does with each
/// parameter, where these move.
pub(super) fn line_growths(
    fit: &Interpolator,
    spline: Option<Option<&MovingSpline<'static>>>,
    factors: &[f64],
    by_parameter: &mut [DVec4],
) -> Vec<f64> {
    match spline {
        None => fit.value_growths(factors.to_vec()),
        Some(Some(spline)) => {
            let (by_value, own) = spline.growths(factors);
            by_parameter.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            by_value
        }
        // No numbers are no derivatives.
        Some(None) => vec![f64::NAN; by_parameter.len()],
    }
}
