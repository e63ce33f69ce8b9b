//! How much sums of the control points of splines grow with each of the points that the splines go through.
//!
//! Whoever asks for a place of a spline asks for few control points, and whoever measures it for one sum of all. The
//! transposed equations tell how that grows with every right-hand side at once, and so with all points, whatever moves
//! these: of A·P = Q and a sum g·P the growths are the solution of Aᵀ·λ = g.

use std::sync::Arc;

use glam::{DVec3, DVec4};

use super::{
    Interpolator,
    interpolate::{EndRow, FactoredEquations, end_derivative},
    leg_growths::LegGrowths,
    moving::{MovingSpline, bessel_speeds},
};
use crate::{
    KnotVector, PointSlopes,
    fit::equation::Equation,
    varied::{
        AllSlopes, SlopeWays,
        same_shape::{ParameterMap, point_row},
    },
};

/// The slopes of the control points of a spline over the knots that stand twice inside, from those of its points: its
/// parameters move with these.
pub(super) fn spline_slopes_asked(
    spline: Arc<MovingSpline<'static>>,
    legs: LegGrowths,
    slopes: &PointSlopes,
    all: Box<AllSlopes>,
) -> PointSlopes {
    let n_points = spline.by_knots.knots().n_points();
    let of = move |factors: &[f64]| {
        let (by_value, by_parameter) = spline.growths(factors);
        let by_step = legs.with_steps(&spline.parameters, &by_parameter);
        let steps = by_step.into_iter().zip(legs.along().iter().copied()).collect();
        PointGrowths { by_value, steps }
    };
    asked(slopes, n_points, of, all)
}

/// The slopes of the control points of a spline at parameters that stay, from those of its points; none where the
/// equations are others than of values and of conditions at both ends, or all slopes at once cost less.
pub(super) fn fixed_slopes_asked(fit: &Interpolator, slopes: &PointSlopes) -> Option<PointSlopes> {
    let is_known =
        matches!(fit.equations, FactoredEquations::Values(_) | FactoredEquations::WithEnds(..));
    let fit = (is_known && slopes.are_asked_rather()).then(|| Arc::new(fit.clone()))?;
    let n_points = fit.knots.n_points();
    let (given, forward) = (slopes.clone(), fit.clone());
    let all = move || {
        let own = |(_, own): &(usize, Vec<DVec4>)| forward.through(own).ok();
        given.by_variable().iter().map(own).collect()
    };
    let of = move |factors: &[f64]| PointGrowths {
        by_value: fit.value_growths(factors.to_vec()),
        steps: Vec::new(),
    };
    Some(asked(slopes, n_points, of, Box::new(all)))
}

/// How something grows with points: by a factor with each, and by a vector times how the step from each to the next
/// does, which grows along another one.
#[derive(Clone, Debug, Default)]
pub(super) struct PointGrowths {
    pub(super) by_value: Vec<f64>,
    pub(super) steps: Vec<(DVec3, DVec3)>,
}

impl PointGrowths {
    /// How it grows where one of the points moves.
    pub(super) fn with(&self, point: usize, speed: DVec3) -> DVec3 {
        let step = |idx: usize| {
            let own = self.steps.get(idx);
            own.map_or(DVec3::ZERO, |(growth, along)| *growth * along.dot(speed))
        };
        let before = point.checked_sub(1).map_or(DVec3::ZERO, step);
        let own = self.by_value.get(point).copied().unwrap_or(0.0);
        own * speed + before - step(point)
    }
}

/// Slopes of so many control points from those of points, by what tells how sums of the control points grow with these.
fn asked(
    slopes: &PointSlopes,
    n_points: usize,
    of: impl Fn(&[f64]) -> PointGrowths + Send + Sync + 'static,
    all: Box<AllSlopes>,
) -> PointSlopes {
    let given: Vec<(usize, Vec<DVec3>)> = slopes
        .moving()
        .map(|(_, moving, own)| {
            (moving.start, own[moving].iter().map(|slope| slope.truncate()).collect())
        })
        .collect();
    let sums = move |factors: &[f64]| {
        let growths = of(factors);
        let by_variable = |(first, own): &(usize, Vec<DVec3>)| {
            own.iter().enumerate().map(|(idx, speed)| growths.with(first + idx, *speed)).sum()
        };
        given.iter().map(by_variable).collect()
    };
    let variables = slopes.moving().map(|(variable, ..)| variable).collect();
    let ways = SlopeWays { sums: Box::new(sums), all };
    PointSlopes::asked(slopes.n_variables(), n_points, variables, ways)
}

