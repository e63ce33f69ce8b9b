//! The least value of a convex quadratic function under linear conditions.
//!
//! The dual method: it begins at the least value without conditions and makes them hold one by one, each
//! step being one to the least value under those that hold so far. Goldfarb & Idnani, *A numerically stable
//! dual method for solving strictly convex quadratic programs*, Math. Programming 27 (1983); Nocedal &
//! Wright, *Numerical Optimization*, §16.5.

use crate::{tolerance::DEPENDENT_RELATIVE, work};

/// `normal`·x + `constant`, which is to be zero, or not below it.
#[derive(Clone, Debug)]
pub(super) struct LinearCondition {
    pub(super) normal: Vec<f64>,
    pub(super) constant: f64,
    pub(super) is_equation: bool,
}

/// The place of the least value, and by how much each condition holds it off from a lower one.
#[derive(Clone, Debug)]
pub(super) struct QuadraticLeast {
    pub(super) place: Vec<f64>,
    pub(super) multipliers: Vec<f64>,
}

/// A condition that holds with equality: which it is, whether its sign is turned, what solving for its
/// normal gave, and its multiplier.
struct Active {
    idx: usize,
    sign: f64,
    normal: Vec<f64>,
    solved: Vec<f64>,
    multiplier: f64,
}

/// Where ½ xᵀ`matrix` x + `gradient`·x is least under the conditions; none where they contradict one another,
/// or the matrix is not positive definite.
pub(super) fn least_quadratic(
    matrix: &[Vec<f64>],
    gradient: &[f64],
    conditions: &[LinearCondition],
) -> Option<QuadraticLeast> {
    let factor = CholeskyFactor::new(matrix)?;
    let mut place = factor.solved(gradient.iter().map(|slope| -slope).collect());
    let mut active: Vec<Active> = Vec::new();
    let n_steps = STEPS_PER_CONDITION * (conditions.len() + matrix.len() + 1);
    for _ in 0..n_steps {
        if !work::goes_on((matrix.len() * (active.len() + 1)) as u64) {
            return None;
        }
        let Some((idx, value)) = most_violated(conditions, &place, &active) else {
            let mut multipliers = vec![0.0; conditions.len()];
            for held in &active {
                multipliers[held.idx] = held.sign * held.multiplier;
            }
            return Some(QuadraticLeast { place, multipliers });
        };
        let sign = if 0.0 < value { -1.0 } else { 1.0 };
        let normal: Vec<f64> = conditions[idx].normal.iter().map(|part| sign * part).collect();
        let solved = factor.solved(normal.clone());
        let added = Active { idx, sign, normal, solved, multiplier: 0.0 };
        hold(added, conditions, &mut place, &mut active)?;
    }
    None
}

/// Steps for each condition and unknown: a condition that was let go may come back a few times.
const STEPS_PER_CONDITION: usize = 20;

/// An equation that does not hold, or else the inequality that fails by most, with its value.
fn most_violated(
    conditions: &[LinearCondition],
    place: &[f64],
    active: &[Active],
) -> Option<(usize, f64)> {
    let mut worst = None;
    let mut most = 0.0;
    for (idx, condition) in conditions.iter().enumerate() {
        if active.iter().any(|held| held.idx == idx) {
            continue;
        }
        let value = dot(&condition.normal, place) + condition.constant;
        let terms = condition.normal.iter().zip(place).map(|(a, x)| (a * x).abs());
        let rounding = DEPENDENT_RELATIVE * terms.fold(condition.constant.abs(), f64::max);
        if condition.is_equation {
            if rounding < value.abs() {
                return Some((idx, value));
            }
        } else if value < -rounding && value < most {
            (worst, most) = (Some(idx), value);
        }
    }
    worst.map(|idx| (idx, most))
}

