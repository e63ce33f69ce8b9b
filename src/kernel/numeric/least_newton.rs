//! Whether a step of Newton's method leads lower from where a search for a least value settled.
//!
//! What such a step promises tells whether a place is the least one whatever the sizes of unknowns: the model by which a
//! search came there may have learned its curvature far away. Nocedal & Wright, *Numerical Optimization*, §3.3; the
//! curvature is scaled as there in §4.5.

use super::{
    answers::{Answers, Wanted},
    least_model::{CurvatureModel, Terms, magnitude},
    least_search::LeastSearch,
    quadratic_program::dot,
};
use crate::tolerance::{
    LEAST_NEARNESS, LEAST_NEWTON_BEND, LEAST_NEWTON_REACH, LEAST_PROBE_RELATIVE,
    LEAST_STEP_RELATIVE,
};

/// The share of a promised fall by which a step of Newton's method may miss that and keep its promise.
const KEPT_SLACK: f64 = 0.1;

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// Whether a step of Newton's method promises more than rounding, and leads lower; the search goes there, with the
    /// curvature that is known. Given are the axes of the curvature, each with how it bends, by unknowns that are stretched.
    pub(super) fn leaves_by_newton(
        &mut self,
        axes: &[(f64, Vec<f64>)],
        stretch: &[f64],
        is_kinked: bool,
    ) -> Result<bool, E> {
        let n = self.place.len();
        let most = axes.iter().map(|(bend, _)| bend.abs()).fold(0.0, f64::max);
        let bend_of = |bend: &f64| bend.abs().max(LEAST_NEWTON_BEND * most);
        let gradients = self.slopes.clone();
        let slopes: Vec<f64> = gradients[0].iter().zip(stretch).map(|(g, s)| g * s).collect();
        let mut way = vec![0.0; n];
        for (bend, axis) in axes {
            let share = -dot(&slopes, axis) / bend_of(bend);
            let parts = axis.iter().zip(stretch);
            way.iter_mut().zip(parts).for_each(|(way, (part, s))| *way += share * part * s);
        }
        let slope = dot(&gradients[0], &way);
        let reach = magnitude(&way);
        let mut parts = way.iter().zip(&self.place).zip(&self.units);
        let is_still =
            parts.all(|((way, x), unit)| (way * unit).abs() <= LEAST_STEP_RELATIVE * x.abs());
        if is_still || !self.is_lower(self.merit(&self.values) + 0.5 * slope, reach) {
            return Ok(false);
        }
        let bend_between = |i: usize, j: usize| -> f64 {
            let sum: f64 = axes.iter().map(|(bend, axis)| bend_of(bend) * axis[i] * axis[j]).sum();
            sum / (stretch[i] * stretch[j])
        };
        let matrix = (0..n).map(|i| (0..n).map(|j| bend_between(i, j)).collect()).collect();
        let model = CurvatureModel::known(matrix);
        let terms = Terms {
            gradients: &gradients,
            values: &self.weighted(&self.values),
            limits: &self.limits(&self.place),
            n_equations: 0,
        };
        let lower = self.shortened(&terms, &model, &way, slope)?;
        let lower = lower.filter(|lower| self.is_lower(self.merit(&lower.values), reach));
        let Some(lower) = lower else { return Ok(false) };
        let missed = self.merit(&self.values) - self.merit(&lower.values) + 0.5 * slope;
        if is_kinked && KEPT_SLACK * -0.5 * slope <= missed.abs() {
            return Ok(false);
        }
        self.leave_for((lower.place, lower.values), reach);
        self.curvature = Some(model);
        Ok(true)
    }

    /// How far along a way the curvature is looked at by gradients: where nothing holds the unknowns by how far the place is
    /// from zero, if that is nearer than their sizes.
    pub(super) fn curvature_reach(&self, way: &[f64]) -> f64 {
        if !self.is_free() {
            return LEAST_PROBE_RELATIVE;
        }
        let along = self.place.iter().zip(&self.units).zip(way);
        let share: f64 = along.map(|((x, unit), part)| x / unit * part).sum();
        LEAST_NEWTON_REACH * share.abs().clamp(LEAST_NEARNESS, 1.0)
    }
}

/// Stretches ways so that the function bends by one along each, with the curvature between them; by how much.
pub(super) fn even_out(ways: &mut [Vec<f64>], curvature: &mut [Vec<f64>]) -> Vec<f64> {
    let bends: Vec<f64> = (0..ways.len()).map(|k| curvature[k][k].abs()).collect();
    let most = bends.iter().copied().fold(0.0, f64::max);
    let stretch: Vec<f64> = (bends.into_iter())
        .map(|bend| if 0.0 < bend { bend } else { most })
        .map(|bend| if 0.0 < bend { 1.0 / bend.sqrt() } else { 1.0 })
        .collect();
    for (i, row) in curvature.iter_mut().enumerate() {
        ways[i].iter_mut().for_each(|part| *part *= stretch[i]);
        row.iter_mut().enumerate().for_each(|(j, bend)| *bend *= stretch[i] * stretch[j]);
    }
    stretch
}

#[cfg(test)]
mod tests {
    use super::super::{least_beside::axis, quadratic_program::dot};
    use crate::{Answers, ConstrainedLeast, LeastEnd, LeastProblem};

