//! The quadratic model by which a search for a least value takes its steps.
//!
//! Nocedal & Wright, *Numerical Optimization*, §18.1 and procedure 18.2.

use super::{
    quadratic_program::{LinearCondition, QuadraticLeast, dot, least_quadratic},
    symmetric_eigen::symmetric_axes,
};
use crate::tolerance::{
    CONDITION_RELATIVE, CURVATURE_SPREAD, HOLDING_RELATIVE, LAST_BIT, RELAXATION_WEIGHT,
};

/// The share of the model's curvature below which a function bends less, after how many such steps in a row the model
/// bends less everywhere, and to which share of itself at most.
const LESS: f64 = 0.7;
const LESS_STEPS: usize = 3;
const LEAST_SCALE: f64 = 0.1;

/// What is known at a place: the function that is to be least, first, then the conditions.
pub(super) struct Terms<'a> {
    pub(super) gradients: &'a [Vec<f64>],
    pub(super) values: &'a [f64],
    /// How far each unknown may go down and up.
    pub(super) limits: &'a [[f64; 2]],
    pub(super) n_equations: usize,
}

/// A condition, or a bound behind all conditions, that holds a place from going lower.
pub(super) struct HoldingCondition {
    pub(super) idx: usize,
    pub(super) normal: Vec<f64>,
    pub(super) multiplier: f64,
}

/// A step of the model.
pub(super) struct ModelStep {
    pub(super) way: Vec<f64>,
    /// Of the conditions.
    pub(super) multipliers: Vec<f64>,
    /// The share of each broken condition that the step mends.
    pub(super) kept: f64,
    /// Whether the linear conditions contradict one another, and were relaxed.
    pub(super) is_relaxed: bool,
}

impl Terms<'_> {
    /// How the function changes along a way.
    pub(super) fn slope(&self, way: &[f64]) -> f64 {
        dot(&self.gradients[0], way)
    }

    /// How many times as far as a way one may go along it before a linear condition breaks; once where one is already.
    pub(super) fn room(&self, way: &[f64]) -> f64 {
        let rooms = self.conditions(self.values).into_iter().map(|condition| {
            let change = dot(&condition.normal, way);
            let is_left = change < 0.0 || condition.is_equation && change != 0.0;
            if is_left { -condition.constant / change } else { f64::INFINITY }
        });
        rooms.fold(f64::INFINITY, f64::min).max(1.0)
    }

    /// The shortest way to where the linear conditions hold, with some of them as equations; none where they
    /// contradict one another.
    pub(super) fn way_back(&self, held: &[usize]) -> Option<Vec<f64>> {
        let n = self.limits.len();
        let mut conditions = self.conditions(self.values);
        held.iter().for_each(|&idx| conditions[idx].is_equation = true);
        least_quadratic(&CurvatureModel::new(n).matrix, &vec![0.0; n], &conditions)
            .map(|found| found.place)
    }

    /// The conditions that hold a place from going lower, as they count in [`Terms::way_back`], each with its
    /// slope and by how much it does; none where they contradict one another.
    pub(super) fn holding(&self) -> Option<Vec<HoldingCondition>> {
        let conditions = self.conditions(self.values);
        let matrix = CurvatureModel::new(self.limits.len()).matrix;
        let found = least_quadratic(&matrix, &self.gradients[0], &conditions)?;
        let all = conditions.into_iter().zip(found.multipliers).enumerate();
        let holding = all.filter(|(_, (condition, multiplier))| {
            let pull = multiplier.abs() * magnitude(&condition.normal);
            condition.is_equation || HOLDING_RELATIVE < pull
        });
        let holding = holding.map(|(idx, (condition, multiplier))| HoldingCondition {
            idx,
            normal: condition.normal,
            multiplier,
        });
        Some(holding.collect())
    }

    /// The linear conditions, those on the conditions' values first, with `values` at the place.
    fn conditions(&self, values: &[f64]) -> Vec<LinearCondition> {
        let n = self.limits.len();
        let given = self.gradients[1..].iter().zip(&values[1..]).enumerate().map(
            |(idx, (gradient, &constant))| LinearCondition {
                normal: gradient.clone(),
                constant,
                is_equation: idx < self.n_equations,
            },
        );
        let sides = self.limits.iter().enumerate().flat_map(|(k, [low, high])| {
            [(1.0, -low), (-1.0, *high)].into_iter().filter(|(_, room)| room.is_finite()).map(
                move |(side, room)| {
                    let mut normal = vec![0.0; n];
                    normal[k] = side;
                    LinearCondition { normal, constant: room, is_equation: false }
                },
            )
        });
        given.chain(sides).collect()
    }
}

