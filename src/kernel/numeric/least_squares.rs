//! Unknowns for which several functions are zero together, or least in their squares.

use super::{
    answers::{Answers, CountedFunctions, Wanted},
    normal_equations::NormalEquations,
};
use crate::{
    ceiling::LEAST_SQUARES_STEPS,
    tolerance::{
        DAMPING_FIRST, LAST_BIT, LEAST_PROBE_RELATIVE, SQUARES_AT_ROOT, SQUARES_IN_VALLEY,
        STEP_REST_RELATIVE,
    },
};

/// Where an iteration towards the least squares ended.
///
/// ```
/// use virote_kernel::{LeastSquares, find_least_squares};
///
/// let circles = |x: &[f64], _| {
///     Ok::<_, ()>(vec![x[0] * x[0] + x[1] * x[1] - 25.0, x[0] - x[1] - 1.0].into())
/// };
/// let found: LeastSquares = find_least_squares(circles, &[1.0, 1.0], &[])?;
/// assert!((found.unknowns[0] - 4.0).abs() < 1e-12 && found.is_settled);
/// # Ok::<(), ()>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LeastSquares {
    /// The unknowns.
    pub unknowns: Vec<f64>,
    /// The values of the functions there.
    pub residuals: Vec<f64>,
    /// The values of the functions at the start.
    pub first_residuals: Vec<f64>,
    /// Whether the last step moved the unknowns by rounding alone.
    pub is_settled: bool,
    /// How far one more step of Newton would lead, as a share of the unknowns or of the way from the start: little
    /// where there is a root, and not where the functions only come near zero, or tend to it.
    pub rest: f64,
    /// How often the functions were asked.
    pub n_evaluations: usize,
}

/// Unknowns near a start for which the squares of several functions add up to least: zero, where there are
/// no more functions than unknowns and they have a common root near by. Each stays between its bounds; there
/// are none of any where `bounds` is empty.
///
/// Steps between Newton's and the steepest descent, by the functions' gradients, or by central differences
/// where they have none. Moré, *The Levenberg-Marquardt
/// algorithm: implementation and theory*, LNM 630 (1978); Nocedal & Wright, *Numerical Optimization*, §10.3. At a bound
/// over which the squares fall an unknown is held, and steps end at bounds: Kanzow, Yamashita & Fukushima,
/// *Levenberg–Marquardt methods with strong local convergence*, J. Comput. Appl. Math. 172 (2004).
///
/// ```
/// use virote_kernel::find_least_squares;
///
/// // The line nearest to three points.
/// let line =
///     |x: &[f64], _| Ok::<_, ()>(vec![x[0], x[0] + x[1] - 1.0, x[0] + 2.0 * x[1] - 1.0].into());
/// let found = find_least_squares(line, &[0.0, 0.0], &[])?;
/// assert!((found.unknowns[0] - 1.0 / 6.0).abs() < 1e-9 && (found.unknowns[1] - 0.5).abs() < 1e-9);
/// # Ok::<(), ()>(())
/// ```
///
/// # Errors
/// Those of the functions.
pub fn find_least_squares<E>(
    functions: impl FnMut(&[f64], Wanted) -> Result<Answers, E>,
    start: &[f64],
    bounds: &[[f64; 2]],
) -> Result<LeastSquares, E> {
    let mut search = SquaresSearch::new(functions, start, bounds)?;
    let mut way = search.go_on()?;
    for _ in 0..LEAPS {
        // What tends to zero, as an exponential does, would be followed until it is none.
        let is_near =
            squares(&search.residuals) <= SQUARES_IN_VALLEY * squares(&search.first_residuals);
        let left = if is_near { SQUARES_AT_ROOT } else { LEFT_BY_LEAP };
        if way.is_ended || !search.leaps(left)? {
            break;
        }
        way = search.go_on()?;
    }
    if way.is_settled {
        search.refine()?;
    }
    let SquaresSearch { asked, unknowns, residuals, first_residuals, .. } = search;
    let moved: Vec<f64> = unknowns.iter().zip(start).map(|(x, start)| x - start).collect();
    let size = largest(&unknowns).max(largest(&moved)).max(f64::MIN_POSITIVE);
    let rest = way.last.map_or(0.0, |(slopes, values)| newton_step(&slopes, &values) / size);
    let (is_settled, n_evaluations) = (way.is_settled, asked.n_evaluations);
    Ok(LeastSquares { unknowns, residuals, first_residuals, is_settled, rest, n_evaluations })
}