/// Moves to the least value at which one more condition holds with equality, and lets go of those that would
/// hold the place off from it; none where the condition contradicts those that stay.
fn hold(
    mut added: Active,
    conditions: &[LinearCondition],
    place: &mut [f64],
    active: &mut Vec<Active>,
) -> Option<()> {
    let constant = added.sign * conditions[added.idx].constant;
    for _ in 0..=active.len() {
        // Moving along `way` keeps the active conditions; `rates` are those of their multipliers.
        let products: Vec<Vec<f64>> = active
            .iter()
            .map(|a| active.iter().map(|b| dot(&a.normal, &b.solved)).collect())
            .collect();
        let right: Vec<f64> = active.iter().map(|held| dot(&held.normal, &added.solved)).collect();
        let rates = CholeskyFactor::new(&products)?.solved(right);
        let mut way = added.solved.clone();
        for (held, rate) in active.iter().zip(&rates) {
            way.iter_mut().zip(&held.solved).for_each(|(part, solved)| *part -= rate * solved);
        }
        let gain = dot(&way, &added.normal);
        let is_independent = DEPENDENT_RELATIVE * dot(&added.solved, &added.normal) < gain;

        // The first multiplier that vanishes ends the step, or the condition that holds at last.
        let blocking = active
            .iter()
            .zip(&rates)
            .enumerate()
            .filter(|(_, (held, rate))| !conditions[held.idx].is_equation && 0.0 < **rate)
            .map(|(k, (held, rate))| (k, held.multiplier / rate))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let missing = -(dot(&added.normal, place) + constant);
        let full = if is_independent { missing / gain } else { f64::INFINITY };
        let length = blocking.map_or(full, |(_, length)| length.min(full));
        if !length.is_finite() {
            return None;
        }
        if is_independent {
            place.iter_mut().zip(&way).for_each(|(x, part)| *x += length * part);
        }
        added.multiplier += length;
        active.iter_mut().zip(&rates).for_each(|(held, rate)| held.multiplier -= length * rate);
        match blocking {
            Some((k, blocked)) if blocked < full => {
                active.remove(k);
            }
            _ => {
                active.push(added);
                return Some(());
            }
        }
    }
    None
}

/// A positive definite matrix as the product of a triangular one and its transpose. Golub & Van Loan,
/// *Matrix Computations*, §4.2.
struct CholeskyFactor {
    rows: Vec<Vec<f64>>,
}

impl CholeskyFactor {
    fn new(matrix: &[Vec<f64>]) -> Option<Self> {
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(matrix.len());
        for (i, given) in matrix.iter().enumerate() {
            let mut row = Vec::with_capacity(i + 1);
            for (j, above) in rows.iter().enumerate() {
                row.push((given[j] - dot(&row[..j], &above[..j])) / above[j]);
            }
            let rest = given[i] - dot(&row, &row);
            if rest.is_nan() || rest <= DEPENDENT_RELATIVE * given[i] {
                return None;
            }
            row.push(rest.sqrt());
            rows.push(row);
        }
        Some(Self { rows })
    }

    fn solved(&self, mut right: Vec<f64>) -> Vec<f64> {
        for (i, row) in self.rows.iter().enumerate() {
            right[i] = (right[i] - dot(&row[..i], &right[..i])) / row[i];
        }
        for i in (0..self.rows.len()).rev() {
            right[i] /= self.rows[i][i];
            let known = right[i];
            right[..i].iter_mut().zip(&self.rows[i]).for_each(|(x, part)| *x -= known * part);
        }
        right
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::{LinearCondition, least_quadratic};

    fn condition(normal: &[f64], constant: f64, is_equation: bool) -> LinearCondition {
        LinearCondition { normal: normal.to_vec(), constant, is_equation }
    }

    #[track_caller]
    fn check(conditions: &[LinearCondition], wanted: Option<([f64; 2], &[f64])>) {
        // (x − 1)² + (y − 2.5)², without its constant.
        let matrix = [vec![2.0, 0.0], vec![0.0, 2.0]];
        let found = least_quadratic(&matrix, &[-2.0, -5.0], conditions);
        match (found, wanted) {
            (None, None) => {}
            (Some(found), Some((place, multipliers))) => {
                let near =
                    |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
                assert!(near(&found.place, &place), "{found:?}");
                assert!(near(&found.multipliers, multipliers), "{found:?}");
            }
            (found, _) => panic!("{found:?}"),
        }
    }

    #[test]
    fn the_example_of_nocedal_and_wright_is_solved() {
        // Example 16.4.
        let sides = [
            condition(&[1.0, -2.0], 2.0, false),
            condition(&[-1.0, -2.0], 6.0, false),
            condition(&[-1.0, 2.0], 2.0, false),
            condition(&[1.0, 0.0], 0.0, false),
            condition(&[0.0, 1.0], 0.0, false),
        ];
        check(&sides, Some(([1.4, 1.7], &[0.8, 0.0, 0.0, 0.0, 0.0])));
    }

    #[test]
    fn equations_hold_and_conditions_that_say_the_same_do_no_harm() {
        let line = condition(&[1.0, 1.0], -2.0, true);
        check(std::slice::from_ref(&line), Some(([0.25, 1.75], &[-1.5])));
        check(
            &[line.clone(), condition(&[2.0, 2.0], -4.0, true)],
            Some(([0.25, 1.75], &[-1.5, 0.0])),
        );
        check(&[line, condition(&[-1.0, 0.0], 0.0, false)], Some(([0.0, 2.0], &[-1.0, 1.0])));
    }

    #[test]
    fn conditions_that_contradict_one_another_are_told() {
        check(&[condition(&[1.0, 0.0], -2.0, false), condition(&[-1.0, 0.0], 1.0, false)], None);
        check(&[condition(&[1.0, 0.0], -2.0, true), condition(&[1.0, 0.0], -1.0, true)], None);
    }
}
