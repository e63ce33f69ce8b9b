//! Splines through points that move, and where the parameters and with them the knots move along.
//!
//! The equations of the spline hold while they move: of A(t)·P = Q the slopes are those of A·Ṗ = Q̇ − Ȧ·P. What
//! Ȧ·P is at a point, the slope of the spline there says, and its slopes by its knots.

use std::borrow::Cow;

use glam::{DVec3, DVec4};

use super::{
    Interpolator, Parametrization,
    equation::Equation,
    interpolate::{EndRow, Ends, FactoredEquations, end_derivative},
};
use crate::{
    GeomError, KnotVector,
    varied::knots::{KnotSlopes, with_knots_twice},
};

/// A spline through values at parameters, any of which may move.
#[derive(Clone, Debug)]
pub(crate) struct MovingSpline<'a> {
    pub(super) fit: Cow<'a, Interpolator>,
    pub(super) parameters: Cow<'a, [f64]>,
    pub(super) values: Cow<'a, [DVec4]>,
    pub(super) tangents: [DVec4; 2],
    pub(super) has_second_knots: bool,
    pub(super) points: Vec<DVec4>,
    pub(super) by_knots: KnotSlopes,
    /// The spline's slope at each parameter.
    pub(super) along: Vec<DVec4>,
    /// The functions of the knots that stand twice at each parameter: which is the first, and their values.
    pub(super) there: Vec<(usize, Vec<f64>)>,
}

/// How fast what a spline is made of moves.
#[derive(Clone, Debug)]
pub(crate) struct SplineSpeeds<'a> {
    pub(crate) parameters: &'a [f64],
    pub(crate) values: &'a [DVec4],
    pub(crate) tangents: [DVec4; 2],
}

impl<'a> MovingSpline<'a> {
    /// The spline that [`Interpolator::new`] makes of these ends and parameters through values, with these
    /// derivatives at clamped ends; none where it has no slopes: of closed ones, of polygons, and of those
    /// with a derivative at each point.
    ///
    /// # Errors
    /// As for [`Interpolator::through`].
    pub(crate) fn new(
        (fit, ends): (&'a Interpolator, Ends),
        parameters: &'a [f64],
        values: &'a [DVec4],
        tangents: [DVec4; 2],
    ) -> Result<Option<Self>, GeomError> {
        let points = match &fit.equations {
            FactoredEquations::Values(_) => fit.through(values)?,
            FactoredEquations::WithEnds(..) => fit.with_tangents(values, tangents)?,
            _ => return Ok(None),
        };
        let Some(by_knots) = KnotSlopes::new(&fit.knots, &points)? else { return Ok(None) };
        let slope = |&t: &f64| derivative(&fit.knots, &points, t, 1);
        let along = parameters.iter().map(slope).collect();
        let twice = by_knots.knots();
        let acting =
            |&t: &f64| twice.with_basis(t, |span, values| (span - twice.degree(), values.to_vec()));
        let there = parameters.iter().map(acting).collect();
        let has_second_knots = ends != Ends::NotAKnot || fit.knots.degree() != 3;
        Ok(Some(Self {
            fit: Cow::Borrowed(fit),
            parameters: Cow::Borrowed(parameters),
            values: Cow::Borrowed(values),
            tangents,
            has_second_knots,
            points,
            by_knots,
            along,
            there,
        }))
    }

    /// The same with what it was made of.
    pub(super) fn into_owned(self) -> MovingSpline<'static> {
        MovingSpline {
            fit: Cow::Owned(self.fit.into_owned()),
            parameters: Cow::Owned(self.parameters.into_owned()),
            values: Cow::Owned(self.values.into_owned()),
            ..self
        }
    }

    /// Its control points.
    pub(crate) fn points(&self) -> &[DVec4] {
        &self.points
    }

    /// How fast its inner knots move with its parameters, on which they depend evenly.
    pub(crate) fn knot_speeds(&self, parameters: &[f64]) -> Vec<f64> {
        let (n, p) = (parameters.len(), self.fit.knots.degree());
        let is_cubic = matches!(self.fit.equations, FactoredEquations::WithEnds(..));
        match (is_cubic, self.has_second_knots) {
            (true, _) => parameters[1..n - 1].to_vec(),
            (false, false) => parameters[2..n - 2].to_vec(),
            (false, true) => {
                let mean = |j: usize| parameters[j..j + p].iter().sum::<f64>() / p as f64;
                (1..n - p).map(mean).collect()
            }
        }
    }

    /// How fast its control points move, beside what its knots do, which is given.
    fn point_speeds(&self, speeds: &SplineSpeeds<'_>, by_knots: &[DVec4]) -> Vec<DVec4> {
        let mut values: Vec<DVec4> = Vec::with_capacity(speeds.values.len() + 2);
        for (i, &value) in speeds.values.iter().enumerate() {
            let (first, basis) = &self.there[i];
            let there: DVec4 = by_knots[*first..].iter().zip(basis).map(|(&p, &n)| p * n).sum();
            values.push(value - self.along[i] * speeds.parameters[i] - there);
        }
        match &self.fit.equations {
            FactoredEquations::WithEnds(band, rows) => {
                let start = self.end_speed(rows[0], false, speeds, by_knots);
                let end = self.end_speed(rows[1], true, speeds, by_knots);
                values.insert(1, start);
                values.insert(values.len() - 1, end);
                band.solve(&mut values);
            }
            FactoredEquations::Values(band) => band.solve(&mut values),
            _ => {}
        }
        values
    }