/// Last bits of the least squares by which those at a place that slopes tell may be more: both are rounded.
const SQUARES_ROUNDINGS: f64 = 16.0;

/// Times that a search goes on from where Newton's steps lead out of a narrow valley.
const LEAPS: usize = 4;

/// Newton's steps of one of these: along a valley that bends the first leads away from its bottom, and the second back.
const LEAP_STEPS: usize = 6;

/// The share of the squares that may be left behind them.
const LEFT_BY_LEAP: f64 = 0.25;

/// A search under way.
struct SquaresSearch<'b, F> {
    bounds: &'b [[f64; 2]],
    asked: CountedFunctions<F>,
    unknowns: Vec<f64>,
    residuals: Vec<f64>,
    first_residuals: Vec<f64>,
}

/// How a search went.
struct SearchPath {
    is_settled: bool,
    /// Whether it went as far as it goes: not where its steps ran out.
    is_ended: bool,
    /// The gradients and values where the last step was taken; none at a root.
    last: Option<(Vec<Vec<f64>>, Vec<f64>)>,
}

impl<'b, F, E> SquaresSearch<'b, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    fn new(functions: F, start: &[f64], bounds: &'b [[f64; 2]]) -> Result<Self, E> {
        let mut asked = CountedFunctions::new(functions);
        let unknowns = clamped(start, bounds);
        let residuals = asked.values(&unknowns)?;
        let first_residuals = residuals.clone();
        Ok(Self { bounds, asked, unknowns, residuals, first_residuals })
    }

    /// The equations of a step in which unknowns stay that the squares would lead over their bounds.
    fn equations(&self, gradients: &[Vec<f64>]) -> NormalEquations {
        let mut equations = NormalEquations::new(gradients, &self.residuals);
        for (k, (x, [low, high])) in self.unknowns.iter().zip(self.bounds).enumerate() {
            let way = equations.right[k];
            if *x <= *low && way < 0.0 || *high <= *x && 0.0 < way {
                equations.hold(k);
            }
        }
        equations
    }

    /// Damped steps, each of which leads down.
    fn go_on(&mut self) -> Result<SearchPath, E> {
        let mut damping = DAMPING_FIRST;
        let mut way = SearchPath { is_settled: false, is_ended: true, last: None };
        for _ in 0..LEAST_SQUARES_STEPS {
            let square = squares(&self.residuals);
            if square <= 0.0 {
                return Ok(SearchPath { is_settled: true, is_ended: true, last: None });
            }
            let gradients = self.asked.gradients(&self.unknowns, self.bounds)?;
            let is_known = gradients.iter().flatten().all(|slope| slope.is_finite());
            let equations = self.equations(&gradients);
            way.last = Some((gradients, self.residuals.clone()));
            if !is_known {
                // Differences that reach to where there is no value.
                return Ok(way);
            }
            // The damping grows until a step leads down, or is none any more.
            let accepted = loop {
                let moved = clamped(&plus(&self.unknowns, &equations.step(damping)), self.bounds);
                let step = minus(&moved, &self.unknowns);
                if !is_moved(&self.unknowns, &step) {
                    break None;
                }
                let values = self.asked.values(&moved)?;
                if squares(&values) < square {
                    break Some((moved, values, step));
                }
                damping *= 8.0;
            };
            let Some((moved, values, step)) = accepted else {
                way.is_settled = true;
                return Ok(way);
            };
            damping = (damping / 16.0).max(f64::MIN_POSITIVE);
            way.is_settled = !is_moved(&moved, &step);
            (self.unknowns, self.residuals) = (moved, values);
            if way.is_settled {
                return Ok(way);
            }
        }
        way.is_ended = false;
        Ok(way)
    }

    /// Goes on by undamped steps where squares are left, though these stay the same to rounding, as long as each step is half
    /// as long as the one before or less: squares tell half of the digits of a place, slopes all of them.
    fn refine(&mut self) -> Result<(), E> {
        let left = squares(&self.residuals);
        let most = (1.0 + SQUARES_ROUNDINGS * LAST_BIT) * left;
        let mut reach = LEAST_PROBE_RELATIVE * largest(&self.unknowns);
        for _ in 0..LEAST_SQUARES_STEPS {
            let is_root = left <= SQUARES_AT_ROOT * squares(&self.first_residuals);
            if is_root || self.asked.has_differences {
                break;
            }
            let gradients = self.asked.gradients(&self.unknowns, self.bounds)?;
            let step = self.equations(&gradients).step(STEP_REST_RELATIVE);
            let length = largest(&step);
            if !is_moved(&self.unknowns, &step) || !length.is_finite() || reach <= length {
                break;
            }
            let moved = clamped(&plus(&self.unknowns, &step), self.bounds);
            let residuals = self.asked.values(&moved)?;
            if most < squares(&residuals) {
                break;
            }
            (self.unknowns, self.residuals, reach) = (moved, residuals, 0.5 * length);
        }
        Ok(())
    }

    /// Goes to where steps of Newton lead, up and down, if no more than a share of the squares is left there.
    fn leaps(&mut self, left: f64) -> Result<bool, E> {
        let (mut unknowns, mut residuals) = (self.unknowns.clone(), self.residuals.clone());
        let most = left * squares(&residuals);
        for _ in 0..LEAP_STEPS {
            let gradients = self.asked.gradients(&unknowns, self.bounds)?;
            let step = NormalEquations::new(&gradients, &residuals).step(STEP_REST_RELATIVE);
            unknowns = clamped(&plus(&unknowns, &step), self.bounds);
            residuals = self.asked.values(&unknowns)?;
            if squares(&residuals) <= most {
                (self.unknowns, self.residuals) = (unknowns, residuals);
                return Ok(true);
            }
            if !squares(&residuals).is_finite() {
                break;
            }
        }
        Ok(false)
    }
}

