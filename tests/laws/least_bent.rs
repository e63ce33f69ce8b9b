//! Least values on kinks that are bent, under conditions that bind, and of functions without derivatives: whatever is
//! answered is right, or refused.

use proptest::{collection::vec, prop_assert, prop_assume, proptest};
use virote_kernel::{Answers, ConstrainedLeast, LeastEnd, LeastProblem, Wanted};

const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Whether the functions tell their derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Derivatives {
    Exact,
    Differences,
}

const BOTH: [Derivatives; 2] = [Derivatives::Exact, Derivatives::Differences];

/// Values of functions, the one that is to be least first, and their gradients.
type Told = (Vec<f64>, Vec<Vec<f64>>);

fn found(
    functions: impl Fn(&[f64]) -> Told,
    start: &[f64],
    derivatives: Derivatives,
) -> ConstrainedLeast {
    let answers = |x: &[f64], wanted: Wanted| {
        let (values, gradients) = functions(x);
        let is_told = wanted == Wanted::Gradients && derivatives == Derivatives::Exact;
        Ok::<_, ()>(Answers { values, gradients: is_told.then_some(gradients) })
    };
    LeastProblem { start, bounds: &vec![FREE; start.len()], n_equations: 0 }
        .find(answers)
        .expect("no failure")
}

fn side(rest: f64) -> f64 {
    if rest < 0.0 { -1.0 } else { 1.0 }
}

/// |y - x²| so many times, and (1 - x)²: least at (1, 1), along a parabola on which it is smooth.
fn folded(x: &[f64], weight: f64) -> Told {
    let (rest, off) = (x[1] - x[0] * x[0], 1.0 - x[0]);
    let slope = weight * side(rest);
    (vec![weight * rest.abs() + off * off], vec![vec![-2.0 * (slope * x[0] + off), slope]])
}

#[test]
fn bent_kinks_are_followed_to_their_least_value() {
    let starts = [[2.0, 4.0], [5.0, 25.0], [-1.0, 1.0], [0.0, 0.0], [-1.2, 1.0], [5.0, 20.0]];
    for weight in [1.0, 10.0, 100.0, 1e4] {
        for (start, derivatives) in starts.iter().flat_map(|start| BOTH.map(|how| (start, how))) {
            let found = found(|x| folded(x, weight), start, derivatives);
            let case = format!("{weight} {start:?} {derivatives:?}: {found:?}");
            let is_told = found.end == LeastEnd::Settled;
            assert!(!is_told || found.values[0] < 1e-5, "{case}");
            assert!(is_told || 10.0 < weight || derivatives != Derivatives::Exact, "{case}");
        }
    }
}

/// Magnitudes of the last of some numbers and squares of what the first are off one, each number less a parabola of the one
/// before it: least is zero, and nothing else is the least near by.
fn woven(x: &[f64], n_smooth: usize, weights: &[f64], bend: f64) -> Told {
    let n = x.len();
    let (mut value, mut slopes) = (0.0, vec![0.0; n]);
    for k in 0..n {
        let before = if k == 0 { 0.0 } else { x[k - 1] };
        let number = x[k] - bend * before * before;
        let (term, slope) = match k < n_smooth {
            true => ((number - 1.0) * (number - 1.0), 2.0 * (number - 1.0)),
            false => (weights[k] * number.abs(), weights[k] * side(number)),
        };
        value += term;
        slopes[k] += slope;
        if 0 < k {
            slopes[k - 1] -= 2.0 * slope * bend * before;
        }
    }
    (vec![value], vec![slopes])
}

#[test]
fn woven_kinks_are_right_or_refused() {
    let mut n_told = [0, 0];
    for case in 0..60_u32 {
        let turn = |k: usize| libm::cos(2.7 * f64::from(case) + 1.3 * k as f64);
        let n = 2 + case as usize % 3;
        let n_smooth = 1 + case as usize % (n - 1);
        let weights: Vec<f64> = (0..n).map(|k| libm::pow(10.0, 1.0 + turn(k + 9))).collect();
        let start: Vec<f64> = (0..n).map(|k| 2.0 * turn(k)).collect();
        for (how, derivatives) in BOTH.into_iter().enumerate() {
            let found = found(|x| woven(x, n_smooth, &weights, 0.4), &start, derivatives);
            let is_told = found.end == LeastEnd::Settled;
            assert!(!is_told || found.values[0] < 1e-5, "{case} {derivatives:?}: {found:?}");
            n_told[how] += usize::from(is_told);
        }
    }
    assert!(57 <= n_told[0] && 18 <= n_told[1], "{n_told:?}");
}

#[test]
fn saddles_between_kinks_are_left() {
    // Along y = x² it falls to both sides of zero, to -1/4 where x² is 1/2.
    let saddle = |x: &[f64]| {
        let rest = x[1] - x[0] * x[0];
        let along = 4.0 * libm::pow(x[0], 3.0) - 2.0 * x[0];
        let value = 10.0 * rest.abs() - x[0] * x[0] + libm::pow(x[0], 4.0);
        (vec![value], vec![vec![along - 20.0 * side(rest) * x[0], 10.0 * side(rest)]])
    };
    for start in [[0.0, 0.0], [1e-3, 0.0], [0.0, 1.0], [1.0, 1.0]] {
        for derivatives in BOTH {
            let found = found(saddle, &start, derivatives);
            let is_told = found.end == LeastEnd::Settled;
            assert!(!is_told || found.values[0] < -0.25 + 1e-5, "{start:?}: {found:?}");
            assert!(is_told || derivatives == Derivatives::Differences, "{start:?}: {found:?}");
        }
    }
}