/// What a function is near a place, as far as one look at it tells: its plane there, which is below it at the place by a gap.
pub(super) struct Plane {
    pub(super) gradient: Vec<f64>,
    pub(super) gap: f64,
}

/// The curvature of a function under conditions, as far as it is known.
pub(super) struct CurvatureModel {
    matrix: Vec<Vec<f64>>,
    is_fresh: bool,
    /// Steps in a row along which the function bent by less than the model.
    n_less: usize,
}

impl CurvatureModel {
    /// The same curvature along every way.
    pub(super) fn new(n: usize) -> Self {
        let row = |i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
        Self { matrix: (0..n).map(row).collect(), is_fresh: true, n_less: 0 }
    }

    /// A curvature that is known.
    pub(super) fn known(matrix: Vec<Vec<f64>>) -> Self {
        Self { matrix, is_fresh: false, n_less: 0 }
    }

    /// Whether it has learned nothing yet.
    pub(super) fn is_fresh(&self) -> bool {
        self.is_fresh
    }

    /// The step of the model, which begins anew where it is of no use any more. `None` where that serves nothing either.
    pub(super) fn renewed_step(&mut self, terms: &Terms<'_>) -> Option<ModelStep> {
        let step = self.step(terms);
        if step.is_some() || self.is_fresh {
            return step;
        }
        *self = Self::new(self.matrix.len());
        self.step(terms)
    }

    /// The step to where the model is least. Where the linear conditions contradict one another, they are
    /// relaxed together by as little as serves. `None` where the model is of no use any more.
    fn step(&self, terms: &Terms<'_>) -> Option<ModelStep> {
        let n_conditions = terms.values.len() - 1;
        let conditions = terms.conditions(terms.values);
        // Conditions that contradict one another by less than what holds are taken as they are.
        let is_off = |value: &f64| CONDITION_RELATIVE < value.abs();
        let held = terms.values.iter().map(|value| if is_off(value) { *value } else { 0.0 });
        for conditions in [&conditions, &terms.conditions(&held.collect::<Vec<f64>>())] {
            if let Some(QuadraticLeast { place: way, mut multipliers }) =
                least_quadratic(&self.matrix, &terms.gradients[0], conditions)
            {
                multipliers.truncate(n_conditions);
                return Some(ModelStep { way, multipliers, kept: 1.0, is_relaxed: false });
            }
        }
        let n = self.matrix.len();
        let most = (0..n).map(|k| self.matrix[k][k]).fold(1.0, f64::max);
        let mut matrix: Vec<Vec<f64>> = self.matrix.clone();
        matrix.iter_mut().for_each(|row| row.push(0.0));
        let mut last = vec![0.0; n];
        last.push(RELAXATION_WEIGHT * most);
        matrix.push(last);
        let mut gradient = terms.gradients[0].clone();
        gradient.push(0.0);
        let relaxed: Vec<LinearCondition> = conditions
            .into_iter()
            .enumerate()
            .map(|(idx, mut condition)| {
                let is_broken = condition.is_equation || condition.constant < 0.0;
                let slack = if idx < n_conditions && is_broken { -condition.constant } else { 0.0 };
                condition.normal.push(slack);
                condition
            })
            .collect();
        let QuadraticLeast { mut place, mut multipliers } =
            least_quadratic(&matrix, &gradient, &relaxed)?;
        let slack = place.pop()?.clamp(0.0, 1.0);
        multipliers.truncate(n_conditions);
        Some(ModelStep { way: place, multipliers, kept: 1.0 - slack, is_relaxed: true })
    }