fn plus(unknowns: &[f64], step: &[f64]) -> Vec<f64> {
    unknowns.iter().zip(step).map(|(x, step)| x + step).collect()
}

fn minus(unknowns: &[f64], others: &[f64]) -> Vec<f64> {
    unknowns.iter().zip(others).map(|(x, other)| x - other).collect()
}

/// Unknowns brought between their bounds, where there are any.
fn clamped(unknowns: &[f64], bounds: &[[f64; 2]]) -> Vec<f64> {
    let mut inside = unknowns.to_vec();
    inside.iter_mut().zip(bounds).for_each(|(x, [low, high])| *x = x.max(*low).min(*high));
    inside
}

pub(super) fn largest(all: &[f64]) -> f64 {
    all.iter().fold(0.0, |most: f64, part| most.max(part.abs()))
}

/// How far a step of Newton leads; endless where nothing slopes.
fn newton_step(gradients: &[Vec<f64>], residuals: &[f64]) -> f64 {
    // Each function in units of its own steepest slope: beside steep ones what only tends to zero would not count,
    // and their squares may be no numbers.
    let (mut slopes, mut values) = (Vec::new(), Vec::new());
    for (gradient, residual) in gradients.iter().zip(residuals) {
        let steepest = largest(gradient);
        if 0.0 < steepest {
            slopes.push(gradient.iter().map(|slope| slope / steepest).collect::<Vec<f64>>());
            values.push(residual / steepest);
        }
    }
    let is_known = slopes.iter().flatten().chain(&values).all(|number| number.is_finite());
    match is_known && !slopes.is_empty() {
        true => largest(&NormalEquations::new(&slopes, &values).step(STEP_REST_RELATIVE)),
        false => f64::INFINITY,
    }
}

/// The sum of squares; of what is no number more than any.
fn squares(residuals: &[f64]) -> f64 {
    let sum: f64 = residuals.iter().map(|value| value * value).sum();
    if sum.is_nan() { f64::INFINITY } else { sum }
}