    const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    fn found(function: fn(&[f64]) -> (f64, Vec<f64>), start: &[f64]) -> ConstrainedLeast {
        let answers = |x: &[f64], _| {
            let (value, slopes) = function(x);
            Ok::<_, ()>(Answers { values: vec![value], gradients: Some(vec![slopes]) })
        };
        LeastProblem { start, bounds: &vec![FREE; start.len()], n_equations: 0 }
            .find(answers)
            .expect("no failure")
    }

    /// Beale's function, Moré, Garbow & Hillstrom, *Testing Unconstrained Optimization Software*, problem 5.
    fn beale(x: &[f64]) -> (f64, Vec<f64>) {
        let [a, b] = [x[0], x[1]];
        let rest = |start: f64, power: i32| start - a * (1.0 - libm::pow(b, f64::from(power)));
        let parts = [(rest(1.5, 1), 1), (rest(2.25, 2), 2), (rest(2.625, 3), 3)];
        let value = parts.iter().map(|(rest, _)| rest * rest).sum();
        let along_a =
            parts.iter().map(|(rest, n)| -2.0 * rest * (1.0 - libm::pow(b, f64::from(*n))));
        let along_b = parts
            .iter()
            .map(|(rest, n)| 2.0 * rest * a * f64::from(*n) * libm::pow(b, f64::from(*n - 1)));
        (value, vec![along_a.sum(), along_b.sum()])
    }

    #[test]
    fn steep_starts_do_not_hide_how_a_function_falls_on() {
        for start in [[1e3, 1e3], [1e3, 1.0], [1e6, 1e6], [1.0, 1.0]] {
            let found = found(beale, &start);
            assert_eq!(found.end, LeastEnd::Settled, "{start:?}: {found:?}");
            let [a, b] = [found.unknowns[0], found.unknowns[1]];
            assert!((a - 3.0).abs() < 1e-6 && (b - 0.5).abs() < 1e-6, "{start:?}: {found:?}");
        }
    }

    #[test]
    fn sums_of_fourth_powers_are_followed_in_few_steps() {
        let quartics = |x: &[f64]| {
            let away: Vec<f64> = x.iter().enumerate().map(|(k, x)| x - k as f64).collect();
            let value = away.iter().map(|away| libm::pow(*away, 4.0)).sum();
            (value, away.iter().map(|away| 4.0 * libm::pow(*away, 3.0)).collect())
        };
        for n in [3, 12, 30] {
            let found = found(quartics, &vec![50.0; n]);
            assert_eq!(found.end, LeastEnd::Settled, "{found:?}");
            assert!(found.values[0] < 1e-24 && found.n_evaluations < 400, "{found:?}");
        }
    }

    /// The sum of the magnitudes of sums of unknowns, each with what is taken off it, and of a number.
    fn kinked(terms: &[(Vec<f64>, f64)], rest: f64, start: &[f64]) -> ConstrainedLeast {
        let answers = |x: &[f64], _| {
            let (mut value, mut slopes) = (rest, vec![0.0; x.len()]);
            for (shares, off) in terms {
                let term = dot(shares, x) - off;
                let side = if term < 0.0 { -1.0 } else { 1.0 };
                value += term.abs();
                slopes.iter_mut().zip(shares).for_each(|(slope, share)| *slope += side * share);
            }
            // Without slopes on kinks themselves.
            let is_on_kink = terms.iter().any(|(shares, off)| (dot(shares, x) - off).abs() <= 0.0);
            let gradients = (!is_on_kink).then(|| vec![slopes]);
            Ok::<_, ()>(Answers { values: vec![value], gradients })
        };
        LeastProblem { start, bounds: &vec![FREE; start.len()], n_equations: 0 }
            .find(answers)
            .expect("no failure")
    }

    #[test]
    fn kinks_are_come_to_in_few_steps_whether_the_least_value_is_zero_or_not() {
        for (n, most) in [(5, 400), (6, 450), (8, 600), (12, 900), (30, 2100)] {
            let start: Vec<f64> = (0..n).map(|k| 3.0 + k as f64).collect();
            let terms: Vec<(Vec<f64>, f64)> = (0..n).map(|k| (axis(n, k), k as f64)).collect();
            for rest in [0.0, 1.0] {
                let found = kinked(&terms, rest, &start);
                assert_eq!(found.end, LeastEnd::Settled, "{found:?}");
                assert!(found.values[0] - rest < 1e-9, "{found:?}");
                assert!(found.n_evaluations <= most, "{n} {rest}: {}", found.n_evaluations);
            }
        }
    }

    #[test]
    fn chains_of_kinks_are_come_to_their_ends() {
        for (n, most) in [(5, 400), (6, 480), (7, 540), (12, 900), (20, 1350), (30, 2200)] {
            let start: Vec<f64> = (0..n).map(|k| 3.0 + k as f64).collect();
            let step = |k: usize| -> Vec<f64> {
                let before = if k == 0 { vec![0.0; n] } else { axis(n, k - 1) };
                axis(n, k).iter().zip(&before).map(|(here, before)| here - before).collect()
            };
            let terms: Vec<(Vec<f64>, f64)> = (0..n).map(|k| (step(k), 0.0)).collect();
            for rest in [0.0, 1.0] {
                let found = kinked(&terms, rest, &start);
                assert_eq!(found.end, LeastEnd::Settled, "{found:?}");
                assert!(found.values[0] - rest < 1e-9, "{found:?}");
                assert!(found.n_evaluations <= most, "{n} {rest}: {}", found.n_evaluations);
            }
        }
    }
}