/// Adds what the right-hand side of an end's condition grows by with each value.
fn add_end_values(row: EndRow, is_last: bool, growth: f64, by_value: &mut [f64]) {
    let last = by_value.len() - 1;
    let idx = |k: usize| if is_last { last - k.min(last) } else { k.min(last) };
    match row {
        EndRow::Values(weights) => {
            weights
                .into_iter()
                .enumerate()
                .for_each(|(k, weight)| by_value[idx(k)] += growth * weight);
        }
        EndRow::Along(_) => by_value[idx(0)] += growth,
        EndRow::Vanishing(_) => {}
    }
}

impl Interpolator {
    /// How a sum of control points with these factors grows with each value, at parameters that stay.
    pub(super) fn value_growths(&self, factors: Vec<f64>) -> Vec<f64> {
        let (mut by_value, ends) = self.transposed(factors);
        for (is_last, (row, growth)) in [false, true].into_iter().zip(ends) {
            add_end_values(row, is_last, growth, &mut by_value);
        }
        by_value
    }

    /// The same of a spline with tangents at its ends, and how the sum grows with each of these; none of others.
    pub(crate) fn growths_with_tangents(&self, factors: Vec<f64>) -> Option<(Vec<f64>, [f64; 2])> {
        let FactoredEquations::WithEnds(_, [EndRow::Along(_), EndRow::Along(_)]) = &self.equations
        else {
            return None;
        };
        let (mut by_value, ends) = self.transposed(factors);
        let mut by_tangent = [0.0; 2];
        for (is_last, (row, growth)) in [false, true].into_iter().zip(ends) {
            add_end_values(row, is_last, growth, &mut by_value);
            if let EndRow::Along(third) = row {
                by_tangent[usize::from(is_last)] = growth * third;
            }
        }
        Some((by_value, by_tangent))
    }

    /// How a sum of control points with these factors grows with each value by its own equation, and with the right-hand
    /// sides of the conditions at both ends.
    pub(super) fn transposed(&self, mut factors: Vec<f64>) -> (Vec<f64>, Vec<(EndRow, f64)>) {
        match &self.equations {
            FactoredEquations::WithEnds(band, [start, end]) => {
                band.solve_transposed(&mut factors);
                let of_end = factors.remove(factors.len() - 2);
                let of_start = factors.remove(1);
                (factors, vec![(*start, of_start), (*end, of_end)])
            }
            FactoredEquations::Values(band) => {
                band.solve_transposed(&mut factors);
                (factors, Vec::new())
            }
            _ => unreachable!("other equations are not asked for slopes"),
        }
    }
}