    /// How fast the right-hand side of an end's condition moves, less what the knots do to its left one.
    fn end_speed(
        &self,
        row: EndRow,
        is_last: bool,
        speeds: &SplineSpeeds<'_>,
        by_knots: &[DVec4],
    ) -> DVec4 {
        let last = self.values.len() - 1;
        let idx = |k: usize| if is_last { last - k.min(last) } else { k.min(last) };
        let sign = if is_last { -1.0 } else { 1.0 };
        let three = |of: &[f64]| [0, 1, 2].map(|k| sign * of[idx(k)]);
        match row {
            EndRow::Values(weights) => {
                let growths = bessel_speeds(three(&self.parameters), three(speeds.parameters));
                let part = |k: usize| {
                    speeds.values[idx(k)] * weights[k] + self.values[idx(k)] * growths[k]
                };
                part(0) + part(1) + part(2)
            }
            EndRow::Along(third) => {
                let [from, to, _] = three(speeds.parameters);
                let (own, tangent) = (usize::from(is_last), self.tangents);
                let growth = sign * (to - from) / 3.0;
                speeds.values[idx(0)] + speeds.tangents[own] * third + tangent[own] * growth
            }
            EndRow::Vanishing(order) => {
                let (column, t) = (if is_last { last + 1 } else { 1 }, self.parameters[idx(0)]);
                let [row, whole] = [
                    end_derivative(&self.fit.knots, column, order),
                    Equation::derivative(&self.fit.knots, t, order),
                ]
                .map(|row| row.largest());
                derivative(self.by_knots.knots(), by_knots, t, order) * (-row / whole)
            }
        }
    }

    /// The slopes of the control points over the knots that stand twice inside, which do not move: those of
    /// its own control points and of its knots together; for each of the speeds.
    ///
    /// # Errors
    /// None but those of knots that cannot be.
    pub(crate) fn slopes(&self, all: &[SplineSpeeds<'_>]) -> Result<Vec<Vec<DVec4>>, GeomError> {
        let mut by_knots = Vec::with_capacity(all.len());
        let mut own = Vec::with_capacity(all.len());
        for speeds in all {
            GeomError::go_on(1)?;
            let moved = self.by_knots.at_speeds(&self.knot_speeds(speeds.parameters));
            own.push(self.point_speeds(speeds, &moved));
            by_knots.push(moved);
        }
        let mut own = with_knots_twice(&self.fit.knots, own)?;
        for (own, by_knots) in own.iter_mut().zip(&by_knots) {
            own.iter_mut().zip(by_knots).for_each(|(own, by_knots)| *own += by_knots);
        }
        Ok(own)
    }
}

/// A derivative of a spline at a parameter.
pub(super) fn derivative(knots: &KnotVector, points: &[DVec4], t: f64, order: usize) -> DVec4 {
    let span = knots.span_at(t);
    if knots.degree() < order {
        return DVec4::ZERO;
    }
    let basis = knots.basis_derivatives_on(span, t, order);
    points[knots.support(span)].iter().zip(basis.row(order)).map(|(&point, &n)| point * n).sum()
}

/// How fast the weights of Bessel's condition move with three parameters.
pub(super) fn bessel_speeds([t0, t1, t2]: [f64; 3], [s0, s1, s2]: [f64; 3]) -> [f64; 3] {
    let d = (t2 - t1) / (t2 - t0);
    let growth = (s2 - s1 - d * (s2 - s0)) / (t2 - t0);
    let e = 1.0 - d;
    let by_d = [1.0 / 3.0, -1.0 / (3.0 * d * d), (2.0 * d * e + e * e) / (3.0 * d * d)];
    by_d.map(|weight| weight * growth)
}

impl Parametrization {
    /// How fast the parameters of points move with these; none by [`Parametrization::Foley`].
    pub(crate) fn speeds(
        self,
        points: &[DVec3],
        parameters: &[f64],
        slopes: &[DVec4],
    ) -> Option<Vec<f64>> {
        let legs = points.windows(2).zip(slopes.windows(2));
        let step = |(ends, slopes): (&[DVec3], &[DVec4])| {
            let (leg, growth) = (ends[1] - ends[0], (slopes[1] - slopes[0]).truncate());
            let length = leg.length();
            match self {
                Self::Uniform => Some([1.0, 0.0]),
                Self::Chord => Some([length, leg.dot(growth) / length]),
                Self::Centripetal => {
                    let root = length.sqrt();
                    Some([root, leg.dot(growth) / (2.0 * length * root)])
                }
                Self::Foley => None,
            }
        };
        let steps: Vec<[f64; 2]> = legs.map(step).collect::<Option<_>>()?;
        let [sum, growth] =
            steps.iter().fold([0.0; 2], |sum, step| [sum[0] + step[0], sum[1] + step[1]]);
        let mut reached = 0.0;
        let mut speeds = vec![0.0];
        for (step, parameter) in steps.iter().zip(&parameters[1..]) {
            reached += step[1];
            speeds.push((reached - parameter * growth) / sum);
        }
        // The last one stays, to the last digit.
        speeds.iter_mut().last().into_iter().for_each(|speed| *speed = 0.0);
        Some(speeds)
    }
}