    /// The step to where the greatest of some planes, with a share of the curvature, is least under the linear conditions and
    /// more of them, and by how much it is lower there; none where rounding lets them contradict one another.
    pub(super) fn step_below(
        &self,
        terms: &Terms<'_>,
        planes: &[Plane],
        more: &[LinearCondition],
        share: f64,
    ) -> Option<(Vec<f64>, f64)> {
        let mut matrix = self.matrix.clone();
        matrix.iter_mut().flatten().for_each(|part| *part *= share);
        let mut given = terms.conditions(terms.values);
        given.extend(more.iter().cloned());
        let mut first = 0;
        for _ in 0..=2 * planes.len() {
            // Where one of them is the greatest; as a condition on itself it says nothing.
            let base = &planes[first];
            let below = planes.iter().map(|plane| {
                let parts = base.gradient.iter().zip(&plane.gradient);
                let normal = parts.map(|(base, other)| base - other).collect();
                LinearCondition { normal, constant: plane.gap - base.gap, is_equation: false }
            });
            let conditions: Vec<LinearCondition> = given.iter().cloned().chain(below).collect();
            let found = least_quadratic(&matrix, &base.gradient, &conditions)?;
            let pulls = &found.multipliers[given.len()..];
            if pulls.iter().sum::<f64>() <= 1.0 + LAST_BIT.sqrt() {
                let heights =
                    planes.iter().map(|plane| dot(&plane.gradient, &found.place) - plane.gap);
                let fall = -heights.fold(f64::NEG_INFINITY, f64::max);
                return Some((found.place, fall));
            }
            // It holds the place off from what is lower by another one.
            first = pulls.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1))?.0;
        }
        None
    }

    /// The curvature with what is many times the least taken for that: beside kinks, which planes tell of, it is none.
    pub(super) fn evened(self) -> Self {
        let n = self.matrix.len();
        let axes = symmetric_axes(self.matrix);
        let bends = || axes.iter().map(|(bend, _)| *bend);
        let most = bends().fold(0.0, f64::max);
        let least = bends().fold(most, f64::min).max(LAST_BIT * most);
        let bend_between = |i: usize, j: usize| -> f64 {
            let bend = |bend: f64| bend.clamp(least, CURVATURE_SPREAD * least);
            axes.iter().map(|(along, axis)| bend(*along) * axis[i] * axis[j]).sum()
        };
        Self::known((0..n).map(|i| (0..n).map(|j| bend_between(i, j)).collect()).collect())
    }

    /// The step that goes to the same least, with the conditions as they are behind a first step.
    pub(super) fn corrected(
        &self,
        terms: &Terms<'_>,
        way: &[f64],
        behind: &[f64],
    ) -> Option<Vec<f64>> {
        let constant = |(gradient, value): (&Vec<f64>, &f64)| value - dot(gradient, way);
        let values: Vec<f64> = terms.gradients.iter().zip(behind).map(constant).collect();
        least_quadratic(&self.matrix, &terms.gradients[0], &terms.conditions(&values))
            .map(|found| found.place)
    }

    /// Learns from the gradients before and behind a way: BFGS, damped so that the model stays convex, and scaled where
    /// the function bends less and less. Oren & Luenberger, *Self-scaling variable metric algorithms*, Management Science
    /// 20 (1974).
    pub(super) fn learn(
        &mut self,
        way: &[f64],
        [before, behind]: [&[Vec<f64>]; 2],
        multipliers: &[f64],
    ) {
        let change = |k: usize| {
            let conditions: f64 = (1..before.len())
                .map(|idx| multipliers[idx - 1] * (behind[idx][k] - before[idx][k]))
                .sum();
            behind[0][k] - before[0][k] - conditions
        };
        let change: Vec<f64> = (0..way.len()).map(change).collect();
        if self.is_fresh {
            // The size of the curvature, before the first is learned.
            let scale = dot(&change, &change) / dot(&change, way);
            if scale.is_finite() && 0.0 < scale {
                self.matrix.iter_mut().flatten().for_each(|part| *part *= scale);
            }
        }
        let mut image: Vec<f64> = self.matrix.iter().map(|row| dot(row, way)).collect();
        let (bend, mut known) = (dot(&change, way), dot(&image, way));
        if known.is_nan() || known <= 0.0 {
            return;
        }
        // What bends less and less, as towards the root of a power, does so along other ways too.
        let is_less = 0.0 < bend && bend < LESS * known;
        self.n_less = if is_less { self.n_less + 1 } else { 0 };
        if LESS_STEPS <= self.n_less {
            let scale = (bend / known).max(LEAST_SCALE);
            self.matrix.iter_mut().flatten().for_each(|part| *part *= scale);
            image.iter_mut().for_each(|part| *part *= scale);
            known *= scale;
        }
        let share = if bend < 0.2 * known { 0.8 * known / (known - bend) } else { 1.0 };
        let damped: Vec<f64> = change
            .iter()
            .zip(&image)
            .map(|(change, image)| share * change + (1.0 - share) * image)
            .collect();
        let damped_bend = dot(&damped, way);
        for (i, row) in self.matrix.iter_mut().enumerate() {
            for (j, part) in row.iter_mut().enumerate() {
                *part += damped[i] * damped[j] / damped_bend - image[i] * image[j] / known;
            }
        }
        self.is_fresh = false;
    }
}

/// The largest part by size.
pub(super) fn magnitude(parts: &[f64]) -> f64 {
    parts.iter().fold(0.0, |most: f64, part| most.max(part.abs()))
}