impl MovingSpline<'_> {
    /// How a sum of control points over the knots that stand twice, with a factor for each, grows with each value and with
    /// each parameter.
    pub(super) fn growths(&self, factors: &[f64]) -> (Vec<f64>, Vec<DVec4>) {
        let mut own = vec![0.0; self.points.len()];
        for (i, &factor) in factors.iter().enumerate().filter(|(_, factor)| 0.0 < factor.abs()) {
            let twice = self.by_knots.knots();
            let row = point_row(&self.fit.knots, twice, i, ParameterMap::SAME);
            let Some((first, parts)) = row else { continue };
            own[first..].iter_mut().zip(parts).for_each(|(sum, part)| *sum += factor * part);
        }
        let (mut by_value, ends) = self.fit.transposed(own);
        let mut by_twice = factors.to_vec();
        let mut by_parameter = Vec::with_capacity(by_value.len());
        for ((growth, along), (first, basis)) in by_value.iter().zip(&self.along).zip(&self.there) {
            by_parameter.push(-*along * *growth);
            by_twice[*first..].iter_mut().zip(basis).for_each(|(sum, n)| *sum -= growth * n);
        }
        for (is_last, (row, growth)) in [false, true].into_iter().zip(ends) {
            add_end_values(row, is_last, growth, &mut by_value);
            self.add_end_growths(row, is_last, growth, &mut by_parameter, &mut by_twice);
        }
        self.add_knot_growths(&by_twice, &mut by_parameter);
        (by_value, by_parameter)
    }

    /// Adds what the right-hand side of an end's condition grows by with each parameter, less what the knots do to its
    /// left one: see [`SplineSpeeds`](super::moving::SplineSpeeds).
    fn add_end_growths(
        &self,
        row: EndRow,
        is_last: bool,
        growth: f64,
        by_parameter: &mut [DVec4],
        by_twice: &mut [f64],
    ) {
        let last = self.values.len() - 1;
        let idx = |k: usize| if is_last { last - k.min(last) } else { k.min(last) };
        let sign = if is_last { -1.0 } else { 1.0 };
        match row {
            EndRow::Values(_) => {
                let there = [0, 1, 2].map(|k| sign * self.parameters[idx(k)]);
                for moving in 0..3 {
                    let mut speeds = [0.0; 3];
                    speeds[moving] = sign;
                    let weights = bessel_speeds(there, speeds);
                    let parts = (0..3).map(|k| self.values[idx(k)] * weights[k]);
                    by_parameter[idx(moving)] += parts.sum::<DVec4>() * growth;
                }
            }
            EndRow::Along(_) => {
                let part = self.tangents[usize::from(is_last)] * (growth / 3.0);
                by_parameter[idx(1)] += part;
                by_parameter[idx(0)] -= part;
            }
            EndRow::Vanishing(order) => {
                let (column, t) = (if is_last { last + 1 } else { 1 }, self.parameters[idx(0)]);
                let row = end_derivative(&self.fit.knots, column, order);
                let share = growth * row.largest()
                    / Equation::derivative(&self.fit.knots, t, order).largest();
                let twice: &KnotVector = self.by_knots.knots();
                let span = twice.span_at(t);
                let basis = twice.basis_derivatives_on(span, t, order);
                let sums = by_twice[span - twice.degree()..].iter_mut();
                sums.zip(basis.row(order)).for_each(|(sum, n)| *sum -= share * n);
            }
        }
    }

    /// Adds what comes of the inner knots, which move with the parameters as [`Self::knot_speeds`] says.
    fn add_knot_growths(&self, by_twice: &[f64], by_parameter: &mut [DVec4]) {
        let p = self.fit.knots.degree();
        let is_cubic = matches!(self.fit.equations, FactoredEquations::WithEnds(..));
        for (knot, growth) in self.by_knots.growths(by_twice).enumerate() {
            match (is_cubic, self.has_second_knots) {
                (true, _) => by_parameter[knot + 1] += growth,
                (false, false) => by_parameter[knot + 2] += growth,
                (false, true) => {
                    let share = growth / p as f64;
                    by_parameter[knot + 1..=knot + p].iter_mut().for_each(|sum| *sum += share);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::{DVec3, DVec4};

    use super::{fixed_slopes_asked, spline_slopes_asked};
    use crate::{
        Ends, Interpolator, Parametrization, PointSlopes,
        fit::{
            leg_growths::LegGrowths,
            moving::{MovingSpline, SplineSpeeds},
        },
    };

    const N_POINTS: usize = 9;

    fn points() -> Vec<DVec3> {
        let point = |i: usize| {
            let t = i as f64;
            DVec3::new(t, libm::sin(1.7 * t), 0.3 * libm::cos(t * t))
        };
        (0..N_POINTS).map(point).collect()
    }

    /// Of one point each, and of all together.
    fn slopes() -> PointSlopes {
        let one = |moving: usize| {
            let mut own = vec![DVec4::ZERO; N_POINTS];
            own[moving] = DVec4::new(0.3, 1.0, -0.7, 0.0);
            (moving, own)
        };
        let wave = |i: usize| DVec4::new(1.0, i as f64, libm::sin(i as f64), 0.0);
        let all = (N_POINTS, (0..N_POINTS).map(wave).collect());
        let by_variable = (0..N_POINTS).map(one).chain([all]).collect();
        PointSlopes::new(N_POINTS + 1, N_POINTS, by_variable).unwrap()
    }

    const SPLINES: [(usize, Ends); 8] = [
        (3, Ends::Bessel),
        (3, Ends::Natural),
        (3, Ends::Quadratic),
        (3, Ends::NotAKnot),
        (3, Ends::Averaged),
        (2, Ends::Averaged),
        (4, Ends::Averaged),
        (5, Ends::Averaged),
    ];

    #[track_caller]
    fn are_near(found: &[DVec4], expected: &[DVec4]) {
        let size = expected.iter().map(|slope| slope.length()).fold(1.0, f64::max);
        assert_eq!(found.len(), expected.len());
        let pairs = found.iter().zip(expected);
        let error = pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        assert!(error < 1e-12 * size, "{error} of {size}");
    }

    /// The slopes of each control point by a variable, asked for by itself.
    fn one_by_one(slopes: &PointSlopes, variable: usize) -> Vec<DVec4> {
        let n_points = slopes.n_points();
        let of = |i: usize| {
            let along = |axis: DVec4| {
                let mut gradient = vec![DVec4::ZERO; n_points];
                gradient[i] = axis;
                slopes.through(&gradient)[variable]
            };
            DVec4::new(along(DVec4::X), along(DVec4::Y), along(DVec4::Z), 0.0)
        };
        (0..n_points).map(of).collect()
    }

    #[test]
    fn control_points_of_moving_splines_grow_as_their_equations_say() {
        let (points, slopes) = (points(), slopes());
        let values: Vec<DVec4> = points.iter().map(|point| point.extend(1.0)).collect();
        for rule in [Parametrization::Chord, Parametrization::Centripetal] {
            let parameters = rule.parameters(&points).unwrap();
            for (degree, ends) in SPLINES {
                let fit = Interpolator::new(&parameters, degree, ends).unwrap();
                let tangents = [DVec4::ZERO; 2];
                let spline = MovingSpline::new((&fit, ends), &parameters, &values, tangents);
                let spline = spline.unwrap().unwrap();
                let legs: LegGrowths = rule.leg_growths(&points).unwrap();
                let owned = Arc::new(spline.clone().into_owned());
                let found = spline_slopes_asked(owned, legs, &slopes, Box::new(|| None));
                for (variable, own) in slopes.by_variable() {
                    let speeds = rule.speeds(&points, &parameters, own).unwrap();
                    let speeds = SplineSpeeds { parameters: &speeds, values: own, tangents };
                    let expected = spline.slopes(&[speeds]).unwrap().concat();
                    are_near(&one_by_one(&found, *variable), &expected);
                    // A sum of them all.
                    let factor = |i: usize| DVec4::new(1.0, -0.5, i as f64, 3.0);
                    let gradient: Vec<DVec4> = (0..expected.len()).map(factor).collect();
                    let sum: f64 = expected.iter().zip(&gradient).map(|(a, b)| a.dot(*b)).sum();
                    let error = found.through(&gradient)[*variable] - sum;
                    assert!(error.abs() < 1e-11 * (1.0 + sum.abs()), "{error} of {sum}");
                }
            }
        }
    }

    #[test]
    fn control_points_of_splines_at_fixed_parameters_grow_with_their_points() {
        let parameters: Vec<f64> =
            (0..N_POINTS).map(|i| i as f64 + 0.2 * libm::sin(i as f64)).collect();
        for (degree, ends) in SPLINES {
            let fit = Interpolator::new(&parameters, degree, ends).unwrap();
            let slopes = slopes();
            let found = fixed_slopes_asked(&fit, &slopes).unwrap();
            for (variable, own) in slopes.by_variable() {
                let expected = fit.through(own).unwrap();
                are_near(&one_by_one(&found, *variable), &expected);
                are_near(&found.by_variable()[*variable].1, &expected);
            }
        }
    }
}