/// Whether a step moves the unknowns by more than rounding.
fn is_moved(unknowns: &[f64], step: &[f64]) -> bool {
    let size = unknowns.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    step.iter()
        .zip(unknowns)
        .any(|(step, x)| STEP_REST_RELATIVE * x.abs().max(STEP_REST_RELATIVE * size) < step.abs())
}

#[cfg(test)]
mod tests {
    use super::{Answers, LeastSquares, find_least_squares};

    fn found(functions: fn(&[f64]) -> Vec<f64>, start: &[f64]) -> LeastSquares {
        find_least_squares(|x, _| Ok::<_, ()>(functions(x).into()), start, &[]).expect("no failure")
    }

    #[test]
    fn roots_of_systems_are_found_to_the_last_digits() {
        let circles =
            found(|x| vec![x[0] * x[0] + x[1] * x[1] - 4.0, x[0] * x[1] - 1.0], &[2.0, 0.3]);
        let [x, y] = [circles.unknowns[0], circles.unknowns[1]];
        assert!((x * x + y * y - 4.0).abs() < 1e-14 && (x * y - 1.0).abs() < 1e-14, "{circles:?}");
        // Rosenbrock's valley as two equations.
        let valley = found(|x| vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]], &[-1.2, 1.0]);
        assert!(valley.unknowns.iter().all(|x| (x - 1.0).abs() < 1e-12), "{valley:?}");
        assert!(valley.n_evaluations < 400, "{}", valley.n_evaluations);
        // A hundred times as narrow, and more, which is left by steps that go up first; there differences have fewer
        // digits.
        let near = |found: &LeastSquares, room| {
            assert!(found.unknowns.iter().all(|x| (x - 1.0).abs() < room), "{found:?}");
        };
        near(&found(|x| vec![1e3 * (x[1] - x[0] * x[0]), 1.0 - x[0]], &[-1.2, 1.0]), 1e-12);
        near(&found(|x| vec![1e6 * (x[1] - x[0] * x[0]), 1.0 - x[0]], &[-1.2, 1.0]), 1e-7);
        let one = found(|x| vec![libm::exp(x[0]) - 1e-3], &[1.0]);
        assert!((one.unknowns[0] - libm::log(1e-3)).abs() < 1e-12, "{one:?}");
    }

    #[test]
    fn places_without_a_value_are_kept_out_of() {
        let large = found(|x| vec![libm::exp(x[0]) - 1e3, x[1] - x[0]], &[0.0, 0.0]);
        assert!(large.unknowns.iter().all(|x| (x - libm::log(1e3)).abs() < 1e-12), "{large:?}");
        // Beyond 1 there is none, and the first step leads there.
        let arc = found(|x| vec![libm::acos(x[0]) - 0.001], &[0.0]);
        assert!((arc.unknowns[0] - libm::cos(0.001)).abs() < 1e-15, "{arc:?}");
        // At the end of its places it is not settled, so that more functions than unknowns are not taken for solved.
        let end = found(|x| vec![(-x[0]).sqrt() + 1.0, 0.5], &[-1.0]);
        assert!(!end.is_settled || 1e-3 < end.rest || end.unknowns[0].abs() < 1e-9, "{end:?}");
    }

    #[test]
    fn more_functions_than_unknowns_are_least_in_their_squares() {
        let mean = found(|x| [1.0, 2.0, 6.0].map(|y| x[0] - y).to_vec(), &[0.0]);
        assert!((mean.unknowns[0] - 3.0).abs() < 1e-8 && mean.is_settled, "{mean:?}");
    }

    #[test]
    fn slopes_tell_all_digits_of_where_squares_are_least() {
        let mean = |x: &[f64], _| {
            let values = [1.0, 2.0, 6.0].map(|y| x[0] - y).to_vec();
            Ok::<_, ()>(Answers { values, gradients: Some(vec![vec![1.0]; 3]) })
        };
        let found = find_least_squares(mean, &[0.0], &[]).expect("no failure");
        assert!((found.unknowns[0] - 3.0).abs() < 1e-15, "{found:?}");
        // The point of y = x² that is nearest to (3/2, 0) and (-1/2, 0) together: 4x³ + 2x = 1.
        let parabola = |x: &[f64], _| {
            let [x, y] = [x[0], x[0] * x[0]];
            let gradients = Some(vec![vec![1.0], vec![2.0 * x], vec![1.0], vec![2.0 * x]]);
            Ok::<_, ()>(Answers { values: vec![x - 1.5, y, x + 0.5, y], gradients })
        };
        let found = find_least_squares(parabola, &[1.0], &[]).expect("no failure");
        let x = found.unknowns[0];
        assert!((4.0 * x * x * x + 2.0 * x - 1.0).abs() < 1e-14, "{found:?}");
    }

    #[test]
    fn fewer_functions_than_unknowns_leave_the_rest_where_it_was() {
        let plane = found(|x| vec![x[0] + x[1] - 2.0], &[0.0, 0.0, 7.0]);
        assert!((plane.unknowns[0] + plane.unknowns[1] - 2.0).abs() < 1e-12, "{plane:?}");
        assert!((plane.unknowns[2] - 7.0).abs() < 1e-12);
    }

    #[test]
    fn unknowns_stay_between_their_bounds() {
        let within = |functions: fn(&[f64]) -> Vec<f64>, start: &[f64], bounds: &[[f64; 2]]| {
            let inside = |x: &[f64], _| {
                let mut pairs = x.iter().zip(bounds);
                assert!(pairs.all(|(x, [low, high])| low <= x && x <= high), "{x:?}");
                Ok::<_, ()>(functions(x).into())
            };
            find_least_squares(inside, start, bounds).expect("no failure")
        };
        // Of the two roots the one inside, from beyond where free steps lead to the other one.
        let circle = |x: &[f64]| vec![x[0] * x[0] + x[1] * x[1] - 25.0, x[0] - x[1] - 1.0];
        let inside = within(circle, &[-0.1, -1.0], &[[-9.0, 0.0], [-9.0, 9.0]]);
        assert!((inside.unknowns[0] + 3.0).abs() < 1e-12 && inside.rest < 1e-9, "{inside:?}");
        // A root on a border, and none inside.
        let corner =
            within(|x| vec![x[0] - 1.0, x[0] * x[1] - 2.0], &[0.2, 0.3], &[[0.0, 1.0], [0.0, 2.0]]);
        assert!((corner.unknowns[1] - 2.0).abs() < 1e-9, "{corner:?}");
        let none = within(|x| vec![x[0] + x[1] - 3.0, x[0] - x[1]], &[0.2, 0.3], &[[0.0, 1.0]; 2]);
        assert!(0.5 < none.residuals[0].abs(), "{none:?}");
        // The squares are least on the border.
        let mean = within(|x| [1.0, 2.0, 6.0].map(|y| x[0] - y).to_vec(), &[0.0], &[[0.0, 2.5]]);
        assert!((mean.unknowns[0] - 2.5).abs() < 1e-12 && mean.is_settled, "{mean:?}");
    }

    #[test]
    fn what_has_no_root_ends_where_it_is_least() {
        let none = found(|x| vec![x[0] * x[0] + 1.0], &[3.0]);
        assert!(
            none.unknowns[0].abs() < 1e-3 && (none.residuals[0] - 1.0).abs() < 1e-6,
            "{none:?}"
        );
        assert!(1e-3 < none.rest, "{none:?}");
        let tends = found(|x| vec![libm::exp(x[0])], &[1.0]);
        assert!(1e-3 < tends.rest, "{tends:?}");
        let beside = found(|x| vec![1.0 / x[0], x[1] * x[1] - 1.0], &[1.0, 2.0]);
        assert!(1e-3 < beside.rest, "{beside:?}");
        let scaled = found(|x| vec![1e-2 * (x[0] - 1.0), 1e2 * (x[1] * x[1] - x[0])], &[2.0, 2.0]);
        assert!(scaled.rest < 1e-9 && (scaled.unknowns[0] - 1.0).abs() < 1e-6, "{scaled:?}");
        let triple = found(|x| vec![x[0] * x[0] * x[0]], &[5.0]);
        assert!(triple.rest < 1e-9, "{triple:?}");
        let flat = found(|_| vec![1.0], &[3.0]);
        assert!((flat.unknowns[0] - 3.0).abs() < 1e-9);
    }
}