#[test]
fn kinks_under_conditions_that_bind_are_told() {
    // Within the circle of radius one, and within a square that stands on a corner.
    let disc = |x: &[f64]| {
        let (rests, inside) = ([x[0] - 2.0, x[1] - 2.0], 1.0 - x[0] * x[0] - x[1] * x[1]);
        let value = rests[0].abs() + rests[1].abs();
        (vec![value, inside], vec![rests.map(side).to_vec(), vec![-2.0 * x[0], -2.0 * x[1]]])
    };
    let square = |x: &[f64], function: (f64, [f64; 2])| {
        let inside = 1.0 - x[0].abs() - x[1].abs();
        (vec![function.0, inside], vec![function.1.to_vec(), vec![-side(x[0]), -side(x[1])]])
    };
    let plane = |x: &[f64]| square(x, (-3.0 * x[0] - x[1], [-3.0, -1.0]));
    let squares = |x: &[f64]| {
        let off = [x[0] - 2.0, x[1] - 1.0];
        square(x, (off[0] * off[0] + off[1] * off[1], [2.0 * off[0], 2.0 * off[1]]))
    };
    for start in [[0.0, 0.0], [-1.0, 3.0], [0.5, 0.5], [3.0, 3.0]] {
        for derivatives in BOTH {
            let told: [(ConstrainedLeast, f64); 3] = [
                (found(disc, &start, derivatives), 4.0 - 2.0_f64.sqrt()),
                (found(plane, &start, derivatives), -3.0),
                (found(squares, &start, derivatives), 2.0),
            ];
            for (found, least) in told {
                let case = format!("{start:?}, {derivatives:?}: {found:?} for {least}");
                let is_told = found.end == LeastEnd::Settled;
                assert!(is_told || derivatives == Derivatives::Differences, "{case}");
                assert!(!is_told || (found.values[0] - least).abs() < 1e-6, "{case}");
                assert!(!is_told || -1e-7 < found.values[1], "{case}");
            }
        }
    }
}

proptest! {
    /// A linear function is least in an ellipsoid where the ellipsoid's normal is its gradient: by Lagrange the least value
    /// is that of the centre less the radius times √(Σ c²/d).
    #[test]
    fn linear_functions_are_least_on_the_border_of_an_ellipsoid(
        slopes in vec(-1.0..1.0_f64, 1..6),
        axes in vec(0.2..2.0_f64, 5),
        center in vec(-2.0..2.0_f64, 5),
        off in vec(-0.5..0.5_f64, 5),
        size in -3.0..3.0_f64,
    ) {
        let size = libm::pow(10.0, size);
        let n = slopes.len();
        let steep: f64 = slopes.iter().zip(&axes).map(|(c, d)| c * c / d).sum();
        prop_assume!(1e-4 < steep);
        let from_center = |x: &[f64]| x.iter().zip(&center).map(|(x, m)| x - size * m).collect::<Vec<f64>>();
        let functions = |x: &[f64]| {
            let away = from_center(x);
            let value = slopes.iter().zip(x).map(|(c, x)| c * x).sum();
            let inside = size * size - axes.iter().zip(&away).map(|(d, r)| d * r * r).sum::<f64>();
            let normal = axes.iter().zip(&away).map(|(d, r)| -2.0 * d * r).collect();
            (vec![value, inside], vec![slopes.clone(), normal])
        };
        let start: Vec<f64> = (0..n).map(|k| size * (center[k] + off[k] / n as f64)).collect();
        let middle: f64 = slopes.iter().zip(&center).map(|(c, m)| c * m).sum();
        let least = size * (middle - steep.sqrt());
        for derivatives in BOTH {
            let found = found(functions, &start, derivatives);
            let is_told = found.end == LeastEnd::Settled;
            prop_assert!(is_told || derivatives == Derivatives::Differences, "{:?}", found);
            let near = 1e-7 * (size + least.abs());
            prop_assert!(!is_told || (found.values[0] - least).abs() < near, "{:?} for {}", found, least);
        }
    }
}

#[test]
fn kinks_of_many_unknowns_are_right_or_refused() {
    for n in [60, 61, 100] {
        let chain = |x: &[f64]| {
            let (mut value, mut slopes) = (0.0, vec![0.0; n]);
            for k in 0..n {
                let rest = x[k] - if k == 0 { 0.0 } else { x[k - 1] };
                value += rest.abs();
                slopes[k] += side(rest);
                if 0 < k {
                    slopes[k - 1] -= side(rest);
                }
            }
            (vec![value], vec![slopes])
        };
        let start: Vec<f64> = (0..n).map(|k| 3.0 + k as f64).collect();
        let found = found(chain, &start, Derivatives::Exact);
        let is_told = found.end == LeastEnd::Settled;
        assert!(!is_told || found.values[0] < 1e-7, "{n}: {found:?}");
        assert!(is_told || 60 < n, "{n}: {found:?}");
    }
}
